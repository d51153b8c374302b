#!/usr/bin/env bash
# A small run of examples/vo_compare, whole and interrupted, and bad input to it: one clear line each.
#   tests/vo_compare.sh path/to/vo_compare
set -u
export LC_ALL=C
program=$1
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
if ! command -v gnuplot >/dev/null; then echo "ok 1 - vo_compare # SKIP gnuplot not found"; exit 0; fi
failures=0
fail() { echo "FAILED: $*"; failures=$((failures + 1)); }
cat >quad.obj <<'END'
v -1 0 -1
v 1 0 -1
v 0 1 0
v 0 0 1
f 1 3 2
f 1 2 4
f 2 3 4
f 1 4 3
END
small=(--mesh quad.obj --up +y --fineness 0.2 --size 16 --rays 16 --paths 1 --directions 2 --threads 2)

bad() {
    local pattern=$1; shift
    timeout 20 "$program" "${small[@]}" "$@" >stdout 2>stderr && fail "no error: $*"
    sed -i '/%,/d' stderr
    [ "$(wc -l <stderr)" = 1 ] && grep -q "^vo_compare: .*$pattern" stderr || { fail "no line '$pattern': $*"; cat stderr; }
}
bad usage --rays 0
bad usage --rays
bad usage --nonsense 1
bad usage --up w
bad 'nowhere.obj' --mesh nowhere.obj
bad 'nowhere.hdr' --environment nowhere.hdr
bad 'cannot be made a directory' --out quad.obj/out
bad 'cannot be made a directory' --keep nowhere/at/all

timeout 60 "$program" "${small[@]}" --out first --keep kept >stdout 2>stderr || { fail "the small run"; tail -3 stderr; }
for file in vo.md gallery/vo.jpg gallery/vo-shining.jpg gallery/vo-laws.jpg plots/vo-laws.svg plots/vo-decay.svg plots/vo-error.svg; do
    [ -s "first/$file" ] || fail "$file was not written"
done
grep -qwi 'nan\|inf' first/vo.md && fail "a figure of the page is not finite"
[ "$(ls kept/*.paths | wc -l)" -ge 10 ] || fail "references were not kept"

# Taken up again: the same errors, and no reference is traced.
timeout 60 "$program" "${small[@]}" --out second --keep kept >stdout 2>stderr || fail "the second run"
grep -q '^reference: shapes' stderr && fail "a kept reference was traced again"
errors() { sed -n '/^## Error by number/,/^## Figure/p' "$1"; }
[ "$(errors first/vo.md)" = "$(errors second/vo.md)" ] || fail "figures differ from the kept reference's"

# Stopped in the reference, either way: a message, status 130, a file that the next run takes up.
for signal in INT TERM; do
    rm -rf kept
    "$program" "${small[@]}" --size 200 --paths 4096 --out third --keep kept >stdout 2>stderr & pid=$!
    for _ in $(seq 100); do ls kept/*.paths >/dev/null 2>&1 && break; grep -q '^reference' stderr && break; sleep 0.1; done
    sleep 1
    kill -$signal $pid 2>/dev/null
    wait $pid
    [ $? = 130 ] || fail "a run that SIG$signal stops ends with status 130"
    grep -q '^vo_compare: .*interrupted' stderr || { fail "a run that SIG$signal stops says so"; tail -2 stderr; }
    ls kept/*.paths >/dev/null 2>&1 || fail "a run that SIG$signal stops keeps what it has"
done

[ $failures = 0 ] && echo "vo_compare: bad input, small runs, interruption: passed"
exit $((failures > 0))
