# The commands of the house. Each does its own set-up (deps.sh); everything is built under build/.
BUILD  ?= build
JOBS   ?= $(shell nproc 2>/dev/null || echo 2)
MAKEFLAGS += --no-print-directory
PREFIX ?= /usr/local
FUZZ_SECONDS ?= 60

help:
	@echo "make demo       bake and relight the Stanford bunny; pictures in out/"
	@echo "make vo         compare vector occluders with other techniques; writes docs/vo.md and its pictures"
	@echo "make bounces    measure interreflection and glossy lobes; writes docs/bounce.md and its pictures"
	@echo "make fiv        moving occluders: writes docs/fiv.md, its pictures and an animation"
	@echo "make advise     ask advise about some scenes; writes docs/advise.md"
	@echo "make test       build and run every test; ends with 'N passed, N failed'"
	@echo "make bench      time and error of every candidate, as tables and CSV"
	@echo "make gpu        time of the generated shaders on this machine's GPU (Vulkan, glslc or glslangValidator)"
	@echo "make gen        rewrite the generated blocks of the headers (gen-check: only compare)"
	@echo "make icount-update  count the instructions of the main kernels anew, for the test of that name"
	@echo "make fuzz       run each fuzz target for FUZZ_SECONDS=$(FUZZ_SECONDS)"
	@echo "make claims     measure what docs/claims.md promises, and compare"
	@echo "make docs-bench rewrite README's table and the pages of docs/ that bench/ writes, from measurements"
	@echo "make docs       the same for every page that a program writes: half an hour and more"
	@echo "make portability  run both headers on other kinds of machine, emulated; writes docs/portability.md"
	@echo "make stability  errors at the extremes, float against double; writes docs/stability.md"
	@echo "make install    copy headers and CMake package to PREFIX=$(PREFIX)"
	@echo "make clean      remove build/ and out/"

# configure DIRECTORY OPTIONS: quiet unless it fails. What needs no test library is configured without the tests.
configure = mkdir -p $(1) && { cmake -S . -B $(1) $(2) >$(1)/configure.log 2>&1 || { cat $(1)/configure.log; exit 1; }; }
without_tests = $(call configure,$(BUILD)/tools,-DPRT_BUILD_TESTS=OFF)

test:
	@./deps.sh test
	@$(call configure,$(BUILD),-DPRT_TEST_VARIANTS=ON)
	@cmake --build $(BUILD) -j$(JOBS)
	@tests/run.sh $(BUILD) -j$(JOBS)

demo:
	@./deps.sh demo
	@$(without_tests)
	@cmake --build $(BUILD)/tools -j$(JOBS) --target demo

vo:
	@./deps.sh demo bench
	@$(without_tests)
	@cmake --build $(BUILD)/tools -j$(JOBS) --target vo

bounces:
	@./deps.sh demo bench
	@$(without_tests)
	@cmake --build $(BUILD)/tools -j$(JOBS) --target bounces

advise:
	@./deps.sh demo bench
	@$(without_tests)
	@cmake --build $(BUILD)/tools -j$(JOBS) --target advise

fiv:
	@./deps.sh demo
	@$(without_tests)
	@cmake --build $(BUILD)/tools -j$(JOBS) --target fiv

bench:
	@./deps.sh bench
	@$(without_tests)
	@cmake --build $(BUILD)/tools -j$(JOBS) --target bench

claims:
	@./deps.sh demo bench
	@$(without_tests)
	@cmake --build $(BUILD)/tools -j$(JOBS) --target claims

# The pages that bench/ writes; docs has all of them. What is measured runs alone, one after the other.
docs-bench:
	@./deps.sh demo bench
	@$(without_tests)
	@cmake --build $(BUILD)/tools -j$(JOBS) --target docs

docs-shaders:
	@./deps.sh test
	@$(call configure,$(BUILD),-DPRT_TEST_VARIANTS=ON)
	@cmake --build $(BUILD) -j$(JOBS) --target shader_tables

docs:
	@for page in docs-bench bounces vo fiv advise stability portability docs-shaders; do $(MAKE) $$page || exit 1; done

gpu gen gen-check icount-update:
	@$(without_tests)
	@cmake --build $(BUILD)/tools -j$(JOBS) --target $@

fuzz:
	@./deps.sh fuzz
	@tests/fuzz/run.sh $(BUILD)/fuzz $(FUZZ_SECONDS)

stability:
	@tests/stability/run.sh docs

portability:
	@tests/portability/run.sh docs/portability.md

install:
	@cmake -S . -B $(BUILD)/install-only -DPRT_BUILD_TESTS=OFF -DPRT_BUILD_EXAMPLES=OFF -DPRT_BUILD_BENCH=OFF -DPRT_BUILD_CODEGEN=OFF \
	    -DCMAKE_INSTALL_PREFIX=$(PREFIX) >/dev/null
	@cmake --install $(BUILD)/install-only

clean:
	rm -rf $(BUILD) out

.PHONY: help test demo vo bounces fiv advise bench docs docs-bench docs-shaders gpu gen gen-check icount-update fuzz stability portability install clean
