"""The groups of the catalogue say what the catalogue and its proofs say."""

from __future__ import annotations

import re
from pathlib import Path

from catalogue import built
from nonholonomic.catalogue import CATALOGUE
from nonholonomic.catalogue.entry_files import entry_file, entry_files
from nonholonomic.catalogue.groups import GROUPS, in_section
from nonholonomic.mechanics.rolling.equations import RollingBody

PAGE = (Path(__file__).parents[4] / "packages/nonholonomic/docs/hierarchy.md").read_text()
#: Classes of nonholonomic/docs/hierarchy.md that mean an integrable system.
CLASSES = {"curves", "lie", "euler-jacobi", "liouville"}


def test_every_system_is_in_one_group() -> None:
    names = [name for group in GROUPS for name in group.names]
    assert sorted(names) == sorted(CATALOGUE)


def test_the_contact_is_that_of_the_system() -> None:
    contacts = {name: group.contact for group in GROUPS for name in group.names}
    for name, item in CATALOGUE.items():
        if item.ball is not None:
            assert contacts[name] == item.ball(item.numbers()).contact, name
    for name in built.ROLLING:
        made = built.made(name)
        assert isinstance(made, RollingBody)
        assert contacts[name] == made.contact, name


def test_integrable_is_what_is_proven_so() -> None:
    rows = re.findall(r"^\| `([\w-]+)` \|.*\| ([^|]*) \|$", PAGE, re.MULTILINE)
    classes = {name: set(found.split(", ")) for name, found in rows if name in CATALOGUE}
    assert classes.keys() == CATALOGUE.keys()
    assert {name for name, found in classes.items() if found & CLASSES} == {
        file.name for file in entry_files() if file.integrable
    }


def test_sections() -> None:
    assert in_section(entry_file("veselova"), "6")
    assert in_section(entry_file("veselova"), "§6.1")
    assert not in_section(entry_file("veselova"), "6.3")
    assert not in_section(entry_file("chaplygin-ball-gyrostat-bruns"), "1")
