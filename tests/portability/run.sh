#!/usr/bin/env bash
# tests/portability/run.sh [FILE.md]: portable.c on every other kind of machine that compilers and emulators here can stand
# in for, compared with a double build of this one; with FILE.md the tables are written there. Exit code 1 if an error is
# larger than promised. What is not installed is left out, and named; on Debian: qemu-user gcc-aarch64-linux-gnu
# libc6-dev-arm64-cross gcc-s390x-linux-gnu libc6-dev-s390x-cross gcc-mingw-w64-x86-64 wine wine64 wasi-libc lld nodejs
# libclang-rt-14-dev-wasm32 tcc musl-tools gcc-i686-linux-gnu libc6-dev-i386-cross clang
set -u
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
work=$(mktemp -d) && trap 'rm -rf "$work"' EXIT
export WINEDEBUG=-all

cat >"$work/wasi.mjs" <<'END'
import { readFileSync } from "node:fs"; import { WASI } from "node:wasi"; import { argv } from "node:process";
const wasi = new WASI({ version: "preview1", args: argv.slice(2), returnOnExit: true });
const module = await WebAssembly.compile(readFileSync(argv[2]));
process.exitCode = wasi.start(await WebAssembly.instantiate(module, wasi.getImportObject()));
END
wasm="clang --target=wasm32-wasi -Wl,-z,stack-size=4194304"
node="node --no-warnings $work/wasi.mjs"

# NAME|COMPILER|FLAGS|RUNNER
platforms="x86-64, gcc|gcc||
x86-64, gcc, AVX-512|gcc|-march=x86-64-v4|
x86-64, clang|clang||
x86-64, tcc|tcc||
x86-64, gcc, musl|musl-gcc|-static|
x86 32 bit, SSE2|i686-linux-gnu-gcc|-msse2 -mfpmath=sse -static|
x86 32 bit, x87, -O0|i686-linux-gnu-gcc|-mno-sse -mfpmath=387 -static -O0|
AArch64|aarch64-linux-gnu-gcc|-static|qemu-aarch64
s390x (big-endian)|s390x-linux-gnu-gcc|-static|qemu-s390x
s390x, vectors, gnu99|s390x-linux-gnu-gcc|-march=z14 -static -std=gnu99|qemu-s390x -cpu max
Windows x86-64, MinGW|x86_64-w64-mingw32-gcc||wine
WebAssembly|$wasm||$node
WebAssembly, SIMD|$wasm|-msimd128|$node"

build() {   # COMPILER OUTPUT FLAGS...: optimised, where the compiler can
    local compiler=$1 output=$2; shift 2
    # shellcheck disable=SC2086
    $compiler -std=c99 -O1 -DPRT_STATIC "$@" -I"$root" "$here/portable.c" -o "$output" -lm >"$work/build" 2>&1
}
plain="-DPRT_NO_SIMD -ffp-contract=off"
if ! build gcc "$work/reference" -DPRT_DOUBLE $plain || ! "$work/reference" write >"$work/expected"; then
    echo "portability: the reference does not build or run here:" >&2; head -n 3 "$work/build" >&2; exit 1
fi
for precision in float double; do   # whose bits others are compared with
    define=; [ $precision = double ] && define=-DPRT_DOUBLE
    build gcc "$work/plain" $plain $define && "$work/plain" check <"$work/expected" >"$work/bits.$precision"
done

