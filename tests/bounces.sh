#!/usr/bin/env bash
# A small run of examples/bounces: its page and pictures are there, bounces bring it closer to the reference, bad input is
# one clear line.
#   tests/bounces.sh path/to/bounces
set -u
export LC_ALL=C
bounces=$1
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
failures=0
fail() { echo "FAILED: $*"; failures=$((failures + 1)); }

timeout 100 "$bounces" --rays 64 --paths 32 --strips 20 --threads 2 --out "$work/out" >"$work/stdout" 2>"$work/stderr" ||
    { fail "exit $?"; cat "$work/stderr"; }
for file in bounce.md gallery/bounce.jpg gallery/glossy.jpg; do [ -s "$work/out/$file" ] || fail "no $file"; done
grep -q 'nan\|inf' "$work/out/bounce.md" && fail "the page has figures that are none"
for scene in shapes room; do
    awk -v scene="$scene" '$1 == scene && $3 == "bounces:" { e[$2] = $5 } END { exit !(e[0] > e[1] && e[1] > e[3]) }' \
        "$work/stdout" || fail "$scene: more bounces are not closer"
done

for bad in "--rays 0" "--paths x" "--strips" "--nonsense" "--environment /nowhere.hdr" "--out"; do
    # shellcheck disable=SC2086
    timeout 20 "$bounces" $bad >/dev/null 2>"$work/stderr"
    [ $? = 1 ] || fail "bounces $bad: exit is not 1"
    [ "$(wc -l <"$work/stderr")" = 1 ] && grep -q '^bounces: ' "$work/stderr" || fail "bounces $bad: not one line"
done
[ $failures = 0 ] && echo "bounces: all well"
exit $((failures > 0))
