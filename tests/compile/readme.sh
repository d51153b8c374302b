#!/usr/bin/env bash
# The examples that users see are what they say: the program in README.md and those in the opening comments of the headers
# compile, in C and C++, and the README's prints what its comment promises.
source "$(dirname "$0")/tap.sh"
cd "$work" || exit 1

awk '/^```c$/ { inside = 1; next } /^```$/ { inside = 0 } inside' "$root/README.md" >readme.c
comment_example() {   # HEADER: the indented program after A COMPLETE EXAMPLE, up to the next heading
    awk '/^   A COMPLETE EXAMPLE/ { inside = 1; next } /^   [A-Z]/ { inside = 0 } inside' "$root/$1" | sed 's/^     //'
}
comment_example prt.h >prt.c
comment_example prt_bake.h >bake.c

promised=$(sed -n 's@.*/\* prints \([^*]*[^ *]\) *\*/.*@\1@p' readme.c)
check "README.md has one program and says what it prints" test -n "$promised"
check "README.md: the program is 15 lines or shorter" test "$(wc -l <readme.c)" -le 15
for precision in "" -DPRT_DOUBLE; do
    check "README.md: C99${precision:+ $precision}" gcc -std=c99 -Wall -Wextra -Wpedantic -Werror $precision -I"$root" readme.c -o readme -lm
    check "README.md prints $promised${precision:+ $precision}" test "$(./readme)" = "$promised"
done
check "README.md: C++11" g++ -std=c++11 -Wall -Werror -I"$root" -x c++ readme.c -o readme -lm
for header in prt bake; do
    check "the example in the opening comment compiles: $header" gcc -std=c99 -Wall -Wextra -Werror -I"$root" $header.c -o $header -lm
    check "the example in the opening comment runs: $header" ./$header
done
for command in $(awk '/^```sh$/ { inside = 1; next } /^```$/ { inside = 0 } inside && $1 == "make" { print $2 }' "$root/README.md"); do
    check "README.md: make $command is a target" grep -q "^$command:" "$root/Makefile"
done
finish
