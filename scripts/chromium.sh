#!/bin/sh
# Installs the Chromium of the system, in which pages are tested, where that is possible.
# Without one those tests are skipped, and say so.
set -eu
for name in chromium chromium-browser google-chrome; do
    command -v $name >/dev/null && exit 0
done
if command -v apt-get >/dev/null && test "$(id -u)" = 0; then
    export DEBIAN_FRONTEND=noninteractive
    if apt-get update -qq && apt-get install -y -qq --no-install-recommends chromium >/dev/null 2>&1; then
        exit 0
    fi
fi
echo "There is no Chromium, and it could not be installed: pages are not tested in a browser."
