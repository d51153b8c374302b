#!/usr/bin/env bash
# examples/advise_page.sh ADVISE OUT COMPILER FLAGS [MESH ...]: runs advise on meshes under environments, and writes
# OUT/advise.md and OUT/plots/advise.svg. Without meshes: three of Debian's glmark2-data.
set -u -o pipefail
export LC_ALL=C
advise=$1 out=$2 compiler=$3 flags=$4; shift 4
models=/usr/share/glmark2/models
[ $# -gt 0 ] || set -- $models/bunny.obj $models/horse.3ds $models/cat.3ds
data=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/data
errors="--error 0.2 --error 0.1 --error 0.05 --error 0.02 --error 0.01"
work=$(mktemp -d) && trap 'rm -rf "$work"' EXIT
mkdir -p "$out/plots"

"$advise" "$1" "$data/sunset.hdr" --floor --error 0.1 --error 0.02 --plot "$out/plots/advise.svg" >"$work/first" || exit 1
for mesh in "$@"; do
    name=$(basename "${mesh%.*}")
    for light in sunset forest studio; do
        # shellcheck disable=SC2086
        "$advise" "$mesh" "$data/$light.hdr" --floor $errors --rows >"$work/one"
        status=$?
        [ $status = 0 ] || [ $status = 3 ] || exit $status
        sed -n "s/^row /| $name | $light /p" "$work/one" >>"$work/rows"
        sed -n "s/^for an error of \(.*\) %: nothing\(.*\)/- $name, $light, \1 %: nothing\2./p" "$work/one" >>"$work/nothing"
        sed -n "s/^    error .*too much; the next one/- $name, $light: &/p" "$work/one" >>"$work/again"
    done
done
moving=$models/horse.3ds
"$advise" "$1" "$data/forest.hdr" --floor --moving $moving --error 0.1 --error 0.05 --error 0.02 >"$work/moving" || [ $? = 3 ] || exit 1
"$advise" "$1" "$data/sunset.hdr" --floor --lights 8 --error 0.3 --error 0.1 --all >"$work/lights" || [ $? = 3 ] || exit 1
{
    cat <<END
# How many bands, rays and bits a scene needs

Written by \`make advise\` on $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1), $compiler, \`$flags\`.

\`examples/advise MESH ENVIRONMENT --error 0.02\` measures a scene and prints the cheapest set-up that keeps an error: *model only
what the scene requires*. An error is the root mean square error of exit radiance over vertices and colours as a share of its
mean, against ray tracing at 512 vertices chosen at random (2 x 4096 rays each, half of them by cosine and half by light, in two
independent halves, so that their noise does not count as error), with its standard error. A set-up is advised if it
keeps the error by two standard errors, and keeps it again at 512 vertices chosen anew, with other rays.

What is tried: irradiance of the normal alone (no byte a vertex), that times ambient occlusion (one byte), and transfer vectors of
1 to 10, 12, 14 and 16 bands, stored as floats, halves, 16 or 8 bits; each under 4 windows and, where rays are needed, 64, 256,
1024 and 4096 of them. *Cheap* is what takes few bytes a vertex, or with \`--by time\` little time.

## One scene

\`advise $(basename "$1") sunset.hdr --floor --error 0.1 --error 0.02\`. *Foretold* is what \`prt_measure_truncation\` and
\`prt_measure_noise\` (\`>>measure\` of prt_bake.h) say without the truth: bands left out, and noise of rays. The first
lines give the energy of light and transfer by band (\`prt_measure_energy\`), what leaving out the bands above costs under this
light and on average over all turns of it (\`prt_measure_truncation_turned\`), and the entropy of visibility
(\`prt_measure_visibility\`).

\`\`\`
$(sed "s#^$1#$(basename "$1")#" "$work/first")
\`\`\`

![Error against bytes a vertex of everything that was tried](plots/advise.svg)

## Advice for $(($# * 3)) scenes

On a round floor. The last column is the error at other vertices with other rays.

| mesh | light | error | method | bands | rays | window | stored | bytes a vertex | ns a vertex | measured, % | measured elsewhere, % |
|---|---|--:|---|--:|--:|---|---|--:|--:|--:|--:|
$(cat "$work/rows")

END
    if [ -s "$work/nothing" ]; then
        printf 'Where nothing that was tried keeps the error (%d of %d; the light holds too much beyond 16 bands):\n\n' \
            "$(wc -l <"$work/nothing")" "$(($# * 15))"
        cat "$work/nothing"
        echo
    fi
    printf 'Advice that had kept the error at the first vertices, and did not at the others, so that the next cheapest was taken: %d of %d.\n' \
        "$(wc -l <"$work/again")" "$(($(wc -l <"$work/rows") + $(wc -l <"$work/again")))"
    cat <<END

## Point lights

\`advise $(basename "$1") sunset.hdr --floor --lights 8 --error 0.3 --error 0.1\`: the same environment as 8 point lights [Debevec 2005].
Vector occluders are tried as well: the mesh cut into 1, 4, 16 and 64 of them (\`prt_vo_split\`), the strongest 1, 2, 4 and 8 kept at
each vertex, 20 bytes each, by the thesis' law of shadows and by the cap law. The truth has one ray a light, and no noise. First, how many
occluders a vertex sees (2^entropy of their form factors, \`prt_measure_entropy\`) and what keeping a few leaves out
(\`prt_measure_occluders\`); then vector occluders and, for comparison, transfer in 8 bits with 1024 rays and without window.

\`\`\`
$(grep -E '^cut into|^method|^vector occluders|^normal only|^ambient occlusion .* 1024 |^transfer .* 1024  none      8 bits|^for an error|^    error' "$work/lights")
\`\`\`

## A moving occluder

\`advise $(basename "$1") forest.hdr --floor --moving $(basename $moving) --error 0.1 --error 0.05 --error 0.02\`: another mesh of half the size
stands at eight places around the scene in turn, and shadows it. Transfer of the scene alone leaves that out; fullsphere irradiance
vectors take it off what transfer gives, from a table of 3 sizes as floats, halves or bytes. The table's size counts where bytes a
vertex are equal. ns a vertex are those of one call a vertex and occluder; \`prt_fiv_shade_n\` takes a fifth of that.

\`\`\`
$(grep -E '^method|^transfer|^for an error|^    error' "$work/moving")
\`\`\`
END
} >"$work/page"
cp "$work/page" "$out/advise.md"
