"""Prints where the package installs from ready-built wheels, as the table of docs/dependencies.md.

python platforms.py, where uv is installed: `uv pip compile` is asked for each platform and each
version of Python, for versions from the oldest that will do in the files pyproject.toml on.  First
each requirement is asked for alone, to name those without a wheel; where all have one, for all of
them together with all that they need.
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
#: Seconds for one answer.
PATIENCE = 60.0
#: Extras for users; the others are for work on the package itself.
EXTRAS = ("cluster", "export", "film", "gpu", "lab", "taylor")


def has_wheels(requirements: tuple[str, ...], platform: str, python: str, *options: str) -> bool:
    """Whether the resolver finds versions that all come as wheels."""
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
    """A cell of the table: yes and the extras that lack a wheel, or the requirements that do."""
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
    """What the packages need of others, and their extras, as if they were one."""
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
    """The lines of the table."""
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
