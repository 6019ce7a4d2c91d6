"""Products of differences of poles."""

from __future__ import annotations

import sympy as sp

from nonholonomic.closed_form.genus_two.separation import gaps


def test_gaps():
    assert gaps((1, 4, 9)) == (24, -15, 40)


def test_second_divided_differences():
    poles = sp.symbols("e_1:4")
    for power, value in ((0, 0), (1, 0), (2, 1), (3, sum(poles))):
        found = sum(e**power / gap for e, gap in zip(poles, gaps(poles), strict=True))
        assert sp.cancel(found - value) == 0
