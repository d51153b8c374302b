#!/usr/bin/env bash
# examples/fiv_tables and fiv_scene at their smallest: pages, pictures and figures come out, frames resume after an
# interrupt, bad input is one clear line and a non-zero exit.
#   tests/fiv_programs.sh path/to/fiv_tables path/to/fiv_scene
set -u
export LC_ALL=C
tables=$1 scene=$2
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
die() { echo "FAILED: $*"; cat stderr 2>/dev/null; exit 1; }

# Two balls with dents, closed.
for n in 3 7; do
    awk -v n=$n 'BEGIN { pi = atan2(0, -1)
        for (i = 0; i <= 16; i++) for (j = 0; j < 32; j++) {
            t = pi * i / 16; p = 2 * pi * j / 32; r = 1 + 0.2 * sin(n * t) * cos(n * p)
            print "v", r * sin(t) * cos(p), r * cos(t), -r * sin(t) * sin(p) }
        for (i = 0; i < 16; i++) for (j = 0; j < 32; j++) {
            a = i * 32 + j + 1; b = i * 32 + (j + 1) % 32 + 1
            print "f", a, a + 32, b + 32; print "f", a, b + 32, b } }' >ball$n.obj
done
balls=(--meshes ball3.obj ball7.obj)

error() {                              # error PATTERN PROGRAM ARGUMENT...
    local pattern=$1
    shift
    timeout 20 "$@" >stdout 2>stderr && die "no error: $*"
    [ "$(wc -l <stderr)" = 1 ] && grep -q -- "$pattern" stderr || die "not one line with '$pattern': $*"
}
error '--wrong: not understood'                "$tables" --wrong
error 'absent.obj: cannot be read as a mesh'   "$tables" --quick --meshes absent.obj ball3.obj
error '/proc/x: cannot be made a directory'    "$tables" --quick --out /proc/x
error '--frames 0: must be a whole number'     "$scene" --frames 0
error '--size wants a number'                  "$scene" --size
error '--meshes wants two files'               "$scene" --meshes ball3.obj
error '--wrong: no such option'                "$scene" --wrong
error 'absent.hdr: cannot be opened'           "$scene" "${balls[@]}" absent.hdr
error 'absent.obj: cannot be read as a mesh'   "$scene" --meshes absent.obj ball3.obj

timeout 100 "$tables" --quick "${balls[@]}" --out docs >stdout 2>stderr || die "fiv_tables --quick"
for word in 'Table 1' 'Table 2' 'Figures 12 to 17' 'what is filled'; do
    grep -q "$word" docs/fiv.md || die "docs/fiv.md has no '$word'"
done
grep -qi 'nan\|inf |' docs/fiv.md && die "docs/fiv.md has a figure that is no number"

small=(--quick --size 32 --rays 4 --frames 3 "${balls[@]}")
timeout 60 "$scene" "${small[@]}" --out whole >stdout 2>stderr || die "fiv_scene"
[ "$(wc -l <whole/fiv-scene.csv)" = 4 ] || die "fiv-scene.csv has not 3 frames"
awk -F, 'NR > 1 && !($2 > 0 && $2 < 0.2) { exit 1 }' whole/fiv-scene.csv || die "an NRMSE is not between 0 and .2"
if command -v img2webp >/dev/null; then
    [ -s whole/fiv-scene.webp ] || die "no animation"
else
    grep -q 'note: no animation' stderr || die "no animation and no note"
    echo "skipped: the animation (img2webp is not installed)"
fi
cp -r whole part && rm part/fiv-scene-001.png
timeout 60 "$scene" "${small[@]}" --out part --resume >stdout 2>stderr || die "fiv_scene --resume"
[ -s part/fiv-scene-001.png ] && [ "$(wc -l <part/fiv-scene.csv)" = 5 ] || die "--resume did not make the missing frame"
cmp -s whole/fiv-scene-000.png part/fiv-scene-000.png || die "--resume changed a frame that was there"
echo "ok: fiv_tables, fiv_scene"
