"""Formulas at many states: the values of SymPy, whatever the shape; mistakes in one sentence."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import sympy as sp

from flow.small import OSCILLATOR, TOP, M, body, gamma, p, starts, u, x, y
from flowlanes.errors import InputError
from flowlanes.formulas.array_evaluation import (
    as_float_array,
    formula,
    parameter_rows,
    read_formulas,
    values,
)
from flowlanes.system.system import Observable, Parameter, System
from flowlanes.system.vectors import dot

a, w = sp.symbols("a w", real=True)
TRIAL = System(
    name="trial",
    title="Trial",
    parameters=(Parameter(p, "p", 1.5), Parameter(a, "a", 2.0, admissible=(a > p,))),
    definitions={w: x * y + a},
    field={x: w, y: -p * x},
    observables=(Observable("height", w**2, "height"), Observable("place", x, "place")),
)
FORMULAS = (
    "x",
    "w*a - p",
    "height",
    x / y,
    sp.sqrt(x**2 + 1) * sp.exp(y),
    sp.sin(x) * sp.cos(y) + sp.tan(x * y) - sp.atan2(y, x),
    sp.asin(x / 9) + sp.acos(y / 9) + sp.atan(w),
    sp.sinh(x) + sp.cosh(y) - sp.tanh(w),
    sp.log(x**2 + 1) + abs(y) * sp.sign(x),
    3,
)


def right(given: Any, point: Any, constants: dict[Any, float]) -> float:
    """SymPy's own value."""
    known = {"height": w**2, "w*a - p": w * a - p, "x": x}
    value = sp.sympify(known.get(given, given)).subs(w, x * y + a)
    return float(value.subs(constants).subs(dict(zip((x, y), point, strict=True))))


def test_values_are_sympys() -> None:
    points = np.random.default_rng(0).uniform(-2, 2, (7, 2))
    found = values(TRIAL, FORMULAS, points)
    known = [[right(f, point, {p: 1.5, a: 2.0}) for f in FORMULAS] for point in points]
    np.testing.assert_allclose(found, known, rtol=1e-13, atol=1e-14)


def test_each_row_has_its_parameters() -> None:
    points = np.random.default_rng(1).uniform(-2, 2, (5, 4, 2))
    squares = np.linspace(0.1, 1.1, 5)
    found = values(TRIAL, ["w*a - p", "height"], points, {"p": squares, a: 7.0})
    assert found.shape == (5, 4, 2)
    for i in range(5):
        alone = values(TRIAL, ["w*a - p", "height"], points[i], {p: squares[i], "a": 7.0})
        np.testing.assert_array_equal(found[i], alone)


def test_one_state_is_enough() -> None:
    assert values(TRIAL, ["x", "y"], np.array([3.0, 4.0])).tolist() == [3.0, 4.0]


def test_vectors_by_their_components() -> None:
    states = starts("chaplygin-ball", 6)
    found = values(body("chaplygin-ball"), ["gamma_3", "dot(M, gamma)", "area"], states)
    area = np.einsum("ni,ni->n", states[:, :3], states[:, 3:])
    np.testing.assert_allclose(found, np.stack([states[:, 5], area, area], axis=1), atol=1e-15)


def test_what_is_no_number_makes_no_noise() -> None:
    found = values(TRIAL, [sp.log(x), 1 / y, sp.sqrt(x)], np.array([[-1.0, 0.0]]))
    assert np.isnan(found[0, [0, 2]]).all()
    assert np.isinf(found[0, 1])


def test_formulas_and_texts_are_the_same() -> None:
    assert formula(TRIAL, "w*a - p") == w * a - p
    assert formula(TRIAL, "height") == w**2
    assert formula(OSCILLATOR, "energy") == y**2 + p * x**2
    assert formula(TOP, dot(M, gamma)) == formula(TOP, "dot(M, gamma)")


def test_a_system_is_read_once() -> None:
    assert read_formulas(TRIAL)[0] is read_formulas(TRIAL)[0]
    assert len(read_formulas(TRIAL)[1]) == 2


def test_rows_of_parameters() -> None:
    assert parameter_rows(TRIAL, None, 5).tolist() == [[1.5, 2.0]]
    assert parameter_rows(TRIAL, {"p": 0.5}, 5).tolist() == [[0.5, 2.0]]
    assert parameter_rows(TRIAL, {p: [0.5, 1.0]}, 2).tolist() == [[0.5, 2.0], [1.0, 2.0]]


MISTAKES: dict[str, tuple[Any, str]] = {
    "vector": (
        lambda: formula(TOP, "M"),
        "top: M is a vector; name one of its components",
    ),
    "foreign symbol": (
        lambda: values(TRIAL, [u], np.zeros((1, 2))),
        "u: neither a state variable, a definition nor a parameter",
    ),
    "shape of states": (
        lambda: values(TRIAL, [x], np.zeros((1, 3))),
        "trial: states have the shape (1, 3); their last axis must be 2",
    ),
    "not a number": (
        lambda: values(TRIAL, [x * sp.nan], np.zeros((1, 2))),
        "nan: a number in a formula must be real and finite",
    ),
    "complex": (
        lambda: values(TRIAL, [x + 2 * sp.I], np.zeros((1, 2))),
        "2*I: a number in a formula must be real and finite",
    ),
    "unknown parameter": (
        lambda: parameter_rows(TRIAL, {"q": 1}, 1),
        "trial: no parameter q; it has p, a",
    ),
    "condition between two parameters": (
        lambda: parameter_rows(TRIAL, {"p": [1.0, 2.5]}, 2),
        "trial: a = 2 is not admissible; a > p must hold",
    ),
    "infinite parameter": (
        lambda: parameter_rows(TRIAL, {"p": [1.0, np.inf]}, 2),
        "trial: p must be finite numbers",
    ),
    "length of parameters": (
        lambda: parameter_rows(TRIAL, {"p": [[1.0]]}, 2),
        "trial: p has the shape (1, 1); it must be one number or 2, one for each motion",
    ),
    "words": (
        lambda: as_float_array("heights", ["low", "high"]),
        "heights: all must be real numbers, in rows of one length",
    ),
}


@pytest.mark.parametrize("name", MISTAKES)
def test_mistakes_give_one_sentence(name: str) -> None:
    attempt, sentence = MISTAKES[name]
    with pytest.raises(InputError) as caught:
        attempt()
    assert str(caught.value) == sentence


def test_a_text_that_cannot_be_read_shows_the_place() -> None:
    with pytest.raises(InputError) as caught:
        formula(TRIAL, "x + height2")
    assert (
        str(caught.value)
        .splitlines()[0]
        .startswith("trial: quantity: unknown name 'height2'; allowed: x, y, w, p, a,")
    )
    assert str(caught.value).splitlines()[2].strip("~") == "        ^"
