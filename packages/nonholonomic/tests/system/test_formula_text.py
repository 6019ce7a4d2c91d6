"""Formulas as text, with equal parts written once."""

import pytest
import sympy as sp

from flowlanes.system.formula_text import exact_text, short_text
from flowlanes.system.system import System
from nonholonomic import from_catalogue

x, y = sp.symbols("x y", real=True)
SHORT, LONG = sp.Float("0.1", 15), sp.Float("0.5", 40)


def formulas(system: System) -> list[sp.Basic]:
    return [*system.rates, *system.definitions[0][:1], *(f for _, f in system.scalar_definitions)]


@pytest.mark.parametrize("name", ["rattleback", "ball-around-sphere", "roller-racer"])
def test_formulas_of_systems_read_as_sympy_writes_them(name: str) -> None:
    for formula in formulas(from_catalogue(name)):
        assert exact_text(formula) == sp.srepr(formula)
        assert short_text(formula) == str(formula)


@pytest.mark.parametrize(
    "value",
    [
        sp.sin(x + y) ** 2 / (x + y) - sp.sqrt(x + y) * (x + y),
        # equal numbers of different precision, and what holds them
        [x + sp.Float("0.5", 15), x + LONG, sp.Float("0.5", 15) * x, LONG * x],
        (sp.Integer(1), 1, sp.Float(1.0), 1.0, True, sp.true),
        [sp.Symbol("x"), x, sp.Symbol("x", positive=True), sp.Dummy("x", dummy_index=7)],
        sp.Matrix([[x, x + y], [x + y, SHORT]]),
        sp.And(x > y, sp.Or(x > y, y > 0)),
    ],
    ids=["shared", "precision", "ones", "assumptions", "matrix", "relations"],
)
def test_what_is_alike_is_told_apart(value: object) -> None:
    assert exact_text(value) == sp.srepr(value)
    if isinstance(value, sp.Basic):
        assert short_text(value) == str(value)
