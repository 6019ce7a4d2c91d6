#!/bin/sh
# Installs wheels into a fresh environment outside the repository, with PYTHON of any version, and
# runs the main job there: what is missing from a wheel shows itself.
# Usage, from the root of the project: try_wheel.sh PYTHON WHEEL...
set -eu
python=$1
shift
constraints=$PWD/constraints.txt
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT

"$python" -m venv "$place/venv"
"$place/venv/bin/python" -m pip install --quiet --disable-pip-version-check --no-input --only-binary=:all: \
    --constraint "$constraints" "$@"
echo "Installed: $(du -sm "$place/venv" | cut -f1) MB, $("$place/venv/bin/python" --version)"
"$place/venv/bin/python" scripts/installed_sizes.py 12
cd "$place"
export FLOWLANES_CACHE=$place/cache
venv/bin/chaplygin --version
venv/bin/chaplygin --quiet study rattleback -o "a study, été" --quick
test -s "a study, été/report.html"
venv/bin/python -m chaplygin --quiet run veselova -o veselova.csv
venv/bin/python -c "import chaplygin as ch; print(ch.from_catalogue('rattleback').title)"
