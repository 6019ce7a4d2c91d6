#!/bin/sh
# Makes the virtual environment VENV and installs into it what is wanted of the package:
# `core`, `test` with what its tests need, `dev` with the tools for work on it, `site` with those for its pages as well, or `release`
# with those for a release. Leaves a file of that name in VENV as a mark.
# Usage, from the root of the project: setup.sh VENV core|test|dev|site|release
set -eu
venv=$1
wanted=$2

least="3.11"
log=$venv/install.log

fail() {
    printf '%s\n' "$@" >&2
    exit 1
}

# Prints the version of the Python named $1 as "3.12"; fails when there is none that runs.
version_of() {
    "$1" -c 'import sys; print("%d.%d" % sys.version_info[:2])' 2>/dev/null
}

is_new_enough() {
    "$1" -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null
}

can_make_environments() {
    "$1" -c 'import ensurepip, venv' 2>/dev/null
}

explain_missing_venv() {
    package=python3-venv
    test "$(version_of python3)" = "$(version_of "$1")" || package=python$(version_of "$1")-venv
    fail "$1 (Python $(version_of "$1")) cannot make virtual environments: its module venv or ensurepip is missing." \
        "On Debian and Ubuntu, install it as root:  apt install $package"
}

# Sets `python` to the interpreter to use: $PYTHON, or the first fit one on the search path.
choose_python() {
    if test -n "${PYTHON-}"; then
        version=$(version_of "$PYTHON") || fail "PYTHON=$PYTHON does not run as a Python."
        is_new_enough "$PYTHON" || fail "PYTHON=$PYTHON is Python $version; Python $least or newer is needed."
        can_make_environments "$PYTHON" || explain_missing_venv "$PYTHON"
        python=$PYTHON
        return
    fi
    without_venv=
    for candidate in python3.13 python3.12 python3.11 python3.14 python3; do
        if is_new_enough "$candidate"; then
            if can_make_environments "$candidate"; then
                python=$candidate
                return
            fi
            without_venv=${without_venv:-$candidate}
        fi
    done
    test -z "$without_venv" || explain_missing_venv "$without_venv"
    if found=$(version_of python3); then
        found="python3 is Python $found, which is too old."
    else
        found="There is no python3 on the search path."
    fi
    fail "Python $least or newer is needed. $found" \
        "On Debian 12, Ubuntu 24.04 and newer, install it as root:  apt install python3 python3-venv" \
        "or name one that is elsewhere:  make PYTHON=/path/to/python$least ..."
}

# An environment made here, or one that the user made and that works, is kept.
is_usable() {
    test "$(cat "$venv/address" 2>/dev/null || pwd -P)" = "$(pwd -P)" &&
        is_new_enough "$venv/bin/python" &&
        "$venv/bin/python" -m pip --version >/dev/null 2>&1
}

show_log() {
    printf '%s\n' "$1 The last lines of $log:" >&2
    tail -n 20 "$log" | sed 's/^/    /' >&2
    exit 1
}

if is_usable; then
    python=$venv/bin/python
else
    choose_python
    rm -rf "$venv"
fi

case $wanted in
core) tools="" named="chaplygin" size="0.8 GB" ;;
test) tools="test" named="chaplygin and what its tests need" size="0.8 GB" ;;
dev) tools="dev" named="chaplygin and the tools for work on it" size="2.4 GB" ;;
release) tools="release" named="chaplygin and the tools that release it" size="0.9 GB" ;;
site) tools="site" named="chaplygin and the tools for work on it and its site" size="2.5 GB" ;;
esac
set --
for package in packages/*; do
    set -- "$@" --editable "$package"
done
for tool in $tools; do
    set -- "$@" --requirement "requirements/$tool.txt"
done
echo "Installing $named into $venv (Python $(version_of "$python"), $size); this happens once and takes a minute or two."

if test ! -d "$venv"; then
    mkdir -p "$venv"
    "$python" -m venv "$venv" >"$log" 2>&1 || show_log "The virtual environment could not be made."
fi
pwd -P >"$venv/address"

"$venv/bin/python" -m pip install --quiet --disable-pip-version-check --no-input --only-binary=:all: \
    --constraint constraints.txt "$@" >"$log" 2>&1 || {
    show_log "Installing failed."
}
touch "$venv/core" "$venv/$wanted"
case $wanted in
dev) touch "$venv/test" ;;
site) touch "$venv/test" "$venv/dev" ;;
esac
