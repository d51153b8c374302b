#!/usr/bin/env bash
# tests/run.sh BUILD_DIR [ctest arguments]: runs ctest and counts single cases, not programs.
# Every program reports in TAP (cmocka by an environment variable), so that a case is a line "ok N - name".
# A program that fails without naming a failed case (a crash, say) counts as one failure. Last line: N passed, N failed
set -u
build=$1; shift
export CMOCKA_MESSAGE_OUTPUT=TAP
ctest --test-dir "$build" -V --timeout 600 "$@" 2>&1 | awk '
    function note(id, line) { text[id] = text[id] line "\n" }
    match($0, /^[0-9]+: /) {
        id = substr($0, 1, RLENGTH - 2) + 0; line = substr($0, RLENGTH + 1)
        if (line ~ /^(not )?ok [0-9]+.*# [Ss][Kk][Ii][Pp]/) { skip[id]++; sub(/^.*# [Ss][Kk][Ii][Pp]/, "", line); why[id] = why[id] ";" line }
        else if (line ~ /^ok [0-9]+/) good[id]++
        else if (line ~ /^not ok [0-9]+/) { bad[id]++; note(id, line) }
        else if (line !~ /^1\.\.[0-9]+$/ && line != "") note(id, line)
        next
    }
    /^ *[0-9]+\/[0-9]+ Test +#[0-9]+: / {
        id = $0; sub(/^[^#]*#/, "", id); id += 0
        name = $0; sub(/^[^#]*#[0-9]+: /, "", name); sub(/ .*/, "", name)
        seconds = $(NF - 1); programs++
        if ($0 ~ /\*\*\*Skipped/) { if (!skip[id]) skip[id] = 1 }
        else if ($0 !~ / Passed /) { if (!bad[id]) { bad[id] = 1; sub(/.*\*\*\*/, ""); note(id, "not ok - " $0) } }
        else if (!good[id] && !skip[id]) good[id] = 1
        passed += good[id]; failed += bad[id]; skipped += skip[id]
        printf "%-44s %4d passed", name, good[id]
        if (skip[id]) printf ", %d skipped%s", skip[id], why[id]
        if (bad[id]) printf ", %d FAILED", bad[id]
        printf "  (%s s)\n", seconds
        if (bad[id]) printf "%s", text[id]
        fflush(); next
    }
    /^CMake Error|No tests were found|^Unable to find executable/ { print }
    END {
        if (!programs) failed++
        if (skipped) printf "%d skipped\n", skipped
        printf "%d passed, %d failed\n", passed, failed
        exit failed > 0
    }'
