#!/usr/bin/env bash
# Bad input to examples/relight: one clear line each, a non-zero exit where nothing sensible can be done, nothing lost.
#   tests/relight_bad_input.sh path/to/relight
set -u
export LC_ALL=C
relight=$1
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
failures=0 cases=0 user=()

fail() { echo "FAILED: $*"; sed 's/^/    /' stderr; failures=$((failures + 1)); }

# run STATUS PATTERN ARGUMENT...: relight must exit so, and write to stderr a line that matches. An error is one line,
# beside notices, and no run takes longer than 20 seconds.
run() {
    local status=$1 pattern=$2 got
    shift 2
    cases=$((cases + 1))
    timeout 20 "${user[@]}" "$relight" --size 16 --rays 16 --threads 2 "$@" >stdout 2>stderr
    got=$?
    sed -i '/^relight: bake .*%,/d' stderr
    if [ $got != "$status" ]; then fail "exit $got, not $status: relight $*"; return; fi
    if [ "$pattern" ] && ! grep -q -- "$pattern" stderr; then fail "no line matches '$pattern': relight $*"; return; fi
    sed -i '/: note: /d' stderr
    if [ "$status" = 1 ] && { [ "$(wc -l <stderr)" != 1 ] || ! grep -q '^relight: ' stderr; }; then
        fail "not one line: relight $*"
    fi
}
error()  { run 1 "$@"; }
works()  { run 0 "$@"; }

# ---- meshes and environments, good and bad ----
tetrahedron='v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 1'
faces='f 1 3 2
f 1 2 4
f 1 4 3
f 2 3 4'
printf '%s\n' "$tetrahedron" "$faces" >good.obj
printf '%s\n' "$tetrahedron" >faceless.obj
printf 'ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0 0\n1 0 0\n' >points.ply
printf '%s\n' 'v nan 0 0' "$tetrahedron" 'f 1 2 3' "$faces" >nan.obj
printf '%s\n' 'v inf 0 0' "$tetrahedron" 'f 1 2 3' "$faces" >inf.obj
printf '%s\n' "$tetrahedron" 'vn 0 0 0' 'f 1//1 3//1 2//1' 'f 1//1 2//1 4//1' 'f 1//1 4//1 3//1' >zero_normals.obj
printf '%s\n' "$tetrahedron" 'v 2 0 0' "$faces" 'f 1 2 2' 'f 1 2 5' >degenerate.obj
printf '%s\n' 'v 1 2 3' 'v 1 2 3' 'v 1 2 3' 'f 1 2 3' >one_place.obj
printf 'this is no mesh\n' >text.obj
printf 'this is no mesh\n' >text.xyzzy
: >empty.obj
printf 'ply\nformat binary_little_endian 1.0\nelement vertex 100\nproperty float x\nproperty float y\nproperty float z\nelement face 100\nproperty list uchar int vertex_indices\nend_header\n\0\0\0' >truncated.ply
printf '{"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attr' >truncated.gltf
printf 'ply\nformat ascii 1.0\nelement vertex 3\nprope' >header.ply
printf 'ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n' >truncated_text.ply
printf 'MM\0\100\1\0=' >truncated.3ds

# pfm NAME BYTES: 8 x 4 pixels; the first value as printf escapes, little-endian, the rest 1.0
pfm() {
    printf 'PF\n8 4\n-1.0\n' >"$1"
    printf '%b' "$2" >>"$1"
    for _ in $(seq 95); do printf '\0\0\200\077'; done >>"$1"
}
pfm good.pfm '\0\0\0200\077'
pfm nan.pfm  '\0\0\0300\0177'
pfm inf.pfm  '\0\0\0200\0177'
pfm minus.pfm '\0\0\0200\0277'
{ printf 'PF\n8 4\n-1.0\n'; head -c 384 /dev/zero; } >black.pfm
head -c 200 good.pfm >truncated.pfm
printf 'PF\n100000 100000\n-1.0\n' >huge.pfm
printf 'PF\n-8 4\n-1.0\n' >negative_size.pfm
printf 'Pf\n8 4\n-1.0\n' >grey.pfm
header='#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n'
# one scanline of 8: 2 2 0 8, then four runs of 8; twice
scanline='\2\2\0\10\210\200\210\200\210\200\210\201'
printf "$header-Y 2 +X 8\n$scanline$scanline" >good.hdr
printf "$header-Y 2 +X 8\n$scanline\2\2\0\10\210\200" >truncated.hdr
printf "$header-Y 2 +X 8\n$scanline\2\2\0\10\210\200\210\200\210\200\210" >almost.hdr
printf "$header-Y 2 +X 8\n$scanline\2\2\0\10\377\200\210\200\210\200\210\201" >overrun.hdr
printf "$header-Y 32768 +X 32767\n$scanline" >huge.hdr
printf "$header-Y 2 +X 0\n" >no_width.hdr
printf "$header-Y -2 +X -8\n" >negative_size.hdr
printf "$header" >no_size.hdr
printf '#?RADIANCE' >cut_in_header.hdr
printf 'no picture\n' >text.hdr
: >empty.hdr

