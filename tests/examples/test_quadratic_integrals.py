"""The certificates of nonholonomic/docs/quadratic-integrals.md."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
import sympy as sp
from flint import arb, ctx

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "packages/nonholonomic/docs/quadratic-integrals.md").read_text(encoding="utf-8")
BODY = [[0, 5, 14, 31], [5, 0, 17, 34], [14, 17, 0, 43], [31, 34, 43, 0]]


@pytest.fixture(scope="module")
def example():
    sys.path.insert(0, str(ROOT / "examples"))
    try:
        import quadratic_integrals

        yield quadratic_integrals
    finally:
        sys.path.remove(str(ROOT / "examples"))


@pytest.fixture(scope="module")
def torus():
    sys.path.insert(0, str(ROOT / "examples"))
    try:
        import quadratic_integrals_torus

        yield quadratic_integrals_torus
    finally:
        sys.path.remove(str(ROOT / "examples"))


@pytest.mark.parametrize(("n", "terms"), [(3, 264), (4, 3264)])
def test_the_lemma(example, n: int, terms: int) -> None:
    counts = list(example.lemma_terms(n))
    assert sum(before for before, _ in counts) == terms
    assert all(left == 0 for _, left in counts)
    assert str(terms) in PAGE


def test_the_multiplier_needs_products(example) -> None:
    I = {name: sp.Symbol(f"I_{name}") for name in ("12", "13", "14", "23", "24", "34")}
    a, b, c = (I["12"] * I["34"], I["13"] * I["24"], I["14"] * I["23"])
    x, y = sp.symbols("x y")
    for residual, difference in zip(
        example.multiplier_residuals(), (b - c, a - c, a - b), strict=True
    ):
        ratio = sp.cancel(residual / difference)
        assert sp.simplify(ratio / (x * y * (x**2 + y**2))) in (1, -1)


def test_search(example) -> None:
    assert example.dimension(BODY, 2, 2) == (84, 1)
    assert example.dimension(example.GENERIC, 1, 3) == (70, 0)


def test_independent_polynomials_are_those_that_are_no_multiples(example) -> None:
    for in_u, in_gamma in re.findall(r"^\| (\d) \| (\d) \|", PAGE, re.MULTILINE):
        sizes = [
            len(example.exponents(4, int(in_u) - less))
            * len(example.exponents(4, int(in_gamma) - less))
            for less in (0, 1)
        ]
        assert f"| {in_u} | {in_gamma} | {sizes[0] - sizes[1]} |" in PAGE


@pytest.mark.slow
def test_further_search(example) -> None:
    assert example.dimension(BODY, 2, 4) == (270, 3)
    assert example.dimension(example.GENERIC, 2, 4) == (270, 2)


@pytest.mark.parametrize(
    ("in_u", "in_gamma", "count"),
    [(1, 3, 0), (2, 2, 1), (2, 4, 3), (4, 4, 1), (4, 6, 3), (4, 8, 6)],
)
def test_products_of_those_known(example, in_u: int, in_gamma: int, count: int) -> None:
    assert example.known(in_u, in_gamma, 3) == count
    assert re.search(rf"\| {in_u} \| {in_gamma} \| \d+ \| {count} \| {count} \|", PAGE)


@pytest.fixture(autouse=True)
def the_precision_of_others() -> Iterator[None]:
    """What is set here for balls ends with the test."""
    before = ctx.prec, ctx.cap
    yield
    ctx.prec, ctx.cap = before


def test_a_step_of_the_orbit_is_enclosed(torus) -> None:
    ctx.prec = torus.BITS
    zeros = [arb(zero).mid() for zero in torus.MARBLE.zeros]
    flow = torus.TorusFlow(torus.MARBLE, zeros, slopes=True)
    start = [[arb(1), arb(0), arb(0)], [arb(2), arb(0), arb(0)]]
    step = arb(1) / 64
    series = flow.coefficients(arb(0), start, 24)
    box = flow._box(arb(0), start, arb(0).union(step))
    for near, inside in zip(series, box, strict=True):
        for coefficients, ball in zip(near, inside, strict=True):
            for share in (0, 1, 2, 3, 4):
                time = step * share / 4
                value = sum((a * time**i for i, a in enumerate(coefficients)), arb(0))
                assert ball.contains(value)


def test_both_ways_to_the_flow_on_the_torus_agree(torus) -> None:
    zeros = [float(zero) for zero in torus.TOP.zeros]
    system = torus.section_system(zeros)
    values = {s: sp.Float(x) for s, x in zip(system.symbols, (0.4, 1.1, 2.5), strict=True)}
    for symbol, formula in system.scalar_definitions:
        values[symbol] = formula.subs(values)
    rates = [float(formula.subs(values)) for formula in system.rates]
    ctx.prec = torus.BITS
    flow = torus.TorusFlow(torus.TOP, [arb(zero).mid() for zero in torus.TOP.zeros], slopes=False)
    ctx.cap = 1
    jets = [torus.Jet(torus.arb_series([angle], 1)) for angle in (1.1, 2.5)]
    second, third = flow.rate(torus.arb_series([0.4], 1), jets)
    assert [1.0, float(second.value[0]), float(third.value[0])] == pytest.approx(rates, rel=1e-12)


def test_slopes_are_those_of_the_flow(torus) -> None:
    ctx.prec = torus.BITS
    centre = [arb(zero).mid() for zero in torus.MARBLE.zeros]
    ctx.cap = 1
    jets = [torus.Jet(torus.arb_series([x], 1), (torus.arb_series([0], 1),) * 2) for x in (1, 2)]
    x = torus.arb_series([3], 1)
    flow = torus.TorusFlow(torus.MARBLE, centre, slopes=True)
    step = arb("1e-12")
    for i in range(2):
        moved = [zero + (step if i == j else 0) for j, zero in enumerate(centre)]
        near = torus.TorusFlow(torus.MARBLE, moved, slopes=True).rate(x, jets)
        for here, there in zip(flow.rate(x, jets), near, strict=True):
            quotient = (there.value - here.value) / step
            assert float(quotient[0]) == pytest.approx(float(here.slope[i][0]), rel=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "misses"), [("TOP", ("0.000852148", "0.001811134")), ("MARBLE", ("0.00012", "0.0005"))]
)
def test_the_torus_is_not_linear(torus, name: str, misses: tuple[str, str]) -> None:
    lines = list(torus.nonlinear_torus(getattr(torus, name)))
    assert lines[-1].endswith("proven")
    for miss in misses:
        assert miss in lines[1] and miss in PAGE


@pytest.mark.slow
def test_the_certificate_does_not_refute_what_is_linear(
    torus, monkeypatch: pytest.MonkeyPatch
) -> None:
    # I_ij = a_i a_j: the β_k are products, and all orbits of a level close together
    class Special(torus.Top):
        def factor(self, first, second):
            return (first * second).inverse()

    monkeypatch.setattr(torus, "WINDING", (6, 3, 2))
    zeros = ("0.79494381000195", "1.89705063492645")
    body = Special("special", torus.TOP.masses, zeros, 400)
    assert list(torus.nonlinear_torus(body))[-1].endswith("undecided")


def test_what_the_page_shows_runs(capsys: pytest.CaptureFixture[str]) -> None:
    (step,) = re.findall(r"```python\n(.*?)```", PAGE, re.DOTALL)
    exec(compile(step, "quadratic-integrals.md", "exec"), {})
    assert capsys.readouterr().out == "['pencil_1', 'pencil_2', 'pencil_3']\n3\n"


def test_the_picture_is_there() -> None:
    (picture,) = re.findall(r"!\[.*?\]\((.*?)\)", PAGE)
    assert (ROOT / "packages/nonholonomic/docs" / picture).exists()
