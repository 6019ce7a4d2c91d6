"""The pictures of the workspace agree with its imports, and every file named is there."""

from __future__ import annotations

import inspect
import os
import re
import subprocess
import sys
from pathlib import Path
from types import ModuleType

import pytest

import chaplygin
import chaplygin.experiment
import flowlanes
import lawproof
import nonholonomic
from workspace import HOMES, ORDER, ROOT, folded, own_imports, own_modules

PAGE = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")
#: The packages whose names `chaplygin` has a part of.
PUBLIC: dict[str, ModuleType] = {
    "flowlanes": flowlanes,
    "lawproof": lawproof,
    "nonholonomic": nonholonomic,
}


def arrows(picture: str) -> dict[str, set[str]]:
    """The arrows of a picture; each room has those of its packages."""
    found: dict[str, set[str]] = {}
    for users, makers in re.findall(r"^    ([\w. &]+) --> ([\w. &]+)$", picture, re.MULTILINE):
        for user in users.split(" & "):
            found.setdefault(user, set()).update(makers.split(" & "))
    return found


def below(room: str, graph: dict[str, set[str]]) -> set[str]:
    """Rooms that a room reaches along arrows."""
    return {x for maker in graph.get(room, ()) for x in {maker, *below(maker, graph)}}


PACKAGES, FOLDERS = (
    arrows(picture) for picture in re.findall(r"```mermaid\n(.*?)```", PAGE, re.DOTALL)
)
#: The folders that have a place of their own in the second picture.
ROOMS = {
    f"{name}.{path.parent.name}"
    for name, home in HOMES.items()
    for path in home.glob("*/__init__.py")
    if name not in ("certificate_checker", "borisov_mamaev_2008")
}


#: Modules of steps that are entered where a law is refuted, on a cluster, or with a store.
ELSEWHERE = {
    "certificate_checker/certificate_points.py",
    "flowlanes/flow/ensembles/dask.py",
    "flowlanes/flow/ensembles/zarr_store.py",
}


def test_the_picture_of_the_packages() -> None:
    real = folded(own_imports(), own_modules(), 1)
    assert PACKAGES.keys() | set().union(*PACKAGES.values()) == set(ORDER)
    for name in ORDER:
        assert PACKAGES.get(name, set()) <= real[name], name
        assert real[name] <= below(name, PACKAGES), name


def test_every_arrow_is_an_import_and_every_import_follows_from_arrows() -> None:
    real = folded(own_imports(), own_modules(), 2)
    assert FOLDERS.keys() | set().union(*FOLDERS.values()) == ROOMS
    for room in ROOMS:
        assert FOLDERS.get(room, set()) <= real[room], room
        assert real[room] & ROOMS <= below(room, FOLDERS), room


def test_every_room_has_a_line() -> None:
    before, _, _ = PAGE.partition("## Tests that were removed")
    listed = re.findall(r"^\| (`[\w.]+`(?:, `[\w.]+`)*) \|", before, re.MULTILINE)
    named = set(re.findall(r"[\w.]+", " ".join(listed)))
    assert {name for name in named if not name.startswith("certificate_checker.")} == {
        *ORDER,
        *ROOMS,
    }


def table(heading: str) -> dict[str, list[str]]:
    """The names in each row of the table with a heading."""
    _, _, after = PAGE.partition(f"| {heading} |\n|---|---|\n")
    rows = [line.strip("| ").split(" | ") for line in after.partition("\n\n")[0].splitlines()]
    return {label.strip("`"): re.findall(r"`(\w+)`", names) for label, names in rows}


def test_the_names_of_everyday_work_are_those_of_the_page() -> None:
    listed = [name for names in table("for | in `chaplygin`").values() for name in names]
    assert listed == chaplygin.__all__
    assert len(listed) <= 42
    for name in listed:
        assert any(
            getattr(package, name, None) is getattr(chaplygin, name)
            for package in (*PUBLIC.values(), chaplygin.experiment)
        ), name


def test_every_other_name_of_a_package_is_on_the_page() -> None:
    listed = table("package | has besides")
    assert list(listed) == list(PUBLIC)
    for package, names in listed.items():
        rest = [
            name
            for name in set(PUBLIC[package].__all__) - {*chaplygin.__all__, "__version__"}
            if not inspect.ismodule(getattr(PUBLIC[package], name))
        ]
        assert names == sorted(rest, key=str.lower), package


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("nonholonomy", r"it is nonholonomic\.nonholonomy"),
        ("scans", r"it is flowlanes\.scans"),
        ("cli", r"write: import chaplygin\.cli"),
        ("nonholonom", r"has no attribute 'nonholonom'$"),
    ],
)
def test_a_name_from_elsewhere_is_refused_with_its_place(name: str, words: str) -> None:
    with pytest.raises(AttributeError, match=words):
        chaplygin.__getattr__(name)


def test_every_file_that_is_named_is_there() -> None:
    places = (ROOT, *(home.parent for home in HOMES.values()))
    for name in re.findall(r"`(\w+/[\w/]+\.py)`", PAGE):
        assert any((place / name).exists() for place in places), name


@pytest.mark.slow
@pytest.mark.parametrize("walk", ["prove", "solve", "ensemble", "study"])
def test_the_modules_of_a_walk_are_entered_in_its_steps(walk: str, tmp_path: Path) -> None:
    (section,) = re.findall(rf"^### [^\n]*: `{walk}`\n(.*?)^###", PAGE, re.MULTILINE | re.DOTALL)
    steps = "".join(re.findall(r"^\d\. .*?(?=^\S|\Z)", section, re.MULTILINE | re.DOTALL))
    printed = subprocess.run(
        [sys.executable, str(ROOT / "scripts" / "files_entered.py"), walk, "--list"],
        env=os.environ | {"FLOWLANES_CACHE": str(tmp_path)},
        check=True,
        capture_output=True,
        text=True,
    ).stdout
    named = set(re.findall(r"`(\w+/[\w/]+\.py)`", steps))
    assert len(named) >= 8
    assert named - ELSEWHERE - set(printed.splitlines()) == set()
