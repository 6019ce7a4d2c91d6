"""§3 beyond its claims: what they rest on, derived a second time or followed numerically."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp

from borisov_mamaev_2008.methods.catalogue_laws import law_named
from borisov_mamaev_2008.methods.derived_verdicts import contrary
from borisov_mamaev_2008.obstructions.divergence_at_equilibria import divergence, excludes_measure
from borisov_mamaev_2008.section_03 import section_03_2, section_03_3
from evaluation import numeric
from flowlanes.errors import InputError
from flowlanes.flow.integrator import integrate
from flowlanes.system.laws import Integral
from flowlanes.system.system import System
from lawproof.proof.prover import prove
from lawproof.proof.verdict import Verdict
from nonholonomic import from_catalogue
from nonholonomic.catalogue import CATALOGUE
from nonholonomic.starts import initial_state


def follow(name, values, times, **parameters):
    """The motion from a state given by the names of its variables."""
    system = CATALOGUE[name].system(parameters)
    if system.reconstruction is None:
        flat = np.concatenate([np.atleast_1d(values[str(n)]) for n in system.state])
        return integrate(system, flat, times)
    return integrate(system, initial_state(system, **values), times)


# --- rest points ---------------------------------------------------------------------------


@pytest.mark.slow
def test_divergence_of_a_celtic_stone_by_differences():
    verdict = section_03_2.celtic_stone()
    body = section_03_2.Body(
        1.0,
        ((1.0, 0.25, 0.0), (0.25, 1.5, 0.0), (0.0, 0.0, 2.0)),
        section_03_2.Ellipsoid((1.0, 0.75, 0.5)),
    )
    system = section_03_2.roll(body, field=section_03_2.Forces(10.0))
    rates = numeric(system, list(system.rates))
    rest, step = np.array([0.0, 0.0, 2.0, 0.0, 0.0, 1.0]), 1e-5
    total = 0.0
    for i in range(6):
        ahead, behind = rest.copy(), rest.copy()
        ahead[i] += step
        behind[i] -= step
        pair = np.stack([ahead, behind], axis=1)
        found = np.asarray(rates(pair)[i])
        total += (found[0] - found[1]) / (2 * step)
    assert float(sp.Rational(verdict.witness["residual"])) == pytest.approx(total, rel=1e-7)
    assert abs(total) > 0.01


def test_a_moving_point_is_refused():
    system = CATALOGUE["chaplygin-sleigh-reduced"].system()
    point = {s: sp.S.One for s in (*system.defaults, *system.symbols)}
    with pytest.raises(ValueError, match="not a rest point"):
        divergence(system, point)


def test_a_rest_point_without_divergence_decides_nothing():
    system = CATALOGUE["suslov"].system({"I_13": 0.0, "I_23": 0.0})
    point = {p: sp.nsimplify(value, rational=True) for p, value in system.defaults.items()}
    axis = (1, 0, 0, 1, 0, 0)
    still = {**point, **dict(zip(system.symbols, map(sp.Integer, axis), strict=True))}
    assert divergence(system, still) == 0
    assert excludes_measure(system, still).decision == "undecided"


def test_contrary():
    assert contrary(Verdict("law", "proven", finding="why")).decision == "refuted"
    assert contrary(Verdict("law", "proven", finding="why")).witness == {"shown": "why"}
    assert contrary(Verdict("law", "refuted")).decision == "proven"
    assert contrary(Verdict("law", "undecided", reason="why")).reason == "why"


def test_unknown_law():
    with pytest.raises(KeyError, match="suslov has no law 'spin'"):
        law_named(CATALOGUE["suslov"].system(), "spin")


# --- energy --------------------------------------------------------------------------------


def test_a_constraint_that_is_not_homogeneous_breaks_the_energy():
    """A point on a line that turns at the rate 1: q₁q̇₂ − q₂q̇₁ = q₁² + q₂²."""
    q_1, q_2, v_1, v_2 = sp.symbols("q_1 q_2 v_1 v_2", real=True)
    square, area = q_1**2 + q_2**2, q_1 * v_2 - q_2 * v_1
    multiplier = 2 * (q_1 * v_1 + q_2 * v_2) / square
    system = System(
        name="turning-line",
        title="a point on a turning line",
        field={q_1: v_1, q_2: v_2, v_1: -multiplier * q_2, v_2: multiplier * q_1},
        relations=(area - square,),
    )
    energy = (v_1**2 + v_2**2) / 2
    assert prove(system, Integral("energy", energy)).decision == "refuted"
    assert prove(system, Integral("jacobi", energy - area)).decision == "proven"


# --- brackets ------------------------------------------------------------------------------


def test_the_printed_jacobi_identity_is_that_of_closed_forms():
    """(3.6) holds for Ω = dA, a closed 2-form."""
    x = section_03_3.x
    A = [x[1] * x[2] ** 2, x[0] ** 3, x[0] * x[1]]
    omega = sp.Matrix(3, 3, lambda i, j: sp.diff(A[j], x[i]) - sp.diff(A[i], x[j]))
    assert sp.expand(section_03_3._cyclic_gradient(omega, 0, 1, 2)) == 0


def test_every_hamiltonian_flow_of_the_book_algebra_shrinks_or_grows_at_a_rest_point():
    system, structure = section_03_3._book()
    assert prove(system, structure)
    assert divergence(system, dict.fromkeys(section_03_3.x, sp.S.Zero)) == 2


# --- Suslov's problem ----------------------------------------------------------------------


def test_suslov_from_euler_and_a_torque_along_the_axis():
    """Iω̇ − Iω×ω − γ×∂U/∂γ is along e₃, and ω̇₃ = 0."""
    system = from_catalogue("suslov-quadratic")
    rng = np.random.default_rng(3)
    inertia = np.diag([CATALOGUE["suslov-quadratic"].defaults[f"I_{i}"] for i in (1, 2, 3)])
    strengths = np.diag([CATALOGUE["suslov-quadratic"].defaults[f"C_{i}"] for i in (1, 2, 3)])
    omega, gamma = np.array([*rng.normal(size=2), 0.0]), rng.normal(size=3)
    rates = np.asarray(numeric(system, list(system.rates))(np.array([*omega, *gamma])[:, None]))
    rates = rates.reshape(6)
    rest = inertia @ rates[:3] - np.cross(inertia @ omega, omega)
    rest -= np.cross(gamma, strengths @ gamma)
    np.testing.assert_allclose(rest[:2], 0.0, atol=1e-14)
    assert rates[2] == 0.0
    np.testing.assert_allclose(rates[3:], np.cross(gamma, omega), atol=1e-14)


def test_suslovs_problem_runs_as_the_bracket():
    p = CATALOGUE["suslov-quadratic"].defaults
    first, second = (p["C_1"] - p["C_3"]) / p["I_2"], (p["C_2"] - p["C_3"]) / p["I_1"]
    omega, gamma = np.array([0.9, -0.5, 0.0]), np.array([2.0, -3.0, 6.0]) / 7
    times = np.linspace(0.0, 20.0, 41)
    body = follow("suslov-quadratic", {"omega": omega, "gamma": gamma}, times)
    p_1, p_2 = -omega[1] / np.sqrt(first), omega[0] / np.sqrt(second)
    start = {"p_1": p_1, "p_2": p_2, "gamma": gamma}
    ratio = float(np.sqrt(second / first))
    other = follow("suslov-bracket", start, times * np.sqrt(first), d=ratio)
    np.testing.assert_allclose(other["gamma"], body["gamma"], atol=1e-12)
    np.testing.assert_allclose(other["p_1"], -body["omega"][:, 1] / np.sqrt(first), atol=1e-12)


def test_the_third_casimir_function_in_complex_form():
    """(p₁ + iγ₁)^d/(p₂ + iγ₂), continued along a motion, stays constant."""
    times = np.linspace(0.0, 20.0, 2001)
    start = CATALOGUE["suslov-bracket"].start.values
    d = 1.4142135623730951
    motion = follow("suslov-bracket", start, times)
    gamma = motion["gamma"]
    angle_1 = np.unwrap(np.arctan2(gamma[:, 0], motion["p_1"]))
    angle_2 = np.unwrap(np.arctan2(gamma[:, 1], motion["p_2"]))
    np.testing.assert_allclose(d * angle_1 - angle_2, d * angle_1[0] - angle_2[0], atol=1e-11)
    assert np.ptp(angle_1) > 1.0


def test_free_suslov_body_ends_in_a_permanent_rotation():
    """No measure: all motions tend to one half of the line I_13 ω₁ + I_23 ω₂ = 0."""
    times = np.linspace(0.0, 200.0, 21)
    motion = follow("suslov", {"omega": (0.9, -0.5, 0.0), "gamma": (1.0, 0.0, 0.0)}, times)
    defaults = CATALOGUE["suslov"].defaults
    product = defaults["I_13"] * motion["omega"][:, 0] + defaults["I_23"] * motion["omega"][:, 1]
    assert abs(product[0]) > 0.1
    assert abs(product[-1]) < 1e-9


def test_both_forces_of_the_potential_must_pull_to_the_axis():
    with pytest.raises(InputError, match="C_1 > C_3 must hold"):
        CATALOGUE["suslov-quadratic"].system({"C_3": 1.5})
