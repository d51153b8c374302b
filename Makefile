# The commands of the house. Each does its own set-up (deps.sh); everything is built under build/.
BUILD  ?= build
JOBS   ?= $(shell nproc 2>/dev/null || echo 2)
PREFIX ?= /usr/local
FUZZ_SECONDS ?= 60

help:
	@echo "make demo       bake and relight the Stanford bunny; pictures in out/"
	@echo "make test       build and run every test; ends with 'N passed, N failed'"
	@echo "make bench      time and error of every candidate, as tables and CSV"
	@echo "make gen        rewrite the generated blocks of the headers (gen-check: only compare)"
	@echo "make fuzz       run each fuzz target for FUZZ_SECONDS=$(FUZZ_SECONDS)"
	@echo "make docs       rewrite the tables and plots of docs/ and README.md from measurements"
	@echo "make install    copy headers and CMake package to PREFIX=$(PREFIX)"
	@echo "make clean      remove build/ and out/"

configure:
	@cmake -S . -B $(BUILD) -DPRT_TEST_VARIANTS=ON >$(BUILD).log 2>&1 || { cat $(BUILD).log; exit 1; }
	@rm -f $(BUILD).log

test:
	@./deps.sh test
	@$(MAKE) --no-print-directory configure
	@cmake --build $(BUILD) -j$(JOBS)
	@tests/run.sh $(BUILD) -j$(JOBS)

demo:
	@./deps.sh demo
	@$(MAKE) --no-print-directory configure
	@cmake --build $(BUILD) -j$(JOBS) --target demo

bench:
	@./deps.sh bench
	@$(MAKE) --no-print-directory configure
	@cmake --build $(BUILD) -j$(JOBS) --target bench

docs:
	@./deps.sh bench
	@$(MAKE) --no-print-directory configure
	@cmake --build $(BUILD) -j$(JOBS) --target docs

gen gen-check: configure
	@cmake --build $(BUILD) -j$(JOBS) --target $@

fuzz:
	@./deps.sh fuzz
	@tests/fuzz/run.sh $(BUILD)/fuzz $(FUZZ_SECONDS)

install:
	@cmake -S . -B $(BUILD)/install-only -DPRT_BUILD_TESTS=OFF -DPRT_BUILD_EXAMPLES=OFF -DPRT_BUILD_BENCH=OFF \
	    -DCMAKE_INSTALL_PREFIX=$(PREFIX) >/dev/null
	@cmake --install $(BUILD)/install-only

clean:
	rm -rf $(BUILD) out

.PHONY: help configure test demo bench docs gen gen-check fuzz install clean
