#!/usr/bin/env bash
# tests/fuzz/run.sh DIRECTORY SECONDS: builds every fuzz_*.c in both precisions (libFuzzer, address and undefined-behaviour
# sanitizers) and runs each for SECONDS. Corpus and crashing inputs stay in DIRECTORY, and the next run goes on from there.
# A target may name further sources and flags in a comment: fuzz-flags: ...
mkdir -p "$1" && directory=$(cd "$1" && pwd) || exit 1
seconds=$2
source "$(dirname "$0")/../compile/tap.sh"
# Signed and unsigned casts of NaN are part of what is tested, so float-cast-overflow is on.
flags="-g -O0 -fsanitize=fuzzer,address,undefined,float-cast-overflow -fno-sanitize-recover=all"

fuzz() {   # SOURCE NAME FLAGS...
    local source=$1 name=$2 extra; shift 2
    extra=$(sed -n 's/.*fuzz-flags: *\([^*]*\).*/\1/p' "$source")
    # shellcheck disable=SC2086
    (cd "$root" && clang $flags "$@" -I"$root" -o "$directory/$name" "$source" $extra -lm) || return 1
    mkdir -p "$directory/$name.corpus"
    "$directory/$name" -max_total_time="$seconds" -timeout=20 -rss_limit_mb=2048 -max_len=4096 -print_final_stats=1 \
        -artifact_prefix="$directory/$name." "$directory/$name.corpus" >"$directory/$name.log" 2>&1 ||
        { grep -E -A12 'ERROR|runtime error|SUMMARY|wrote although|Test unit written' "$directory/$name.log" | head -n 40; return 1; }
}
works() { printf 'int LLVMFuzzerTestOneInput(const char *d, unsigned long n) { return d && n > 9; }\n' |
          clang -fsanitize=fuzzer,address,undefined -x c - -o "$work/probe" >/dev/null 2>&1; }
if works; then
    for source in "$tests"/fuzz/fuzz_*.c; do
        base=$(basename "$source" .c)
        for precision in float double; do
            define=; [ $precision = double ] && define=-DPRT_DOUBLE
            name=${base}_$precision
            check "$name, $seconds s" fuzz "$source" "$name" $define
            [ -f "$directory/$name.log" ] && sed -n 's/^stat::number_of_executed_units: */# inputs tried: /p' "$directory/$name.log"
        done
    done
else
    skip "fuzzing" "clang with libFuzzer not found"
fi
finish