usable() {   # COMPILER RUNNER
    command -v "${1%% *}" >/dev/null && { [ -z "$2" ] || command -v "${2%% *}" >/dev/null; }
}
# Worst share of what is promised, and which operation it is: of a table that `portable check` printed
worst() { awk -F'|' '{ share = $4 > 0 ? $3 / $4 : $3 > 0 ? 1e9 : 0 } share >= most { most = share; name = $1 }
                     END { printf "%.2f (%s)", most, name }' "$1"; }
same() { awk -F'|' 'NR == FNR { bits[$1] = $5; next } bits[$1] == $5 { n++ } END { printf "%d of %d", n, FNR }' "$1" "$2"; }
differing() { awk -F'|' 'NR == FNR { bits[$1] = $5; next } bits[$1] != $5 { print $1 }' "$1" "$2"; }

failed=0 left_out=
: >"$work/rows"; : >"$work/differ"
count=$(wc -l <<<"$platforms") index=0
while IFS='|' read -r name compiler flags runner; do
    index=$((index + 1))
    [ -t 2 ] && printf '\r[%d/%d] %-30s' $index "$count" "$name" >&2
    if ! usable "$compiler" "$runner" || { [[ $flags == *x86-64-v4* ]] && ! grep -qw avx512f /proc/cpuinfo; }; then
        left_out="$left_out; $name"; continue
    fi
    row="$name"
    for precision in float double; do
        define=; [ $precision = double ] && define=-DPRT_DOUBLE
        program=$work/program; [ "$runner" = wine ] && program=$work/program.exe
        for mode in default plain; do
            options=$flags; [ $mode = plain ] && options="$flags $plain"
            [ "$compiler" = tcc ] && options=${options/-ffp-contract=off/}
            # shellcheck disable=SC2086
            if ! build "$compiler" "$program" $options $define; then
                echo "portability: $name does not build: $(grep -m1 -E 'error|cannot' "$work/build")" >&2
                failed=1; row="$row | does not build"; continue
            fi
            # shellcheck disable=SC2086
            $runner "$program" check <"$work/expected" 2>"$work/errors" | tr -d '\r' >"$work/table"
            status=${PIPESTATUS[0]}
            if [ "$(wc -l <"$work/table")" != "$(wc -l <"$work/bits.$precision")" ]; then
                echo "portability: $name does not run: $(head -n 1 "$work/errors")" >&2
                failed=1; row="$row | does not run"; continue
            fi
            if [ "$status" != 0 ]; then
                failed=1
                echo "portability: $name, $precision, $mode: larger errors than promised: $(awk -F'|' '!($3 <= $4) { printf "%s %s, ", $1, $3 }' "$work/table")" >&2
            fi
            if [ $mode = default ]; then row="$row | $(worst "$work/table")"
            else
                row="$row | $(same "$work/bits.$precision" "$work/table")"
                differing "$work/bits.$precision" "$work/table" | sed "s/^/$precision|/" >>"$work/differ"
            fi
        done
    done
    echo "| $row |" >>"$work/rows"
done <<<"$platforms"
[ -t 2 ] && printf '\r%60s\r' "" >&2

report() {
    cat <<END
# The same results on other machines

Written by \`make portability\`, on $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1), $(gcc --version | head -n 1);
machines of other kinds are emulated (QEMU, Wine, Node.js). $(wc -l <"$work/bits.float") operations of both headers run on inputs that every
machine holds exactly. *Error*: the largest error against a double build of x86-64, as a share of what the headers promise
for it, at the compiler's default flags with -O1. *Bit-identical*: operations all of whose results have the same bits as on
x86-64, with \`PRT_NO_SIMD\` and \`-ffp-contract=off\`.

| machine | error, float | bit-identical, float | error, double | bit-identical, double |
|---|---|---|---|---|
$(cat "$work/rows")

Not bit-identical everywhere, and on how many of the machines above: $(sort "$work/differ" | uniq -c | sort -rn |
    awk '{ n = $1; sub(/^ *[0-9]+ /, ""); split($0, part, "|"); printf "%s%s (%s, %d)", sep, part[2], part[1], n; sep = "; " }').
What differs there: the C library's sine, cosine, exponential and logarithm, and wider intermediate results (the x87; s390x
in strict C99, where expressions of float are evaluated in double).

| operation | results | error, float | promised | error, double | promised |
|---|--:|--:|--:|--:|--:|
$(paste -d'|' "$work/bits.float" "$work/bits.double" | awk -F'|' '{ printf "| %s | %s | %s | %s | %s | %s |\n", $1, $2, $3, $4, $8, $9 }')
END
    [ -z "$left_out" ] || printf '\nNot installed where this was written:%s.\n' "${left_out#;}"
}
report >"$work/report"
if [ $# -gt 0 ]; then cp "$work/report" "$1" || exit 1; else cat "$work/report"; fi
exit $failed
