"""Error bounds of closed forms: they hold, and they are small."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
import sympy as sp
from flint import acb, acb_mat, arb, ctx

from flowlanes.errors import InputError
from flowlanes.formulas.balls import components
from nonholonomic.catalogue import from_catalogue
from nonholonomic.closed_form import solve
from nonholonomic.closed_form.genus_two.separated_motion import (
    SeparatedMotion,
    separate,
    steps_from_torus,
)
from nonholonomic.closed_form.genus_two.separation import SeparatedSystem, nu, nuprime
from nonholonomic.closed_form.genus_two_solution import solve_on_torus
from nonholonomic.closed_form.rigorous import analyticity_strip, rigorous_motion
from nonholonomic.closed_form.rigorous.affine import Affine
from nonholonomic.closed_form.rigorous.analyticity_strip import least, lines_of, strip_bound
from nonholonomic.closed_form.rigorous.branch_formula import Branch, LeavesBranchError, direction
from nonholonomic.closed_form.rigorous.quadrature import (
    RigorousQuadrature,
    _fourier_coefficients,
    _reflection,
    _symmetry,
    _values_on_grid,
    quadratures,
)
from nonholonomic.closed_form.rigorous.theta import Numerators, numerators_at
from nonholonomic.closed_form.separations.bruns import veselova_in_bruns_field
from nonholonomic.closed_form.separations.chaplygin_ball import chaplygin_ball
from nonholonomic.closed_form.separations.rubber_sphere import hollow_ball
from nonholonomic.closed_form.separations.veselova import veselova
from nonholonomic.starts import initial_state

BITS = 300
VESELOVA = veselova()
BODY = dict(
    zip(
        (p.symbol for p in VESELOVA.system.parameters),
        map(Fraction, ("1", "3/2", "17/8")),
        strict=True,
    )
)
START = tuple(map(Fraction, ("11/15", "-2/15", "-2/3", "2/3", "1/3", "2/3")))


@pytest.fixture(scope="module")
def motion() -> SeparatedMotion:
    with ctx.workprec(BITS):
        return separate(VESELOVA, BODY, START)


def clock(motion: SeparatedMotion) -> Branch:
    rate = components(VESELOVA.time_rescaling)
    return Branch(rate, motion.values, steps_from_torus(VESELOVA, rate)[1])


@pytest.fixture(scope="module")
def quadrature(motion: SeparatedMotion) -> RigorousQuadrature:
    (found,) = quadratures(motion.torus, clock(motion), 22, 1e6)
    return found


def summed(quadrature: RigorousQuadrature, until: int) -> Any:
    """The integral by Gauss's rule with 36 nodes on every unit of τ."""
    with ctx.workprec(130):
        total = arb(0)
        for k in range(36):
            node, weight = arb.legendre_p_root(36, k, weight=True)
            for first in range(until):
                total += weight / 2 * quadrature.rate((first + (node + 1) / 2).mid())
        return total


# --- affine numbers ------------------------------------------------------------------------


def boxes(generator: np.random.Generator, count: int = 50) -> Affine:
    def drawn(*shape: int) -> Any:
        return generator.normal(size=shape) + 1j * generator.normal(size=shape)

    return Affine(2 + drawn(count), drawn(2, count), 1e-3 * np.ones(count), (0.02, 0.03))


OPERATIONS = {
    "sum": lambda x, y: x + y,
    "difference": lambda x, y: x - y,
    "product": lambda x, y: x * y,
    "multiple": lambda x, _: x * 3,
    "root": lambda x, _: x.sqrt() if isinstance(x, Affine) else np.sqrt(x),
    "inverse": lambda x, _: x.inverse() if isinstance(x, Affine) else 1 / x,
}


@pytest.mark.parametrize("name", OPERATIONS)
def test_affine_operations_contain_the_values(name: str) -> None:
    generator = np.random.default_rng(7)
    x, y = boxes(generator), boxes(generator)
    result = OPERATIONS[name](x, y)
    for _ in range(200):
        place = generator.uniform(-1, 1, size=2) * np.array(x.half)
        turn = np.exp(2j * np.pi * generator.uniform(size=2))
        values = [
            z.middle + place @ z.slopes + t * z.rest for z, t in zip((x, y), turn, strict=True)
        ]
        gap = np.abs(OPERATIONS[name](*values) - result.middle - place @ result.slopes)
        assert np.all(gap <= result.rest)


@pytest.mark.parametrize("middle", [-1.0, 0.01, -1 + 0.01j])
def test_affine_root_knows_where_it_does_not_exist(middle: complex) -> None:
    number = Affine(np.array([middle]), np.ones((2, 1), complex), np.zeros(1), (0.02, 0.02))
    with np.errstate(all="ignore"):
        assert not np.isfinite(number.sqrt().size).any()


