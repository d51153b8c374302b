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
form[prt]='#define PRT_IMPLEMENTATION
#include "prt.h"'
form[bake]='#define PRT_IMPLEMENTATION
#define PRT_BAKE_IMPLEMENTATION
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
    local compiler language std precision linkage simd name
    for compiler in gcc clang; do
        have $compiler || continue
        for std in c99 c11 c17 c2x c++11 c++14 c++17 c++20; do
            [ "$quick" = quick ] && [ $std != c99 ] && [ $std != c++11 ] && continue
            language=c; [[ $std == c++* ]] && language=c++
            for precision in "" -DPRT_DOUBLE; do
                for linkage in "" -DPRT_STATIC; do
                    for simd in "" -DPRT_NO_SIMD -mavx2 -mavx512f; do
                        for name in $names; do
                            # The width of vectors matters to implementations only.
                            if [ -n "$simd" ]; then
                                [[ $name == prt || $name == bake ]] || continue
                                case $simd in -m*) supports "$compiler" "$simd" || continue ;; esac
                            fi
                            # PRT_STATIC goes with PRT_IMPLEMENTATION, in every file (prt.h, CONFIG MACROS).
                            [ -n "$linkage" ] && [[ $name == *declarations ]] && continue
                            [ "$quick" = quick ] && [[ $name != prt_then_bake || -n $linkage || -n $simd ]] && continue
                            echo "$compiler $std|$compiler -std=$std $warnings -I$root $precision $linkage $simd" \
                                 "-fsyntax-only -x $language $work/$name.c"
                        done
                    done
                done
            done
        done
        [ "$quick" = quick ] && continue
        for std in c99 c2x c++11 c++20; do   # some warnings need the optimiser
            language=c; [[ $std == c++* ]] && language=c++
            for precision in "" -DPRT_DOUBLE; do
                for simd in "" -DPRT_NO_SIMD -mavx2 -mavx512f; do
                    case $simd in -m*) supports "$compiler" "$simd" || continue ;; esac
                    name=prt; [ -e "$root/prt_bake.h" ] && name=prt_then_bake
                    echo "$compiler $std optimised|$compiler -std=$std $warnings -I$root $precision $simd" \
                         "-O2 -c -o /dev/null -x $language $work/$name.c"
                done
            done
        done
    done
}
supports() { "$1" "$2" -x c -fsyntax-only /dev/null 2>/dev/null; }

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
