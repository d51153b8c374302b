#!/usr/bin/env bash
# What keeps the tree honest: links lead somewhere, licences are complete, the headers' own maps are true, generated text is
# what its generator prints, and no file tells of the machine that it was made on.
# honest.sh [prt_codegen]: with the generator's program, the generated blocks are compared too.
source "$(dirname "$0")/tap.sh"
cd "$root" || exit 1
codegen=${1:-}
if git rev-parse --git-dir >/dev/null 2>&1; then mapfile -t files < <(git ls-files | while read -r f; do [ -f "$f" ] && echo "$f"; done)
else mapfile -t files < <(find . -type f -not -path './build*' -not -path './.cache/*' -not -path './out/*' | sed 's#^\./##'); fi
text=(); for file in "${files[@]}"; do grep -Iq . "$file" 2>/dev/null && text+=("$file"); done

# ---- documents ----
broken_links() {
    local file target
    for file in "${files[@]}"; do
        [[ $file == *.md ]] || continue
        grep -oE '\]\([^)]+\)' "$file" | sed -E 's/^\]\(//; s/\)$//; s/ ".*"$//' | while read -r target; do
            case $target in http://*|https://*|mailto:*|'#'*) continue ;; esac
            [ -e "$(dirname "$file")/${target%%#*}" ] || echo "$file: $target"
        done
    done
}
check_empty "every link in a document leads to a file" "$(broken_links)"
check_empty "every document in docs/ is reachable from README.md or another document" "$(
    for file in docs/*.md; do
        grep -lq "$(basename "$file")" README.md CONTRIBUTING.md $(ls docs/*.md | grep -vx "$file") || echo "$file"
    done)"

# ---- licence ----
for header in prt.h prt_bake.h; do
    check "$header ends with both licences, as in LICENSE" diff LICENSE <(tail -n $(($(wc -l <LICENSE) + 1)) $header | sed '$d')
    check "$header: line 1 names version and licences" bash -c "head -n 1 $header | grep -qF \"$header - v$(sed -n 's/^#define PRT_VERSION "\(.*\)"/\1/p' prt.h) - \" && head -n 1 $header | grep -q 'MIT or Unlicense'"
done

# ---- the header's own map ----
check_empty "prt.h: the map names every room, and every room of the map exists" "$(
    diff <(grep -oE '^     >>[a-z]+' prt.h | tr -d ' ' | sort -u) <(grep -E '^/\* -+ >>[a-z]+ -+' prt.h | grep -oE '>>[a-z]+' | sort -u))"

# ---- nothing of the machine, nothing left over ----
check_empty "no absolute path of somebody's machine" "$(grep -nE '(^|[^A-Za-z0-9_.$}/])/(home|Users|root|work|mnt|build)/[A-Za-z0-9]' "${text[@]}" | head)"
marks='TO''DO|FIX''ME|X''XX'
check_empty "nothing is left to do in the text" "$(grep -nwE "$marks" "${text[@]}" | head)"
check_empty "no conflict marks" "$(grep -nE '^(<<<<<<<|>>>>>>>)( |$)' "${text[@]}" | head)"

# ---- generated text ----
if [ -n "$codegen" ]; then check "prt.h and shaders/ hold what the generator prints" "$codegen" --check prt.h shaders/* examples/common/relighter.c
else skip "prt.h and shaders/ hold what the generator prints" "the generator was not built"; fi
check_empty "README.md: the cost table is filled in" "$(
    awk '/<!-- BEGIN TABLE cost -->/ { inside = 1; next } /<!-- END TABLE cost -->/ { inside = 0 } inside && /^\|/ { rows++ }
         END { if (rows < 5) print "between the marks stand " rows + 0 " rows; make docs writes them" }' README.md)"
finish
