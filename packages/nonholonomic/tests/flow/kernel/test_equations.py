"""What machine code is made of: rates, deviations, sections, guards."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import sympy as sp

from flow.small import OSCILLATOR, TOP, M, body, gamma, p, u, x, y
from flowlanes.errors import InputError
from flowlanes.flow.kernel.equations import (
    Equations,
    Section,
    equations_of,
    poincare_section,
    serial,
    serial_terms,
)
from flowlanes.formulas.array_evaluation import numbers
from flowlanes.formulas.graph import Graph
from flowlanes.system.system import Guard, Parameter, System
from flowlanes.system.vectors import to_components

#: Two variables and a guard.
TRIAL = System(
    name="trial",
    title="Trial",
    parameters=(Parameter(p, "p", 1.5),),
    field={x: y**2, y: -p * sp.sin(x)},
    guards=(Guard("near", 9 - x, "far"), Guard("low", y + p, "low")),
)
POINT = {x: 0.3, y: -0.7, p: 1.5}
DEVIATIONS = [[0.2, -1.0], [1.5, 0.4]]


def numbers_of(terms: Any) -> list[float]:
    """Terms at the point, with two deviations behind the state."""
    state = np.array([[POINT[x], POINT[y], *DEVIATIONS[0], *DEVIATIONS[1]]])
    return list(numbers(terms, state, np.array([POINT[p]]))[0])


def known(formula: Any) -> float:
    return float(sp.sympify(formula).subs(POINT))


@pytest.mark.parametrize(("backward", "sign"), [(False, 1), (True, -1)])
def test_rates_and_deviations(backward: bool, sign: int) -> None:
    """Behind the rates follow their derivatives along each deviation."""
    equations = equations_of(TRIAL, 2, None, backward)
    field = sp.Matrix([y**2, -p * sp.sin(x)])
    slopes = field.jacobian([x, y]).subs(POINT)
    right = [sign * known(f) for f in field]
    for deviation in DEVIATIONS:
        right += [sign * float(r) for r in slopes * sp.Matrix(deviation)]
    np.testing.assert_allclose(numbers_of(equations.rates), right, rtol=1e-15)
    assert set(equations.pieces) == {"rates", "guards"}
    assert numbers_of(equations.guards) == pytest.approx([9 - 0.3, -0.7 + 1.5])


@pytest.mark.parametrize(("backward", "sign"), [(False, 1), (True, -1)])
@pytest.mark.parametrize("direction", [1, -1, 0])
def test_sections(backward: bool, sign: int, direction: int) -> None:
    """Their rate is that of the motion; backward a rise becomes a fall."""
    equations = equations_of(TRIAL, 0, Section(x * y - p, direction, y), backward)
    assert equations.direction == sign * direction
    rate = y * y**2 + x * (-p * sp.sin(x))
    right = [known(x * y - p), sign * known(rate), known(y)]
    np.testing.assert_allclose(numbers_of(equations.pieces["section"]), right, rtol=1e-15)


def test_a_section_needs_no_condition() -> None:
    equations = equations_of(OSCILLATOR, 0, poincare_section(OSCILLATOR, x), False)
    assert len(equations.pieces["section"]) == 2
    assert equations.where is None
    assert set(equations_of(OSCILLATOR, 0, None, False).pieces) == {"rates"}


def test_components_of_a_vector_are_measured_together() -> None:
    assert equations_of(TOP, 0, None, False).groups == ((0, 1, 2), (3, 4, 5))
    assert equations_of(OSCILLATOR, 0, None, False).groups == ((0,), (1,))
    assert equations_of(TOP, 3, None, False).groups == ((0, 1, 2), (3, 4, 5))


def test_what_a_section_says() -> None:
    """Formulas, texts, names of integrals, values, angles."""
    area = to_components(M.T * gamma)[0]
    assert poincare_section(OSCILLATOR, "x", 0.5) == Section(x - sp.Float(0.5), 1, None)
    assert poincare_section(OSCILLATOR, "energy", direction=-1).value == y**2 + p * x**2
    assert sp.expand(poincare_section(body("chaplygin-ball"), "area").value - area) == 0
    angle = poincare_section(OSCILLATOR, x + y, sp.pi / 3, direction=0, angle=True)
    assert angle.value == sp.sin(x + y - sp.pi / 3)
    assert angle.where == sp.cos(x + y - sp.pi / 3)
    assert angle.direction == 0


MISTAKES: dict[str, tuple[Any, str]] = {
    "direction": (
        lambda: poincare_section(OSCILLATOR, x, direction=2),
        "direction = 2: it must be 1 (rising), -1 (falling) or 0",
    ),
    "no state": (
        lambda: poincare_section(OSCILLATOR, "p", 3),
        "oscillator: the section p = 3 contains no state",
    ),
    "state that cancels": (
        lambda: poincare_section(OSCILLATOR, x - x + p),
        "oscillator: the section p = 0 contains no state",
    ),
    "vector": (
        lambda: poincare_section(TOP, "M"),
        "top: M is a vector; name one of its components",
    ),
    "function": (
        lambda: poincare_section(OSCILLATOR, sp.zeta(x)),
        "zeta(x): the machine code has no function zeta",
    ),
    "complex value": (
        lambda: poincare_section(OSCILLATOR, x, sp.I),
        "poincare_section: value must be a number, not an ImaginaryUnit",
    ),
    "foreign symbol": (
        lambda: equations_of(OSCILLATOR, 0, Section(x - u), False),
        "u: neither a state variable, a definition nor a parameter",
    ),
    "no motion": (
        lambda: equations_of(System(name="still", title="Still", field={}), 0, None, False),
        "still: a system without state has no motion",
    ),
}


@pytest.mark.parametrize("name", MISTAKES)
def test_mistakes_give_one_sentence(name: str) -> None:
    attempt, sentence = MISTAKES[name]
    with pytest.raises(InputError) as caught:
        attempt()
    assert str(caught.value) == sentence


def test_texts_tell_different_terms_apart() -> None:
    """Operations, their order, numbers and leaves; shared terms are written once."""
    graph = Graph()
    a, b = graph.state(0), graph.state(1)
    terms = [a + b, a - b, b - a, a * b, graph.call("sin", a), graph.parameter(0), graph.number(2)]
    texts = [serial_terms([t]) for t in terms] + [serial_terms([a, b]), serial_terms([b, a])]
    assert len(set(texts)) == len(texts)
    square = (a + b) * (a + b)
    assert serial_terms([square]).count("add") == 1


def test_the_text_of_equations_holds_all_of_them() -> None:
    def text(**changes: Any) -> str:
        options = {"deviations": 0, "section": None, "backward": False} | changes
        return serial(equations_of(TRIAL, **options))

    cut = Section(x, 1)
    texts = {
        text(),
        text(deviations=1),
        text(backward=True),
        text(section=cut),
        text(section=Section(x, -1)),
        text(section=Section(x, 1, y)),
        text(section=Section(x, 1, -y)),
        text(section=cut, backward=True),
    }
    assert len(texts) == 8
    assert text() == text()


def test_equations_are_of_one_graph() -> None:
    equations: Equations = equations_of(TRIAL, 1, Section(x, 1), False)
    assert {term.graph for terms in equations.pieces.values() for term in terms} == {
        equations.graph
    }
