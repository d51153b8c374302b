#!/usr/bin/env bash
# Linking, symbols, macros: what the headers add to a program beyond what it asked for is nothing.
source "$(dirname "$0")/tap.sh"
cd "$work" || exit 1
here=$tests/compile
has_bake=; [ -e "$root/prt_bake.h" ] && has_bake=1

build() { local cc=$1; shift; $cc $warnings -I"$root" -O1 "$@" -lm; }
language() { case $1 in *++*) echo c++ ;; *) echo c ;; esac; }

# ---- several files in one program ----
two_files() {   # C compiler for the implementation, compiler for the other file
    build "$1" -x "$(language "$1")" -c "$here/units.c" -o one.o -DUNIT_IMPLEMENTATION -DUNIT_MAIN_TWO_FILES &&
    build "$2" -x "$(language "$2")" -c "$here/units.c" -o two.o -DUNIT_SECOND &&
    "$1" one.o two.o -o two_files -lm && [ "$(./two_files)" = "0.630783 0.630783" ]
}
check "two files, one implementation: C and C" two_files gcc gcc
check "two files, one implementation: C++ and C++" two_files g++ g++
check "two files, one implementation: C++ implements, C uses" two_files g++ gcc
check "two files, one implementation: C implements, C++ uses" two_files gcc g++
two_implementations() {   # each header implemented in a file of its own, used by a third; what each defines is its own
    local cc=$1 x; x=$(language "$1")
    printf '#define PRT_IMPLEMENTATION\n#include "prt.h"\n' >run_time.c
    printf '#define PRT_BAKE_IMPLEMENTATION\n#include "prt_bake.h"\n' >baker.c
    sed '/IMPLEMENTATION/d' "$work/bake_example.c" >user.c
    for file in run_time baker user; do build "$cc" -O0 -x "$x" -c $file.c -o $file.o || return; done
    $cc run_time.o baker.o user.o -o two -lm && [ "$(./two)" = "under the ball 0.75, beside it 0.96" ]
}
awk '/^   A COMPLETE EXAMPLE/ { inside = 1; next } /^   [A-Z]/ { inside = 0 } inside' "$root/prt_bake.h" >bake_example.c
check "each header implemented in its own file: C" two_implementations gcc
check "each header implemented in its own file: C++" two_implementations "g++ -Wno-missing-field-initializers"
both_precisions() {
    local cc=$1 x; x=$(language "$1")
    build "$cc" -x "$x" -c "$here/units.c" -o f.o -DPRT_STATIC -DUNIT_NAMES_PRECISION &&
    build "$cc" -x "$x" -c "$here/units.c" -o d.o -DPRT_STATIC -DUNIT_NAMES_PRECISION -DPRT_DOUBLE &&
    build "$cc" -x "$x" -c "$here/units.c" -o m.o -DPRT_STATIC -DUNIT_MAIN_BOTH_PRECISIONS &&
    "$cc" f.o d.o m.o -o both -lm && [ "$(./both)" = "0.630783 0.630783 12 24 different" ]
}
check "both precisions in one program (PRT_STATIC): C" both_precisions gcc
check "both precisions in one program (PRT_STATIC): C++" both_precisions g++

# ---- overridden macros ----
limits() { build gcc -std=c99 "$here/limits.c" -o limits "$@" && ./limits; }
for bands in 1 3 5 7 10 11 1024; do
    check "PRT_MAX_BANDS=$bands, float" limits -DPRT_MAX_BANDS=$bands -DPRT_STATIC
    check "PRT_MAX_BANDS=$bands, double" limits -DPRT_MAX_BANDS=$bands -DPRT_STATIC -DPRT_DOUBLE
done
for bands in 1 3 1024; do   # every function compiled, with the warnings that need the optimiser
    check "PRT_MAX_BANDS=$bands, PRT_NO_SIMD, optimised" limits -DPRT_MAX_BANDS=$bands -DPRT_NO_SIMD -O2
done
for bands in 1 2; do        # fewer coefficients than a vector has lanes
    check "PRT_MAX_BANDS=$bands, optimised" limits -DPRT_MAX_BANDS=$bands -O2
done

check "PRT_MAX_BANDS=5, optimised little" limits -DPRT_MAX_BANDS=5 -O1
refused() {   # MESSAGE compiler flags: the first complaint is this one
    local message=$1; shift
    [[ $(gcc -std=c99 -fsyntax-only -I"$root" -x c "$@" baker.c 2>&1 | grep -m1 error) == *"$message"* ]]
}
for bands in 0 -1 1025 many; do
    check "PRT_MAX_BANDS=$bands is refused" refused "PRT_MAX_BANDS must be" -DPRT_MAX_BANDS=$bands
done
check "PRT_STATIC without PRT_IMPLEMENTATION is refused" refused "define PRT_IMPLEMENTATION too" -DPRT_STATIC
check "PRT_NO_CH" limits -DPRT_NO_CH -O2
check "PRT_NO_CH, double, static" limits -DPRT_NO_CH -DPRT_DOUBLE -DPRT_STATIC

