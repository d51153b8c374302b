# Sourced by the test scripts: one line "ok N - name" for each check (TAP, what tests/run.sh counts).
tests=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
root=$(dirname "$tests")
jobs=${JOBS:-$(nproc 2>/dev/null || echo 2)}
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
warnings="-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror"

tap_count=0 tap_failed=0
ok()     { tap_count=$((tap_count + 1)); echo "ok $tap_count - $1"; }
not_ok() { tap_count=$((tap_count + 1)); tap_failed=$((tap_failed + 1)); echo "not ok $tap_count - $1"
           [ -z "${2:-}" ] || printf '%s\n' "$2" | head -n 25 | sed 's/^/# /'; }
skip()   { tap_count=$((tap_count + 1)); echo "ok $tap_count - $1 # SKIP $2"; }

# check NAME COMMAND...: the command must succeed.
check() { local name=$1 output; shift; if output=$("$@" 2>&1); then ok "$name"; else not_ok "$name" "$output"; fi; }
# check_empty NAME TEXT: the text lists what is wrong, so it must be empty.
check_empty() { if [ -z "$2" ]; then ok "$1"; else not_ok "$1" "$2"; fi; }
have() { command -v "$1" >/dev/null 2>&1; }
finish() { echo "1..$tap_count"; exit $((tap_failed > 0)); }
