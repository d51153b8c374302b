#!/usr/bin/env bash
# A small run of examples/advise, whole and interrupted, and bad input to it: one clear line each.
#   tests/advise.sh path/to/advise
set -u
export LC_ALL=C
program=$1
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
failures=0
fail() { echo "FAILED: $*"; failures=$((failures + 1)); }

# Two planes that face each other, 21 x 21 vertices each: half of the sky is hidden, differently everywhere.
awk 'BEGIN { n = 21; for (s = 0; s < 2; s++) for (y = 0; y < n; y++) for (x = 0; x < n; x++) print "v", x / n, 0.4 * s, y / n
    for (s = 0; s < 2; s++) for (y = 0; y < n - 1; y++) for (x = 1; x < n; x++) { k = s * n * n + y * n + x
        if (s) { print "f", k, k + 1, k + n; print "f", k + 1, k + n + 1, k + n }
        else { print "f", k, k + n, k + 1; print "f", k + 1, k + n, k + n + 1 } } }' >planes.obj
# A map of 64 x 32: 1, and 16 in a patch of 8 x 8 texels above the horizon.
awk 'BEGIN { printf "PF\n64 32\n-1.0\n"
    for (y = 0; y < 32; y++) for (x = 0; x < 64; x++) for (c = 0; c < 3; c++)
        printf("%c%c%c%c", 0, 0, 128, (y >= 20 && y < 28 && x >= 8 && x < 16) ? 65 : 63) }' >map.pfm
{ printf 'PF\n64 32\n-1.0\n'; head -c 24576 /dev/zero; } >black.pfm
head -c 200 map.pfm >truncated.pfm
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\n' >faceless.obj
printf 'v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >nan.obj
printf 'no mesh\n' >text.obj

bad() {
    local pattern=$1; shift
    timeout 20 "$program" "$@" >stdout 2>stderr
    [ $? = 1 ] || fail "exit code is not 1: $*"
    sed -i '/%,/d' stderr
    [ "$(wc -l <stderr)" = 1 ] && grep -q -- "^advise: .*$pattern" stderr || { fail "no line '$pattern': $*"; cat stderr; }
}
bad 'wants a mesh and an environment'           planes.obj
bad 'missing.obj: cannot be read as a mesh'     missing.obj map.pfm
bad 'text.obj: '                                text.obj map.pfm
bad 'faceless.obj: '                            faceless.obj map.pfm
bad 'nan.obj: has a vertex whose position'      nan.obj map.pfm
bad 'missing.hdr: cannot be opened'             planes.obj missing.hdr
bad 'truncated.pfm: is cut short'               planes.obj truncated.pfm
bad 'black: the environment is black'           planes.obj black.pfm
bad '--error 0: must be a number above 0'       planes.obj map.pfm --error 0
bad '--error nan: must be'                      planes.obj map.pfm --error nan
bad '--error 2%: must be'                       planes.obj map.pfm --error 2%
bad '--error wants a number'                    planes.obj map.pfm --error
bad '--by wants bytes or time'                  planes.obj map.pfm --by money
bad '--check 1: must be a whole number'         planes.obj map.pfm --check 1
bad '--rays 63: must be'                        planes.obj map.pfm --rays 63
bad '--moving and --lights: one at a time'      planes.obj map.pfm --moving planes.obj --lights 2
bad 'missing.obj: cannot be read as a mesh'     planes.obj map.pfm --moving missing.obj
bad '--lights 65: must be'                      planes.obj map.pfm --lights 65
bad '--threads x: must be'                      planes.obj map.pfm --threads x
bad '--csv wants a file'                        planes.obj map.pfm --csv
bad '--wrong: no such option'                   planes.obj map.pfm --wrong
bad 'extra: a third file'                       planes.obj map.pfm extra
bad 'nowhere/at/all.csv'                        planes.obj map.pfm --check 16 --rays 64 --csv nowhere/at/all.csv
bad 'must end in .svg or .png'                  planes.obj map.pfm --check 16 --rays 64 --plot plot.gif