# ---- what is fine ----
works ''                                        good.obj good.pfm good.hdr
works 'note: 4 vertex normals were missing'     good.obj good.pfm
works 'note: 4 vertex normals were missing'     zero_normals.obj good.pfm
works 'note: 2 triangles have no area: kept'    degenerate.obj good.pfm
works 'nan.pfm: note: 1 values were not numbers' good.obj nan.pfm
works 'inf.pfm: note: 1 values were infinite'   good.obj inf.pfm
works 'minus.pfm: note: 1 values were negative' good.obj minus.pfm
works 'black.pfm: note: the environment is all black' good.obj black.pfm
run 0 '' --help

# ---- meshes ----
error 'missing.obj: cannot be read as a mesh'   missing.obj good.pfm
error 'empty.obj: cannot be read as a mesh'     empty.obj good.pfm
error 'text.obj: '                              text.obj good.pfm
error 'text.xyzzy: cannot be read as a mesh'    text.xyzzy good.pfm
error 'truncated.ply: cannot be read as a mesh' truncated.ply good.pfm
error 'header.ply: cannot be read as a mesh'    header.ply good.pfm
error 'truncated_text.ply: cannot be read as a mesh' truncated_text.ply good.pfm
error 'truncated.gltf: cannot be read as a mesh' truncated.gltf good.pfm
error 'truncated.3ds: '                         truncated.3ds good.pfm
error 'faceless.obj: '                          faceless.obj good.pfm
error 'points.ply: '                            points.ply good.pfm
error 'nan.obj: has a vertex whose position is not finite' nan.obj good.pfm
error 'inf.obj: has a vertex whose position is not finite' inf.obj good.pfm
error 'all vertices of the mesh lie in one place' one_place.obj good.pfm

# ---- environments ----
error 'missing.hdr: cannot be opened: No such file' good.obj missing.hdr
error 'empty.hdr: is empty'                     good.obj empty.hdr
error 'text.hdr: cannot be read as a Radiance'  good.obj text.hdr
error 'truncated.hdr: is cut short'             good.obj truncated.hdr
error 'almost.hdr: is cut short'                good.obj almost.hdr
error 'overrun.hdr: is damaged'                 good.obj overrun.hdr
error 'huge.hdr: claims 32767 x 32768 pixels'   good.obj huge.hdr
error 'no_width.hdr: '                          good.obj no_width.hdr
error 'negative_size.hdr: '                     good.obj negative_size.hdr
error 'no_size.hdr: cannot be read'             good.obj no_size.hdr
error 'cut_in_header.hdr: cannot be read'       good.obj cut_in_header.hdr
error 'truncated.pfm: is cut short'             good.obj truncated.pfm
error 'huge.pfm: claims 100000 x 100000 pixels' good.obj huge.pfm
error 'negative_size.pfm: claims -8 x 4 pixels' good.obj negative_size.pfm
error 'grey.pfm: '                              good.obj grey.pfm
mkdir directory.hdr
error 'directory.hdr: is empty or cannot be read' good.obj directory.hdr

# ---- the command line ----
error '--bands 65: must be a whole number from 1 to 64' good.obj --bands 65
error '--bands 0: must be'                      good.obj --bands 0
error '--bands 5x: must be'                     good.obj --bands 5x
error '--bands 99999999999999999999: must be'   good.obj --bands 99999999999999999999
error '--rays 0: must be'                       good.obj --rays 0
error '--bounces -1: must be'                   good.obj --bounces -1
error '--threads -1: must be'                   good.obj --threads -1
error '--bands wants a number'                  good.obj --bands
error '--out wants a directory'                 good.obj --out
error '--wrong: no such option'                 good.obj --wrong
error 'second.obj: a second mesh beside good.obj' good.obj second.obj

