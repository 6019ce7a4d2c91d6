#!/bin/sh
# Tests a package in an environment that has nothing but its own dependencies and what tests need:
# its wheel, and those of the packages of the workspace that it names, are built and installed.
# Usage, from the root of the project: test_alone.sh PACKAGE [OPTION OF PYTEST...]
set -eu
test -n "${1-}" && test -d "packages/$1" || {
    echo "Name a package: PACKAGE=$(ls packages | paste -sd '|' -)" >&2
    exit 2
}
package=$1
shift
place=build/alone/$package
rm -rf "$place"
mkdir -p "$place"
"${PYTHON-python3}" -m venv "$place/venv"
python=$place/venv/bin/python
"$python" -m pip wheel --quiet --disable-pip-version-check --no-deps --wheel-dir "$place/wheels" packages/*
"$python" -m pip install --quiet --disable-pip-version-check --no-input --only-binary=:all: \
    --constraint constraints.txt --find-links "$place/wheels" --requirement requirements/test.txt "$package"
echo "$package: a wheel of $(du -k "$place"/wheels/"$(echo "$package" | tr - _)"-*.whl | cut -f1) kB," \
    "an environment of $(du -sm "$place/venv" | cut -f1) MB"
"$python" -m pytest -n 2 "$@" "packages/$package"
