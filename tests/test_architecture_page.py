"""The pictures of the workspace agree with its imports, and every file named is there."""

from __future__ import annotations

import re

from workspace import HOMES, ORDER, ROOT, folded, own_imports, own_modules

PAGE = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")


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


def test_every_file_that_is_named_is_there() -> None:
    places = (ROOT, *(home.parent for home in HOMES.values()))
    for name in re.findall(r"`(\w+/[\w/]+\.py)`", PAGE):
        assert any((place / name).exists() for place in places), name