# --- formulas ------------------------------------------------------------------------------


def test_formulas_leave_their_branch() -> None:
    x = nu.symbols[0]
    with pytest.raises(LeavesBranchError):
        Branch([sp.sqrt(x - 2)], {}).at([arb(1)] * 3, [arb(0)] * 3)
    with pytest.raises(LeavesBranchError):
        Branch([1 / x], {}).at([arb(0, 1)] * 3, [arb(0)] * 3)


def test_formulas_of_other_kinds_are_refused() -> None:
    with pytest.raises(ValueError, match="neither a sum, a product nor a root"):
        Branch([sp.sin(nu.symbols[0])], {})


def test_parities_are_read_off_the_formulas() -> None:
    x, y, _ = nu.symbols
    dx = nuprime.symbols[0]
    formulas = [x * y, sp.sqrt(x**2 + y**2), x**3 / y**2, x + y, x * dx + 1, sp.sqrt(x + 2)]
    assert Branch(formulas, {}).parities([-1, 1, 1]) == [-1, 1, -1, 0, 1, 0]
    assert Branch([x * dx, y * dx], {}).parities([-1, 1, 1], [1, -1, -1]) == [-1, 1]


# --- theta functions -----------------------------------------------------------------------


def test_numerators_are_theta_functions(motion: SeparatedMotion) -> None:
    torus, Y = motion.torus, motion.torus.lattice.Y
    with ctx.workprec(120):
        N, _ = Numerators(torus, (0, 0)).real(lines_of((3, 5), (1, 1)))
        matrix = acb_mat([[acb(0, Y[i, j]) for j in (0, 1)] for i in (0, 1)])
        for j, k in np.ndindex(3, 5):
            values = matrix.theta(acb_mat([[arb(j) / 3], [arb(k) / 5]])).entries()
            for own, c, theta in zip(N, torus.factors, torus.thetas, strict=True):
                (a, b), (e, f) = ((x % 2, y % 2) for x, y in theta.characteristic)
                known = c * values[8 * a + 4 * b + 2 * e + f].real
                # characteristics are classes modulo 2, up to the sign
                n = own[j, k]
                assert any(n.overlaps(sign * known) for sign in (1, -1))
                assert n.rad() < 1e-30


def test_rates_are_derivatives(motion: SeparatedMotion) -> None:
    torus = motion.torus
    with ctx.workprec(200):
        step = arb(2) ** -40
        moving = replace(torus, V=torus.along)
        before, after = (numerators_at(moving, t)[0] for t in (-step, step))
        _, rate = numerators_at(moving, arb(0))
        for a, b, r in zip(before, after, rate, strict=True):
            assert abs((b - a) / (2 * step) - r) < 1e-20


def test_boxes_contain_the_numerators(motion: SeparatedMotion) -> None:
    torus, heights = motion.torus, (0.05, -0.03)
    with ctx.workprec(64):
        numerators = Numerators(torus, heights)
        rough = numerators.boxes(lines_of((8, 8), (1, 1)), (1 / 16, 1 / 16))
        fine = numerators.boxes(lines_of((32, 32), (1, 1)), (0.0, 0.0))
    for coarse, points in zip((*rough[0], *rough[1]), (*fine[0], *fine[1]), strict=True):
        middle = coarse.middle.reshape(8, 8)
        for i in (-1, 0, 1):
            for j in (-1, 0, 1):
                at = points.middle.reshape(32, 32)
                at = np.roll(at, (-i, -j), axis=(0, 1))[::4, ::4]
                line = np.tensordot([i / 32, j / 32], coarse.slopes, 1).reshape(8, 8)
                inner = slice(1, 7)
                gap = np.abs(at - middle - line)[inner, inner]
                assert np.all(gap <= coarse.rest.reshape(8, 8)[inner, inner])


# --- the strip -----------------------------------------------------------------------------


@pytest.mark.slow
def test_strip_bound_holds_inside(motion: SeparatedMotion) -> None:
    torus, branch = motion.torus, clock(motion)
    with ctx.workprec(64):
        branch.learn(*direction(*numerators_at(torus, arb(0))))
        strip = strip_bound(torus, branch, (1, 1))
        generator = np.random.default_rng(3)
        assert min(strip.half) > 0.03
        for _ in range(6):
            heights = generator.uniform(-1, 1, size=2) * strip.half
            N, rate = Numerators(torus, heights).boxes(lines_of((20, 20), (1, 1)), (0.0, 0.0))
            (values,) = branch.values_on_boxes(*direction(N, rate))
            assert np.abs(values.middle).max() < strip.bounds[0]


