#!/usr/bin/env bash
# A bake of examples/relight that was interrupted and resumed equals one that was not, byte for byte; a killed one leaves
# the old file as it was, or its last checkpoint, from which --resume goes on.
#   tests/relight_resume.sh path/to/relight
set -u
relight=$1
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
die() { echo "FAILED: $*"; cat log 2>/dev/null; exit 1; }

# A ball of 60 x 120 vertices with dents, so that some rays are blocked.
awk 'BEGIN { pi = atan2(0, -1)
    for (i = 0; i <= 60; i++) for (j = 0; j < 120; j++) {
        t = pi * i / 60; p = 2 * pi * j / 120; r = 1 + 0.15 * sin(6 * t) * cos(5 * p)
        print "v", r * sin(t) * cos(p), r * cos(t), r * sin(t) * sin(p) }
    for (i = 0; i < 60; i++) for (j = 0; j < 120; j++) {
        a = i * 120 + j + 1; b = i * 120 + (j + 1) % 120 + 1
        print "f", a, b, b + 120; print "f", a, b + 120, a + 120 } }' >ball.obj
{ printf 'PF\n8 4\n-1.0\n'; for _ in $(seq 96); do printf '\0\0\200\077'; done; } >white.pfm

# Interrupts a bake after a while; more rays where it was too quick for that.
rays=256
for attempt in 1 2 3 4 5 6; do
    rm -rf parts
    "$relight" ball.obj white.pfm --size 64 --rays $rays --threads 2 --out parts >log 2>&1 &
    pid=$!
    while kill -0 $pid 2>/dev/null && ! ls parts 2>/dev/null | grep -q .; do sleep 0.05; [ -d parts ] && break; done
    sleep 0.4
    kill -INT $pid 2>/dev/null
    wait $pid
    status=$?
    [ $status = 130 ] && grep -q 'points are baked; --resume goes on' log && ! grep -q ': 0 of' log && break
    [ $status = 0 ] || [ $status = 130 ] || die "exit $status after SIGINT"
    rays=$((rays * 3))
done
[ $status = 130 ] || die "the bake was too quick to be interrupted"
echo "interrupted at $rays rays: $(tail -1 log)"
[ -f parts/ball.prt ] || die "nothing was kept"
"$relight" ball.obj white.pfm --size 64 --rays $rays --threads 1 --out parts --resume >log 2>&1 || die "resume"
"$relight" ball.obj white.pfm --size 64 --rays $rays --threads 3 --out whole >log 2>&1 || die "uninterrupted bake"
cmp parts/ball.prt whole/ball.prt || die "resumed and uninterrupted transfer differ"
cmp parts/ball-white.png whole/ball-white.png || die "resumed and uninterrupted pictures differ"
cp whole/ball.prt parts/direct.prt
"$relight" ball.obj white.pfm --size 64 --rays $rays --threads 2 --out whole --resume --bounces 2 >log 2>&1 ||
    die "bounces"
[ "$(grep -c '^bounce [12]: adds at most 0\.[0-9]* to white$' log)" = 2 ] || die "two bounces are not two lines"
cmp whole/ball.prt parts/direct.prt || die "bounces changed the file of direct transfer"
cmp -s parts/ball-white.png whole/ball-white.png && die "bounces between dents are not seen"
echo "resumed and uninterrupted bakes agree byte for byte"

# A killed bake, over the file of an earlier one.
"$relight" ball.obj white.pfm --size 64 --rays $rays --seed 7 --threads 2 --out whole >log 2>&1 &
pid=$!
sleep 0.6
kill -KILL $pid 2>/dev/null
wait $pid 2>/dev/null
cmp parts/ball.prt whole/ball.prt || [ $? != 1 ] || { grep -q whole/ball.prt log || die "a killed bake changed the file"; }
echo "a killed bake leaves the old file alone"

# A killed bake goes on from its last checkpoint. Too long to end by itself; ended when a checkpoint is there.
endless() { "$relight" ball.obj white.pfm --size 64 --rays 200000 --threads 1 --checkpoint 1 --out killed "$@" >log 2>&1 & pid=$!; }
until_longer_than() {   # SIZE: waits for killed/ball.prt to be longer
    for _ in $(seq 600); do
        [ -s killed/ball.prt ] && [ "$(wc -c <killed/ball.prt)" -gt "$1" ] && return
        kill -0 $pid 2>/dev/null || die "the bake ended early"
        sleep 0.05
    done
    kill -KILL $pid
    die "no checkpoint within 30 s"
}
endless
until_longer_than 0
kill -KILL $pid
wait $pid 2>/dev/null
endless --resume
until_longer_than "$(wc -c <killed/ball.prt)"
kill -INT $pid
wait $pid
[ $? = 130 ] && grep -q 'points are baked; --resume goes on' log || die "exit after SIGINT"
echo "a killed bake goes on from its checkpoint: $(tail -1 log)"
