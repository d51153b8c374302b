#!/usr/bin/env bash
# compile.sh PRT_CODEGEN [NAGA_MODULES]: what it prints compiles in every dialect that it is meant for, at both precisions; bad requests
# are refused with one line. TAP on standard output.
set -u
codegen=$1 naga=${2:-}
here=$(cd "$(dirname "$0")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
count=0 failed=0
check() { # check NAME COMMAND...: succeeds
    local name=$1 output; shift
    count=$((count + 1))
    if output=$("$@" 2>&1); then echo "ok $count - $name"
    else failed=1; echo "not ok $count - $name"; printf '%s\n' "$output" | head -n 20; fi
}
refused() { # refused NAME ARGUMENTS...: exit code not 0, one line
    local name=$1 output; shift
    count=$((count + 1))
    if ! output=$("$codegen" "$@" 2>&1 >/dev/null) && [ -n "$output" ] && [ "$(printf '%s\n' "$output" | wc -l)" = 1 ]
    then echo "ok $count - refused: $name ($output)"
    else failed=1; echo "not ok $count - refused: $name"; printf '%s\n' "$output" | head -n 20; fi
}

for precision in float half; do
    for bands in 1 4 10; do
        "$codegen" --lang glsl --emit all --bands $bands --precision $precision -o "$folder/p.glsl" || exit 1
        for version in "330" "450" "300 es" "310 es"; do
            { echo "#version $version"
              case $version in *es) echo "precision highp float;" ;; esac
              cat "$folder/p.glsl"; echo "void main() {}"; } >"$folder/p.vert"
            check "GLSL $version, $precision, $bands bands" glslangValidator -S vert "$folder/p.vert"
        done
        "$codegen" --lang hlsl --emit all --bands $bands --precision $precision -o "$folder/p.hlsl" || exit 1
        echo "[numthreads(1, 1, 1)] void main() {}" >>"$folder/p.hlsl"
        if command -v glslc >/dev/null; then
            check "HLSL by glslc, $precision, $bands bands" glslc -x hlsl -fshader-stage=comp -o "$folder/p.spv" "$folder/p.hlsl"
        fi
        check "HLSL, $precision, $bands bands" glslangValidator -D -V -S comp -e main -o "$folder/p.spv" "$folder/p.hlsl"
    done
done
for bands in 1 4 10; do
    "$codegen" --lang glsl --emit all --bands $bands --precision float16 -o "$folder/p.glsl" || exit 1
    { echo "#version 450"; cat "$folder/p.glsl"; echo "void main() {}"; } >"$folder/p.vert"
    check "GLSL 450, float16, $bands bands" glslangValidator -V -S vert -o "$folder/p.spv" "$folder/p.vert"
    "$codegen" --lang hlsl --emit all --bands $bands --precision float16 -o "$folder/p.hlsl" || exit 1
    echo "[numthreads(1, 1, 1)] void main() {}" >>"$folder/p.hlsl"
    check "HLSL, float16, $bands bands" glslangValidator -D -V --hlsl-enable-16bit-types -S comp -e main -o "$folder/p.spv" "$folder/p.hlsl"
    "$codegen" --lang c --emit all --bands $bands -o "$folder/p.c" || exit 1
    for standard in c99 c11; do
        check "C, $standard, $bands bands" cc -std=$standard -Wall -Wextra -Wpedantic -Wconversion -Werror \
            -Wno-unused-function -c -o "$folder/p.o" "$folder/p.c"
    done
done
if [ -n "$naga" ]; then
    for bands in 1 4 10; do
        "$codegen" --lang wgsl --emit all --bands $bands -o "$folder/p$bands.wgsl" || exit 1
        "$codegen" --lang wgsl --emit all --bands $bands --precision half -o "$folder/h$bands.wgsl" || exit 1
    done
    check "WGSL, both precisions, 1, 4 and 10 bands" node "$here/wgsl_to_spirv.mjs" "$naga" "$folder"/*.wgsl
else
    count=$((count + 1)); echo "ok $count - WGSL # SKIP node or naga-wasm is not there"
fi
check "a range of bands" "$codegen" --lang wgsl --emit sh_eval,sh_at --bands 2-5
check "a prefix" bash -c "'$codegen' --prefix my_ --emit sh_eval | grep -q 'void my_sh_eval('"
refused "unknown kernel"         --lang glsl --emit sh_evil
refused "unknown language"       --lang cg --emit sh_eval
refused "unknown precision"      --lang c --precision double --emit sh_eval
refused "too many bands"         --lang glsl --bands 11 --emit sh_eval
refused "no bands"               --lang glsl --bands 0 --emit sh_eval
refused "words for bands"        --lang glsl --bands many --emit sh_eval
refused "a range upside down"    --lang glsl --bands 4-2 --emit sh_eval
refused "all of too many bands"  --lang glsl --bands 40 --emit all
refused "a kernel twice"         --lang glsl --emit sh_eval,sh_at,sh_eval
refused "an empty list"          --lang glsl --emit ,
refused "a prefix of digits"     --lang glsl --prefix 9lives_ --emit sh_eval
refused "nothing to print"       --lang glsl
refused "unknown option"         --lung glsl
refused "option without value"   --emit
refused "no such folder"         --emit sh_eval -o "$folder/missing/p.c"
refused "no such file to check"  --check "$folder/missing.h"
echo "1..$count"
exit $failed
