#!/usr/bin/env bash
# Guards the main kernels against slowing down unnoticed: counts their instructions (callgrind: exact, no timing) and
# compares them with those committed for the same compiler. Fewer than committed fails too: otherwise what is gained
# once can be lost later without a word.
#   icount.sh PROGRAM COMPILER CSV            exit 0 as committed, 1 not, 77 cannot tell (no valgrind, other compiler)
#   icount.sh PROGRAM COMPILER CSV --update   replaces the counts of this compiler in CSV
set -u
program=$1 compiler=$2 csv=$3 update=${4:-}
tolerance=2   # percent
command -v valgrind >/dev/null || { echo "icount: skipped, valgrind is not installed"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
(cd "$work" && valgrind --tool=callgrind --dump-instr=no --callgrind-out-file=out "$program") >"$work/log" 2>&1 ||
    { echo "icount: valgrind failed:"; tail -n 5 "$work/log"; exit 1; }
# one dump for each kernel, with its name and its sum
awk '/^desc: Trigger: Client Request: / { name = $5 } /^(summary|totals): / && name != "" { print name "," $2; name = "" }' \
    "$work"/out.* | sort -u >"$work/now"
[ -s "$work/now" ] || { echo "icount: no counts came out of valgrind"; tail -n 5 "$work/log"; exit 1; }

if [ "$update" = --update ]; then
    { echo "compiler,kernel,instructions"
      { [ -f "$csv" ] && awk -F, -v c="$compiler" 'NR > 1 && $1 != c' "$csv"; sed "s/^/$compiler,/" "$work/now"; } | sort
    } >"$work/new" && cp "$work/new" "$csv" && echo "icount: wrote $(wc -l <"$work/now") counts of $compiler to $csv"
    exit
fi
awk -F, -v c="$compiler" '$1 == c { print $2 "," $3 }' "$csv" 2>/dev/null >"$work/then"
[ -s "$work/then" ] ||
    { echo "icount: skipped, $csv has no counts of $compiler (make icount-update adds them)"; exit 77; }
awk -F, -v t="$tolerance" '
    NR == FNR { then[$1] = $2; next }
    !($1 in then) { printf "  %-28s %8d, not in the list\n", $1, $2; faster = 1; next }
    { percent = 100 * ($2 - then[$1]) / then[$1]
      mark = percent > t ? "  SLOWER" : percent < -t ? "  FASTER" : ""
      if (percent > t) slower = 1; else if (percent < -t) faster = 1
      printf "  %-28s %8d, was %8d (%+.1f %%)%s\n", $1, $2, then[$1], percent, mark }
    END {
      if (slower) print "icount: instructions grew by more than " t " %."
      if (faster || slower) print "icount: if that is meant, make icount-update, and commit bench/icount.csv"
      else print "icount: fine"
      exit slower || faster }' "$work/then" "$work/now"
