"""The picture of the house agrees with its imports, and every file named is there."""

from __future__ import annotations

import re
from pathlib import Path

from test_layout import HOME, folded, imports

PAGE = (Path(__file__).parents[1] / "docs" / "architecture.md").read_text()


def arrows() -> dict[str, set[str]]:
    found: dict[str, set[str]] = {}
    for users, makers in re.findall(r"^    ([\w &]+) --> ([\w &]+)$", PAGE, re.MULTILINE):
        for user in users.split(" & "):
            found.setdefault(user, set()).update(makers.split(" & "))
    return found


def below(room: str, graph: dict[str, set[str]]) -> set[str]:
    """Rooms that a room reaches along arrows."""
    return {x for maker in graph.get(room, ()) for x in {maker, *below(maker, graph)}}


def test_every_arrow_is_an_import_and_every_import_follows_from_arrows() -> None:
    drawn, real = arrows(), folded(imports(HOME), HOME, 1)
    rooms = {path.name for path in HOME.iterdir() if (path / "__init__.py").exists()}
    assert drawn.keys() | set().union(*drawn.values()) == rooms
    for room in rooms:
        assert drawn.get(room, set()) <= real[room], room
        assert real[room] & rooms <= below(room, drawn), room


def test_every_room_has_a_line() -> None:
    rooms = {path.name for path in HOME.iterdir() if (path / "__init__.py").exists()}
    before, _, _ = PAGE.partition("## Tests that were removed")
    listed = re.findall(r"^\| (`\w+`(?:, `\w+`)*) \|", before, re.MULTILINE)
    assert set(re.findall(r"\w+", " ".join(listed))) == rooms


def test_every_file_that_is_named_is_there() -> None:
    for name in re.findall(r"`(\w+/[\w/]+\.py)`", PAGE):
        place = HOME.parents[1] if name.startswith(("tests/", "scripts/")) else HOME
        assert (place / name).exists(), name
