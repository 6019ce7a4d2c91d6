"""Modes of a contact and their names."""

from __future__ import annotations

from itertools import product

from nonholonomic.contact.friction.modes import FLIGHT, MODE_NAMES, Mode


def test_every_mode_has_one_of_the_names():
    flags = product([True, False], repeat=4)
    assert {Mode(*choice).name for choice in flags} == set(MODE_NAMES)


def test_ranges_share_the_name_of_their_mode():
    assert {Mode(range=span).name for span in ("inner", "middle", "outer")} == {"sliding"}
    assert FLIGHT.name == MODE_NAMES[0]