def test_strip_that_a_sample_allows_is_proven_on_all_boxes(
    motion: SeparatedMotion, monkeypatch: pytest.MonkeyPatch
) -> None:
    torus, branch = motion.torus, clock(motion)
    branch.learn(*direction(*numerators_at(torus, arb(0))))
    widths = analyticity_strip._widths

    def too_wide(*arguments: Any) -> tuple[float, float]:
        return widths(*arguments) if arguments[-1] == 1 else (0.59, 0.59)

    monkeypatch.setattr(analyticity_strip, "_widths", too_wide)
    found = strip_bound(torus, branch, (1, 1))
    assert [max(found.half) < 0.59, *np.isfinite(found.bounds)] == [True, True]


@pytest.mark.slow
def test_least_is_below_all_values(motion: SeparatedMotion, quadrature: RigorousQuadrature) -> None:
    bound = least(motion.torus, quadrature.branch, (1, 1))
    assert 0 < bound < min(float(quadrature.rate(arb(t)).mid()) for t in range(200))


@pytest.mark.slow
def test_next_to_a_separatrix_there_are_no_bounds() -> None:
    near = tuple(map(Fraction, ("1/10000000", "1", "0", "1", "-1/10000000", "0")))
    with ctx.workprec(BITS):
        torus = separate(VESELOVA, BODY, near).torus
        branch = Branch([sp.Integer(1) + nu.symbols[0] ** 2], {})
        with pytest.raises(InputError, match="separatrix"):
            quadratures(torus, branch, 20, 1.0)


# --- quadratures ---------------------------------------------------------------------------


