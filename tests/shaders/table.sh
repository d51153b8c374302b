#!/usr/bin/env bash
# table.sh PRT_CODEGEN: the table of docs/shaders.md names every function of prt.h and every kernel, and nothing else. TAP.
set -u
codegen=$1
cd "$(dirname "$0")/../.." || exit 1
page=docs/shaders.md
rows() { grep '^| .*|$' $page | sed -n '/^| \*\*basis/,$p'; }
names() { grep -oE '`[a-z0-9_]+`' | tr -d '\`' | sort -u; }
functions=$(grep -E '^PRTDEF ' prt.h | grep -oE '\bprt_[a-z0-9_]+ *\(' | tr -d ' (' | grep -v __ | sort -u)
kernels=$("$codegen" --list | awk 'NR > 1 { print $1 }' | sort -u)
count=0 failed=0
same() { # same NAME WANTED GOT
    local difference
    count=$((count + 1))
    difference=$(comm -3 <(printf '%s\n' "$2") <(printf '%s\n' "$3") | tr -d '\t' | tr '\n' ' ')
    if [ -n "$2" ] && [ -z "$difference" ]; then echo "ok $count - $1"
    else failed=1; echo "not ok $count - $1: $difference"; fi
}
same "$page: a row for every function of prt.h" "$functions" "$(rows | cut -d'|' -f2 | names)"
same "$page: a place for every kernel" "$kernels" "$(rows | cut -d'|' -f3 | names | grep -vxE 'step|low')"
echo "1..$count"
exit $failed