implementation() { # FILE: the source that holds everything
    printf '#define PRT_IMPLEMENTATION\n#define PRT_BAKE_IMPLEMENTATION\n#include "prt.h"\n'
    [ -n "$has_bake" ] && printf '#include "prt_bake.h"\n'
}
implementation >all.c
sed '/IMPLEMENTATION/d' all.c >declarations.c
printf '#define PRT_IMPLEMENTATION\n#include "prt.h"\n' >prt.c

# Functions that the headers declare, from their text with comments removed.
declared=$(for header in prt.h ${has_bake:+prt_bake.h}; do
        sed '/interface ends here/,$d' "$root/$header"
    done | gcc -fpreprocessed -dD -E -P -x c - 2>/dev/null | grep -v '^ *#' | tr '\n' ' ' |
    grep -oE 'PRTDEF [^;{]*' | sed -E 's/^[^(]*[ *](prt_[a-z0-9_]+) *\(.*/\1/' | sort)
check_empty "every declaration starts with a prt_ name" "$(printf '%s\n' "$declared" | grep -v '^prt_[a-z]')"
check_empty "no function is declared twice" "$(printf '%s\n' "$declared" | uniq -d)"

exported() {   # compiler flags...: the shared library's functions
    "$@" -shared -fPIC -fvisibility=hidden -I"$root" '-DPRTDEF=__attribute__((visibility("default")))' all.c -o all.so -lm &&
    nm -D --defined-only all.so | awk '$2 == "T" { print $3 }' | sort
}
check "PRTDEF overridden: a library exports what is declared, nothing else (C)" \
    diff <(printf '%s\n' "$declared") <(exported gcc)
check "PRTDEF overridden: a library exports what is declared, nothing else (C++)" \
    diff <(printf '%s\n' "$declared") <(exported g++ -x c++)

library='^(sqrt|sin|cos|sincos|tan|asin|acos|atan|atan2|exp|log|pow|hypot|floor|ceil|fabs|fmod|ldexp|frexp|fmin|fmax|fma|cbrt|expm1|log1p|copysign|scalbn|nearbyint|rint|lrint)f?$|^(memcpy|memset|memmove|memcmp|memchr|strlen|strcmp|strncmp|strchr|__stack_chk_fail)$'
undefined() { nm -u "$@" | awk '{ print $2 }' | grep -vE "$library" | grep -v '^_ZSt'; }   # C++ has its own pow(double, int)
for configuration in "gcc" "gcc -DPRT_DOUBLE" "g++" "clang" "clang++ -DPRT_DOUBLE"; do
    read -r cc precision <<<"$configuration"
    if ! have "$cc"; then skip "$cc: symbols" "$cc not found"; continue; fi
    x=$(language "$cc")
    level=-O1; [[ $cc == clang* ]] && level=-O0      # half the time, the same symbols
    rm -f ./*.o
    object() { local out=$1; shift; $cc -x "$x" -c -I"$root" -fno-pic $level $precision "$@" -o "$out"; }
    check "$configuration: compiles" eval 'object declarations.o declarations.c && object all.o all.c &&
        object static.o -DPRT_STATIC all.c'
    check "$configuration: defines what is declared, nothing else" \
        diff <(printf '%s\n' "$declared") <(nm -g --defined-only all.o | awk '{ print $3 }' | grep -v '^_ZSt' | sort)
    check_empty "$configuration: no symbol without PRT_IMPLEMENTATION" "$(nm declarations.o)"
    check_empty "$configuration: no external symbol with PRT_STATIC" "$(nm -g --defined-only static.o | grep -v ' _ZSt')"
    check_empty "$configuration: no writable data" "$(nm all.o | grep -E ' [BbCDdSs] ')"
    check_empty "$configuration: needs the C library's mathematics, memcpy and the like, malloc and free, nothing else" \
        "$(undefined all.o | grep -vxE 'malloc|free')"
done
check "prt.h alone: compiles" gcc -c -I"$root" -fno-pic -O1 prt.c -o prt.o
check_empty "prt.h alone: no malloc, no free" "$(undefined prt.o)"

# ---- macros ----
leaked() {   # FILE LANGUAGE: macros that a file has after the includes, less those of the standard headers it includes
    local x=$2
    grep -hE '^# *include <' "$root/prt.h" ${has_bake:+"$root/prt_bake.h"} | sed 's/^# */#/' | sort -u >standard.c
    comm -13 <(gcc -x "$x" -dM -E standard.c | awk '{ print $2 }' | sed 's/(.*//' | sort) \
             <(gcc -x "$x" -dM -E -I"$root" "$1" | awk '{ print $2 }' | sed 's/(.*//' | sort) | grep -vE '^PRT_[A-Z0-9_]+$|^PRTDEF$|^prt__[a-z0-9_]+$'
}
for x in c c++; do
    check_empty "only PRT_ macros are left after the includes: $x, declarations" "$(leaked declarations.c $x)"
    check_empty "only PRT_ macros are left after the includes: $x, implementation" "$(leaked all.c $x)"
done
finish
