"""MEGNO of regular motions: the numbers of flowlanes/docs/charts.md, most of them below 2."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import sympy as sp

import chaplygin as ch
from flowlanes.lyapunov.indicators import megno

PAGE = (Path(__file__).parents[1] / "packages/flowlanes/docs/charts.md").read_text(encoding="utf-8")
x, v = sp.symbols("x v", real=True)


@pytest.mark.parametrize(
    ("force", "until", "number"),
    [
        (-sp.sin(x), 500.0, "0.56 at T = 500"),
        (-sp.sin(x), 2000.0, "1.87 at 2000"),
        (-sp.sin(x), 10_000.0, "2.11 at 10,000"),
        (-x, 10_000.0, "0"),
    ],
)
def test_regular_motions_have_less_than_two_for_long(
    force: sp.Expr, until: float, number: str
) -> None:
    """The page said 2."""
    rule = megno(ch.System("pendulum", "Pendulum", {x: v, v: force}), until)
    value = float(rule(np.array([[0.5, 0.0]]), {})["value"][0])
    assert number in PAGE
    assert value == pytest.approx(float(number.split(maxsplit=1)[0]), abs=0.005)
