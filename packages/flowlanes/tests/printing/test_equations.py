"""Displayed equations in HTML: rows of terms between which a line may break."""

from __future__ import annotations

import re

import sympy as sp

from flowlanes.printing.equations import equations_html
from flowlanes.system.vectors import real_symbol

a, b, c = map(real_symbol, "abc")


def test_a_sum_is_broken_into_terms_and_a_product_stays_whole() -> None:
    written = equations_html([("x", a - b + c * (a + b)), ("y", a * b)])
    sums, products = (row for row in written.split("\n"))
    assert len(re.findall("<math", sums)) == 1 + 3
    assert len(re.findall("<math", products)) == 1 + 1


def test_every_term_has_its_width() -> None:
    narrow, wide = (
        max(map(int, re.findall(r"--width: (\d+)", equations_html([("", formula)]))))
        for formula in (a * b, sp.sqrt(a + b) * (a + b + c) * (a - b - c))
    )
    assert 0 < narrow < wide


def test_the_width_of_equations_is_that_of_their_widest_term() -> None:
    terms = [a * b * (a + k) for k in range(2, 12)]
    one, sum_of_ten = (
        max(map(int, re.findall(r"--width: (\d+)", equations_html([("", formula)]))))
        for formula in (terms[-1], sp.Add(*terms))
    )
    assert sum_of_ten <= one + 3


def test_a_remark_without_a_left_side_stands_under_the_right_sides() -> None:
    row = equations_html([("x", a), ("", r"\text{rank } 4")]).split("\n")[1]
    assert row.startswith('<div><div class="left"><wbr/></div><div class="right"><math')
    alone = equations_html([("", a)])
    assert 'class="left"' not in alone


def test_a_sign_that_goes_on_with_the_line_above_keeps_its_distance() -> None:
    row = equations_html([("u", a), ("", "+ b")]).split("\n")[1]
    assert "<mrow><mrow /><mo>&#x0002B;</mo>" in row