@pytest.mark.parametrize("place", [None, 0, 1, 2])
def test_values_by_reflection_and_their_coefficients_are_those_of_the_formulas(
    motion: SeparatedMotion, place: int | None
) -> None:
    """Of the clock and of components of ν and ν′, which change their sign with the periods."""
    torus = motion.torus
    with ctx.workprec(120):
        branch = clock(motion)
        if place is not None:
            branch = Branch([nu.symbols[place], nuprime.symbols[place]], {})
        periods, shifts = _symmetry(torus, branch)
        assert all(_reflection(torus, branch))
        lines = lines_of((5, 7), periods)
        grids = _values_on_grid(torus, branch, lines, shifts)
        N, rate = Numerators(torus, (0, 0)).real(lines)
        for j, k in np.ndindex(5, 7):
            known = branch.at(*direction([x[j, k] for x in N], [x[j, k] for x in rate]))
            assert all(grid[j, k].overlaps(x) for grid, x in zip(grids, known, strict=True))
            assert all(grid[j, k].rad() < 1e-25 for grid in grids)
        for grid, shift in zip(grids, shifts, strict=True):
            table = _fourier_coefficients(grid, lines, shift)
            one, two = (
                [Fraction(2 * i + own, 2) for i in range(-(count // 2), count // 2 + 1)]
                for count, own in zip((5, 7), shift, strict=True)
            )
            for j, k in np.ndindex(5, 7):
                left, right = (
                    [acb(arb(2 * int(x * 2) * place) / (2 * count)).exp_pi_i() for x in numbers]
                    for numbers, place, count in ((one, j, 5), (two, k, 7))
                )
                value = (acb_mat([left]) * table * acb_mat([[x] for x in right]))[0, 0]
                assert value.real.overlaps(grid[j, k])
                assert value.imag.contains(0)


@pytest.mark.slow
def test_quadrature_agrees_with_gauss(quadrature: RigorousQuadrature) -> None:
    assert abs(quadrature.integral(3) - summed(quadrature, 3)) < 1e-21


@pytest.mark.slow
def test_bounds_of_a_coarse_quadrature_hold(
    motion: SeparatedMotion, quadrature: RigorousQuadrature
) -> None:
    (coarse,) = quadratures(motion.torus, clock(motion), 3, 100.0)
    assert coarse.coefficients.nrows() < quadrature.coefficients.nrows()
    for tau in (0, 0.5, 7, 100, -33):
        assert coarse.integral(tau).contains(quadrature.integral(tau))
        assert coarse.integral(tau).rad() < 1e-3


def test_mean_is_the_mean(quadrature: RigorousQuadrature) -> None:
    assert abs(quadrature.integral(1e6) / 1e6 - quadrature.mean) < 1e-6
    assert quadrature.mean.rad() < 1e-26


@pytest.mark.parametrize("tau", [0, 1, -12.5, 1e6])
def test_inverse_contains_where_it_came_from(quadrature: RigorousQuadrature, tau: float) -> None:
    found = quadrature.inverse(quadrature.integral(tau))
    assert found.contains(arb(tau))
    assert found.rad() < 1e-20


@pytest.mark.slow
def test_odd_functions_are_integrated_on_the_same_grid(motion: SeparatedMotion) -> None:
    (found,) = quadratures(motion.torus, Branch(nu.symbols[:1], {}), 22, 10.0)
    assert any(found.shift)
    assert found.periods == (1, 1)
    assert found.mean.contains(0)
    assert abs(found.integral(3) - summed(found, 3)) < 1e-21


@pytest.mark.slow
def test_resonant_motion(motion: SeparatedMotion) -> None:
    with ctx.workprec(BITS):
        torus = replace(motion.torus, V=(arb(2) / 7, arb(1) / 7))
    (found,) = quadratures(torus, clock(motion), 22, 10.0)
    assert abs(found.integral(3) - summed(found, 3)) < 1e-21


# --- states --------------------------------------------------------------------------------


@pytest.mark.slow
def test_states_keep_the_integrals_and_agree_with_doubles() -> None:
    system = replace(VESELOVA.system, reconstruction=None, observables=())
    solution = solve_on_torus(replace(VESELOVA, system=system), BODY, START)
    motion = rigorous_motion(solution, 20, 1e6)
    state = motion.state("1e6")
    with ctx.workprec(200):
        omega, gamma = state[:3], state[3:]
        moments = [arb(x.numerator) / x.denominator for x in BODY.values()]
        energy = sum((i * w * w for i, w in zip(moments, omega, strict=True)), arb(0))
        before = sum(i * x * x for i, x in zip(BODY.values(), START, strict=False))
        assert energy.contains(arb(before.numerator) / before.denominator)
        assert sum((g * w for g, w in zip(gamma, omega, strict=True)), arb(0)).contains(0)
    assert max(float(x.rad()) for x in state) < 1e-19
    again = solution.rigorous(1e6, 20)
    assert all(x.overlaps(y) for x, y in zip(state, again, strict=True))
    rough = solution.states(np.array([1e6]))[0]
    assert max(abs(float(x.mid()) - y) for x, y in zip(state, rough, strict=True)) < 1e-11


@pytest.mark.slow
@pytest.mark.parametrize("make", [chaplygin_ball, veselova_in_bruns_field])
def test_motion_in_space_agrees_with_doubles(make: Callable[[], SeparatedSystem]) -> None:
    """Two fixed directions and a path, and one fixed direction."""
    separable = make()
    values = {p.symbol: p.default for p in separable.system.parameters}
    start = initial_state(separable.system, (1.0, 0.5, 0.0), (0.0, 0.0, 1.0))
    solution = solve_on_torus(separable, values, start)
    balls = rigorous_motion(solution, 8, 30.0).state(30.0)
    assert max(float(x.rad()) for x in balls) < 1e-8
    rough = solution.states(np.array([30.0]))[0]
    assert len(balls) == len(rough)
    assert max(abs(float((x - float(y)).mid())) for x, y in zip(balls, rough, strict=True)) < 1e-12


@pytest.mark.slow
def test_without_fixed_directions_there_are_bounds_of_the_reduced_state_alone() -> None:
    separable = hollow_ball()
    values = {p.symbol: p.default for p in separable.system.parameters}
    start = initial_state(separable.system, (1.0, 0.5, 0.0), (0.0, 0.0, 1.0))
    solution = solve_on_torus(separable, values, start)
    assert "no direction is known" in solution.not_rigorous
    balls = solution.rigorous(30.0, 8)
    assert len(balls) == len(start)
    assert max(float(x.rad()) for x in balls[:6]) < 1e-8
    assert all(x.rad() == arb("inf") for x in balls[6:])
    rough = solution.states(np.array([30.0]))[0, :6]
    for ball, number in zip(balls[:6], rough, strict=True):
        assert abs(ball - arb(float(number))) < 1e-12


@pytest.mark.slow
def test_a_place_that_is_left_open_is_said_to_be() -> None:
    system = from_catalogue("rubber-chaplygin-ball-bruns")
    start = initial_state(system, (1.0, 0.5, 0.0), (0.0, 0.0, 1.0))
    solution = solve(system, start)
    assert "one direction alone is known that stays in space" in solution.not_rigorous
    assert solve(from_catalogue("veselova"), start[:10]).not_rigorous == ""


@pytest.mark.slow
@pytest.mark.parametrize("time", ["1e300", "-1e61"])
def test_times_beyond_all_measure_are_refused(time: str) -> None:
    start = initial_state(VESELOVA.system, (0.8, 0.1, -0.6), (0.6, 0.0, 0.8))
    motion = solve_on_torus(VESELOVA, VESELOVA.system.defaults, start)
    with pytest.raises(InputError, match=r"up to \|t\| = [0-9.]+e\+(59|60|61), not"):
        motion.rigorous(time, 20)
