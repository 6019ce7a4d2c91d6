"""Functions in vector instructions against mpmath, at ordinary arguments and at all edges."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

import mpmath
import numpy as np
import pytest

from flow.machine import exact, run
from flowlanes.flow.machine_code.arithmetic import Double, Pair
from flowlanes.flow.machine_code.elementary import FUNCTIONS
from flowlanes.flow.machine_code.ir_writer import IRWriter

DIGITS = 60
COUNT = 250


def _signed(rng: np.random.Generator, low: float, high: float) -> np.ndarray:
    """Numbers of both signs with magnitudes from 2^low to 2^high."""
    return rng.choice([-1.0, 1.0], COUNT) * 2.0 ** rng.uniform(low, high, COUNT)


def _near_quarters(rng: np.random.Generator) -> np.ndarray:
    """The doubles next to multiples of π/2 up to 10¹², where functions vanish or end."""
    few, many = np.arange(1, 60), rng.integers(60, 600_000_000_000, 60)
    with mpmath.workdps(DIGITS):
        turns = [float(mpmath.pi / 2 * int(n)) for n in (*few, *many)]
    return np.concatenate([turns, np.nextafter(turns, np.inf), np.nextafter(turns, 0)])


def _angles(rng: np.random.Generator) -> np.ndarray:
    parts = [_signed(rng, low, high) for low, high in ((-60, 0), (-3, 5), (0, 30), (30, 40))]
    return np.concatenate([*parts, _near_quarters(rng)])


def _ratios(rng: np.random.Generator) -> np.ndarray:
    """Magnitudes below 1, many of them near it."""
    edge = 1 - 2.0 ** rng.uniform(-50, -1, COUNT)
    return np.concatenate([rng.uniform(-1, 1, COUNT), _signed(rng, -60, 0), edge, -edge])


def _lengths(rng: np.random.Generator) -> np.ndarray:
    near = 1 + _signed(rng, -50, -1)
    parts = [rng.uniform(0.4, 3, COUNT), 2.0 ** rng.uniform(-960, 1020, COUNT), near]
    return np.concatenate(parts)


def _between(*bounds: float) -> Callable[[np.random.Generator], np.ndarray]:
    """Numbers up to each of some bounds, and tiny ones."""

    def make(rng: np.random.Generator) -> np.ndarray:
        parts = [rng.uniform(-bound, bound, COUNT) for bound in bounds]
        return np.concatenate([*parts, _signed(rng, -60, -1)])

    return make


def _any(rng: np.random.Generator) -> np.ndarray:
    parts = [_signed(rng, low, high) for low, high in ((-3, 3), (-60, 60), (-900, 900))]
    return np.concatenate(parts)


#: Functions of one variable: arguments, mpmath's word for it.
CASES: dict[str, tuple[Callable[[np.random.Generator], np.ndarray], Callable[[Any], Any]]] = {
    "abs": (_any, mpmath.fabs),
    "sign": (_any, mpmath.sign),
    "sin": (_angles, mpmath.sin),
    "cos": (_angles, mpmath.cos),
    "tan": (_angles, mpmath.tan),
    "asin": (_ratios, mpmath.asin),
    "acos": (_ratios, mpmath.acos),
    "atan": (_any, mpmath.atan),
    # the second word of a pair needs room below the first: to e⁻⁶⁰⁰
    "exp": (_between(2, 600), mpmath.exp),
    "sinh": (_between(2, 700), mpmath.sinh),
    "cosh": (_between(2, 700), mpmath.cosh),
    "tanh": (_between(2, 50), mpmath.tanh),
    "log": (_lengths, mpmath.log),
}


def _given(name: str, words: int) -> np.ndarray:
    """Arguments of a function, of one double or two (n, 1, words)."""
    rng = np.random.default_rng(sum(map(ord, name)))
    heads = CASES[name][0](rng)
    rests = np.spacing(np.abs(heads)) * rng.uniform(-0.49, 0.49, heads.size)
    return np.stack([heads, rests], axis=1)[:, None, :words]


def _apply(arithmetic: Any, name: str, given: np.ndarray, lanes: int = 8) -> np.ndarray:
    found = run(arithmetic, lanes, lambda k, values: [FUNCTIONS[name](k, *values)], given)
    return found[:, 0]


@pytest.mark.parametrize("name", sorted(CASES))
def test_doubles_are_right_to_the_last_place(name: str) -> None:
    """Not more than a unit in the last place of the right value."""
    given = _given(name, 1)
    with mpmath.workdps(DIGITS):
        right = [CASES[name][1](exact(x)) for x in given[:, 0]]
        units = np.spacing(np.abs([float(y) for y in right]))
        found = _apply(Double, name, given)
        errors = [abs(float(y - exact(z))) for y, z in zip(right, found, strict=True)]
    assert np.max(errors / units) < 0.9


@pytest.mark.parametrize("name", sorted(CASES))
def test_pairs_are_right_to_thirty_one_digits(name: str) -> None:
    """Relative errors of numbers with two words."""
    given = _given(name, 2)
    with mpmath.workdps(DIGITS):
        right = [CASES[name][1](exact(x)) for x in given[:, 0]]
        found = _apply(Pair, name, given)
        errors = [abs((exact(z) - y) / y) for y, z in zip(right, found, strict=True)]
        assert max(errors) < 1e-31


def _points(words: int) -> np.ndarray:
    """Points of the plane, also near the axes and diagonals, huge and tiny."""
    rng = np.random.default_rng(5)
    wide = np.stack([_signed(rng, -8, 8), _signed(rng, -8, 8)], axis=1)
    flat = np.stack([_signed(rng, -60, -20), _signed(rng, -2, 2)], axis=1)
    diagonal = _signed(rng, -2, 2)[:, None] * (1 + np.stack([_signed(rng, -52, -2)] * 2, axis=1))
    diagonal[:, 1] /= 1 + 2.0**-30
    huge = wide * 2.0**1000
    tiny = wide * 2.0**-900
    heads = np.concatenate([wide, flat, flat[:, ::-1], diagonal, huge, tiny])
    rests = np.spacing(np.abs(heads)) * rng.uniform(-0.49, 0.49, heads.shape)
    return np.stack([heads, rests], axis=2)[:, :, :words]


@pytest.mark.parametrize(("arithmetic", "allowed"), [(Double, 1.7e-16), (Pair, 1e-31)])
def test_angle_of_a_point(arithmetic: Any, allowed: float) -> None:
    """All four quadrants, by relative error."""
    given = _points(arithmetic.words)
    with mpmath.workdps(DIGITS):
        right = [mpmath.atan2(exact(y), exact(x)) for y, x in given]
        found = _apply(arithmetic, "atan2", given)
        assert max(abs((exact(z) - y) / y) for y, z in zip(right, found, strict=True)) < allowed


EDGES = np.array([0.0, -0.0, np.inf, -np.inf, np.nan, 1, -1, 5e-324, 1e-310, 1e300, 711, -800])

NUMPY = {"asin": np.arcsin, "acos": np.arccos, "atan": np.arctan}


def _same(found: np.ndarray, right: np.ndarray) -> np.ndarray:
    """Zeros, infinities and numbers that are none equal with their signs, others nearly."""
    special = ~np.isfinite(right) | (right == 0)
    close = np.isclose(found, right, rtol=1e-15, atol=0) & ~special
    alike = (found == right) & (np.signbit(found) == np.signbit(right))
    return close | alike | (np.isnan(found) & np.isnan(right))


@pytest.mark.parametrize("arithmetic", [Double, Pair])
@pytest.mark.parametrize("name", sorted(set(CASES) - {"sign"}))
def test_edges(name: str, arithmetic: Any) -> None:
    """Signed zeros, infinities, what is not a number, the ends of the domain: as NumPy has it."""
    edges = EDGES[EDGES != 1e300] if name in ("sin", "cos", "tan") else EDGES
    given = np.zeros((edges.size, 1, arithmetic.words))
    given[:, 0, 0] = edges
    with np.errstate(all="ignore"):
        right = (NUMPY.get(name) or getattr(np, name))(edges)
    found = _apply(arithmetic, name, given)[:, 0]
    assert list(edges[~_same(found, right)]) == []


@pytest.mark.parametrize("arithmetic", [Double, Pair])
def test_edges_of_the_angle(arithmetic: Any) -> None:
    """All pairs of zeros, infinities, huge and tiny numbers."""
    values = [0.0, -0.0, 1, -1, np.inf, -np.inf, np.nan, 5e-324, 1e300, -1.7e308]
    points = np.array([(y, x) for y in values for x in values])
    given = np.zeros((len(points), 2, arithmetic.words))
    given[:, :, 0] = points
    found = _apply(arithmetic, "atan2", given)[:, 0]
    assert points[~_same(found, np.arctan2(*points.T))].tolist() == []


@pytest.mark.parametrize("arithmetic", [Double, Pair])
def test_sign(arithmetic: Any) -> None:
    """1, −1, nothing at zero."""
    given = np.zeros((5, 1, arithmetic.words))
    given[:, 0, 0] = [3, -1e-300, 0, np.inf, np.nan]
    found = _apply(arithmetic, "sign", given)[:, 0]
    np.testing.assert_array_equal(found, [1, -1, 0, 1, np.nan])


@pytest.mark.parametrize("name", ["sin", "cos", "tan"])
def test_angles_beyond_measure(name: str) -> None:
    """Where turns are not told apart there is no number, never a wrong one."""
    given = np.array([2.0**41, -1e18, 1e300]).reshape(3, 1, 1)
    assert np.isnan(_apply(Double, name, given)).all()


def test_results_too_small_for_ordinary_numbers() -> None:
    """The exponential fades out gradually."""
    given = np.linspace(-745.13, -708, 100).reshape(-1, 1, 1)
    with mpmath.workdps(DIGITS):
        right = [float(mpmath.exp(float(x))) for x in given[:, 0, 0]]
    found = _apply(Double, "exp", given)[:, 0]
    assert np.max(np.abs(found - right)) <= 5e-324


@pytest.mark.parametrize("arithmetic", [Double, Pair])
@pytest.mark.parametrize("name", sorted(FUNCTIONS))
def test_bits_do_not_depend_on_the_number_of_lanes(name: str, arithmetic: Any) -> None:
    """Widths 1, 2, 8, 16."""
    words = arithmetic.words
    given = (_points(words) if name == "atan2" else _given(name, words))[:96]
    found = [_apply(arithmetic, name, given, lanes).tobytes() for lanes in (1, 2, 8, 16)]
    assert len(set(found)) == 1


@pytest.mark.parametrize("arithmetic", [Double, Pair])
@pytest.mark.parametrize("name", sorted(FUNCTIONS))
def test_no_branches_and_no_calls(name: str, arithmetic: Any) -> None:
    """Nothing is written that would take lanes one by one."""
    w = IRWriter(8)
    k = arithmetic(w)
    operands = [k.load("%given", i) for i in range(2 if name == "atan2" else 1)]
    FUNCTIONS[name](k, *operands)
    calls = set(re.findall(r"@llvm\.(\w+)", "\n".join(w.lines)))
    assert calls <= {"fma", "sqrt"}
    assert not any(line.split()[0] == "br" or line.endswith(":") for line in w.lines)
