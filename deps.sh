#!/usr/bin/env bash
# Installs what the examples, tests and benchmarks need; the headers themselves need nothing.
#   ./deps.sh [demo] [test] [bench] [fuzz]     the groups wanted, all when none is named
#   ./deps.sh --list [group ...]               only prints the packages of the groups
# Whatever is already there, from Debian's packages or from elsewhere, is left alone. With apt and root (or sudo without
# a password) the rest is installed; otherwise one line says what to install. Exit code 1: something necessary is missing.
set -u
cache=$(cd "$(dirname "$0")" && pwd)/.cache

list=0
[ "${1:-}" = --list ] && { list=1; shift; }
groups=" ${*:-demo test bench fuzz} "
for group in $groups; do
    case $group in
        demo|test|bench|fuzz) ;;
        *) echo "deps.sh: no group '$group'; the groups are: demo test bench fuzz" >&2; exit 2 ;;
    esac
done

cmd() { command -v "$1" >/dev/null 2>&1; }
pc()  { pkg-config --exists "$@" 2>/dev/null; }
hdr() { printf '#include <%s>\n' "$1" | cc -E -x c - >/dev/null 2>&1; }
lavapipe() { compgen -G '/usr/share/vulkan/icd.d/lvp_icd*' >/dev/null; }
fuzzer() { printf 'int LLVMFuzzerTestOneInput(const char *d, unsigned long n) { return d && n > 9; }\n' |
           clang -fsanitize=fuzzer,address,undefined -x c - -o /dev/null >/dev/null 2>&1; }

missing=() optional=()
# need GROUPS PACKAGE PROBE...: the package is necessary for these groups unless the probe succeeds.
# want ...: the same, but those groups can do without (they skip what uses it and say so).
wanted() { local group; for group in $1; do [[ $groups == *" $group "* ]] && return 0; done; return 1; }
need() { local in=$1 package=$2; shift 2; wanted "$in" || return 0; [ $list = 0 ] && "$@" || missing+=("$package"); }
want() { local in=$1 package=$2; shift 2; wanted "$in" || return 0; [ $list = 0 ] && "$@" || optional+=("$package"); }

# The test libraries for 32-bit x86, unpacked into .cache/i386: as packages they would need a second architecture enabled
# on the whole system. Only downloads from the distribution's own archive; the 32-bit tests are skipped without it.
libraries_for_32_bit() {
    wanted test && [ ! -e "$cache/i386/usr/include/mpfr.h" ] && cmd i686-linux-gnu-gcc && cmd apt-get && cmd dpkg-deb || return 0
    echo "deps.sh: unpacking the 32-bit test libraries into .cache/i386"
    local work; work=$(mktemp -d) || return 0
    (
        set -e
        cd "$work"; mkdir -p state/lists/partial cache/archives/partial root; touch state/status
        apt=(apt-get -qq -o APT::Architecture=i386 -o APT::Architectures::=i386 -o Dir::State="$work/state"
             -o Dir::State::status="$work/state/status" -o Dir::Cache="$work/cache" -o APT::Sandbox::User=)
        "${apt[@]}" update || true
        "${apt[@]}" download libcmocka-dev libcmocka0 libmpfr-dev libgmp-dev
        for package in *.deb; do dpkg-deb -x "$package" root; done
        mkdir -p "$cache"; rm -rf "$cache/i386"; mv root "$cache/i386"
    ) >/dev/null 2>&1 || echo "deps.sh: they are not to be had; the 32-bit tests will be skipped" >&2
    rm -rf "$work"
}

# naga, which checks WGSL, is a package of npm, of one version; the WGSL tests are skipped without it.
naga() {
    wanted test && [ ! -e "$cache/npm/node_modules/naga-wasm" ] && cmd npm || return 0
    echo "deps.sh: installing naga-wasm into .cache/npm"
    mkdir -p "$cache/npm" && npm install --silent --no-save --prefix "$cache/npm" naga-wasm@30.1.0 >/dev/null 2>&1 ||
        echo "deps.sh: naga-wasm is not to be had; the WGSL tests will be skipped" >&2
}

every="demo test bench fuzz"
need "$every"     gcc                      cmd cc
need "$every"     g++                      cmd c++
need "$every"     libc6-dev                hdr math.h
need "$every"     make                     cmd make
need "$every"     cmake                    cmd cmake
need "$every"     pkg-config               cmd pkg-config
need "demo"       libembree-dev            hdr embree3/rtcore.h
need "demo"       libassimp-dev            hdr assimp/scene.h
need "demo"       libosmesa6-dev           hdr GL/osmesa.h
need "demo"       libstb-dev               hdr stb/stb_image.h
need "demo"       libcglm-dev              hdr cglm/cglm.h
need "demo"       fonts-dejavu-core        test -f /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf
need "demo"       glmark2-data             test -d /usr/share/glmark2/models
want "demo test"  webp                     cmd img2webp
need "test"       libcmocka-dev            pc cmocka
need "test bench" libmpfr-dev              hdr mpfr.h
want "test bench" libembree-dev            hdr embree3/rtcore.h
want "test"       libassimp-dev            hdr assimp/scene.h
want "test"       libosmesa6-dev           hdr GL/osmesa.h
want "test bench" libstb-dev               hdr stb/stb_image.h
want "test"       libcglm-dev              hdr cglm/cglm.h
want "test fuzz"  clang                    cmd clang
want "test fuzz"  libclang-rt-dev          fuzzer
want "test"       gcc-i686-linux-gnu       cmd i686-linux-gnu-gcc
want "test"       libc6-i386               test -e /lib/ld-linux.so.2
need "bench"      python3                  cmd python3
want "test bench" valgrind                 hdr valgrind/callgrind.h
want "bench"      gnuplot-nox              cmd gnuplot

want "test"       glslang-tools            cmd glslangValidator
want "test"       glslc                    cmd glslc
want "test"       spirv-tools              cmd spirv-val
want "test"       spirv-cross              cmd spirv-cross
want "test"       npm                      cmd npm
want "test"       libvulkan-dev            hdr vulkan/vulkan.h
want "test"       mesa-vulkan-drivers      lavapipe
want "test"       chromium                 cmd chromium

read -ra packages <<<"$(printf '%s\n' "${missing[@]}" "${optional[@]}" | sort -u | tr '\n' ' ')"
if [ $list = 1 ]; then printf '%s\n' "${packages[@]}"; exit 0; fi
if [ ${#packages[@]} = 0 ]; then libraries_for_32_bit; naga; exit 0; fi

root=()
if [ "$(id -u)" != 0 ]; then root=(sudo -n); fi
if cmd apt-get && { [ "$(id -u)" = 0 ] || sudo -n true 2>/dev/null; }; then
    echo "deps.sh: installing ${packages[*]}"
    export DEBIAN_FRONTEND=noninteractive
    install=("${root[@]}" apt-get install -y --no-install-recommends "${packages[@]}")
    "${install[@]}" >/dev/null 2>&1 || { "${root[@]}" apt-get update >/dev/null && "${install[@]}" >/dev/null; } &&
        { libraries_for_32_bit; naga; exit 0; }
    echo "deps.sh: apt-get could not install: ${packages[*]}" >&2
else
    echo "deps.sh: please install (Debian's names): ${packages[*]}" >&2
fi
[ ${#missing[@]} = 0 ]