# A small run: advice that keeps a loose error, none for an error that nothing keeps.
timeout 60 "$program" planes.obj map.pfm --check 64 --rays 256 --threads 2 --error 0.3 --csv all.csv >stdout 2>stderr
[ $? = 0 ] || { fail "the small run"; tail -3 stderr; }
grep -q '^for an error of 30 %: .* bytes and .* ns a vertex' stdout || fail "no advice"
grep -q '^transmissive: no material' stdout || fail "opaque material"
[ "$(grep -c '^cut into .* occluders: a vertex sees' stdout)" -ge 3 ] || fail "no occluders counted"
grep -qwi 'nan\|inf' stdout all.csv && fail "a figure is not finite"
[ "$(wc -l <all.csv)" -gt 100 ] || fail "few rows in all.csv"
# What bands cost is foretold: with most rays and from 4 to 10 bands within a tenth or half a percent of the mean.
awk -F, '$1 == "transfer" && $2 >= 4 && $2 <= 10 && $3 == 256 && $4 == "none" && $5 == "float" { n++; d = $8 - $10; if (d < 0) d = -d
         if (!(d <= 0.1 * $8 + 3 * $9 + 0.005)) bad++ } END { exit !(n >= 7 && !bad) }' all.csv || fail "foretold errors are off"
timeout 60 "$program" planes.obj map.pfm --check 64 --rays 64 --error 0.00001 >stdout 2>stderr
[ $? = 3 ] || fail "exit code where nothing keeps the error"
grep -q 'nothing that was tried; the least error was' stdout || fail "says that nothing keeps the error"
# A pane of glass: one face of the file's two.
printf 'newmtl glass\nd 0.25\nnewmtl wall\nd 1\n' >panes.mtl
printf 'mtllib panes.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nusemtl glass\nf 1 2 3\nusemtl wall\nf 1 2 4\n' >panes.obj
timeout 60 "$program" panes.obj map.pfm --check 16 --rays 64 --error 1 >stdout 2>stderr
grep -q '^transmissive: 1 faces' stdout || fail "transmissive material"
# Point lights: vector occluders are tried, too.
timeout 60 "$program" planes.obj map.pfm --lights 3 --check 64 --rays 64 --error 1 --csv lights.csv >stdout 2>stderr
[ $? = 0 ] || { fail "the run with lights"; tail -3 stderr; }
[ "$(grep -c '^vector occluders,' lights.csv)" -ge 20 ] || fail "vector occluders were not tried"
grep -qwi 'nan\|inf' stdout lights.csv && fail "a figure of the run with lights is not finite"
# A moving occluder: its shadow, taken off what transfer gives, lessens the error.
timeout 60 "$program" planes.obj map.pfm --moving planes.obj --check 64 --rays 64 --error 1 --csv moving.csv >stdout 2>stderr
[ $? = 0 ] || { fail "the run with a moving mesh"; tail -3 stderr; }
awk -F, '$2 == 10 && $3 == 64 && $4 == "none" && $5 == "float" { if ($1 == "transfer") without = $8
         if ($1 == "transfer and FIV" && (!with || $8 < with)) with = $8 } END { exit !(with > 0 && with < without) }' moving.csv ||
    fail "irradiance vectors do not lessen the error"
if command -v gnuplot >/dev/null; then
    timeout 60 "$program" planes.obj map.pfm --check 16 --rays 64 --error 1 --plot plot.svg >stdout 2>stderr || fail "plot"
    grep -q '</svg>' plot.svg || fail "no plot"
fi

# Interrupted: exit code 130 and a line that says so.
"$program" planes.obj map.pfm --check 65536 --threads 1 >stdout 2>stderr & pid=$!
sleep 1
kill -INT $pid 2>/dev/null
wait $pid
[ $? = 130 ] || fail "exit code of an interrupted run"
grep -q '^advise: interrupted' stderr || fail "an interrupted run says so"

[ $failures = 0 ] && echo "advise: bad input, small runs, interruption: passed"
exit $((failures > 0))
