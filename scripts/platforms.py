"""Print where the package installs from wheels, as in the table of docs/dependencies.md.

Usage: python platforms.py, with uv installed.  `uv pip compile` is run for each platform and each
version of Python, for versions from the oldest allowed in pyproject.toml on.  First each
requirement is resolved alone, to find those without a wheel; if all have wheels, all of them are
resolved together with their dependencies.
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
#: Names of platforms in the resolver and in the table.
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
#: Time limit in seconds for one answer.
PATIENCE = 60.0
#: Extras for users; the others are for the development of the package.
EXTRAS = ("cluster", "export", "film", "gpu", "lab", "taylor")


def has_wheels(requirements: tuple[str, ...], platform: str, python: str, *options: str) -> bool:
    """True if the resolver finds versions that all have wheels."""
    try:
        asked = subprocess.run(
            [
                *("uv", "pip", "compile", "-", "--quiet", "--no-header", "--only-binary", ":all:"),
                *("--python", sys.executable),
                *("--python-platform", platform, "--python-version", python, *options),
            ],
            input="\n".join(requirements),
            capture_output=True,
            text=True,
            check=False,
            timeout=PATIENCE,
        )
    except subprocess.TimeoutExpired:
        sys.exit(f"no answer in {PATIENCE:g} s: {', '.join(requirements)} on {platform} {python}")
    if asked.returncode not in (0, 1) or "error sending request" in asked.stderr:
        sys.exit(asked.stderr)
    return asked.returncode == 0


def cell(project: dict, platform: str, python: str) -> str:
    """Cell of the table: yes with the extras, or the requirements, that have no wheel."""
    core, optional = tuple(project["dependencies"]), project["optional-dependencies"]

    def lacking(requirements: tuple[str, ...]) -> list[str]:
        alone = [r for r in requirements if not has_wheels((r,), platform, python, "--no-deps")]
        return [_name(requirement) for requirement in alone]

    if missing := lacking(core):
        return "no: " + ", ".join(missing)
    if not has_wheels(core, platform, python):
        alone = [_name(r) for r in core if not has_wheels((r,), platform, python)]
        return f"no: what {', '.join(alone)} needs" if alone else "no: no common versions"
    without = [
        f"`{extra}`"
        for extra in EXTRAS
        if lacking(tuple(optional[extra]))
        or not has_wheels((*core, *optional[extra]), platform, python)
    ]
    return "yes" + (f", without {', '.join(without)}" if without else "")


def _name(requirement: str) -> str:
    return requirement.partition(">")[0]


def all_together() -> dict:
    """Requirements of all packages and their extras, as for a single package."""
    places = sorted((ROOT / "packages").glob("*/pyproject.toml"))
    own = {place.parent.name for place in places}

    def foreign(requirements: list[str]) -> list[str]:
        return sorted(
            {r for r in requirements if r.partition("==")[0].partition("[")[0] not in own}
        )

    projects = [tomllib.loads(place.read_text(encoding="utf-8"))["project"] for place in places]
    extras: dict[str, list[str]] = {}
    for project in projects:
        for name, listed in project.get("optional-dependencies", {}).items():
            extras[name] = foreign([*extras.get(name, []), *listed])
    needed = [r for project in projects for r in project["dependencies"]]
    return {"dependencies": foreign(needed), "optional-dependencies": extras}


def table() -> list[str]:
    """Lines of the table."""
    project = all_together()
    places = list(product(PLATFORMS, PYTHONS))
    cells = {}
    with ThreadPoolExecutor(4) as threads:
        for place, found in zip(
            places, threads.map(lambda p: cell(project, *p), places), strict=True
        ):
            cells[place] = found
            print(*place, found, file=sys.stderr)
    rows = [
        f"| {own} | " + " | ".join(cells[name, python] for python in PYTHONS) + " |"
        for name, own in PLATFORMS.items()
    ]
    head = " | ".join(f"CPython {python}" for python in PYTHONS)
    return [f"| | {head} |", "|---" * (len(PYTHONS) + 1) + "|", *rows]


if __name__ == "__main__":
    print("\n".join(table()))
