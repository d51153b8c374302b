#!/usr/bin/env bash
# tests/stability/run.sh [DIRECTORY]: what stability.c measures, in float and in double, and as plots; with DIRECTORY the
# page is written to DIRECTORY/stability.md and the plots to DIRECTORY/plots. Exit code 1 if an error exceeds its bound.
set -u
export LC_ALL=C
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
[ $# = 0 ] || set -- "$(mkdir -p "$1/plots" && cd "$1" && pwd)"
work=$(mktemp -d) && trap 'rm -rf "$work"' EXIT
flags="-O3 -march=native"
failed=0
for precision in float double; do
    define=; [ $precision = double ] && define=-DPRT_DOUBLE
    for most in 64 1024; do
        # shellcheck disable=SC2086
        if ! ${CC:-cc} -std=c99 $flags -DPRT_STATIC -DPRT_MAX_BANDS=$most $define -I"$root" "$here/stability.c" \
                -o "$work/stability" -lm 2>"$work/errors"; then
            echo "stability: does not build: $(grep -m1 error "$work/errors")" >&2; exit 1
        fi
        if [ $most = 64 ]; then "$work/stability" || failed=1; else "$work/stability" bands || failed=1; fi
    done >"$work/$precision"
done
[ -s "$work/float" ] && [ -s "$work/double" ] || { echo "stability: nothing was measured" >&2; exit 1; }
cd "$work" || exit 1
for precision in float double; do
    grep ^drift $precision | tr '|' ' ' >drift.$precision
    grep ^chain $precision | tr '|' ' ' >chain.$precision
done

plots() {   # DIRECTORY
    command -v gnuplot >/dev/null || { echo "stability: no plots: gnuplot is not installed" >&2; return 1; }
    gnuplot <<END
set terminal svg size 960,460 font ",13"
set grid
set output "$1/stability-drift.svg"
set logscale xy
set format y "10^{%L}"
set xlabel "turns"
set ylabel "lost orthogonality, relative"
set key outside right center Left reverse maxrows 6
set yrange [1e-17:1]
plot "drift.float" using 2:3 with linespoints title "vector, float", \
     "drift.float" using 2:4 with linespoints title "scaled every 1000", \
     "drift.float" using 2:5 with linespoints title "matrix, float", \
     "drift.float" using 2:6 with linespoints title "Gram-Schmidt every 1000", \
     "drift.double" using 2:3 with linespoints title "vector, double", \
     "drift.double" using 2:5 with linespoints title "matrix, double"
set output "$1/stability-masks.svg"
unset logscale x
set yrange [1e-6:100]
set xrange [1:64]
set xlabel "masks by one hemisphere, 3 bands"
set ylabel "norm of the light, 1 before"
plot "chain.float" using 2:3 with lines lw 2 title "no window", \
     "chain.float" using 2:4 with lines lw 2 title "Hann on light and filter", \
     "chain.float" using 2:5 with lines lw 2 title "positive window on the filter", \
     "chain.double" using 2:3 with lines dt 2 lc rgb "#000000" title "double (the same)", \
     "chain.double" using 2:4 with lines dt 2 lc rgb "#000000" notitle, \
     "chain.double" using 2:5 with lines dt 2 lc rgb "#000000" notitle, \
     sqrt(0.5) with lines dt 3 title "exact: sqrt(1/2)"
END
}

table() {   # SECTION
    printf '| | error, float | allowed | error, double | allowed |\n|---|--:|--:|--:|--:|\n'
    paste -d'|' <(grep "^case|$1|" float) <(grep "^case|$1|" double) |
        awk -F'|' '{ printf "| %s | %s | %s | %s | %s |\n", $3, $4, $5, $9, $10 }'
}
at() { awk -v k="$2" -v c="$3" '$2 == k { printf "%.2g", $c }' "$1"; }

report() {
    cat <<END
# Stability at the extremes

Written by \`make stability\`, on $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1), $(${CC:-cc} --version | head -n 1), \`$flags\`.
Each figure is the worst of its comparisons, beside what arithmetic allows there: \`tests/extremes.h\` says why it is so much, and
\`tests/test_extremes.c\` asserts every one, in all builds that \`make test\` makes. What other machines do: [portability.md](portability.md).

## Directions beside the poles

Relative errors of Y(l,0) and Y(l,±1), which is linear in the tilt; all other values vanish with its square.

$(table "Directions beside the poles")

## Many bands

Σ_m Y(l,m)² = (2l+1)/4π, relative, worst band, from a pole to the equator. \`tests/test_sh_high.c\` compares single values with MPFR.

$(table "Many bands")

## Radiance from subnormal to huge

Maps, rotation, convolution, irradiance, window and product at this radiance, over it, against radiance 1, relative to the sum of sizes.
Below 1e-38 a float has fewer digits, in steps of 1.4e-45; maps are floats in both builds. At 1e38 the irradiance itself, about
5e38, is more than a float holds: it becomes infinity, and is left out.

$(table "Radiance from subnormal to huge")

## A million rotations

The norm of each band of a vector of 5 bands that is turned in place again and again, and |R Rᵀ - 1| of a matrix that collects turns,
R ← Q R. Drift is in proportion to the turns, since the same rounding of the same turn goes the same way every time.

$(table "A million rotations")

![Drift against the number of turns](plots/stability-drift.svg)

What putting it right costs, ns a turn:

| | float | double |
|---|--:|--:|
$(paste -d'|' <(grep ^cost float) <(grep ^cost double) | awk -F'|' '{ printf "| %s | %s | %s |\n", $2, $3, $6 }')

Turns that are kept as a matrix or quaternion, put right now and then, and applied to the original vector do not drift at all.

## Chains of masks

Masks 1 to 64 by the same hemisphere at 3 bands. Exact masking leaves √½ of the norm, however often. Without a window the
chain grows, to $(at chain.float 64 3) at 64 masks; with Hann on both factors, as published, it fades to $(at chain.float 64 4); with the
positive window on the filter alone it can only fall, here to $(at chain.float 64 5). Float and double agree: it is the truncation that
does this, not rounding. The table has what exceeds 1 there. More in [masks.md](masks.md).

$(table "Chains of masks")

![Norm against masks](plots/stability-masks.svg)

## Bakes of one ray and of a million

A wall hides half of the sky: error of the first four coefficients of transfer against the closed form.

$(table "Bakes of one ray and of a million")

## Lights around the receiver

Share of the directions that meet a sphere (\`prt_sh_sphere\`), against (1 - cos)/2.

$(table "Lights around the receiver")

## Scenes of any size, anywhere

Against the same scene of size 1 at the origin. A place 64 or 1000 sizes from the origin is known to so many eps of a
size, and so is the result.

$(table "Scenes of any size, anywhere")
END
}
report >page
if [ $# -gt 0 ]; then
    plots "$1/plots"
    cp page "$1/stability.md" || exit 1
else
    cat page
fi
exit $failed
