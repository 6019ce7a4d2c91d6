#!/bin/sh
# Checks the front end in packages/chaplygin/web/ and builds it anew, where there are Node and the packages it needs;
# with the argument `compare` it fails where the result is not what is committed.
# Usage, from the root of the project: front_end.sh [compare]
set -eu
built=packages/chaplygin/src/chaplygin/page/static

is_new_enough() {
    test "$(node --version 2>/dev/null | sed 's/^v\([0-9]*\).*/\1/')" -ge 20 2>/dev/null
}

if ! is_new_enough || ! command -v npm >/dev/null; then
    echo "There is no Node 20 or newer: the front end is neither checked nor built; $built stays as it is."
    exit 0
fi
log=$(mktemp)
trap 'rm -f "$log"' EXIT
if ! npm --prefix packages/chaplygin/web ci --no-audit --no-fund >"$log" 2>&1; then
    tail -n 5 "$log" >&2
    echo "The packages of the front end could not be installed: it is neither checked nor built."
    exit 0
fi
for task in types test build; do
    npm --prefix packages/chaplygin/web run --silent $task >"$log" 2>&1 || {
        cat "$log" >&2
        echo "The front end fails: npm run $task in packages/chaplygin/web/" >&2
        exit 1
    }
done
tail -n 1 "$log"
if test "${1-}" = compare && test -n "$(git status --porcelain -- $built)"; then
    git status --short -- $built >&2
    echo "The front end in $built is not what packages/chaplygin/web/ builds: run make web, and commit it." >&2
    exit 1
fi
