#!/usr/bin/env bash
# tests/compile/warnings.sh [quick]: the headers compile without a warning, as C99 to C23 and C++11 to C++20, in every
# configuration and order of inclusion. One check for each compiler and standard; a failing one lists its command lines.
# quick: only the oldest standards, gcc and clang, with the implementation.
source "$(dirname "$0")/tap.sh"
quick=${1:-}

declare -A form   # what a user's file may contain
form[declarations]='#include "prt.h"'
form[bake_declarations]='#include "prt_bake.h"'
form[twice]='#include "prt.h"
#include "prt_bake.h"
#include "prt.h"
#define PRT_IMPLEMENTATION
#define PRT_BAKE_IMPLEMENTATION
#include "prt_bake.h"
#include "prt.h"
#include "prt_bake.h"'
form[bake_twice]='#include "prt_bake.h"
#define PRT_IMPLEMENTATION
#define PRT_BAKE_IMPLEMENTATION
#include "prt_bake.h"'
form[prt]='#define PRT_IMPLEMENTATION
#include "prt.h"'
form[bake]='#define PRT_IMPLEMENTATION
#define PRT_BAKE_IMPLEMENTATION
#include "prt_bake.h"'
form[bake_alone]='#define PRT_BAKE_IMPLEMENTATION
#include "prt_bake.h"'
form[prt_then_bake]='#define PRT_IMPLEMENTATION
#define PRT_BAKE_IMPLEMENTATION
#include "prt.h"
#include "prt_bake.h"'
form[bake_then_prt]='#define PRT_IMPLEMENTATION
#define PRT_BAKE_IMPLEMENTATION
#include "prt_bake.h"
#include "prt.h"'
for name in "${!form[@]}"; do
    if [[ $name == *bake* || $name == twice ]] && [ ! -e "$root/prt_bake.h" ]; then continue; fi
    printf '%s\n' "${form[$name]}" >"$work/$name.c"
    names="${names:-} $name"
done

# One compile job a line: GROUP|command line
plan() {
    local compiler std
    for compiler in gcc clang; do
        have $compiler || continue
        if [ "$quick" = quick ]; then
            for std in c99 c++11; do syntax prt_then_bake "" "" ; done
            continue
        fi
        for std in c99 c2x c++11 c++20; do          # the ends of the range: every form, linkage and width
            for form in $names; do
                syntax $form "" ""
                # PRT_STATIC goes with PRT_IMPLEMENTATION, in every file (prt.h, CONFIG MACROS).
                [[ $form == *declarations || $form == bake_alone ]] || syntax $form -DPRT_STATIC ""
            done
            for simd in -DPRT_NO_SIMD -mavx2 -mavx512f; do syntax bake "" $simd; done
        done
        for std in c11 c17 c++14 c++17; do          # between them
            syntax bake_declarations "" ""
            syntax twice "" ""
            syntax bake -DPRT_STATIC ""
        done
    done
    [ "$quick" = quick ] && return
    compiler=gcc                                    # some of its warnings need the optimiser; none of clang's do
    std=c99; for simd in "" -DPRT_NO_SIMD -mavx2 -mavx512f; do optimised $simd; done
    std=c++20; for simd in "" -mavx512f; do optimised $simd; done
}
supports() { "$1" "$2" -x c -fsyntax-only /dev/null 2>/dev/null; }
language() { case $std in c++*) echo c++ ;; *) echo c ;; esac; }
line() {   # GROUP SIMD the rest of the command
    local group=$1 simd=$2 precision; shift 2
    case $simd in -m*) supports $compiler $simd || return ;; esac
    for precision in "" -DPRT_DOUBLE; do
        echo "$group|$compiler -std=$std $warnings -I$root $precision $simd $*"
    done
}
syntax() { line "$compiler $std" "$3" $2 -fsyntax-only -x "$(language)" "$work/$1.c"; }   # FORM LINKAGE SIMD
optimised() { line "$compiler $std optimised" "${1:-}" -O2 -c -o /dev/null -x "$(language)" "$work/prt_then_bake.c"; }

compile() {   # GROUP|command -> GROUP|ok or GROUP|command and its first complaint, on one line
    local group=${1%%|*} command=${1#*|} output
    if output=$($command 2>&1); then echo "$group|ok"
    else echo "$group|$command: $(printf '%s' "$output" | grep -m1 -E 'error|warning' | tr -d '|')"; fi
}
export -f compile
plan >"$work/plan"
xargs -P "$jobs" -d '\n' -n 1 bash -c 'compile "$1"' - <"$work/plan" >"$work/results"

while IFS= read -r group; do
    count=$(grep -c -F "$group|" "$work/plan")
    check_empty "$group without a warning ($count compilations)" \
        "$(grep -F "$group|" "$work/results" | grep -v '|ok$' | cut -d'|' -f2- | sed "s#$work/#form #; s#-I$root ##")"
done < <(cut -d'|' -f1 "$work/plan" | awk '!seen[$0]++')
have gcc || skip "gcc" "gcc not found"
have clang || skip "clang" "clang not found"
[ "$(wc -l <"$work/results")" = "$(wc -l <"$work/plan")" ] || not_ok "every compilation reported"
finish
