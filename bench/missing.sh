#!/usr/bin/env bash
# Names the public functions of a header that no line of the benchmark's table calls; exit 1 if there are any.
#   missing.sh prt.h candidates.h
set -u
header=$1 table=$2 missing=0 count=0
for name in $(sed '/The interface ends here/q' "$header" | sed -nE 's/^PRTDEF .*[ *](prt_[a-z0-9_]+) *\(.*/\1/p' | sort -u); do
    count=$((count + 1))
    grep -qE "(^|[^a-z0-9_])$name *\(" "$table" && continue
    missing=$((missing + 1))
    echo "missing: $name has no row in ${table##*/}: add one line, whose head tells how"
done
[ "$count" -gt 0 ] || { echo "missing: $header declares nothing that begins with PRTDEF"; exit 1; }
[ "$missing" = 0 ] && echo "missing: none of $count functions"
exit $((missing > 0))
