"""Prints where the package installs from ready-built wheels, as the table of docs/dependencies.md.

python platforms.py, where uv is installed: `uv pip compile` is asked for each platform and each
version of Python, for the oldest versions that will do and newer ones as in pyproject.toml.  Where
there is no solution, each requirement is asked for alone, to name those without a wheel.
"""

from __future__ import annotations

import subprocess
import sys
import tomllib
from concurrent.futures import ThreadPoolExecutor
from itertools import product
from pathlib import Path

ROOT = Path(__file__).parents[1]
PYTHONS = ("3.11", "3.12", "3.13", "3.14")
#: Names of the resolver, and their own.
PLATFORMS = {
    "x86_64-manylinux_2_28": "Linux, x86-64",
    "aarch64-manylinux_2_28": "Linux, aarch64",
    "aarch64-apple-darwin": "macOS, Apple silicon",
    "x86_64-apple-darwin": "macOS, Intel",
    "x86_64-pc-windows-msvc": "Windows, x86-64",
    "aarch64-pc-windows-msvc": "Windows, ARM",
    "x86_64-unknown-linux-musl": "Linux with musl, x86-64",
    "aarch64-unknown-linux-musl": "Linux with musl, aarch64",
}
#: Extras for users; the others are for work on the package itself.
EXTRAS = ("cluster", "export", "film", "gpu", "lab", "taylor")


def has_wheels(requirements: tuple[str, ...], platform: str, python: str) -> bool:
    """Whether the resolver finds versions that all come as wheels."""
    asked = subprocess.run(
        [
            *("uv", "pip", "compile", "-", "--quiet", "--no-header", "--only-binary", ":all:"),
            *("--python-platform", platform, "--python-version", python),
        ],
        input="\n".join(requirements),
        capture_output=True,
        text=True,
        check=False,
    )
    if asked.returncode not in (0, 1) or "error sending request" in asked.stderr:
        sys.exit(asked.stderr)
    return asked.returncode == 0


def without_wheels(requirements: tuple[str, ...], platform: str, python: str) -> tuple[str, ...]:
    """Those of the requirements for which there are no wheels; empty if they all install."""
    if has_wheels(requirements, platform, python):
        return ()
    alone = tuple(r for r in requirements if not has_wheels((r,), platform, python))
    return alone or ("no common solution",)


def cell(project: dict, platform: str, python: str) -> str:
    """A cell of the table: yes, or the requirements without wheels; then extras that lack some."""
    core = tuple(project["dependencies"])
    if missing := without_wheels(core, platform, python):
        return "no: " + ", ".join(_name(r) for r in missing)
    optional = project["optional-dependencies"]
    lacking = [
        f"`{extra}`"
        for extra in EXTRAS
        if not has_wheels((*core, *optional[extra]), platform, python)
    ]
    return "yes" + (f", without {', '.join(lacking)}" if lacking else "")


def _name(requirement: str) -> str:
    return requirement.partition(">")[0]


def table() -> list[str]:
    """The lines of the table."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    places = list(product(PLATFORMS, PYTHONS))
    with ThreadPoolExecutor(4) as threads:
        cells = dict(zip(places, threads.map(lambda p: cell(project, *p), places), strict=True))
    rows = [
        f"| {own} | " + " | ".join(cells[name, python] for python in PYTHONS) + " |"
        for name, own in PLATFORMS.items()
    ]
    head = " | ".join(f"CPython {python}" for python in PYTHONS)
    return [f"| | {head} |", "|---" * (len(PYTHONS) + 1) + "|", *rows]


if __name__ == "__main__":
    print("\n".join(table()))