# ---- places that cannot be written ----
error '/proc/relight: cannot be made a directory' good.obj good.pfm --out /proc/relight
error 'good.obj: cannot be made a directory: Not a directory' good.obj good.pfm --out good.obj
mkdir locked && chmod 555 locked
chmod 755 .
as_nobody=(setpriv --reuid=65534 --regid=65534 --clear-groups)
if [ "$(id -u)" = 0 ] && "${as_nobody[@]}" test -x "$relight" -a -r good.obj 2>/dev/null; then user=("${as_nobody[@]}"); fi
if [ ! -w locked ] || [ ${#user[@]} != 0 ]; then
    error 'locked/good.prt: cannot be created: Permission denied' good.obj good.pfm --out locked
else
    echo "skipped: a directory without write permission (this user may write everywhere)"
fi
user=()

# ---- a full disk: the old file stays as it was ----
works '' good.obj good.pfm --out full
cp full/good.prt before.prt
cases=$((cases + 1))
(ulimit -f 1 && "$relight" --size 16 --rays 17 --bands 64 good.obj good.pfm --out full) >stdout 2>stderr
[ $? = 1 ] && [ "$(wc -l <stderr)" -ge 1 ] && grep -q 'full/good.prt: there is no room for its' stderr || fail 'disk full'
cmp -s full/good.prt before.prt || fail 'disk full: the old file was changed'
[ "$(ls full)" = $'good-good.png\ngood.prt' ] || fail "disk full: left something behind: $(ls full)"

# ---- a disk that is really full: a file system of 256 KiB, where this user may mount one ----
export relight
on_small_disk() {   # COMMAND: with an empty small disk at ./disk
    mkdir -p disk
    unshare --mount --map-root-user bash -c 'mount -t tmpfs -o size=256k small disk || exit 99; '"$1" >stdout 2>stderr
}
fails_saying() {    # STATUS PATTERN
    cases=$((cases + 1))
    sed -i '/^relight: bake .*%,/d; /: note: /d' stderr
    [ "$1" = 1 ] && [ "$(wc -l <stderr)" = 1 ] && grep -q -- "$2" stderr || fail "exit $1, or no line matches '$2'"
}
if on_small_disk true; then
    on_small_disk '"$relight" --size 16 --rays 16 good.obj good.pfm --out disk && cp disk/good.prt before.prt || exit 98
        cat /dev/zero >disk/fill 2>/dev/null
        "$relight" --size 16 --rays 16 --bands 64 good.obj good.pfm --out disk; status=$?
        cmp disk/good.prt before.prt && [ "$(ls disk)" = "fill
good-good.png
good.prt" ] && exit $status'
    fails_saying $? 'disk/good.prt: there is no room for its'
    on_small_disk 'cat /dev/zero >disk/fill 2>/dev/null; truncate -s -8192 disk/fill
        "$relight" --size 300 --rays 16 good.obj minus.pfm --out disk; status=$?; ls disk >&1; exit $status'
    fails_saying $? 'disk/good-minus.png: '
    grep -q png stdout && fail 'disk full: left half a picture behind'
    # Fills up between the first checkpoint and the end, which is minutes away: what is baked is kept elsewhere.
    mkdir elsewhere
    awk 'BEGIN { for (y = 0; y < 40; y++) for (x = 0; x < 40; x++) print "v", x, (x * y) % 3, y
        for (y = 0; y < 39; y++) for (x = 1; x < 40; x++) print "f", 40*y+x, 40*y+x+1, 40*y+x+40 }' >grid.obj
    on_small_disk 'TMPDIR=$PWD/elsewhere "$relight" --size 16 --bands 2 --rays 1000000 --threads 1 --checkpoint 1 grid.obj good.pfm --out disk & pid=$!
        for _ in $(seq 400); do [ -s disk/grid.prt ] && break; sleep 0.05; done
        cp disk/grid.prt before.prt; cat /dev/zero >disk/fill 2>/dev/null
        kill -INT $pid; wait $pid; status=$?; cmp disk/grid.prt before.prt && exit $status'
    status=$?
    sed -i '/No space left on device$/d' stderr              # of a second checkpoint, if it came to that
    fails_saying $status 'disk/grid.prt: cannot be written: No space left on device; what is baked is in .*/elsewhere/relight-.*/grid.prt'
else
    echo "skipped: a full disk (this user may not mount one)"
fi

# ---- transfer that does not fit ----
works ''                                        good.obj good.pfm --resume
error 'good.prt: was baked with 5 bands, not 4' good.obj good.pfm --resume --bands 4
error 'good.prt: was baked with 16 rays, not 8' good.obj good.pfm --resume --rays 8
error 'good.prt: was baked with seed 0, not 3'  good.obj good.pfm --resume --seed 3
cp good.obj other.obj && printf 'v 2 2 2\nf 2 3 5\n' >>other.obj && cp out/good.prt out/other.prt
error 'other.prt: was baked for another mesh'   other.obj good.pfm --resume
error 'absent/good.prt: cannot be opened'       good.obj good.pfm --resume --out absent
head -c 300 full/good.prt >out/good.prt
error 'good.prt: ends too early'                good.obj good.pfm --resume
head -c 300 full/good.prt | tr '\0' '\1' >out/good.prt
error 'good.prt: '                              good.obj good.pfm --resume
echo text >out/good.prt
error 'good.prt: ends too early'                good.obj good.pfm --resume

echo "$cases cases, $failures failed"
[ $failures = 0 ]
