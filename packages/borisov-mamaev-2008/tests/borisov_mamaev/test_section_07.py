"""The corrected formulas of §7 along numerical motions, and by a derivation of their own."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import solve_ivp

from evaluation import numeric
from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.system import System
from flowlanes.system.vectors import Diagonal, Vector, to_components
from nonholonomic.catalogue import CATALOGUE
from nonholonomic.catalogue.chaplygin_ball.chaplygin_ball import DENSITY
from nonholonomic.catalogue.chaplygin_ball.chaplygin_ball_angles import (
    MOMENTUM,
    VERTICAL,
    ball_in_angles,
    c,
    gyroscopic,
    gyroscopic_matrix,
    p_phi,
    p_theta,
    phi,
    reduction,
    theta,
)
from nonholonomic.catalogue.chaplygin_ball.chaplygin_bracket import hamiltonian_form

M, L, gamma, k = (Vector(name) for name in ("M", "L", "gamma", "k"))
I, J, A = Diagonal("I"), Diagonal("J"), Diagonal("A")
N = sp.Symbol("N", real=True)
NORMAL = np.array([2.0, -3.0, 6.0]) / 7.0
LEVEL = np.cross(NORMAL, [0.7, 0.4, 1.1])  # a momentum with (M, γ) = 0
FREE = np.array([0.9, -0.2, 1.3])
MOVED = 0.02


def named(system: System, name: str) -> Isomorphism:
    (law,) = (item for item in system.laws if item.name == name)
    assert isinstance(law, Isomorphism)
    return law


def to_bracket_with_rotors() -> tuple[System, Isomorphism]:
    target = hamiltonian_form(sp.S.Zero, k)
    law = Isomorphism("form", target, {L: DENSITY * (M + k), gamma: gamma}, DENSITY)
    return CATALOGUE["chaplygin-ball-gyrostat"].system(), law


def of_the_ball(name: str) -> Callable[[], tuple[System, Isomorphism]]:
    def both() -> tuple[System, Isomorphism]:
        system = CATALOGUE["chaplygin-ball"].system()
        return system, named(system, name)

    return both


def to_angles_with_rotors() -> tuple[System, Isomorphism]:
    return ball_in_angles(k), reduction(k)


CASES = {
    "Theorem 10": (of_the_ball("clebsch_case"), [*LEVEL, *NORMAL]),
    "Fedorov": (of_the_ball("fedorov"), [*LEVEL, *NORMAL]),
    "bracket with rotors": (to_bracket_with_rotors, [*FREE, *NORMAL]),
    "angles with rotors": (to_angles_with_rotors, [1.1, 0.4, *FREE]),
}


def end(field: Callable[[np.ndarray], np.ndarray], start: np.ndarray, until: float) -> np.ndarray:
    found = solve_ivp(
        lambda _, x: field(x), (0.0, until), start, method="DOP853", rtol=1e-12, atol=1e-12
    )
    assert found.success
    return found.y[:, -1]


def gap(system: System, law: Isomorphism, start: list[float]) -> float:
    """Distance of the carried motion from the target's own, after the time 3 of the target."""
    target = law.target
    place = [value for _, formula in law.map for value in _flat(formula)]
    onto = numeric(system, place)
    speed = numeric(system, [rate / to_components(law.time) for rate in system.rates])
    names = [symbol for symbol, _ in law.constants]
    fixed = numeric(system, [formula for _, formula in law.constants])(start)
    values = {str(p.symbol): p.default for p in system.parameters}
    inherited = {p.symbol: values.get(str(p.symbol), p.default) for p in target.parameters}
    inherited |= dict(zip(names, map(float, fixed), strict=True))
    field = numeric(target, target.rates, inherited)
    begin = np.asarray(onto(start), dtype=float)
    arrived = onto(end(speed, np.asarray(start, dtype=float), 3.0))
    return float(np.abs(end(field, begin, 3.0) - arrived).max())


def _flat(formula: object) -> list[sp.Expr]:
    value = to_components(formula)
    return list(value) if isinstance(value, sp.MatrixBase) else [value]


@pytest.mark.slow
@pytest.mark.parametrize("case", CASES)
def test_the_motion_is_carried_to_the_target(case):
    make, start = CASES[case]
    system, law = make()
    assert gap(system, law, start) < 1e-9


@pytest.mark.parametrize("case", ["Theorem 10", "Fedorov", "angles with rotors"])
def test_the_printed_form_leads_elsewhere(case):
    make, start = CASES[case]
    system, law = make()
    assert gap(system, law.as_printed, start) > MOVED


# --- S̄ with rotors by (4.5), and the bracket it gives -----------------------------------------

NUMBERS = {
    symbol: sp.Rational(number)
    for symbol, number in (
        *zip(I.symbols, ("1.1", "1.6", "2.3"), strict=True),
        *zip(k.symbols, ("0.3", "-0.5", "0.2"), strict=True),
        *zip(sp.symbols("m R", real=True), ("0.7", "1"), strict=True),
        *zip((theta, phi, c, p_theta, p_phi), ("0.7", "0.4", "0.9", "0.3", "-0.8"), strict=True),
    )
}
REACH = sp.Rational("0.7")
MOMENTS = [i + REACH for i in I.symbols]
TENSORS = {
    **dict(zip(J.symbols, MOMENTS, strict=True)),
    **{a: 1 / j for a, j in zip(A.symbols, MOMENTS, strict=True)},
}
UP = sp.Matrix(to_components(VERTICAL))
ROTORS = sp.Matrix(k.symbols)
LEVER = sp.Matrix([g / j for g, j in zip(UP, MOMENTS, strict=True)])
DET_J = sp.Mul(*MOMENTS)
RHO = 1 / sp.sqrt(DET_J * (1 - REACH * UP.dot(LEVER)))


def value(formula: sp.Expr) -> float:
    inner = {**dict(zip(gamma.symbols, UP, strict=True)), N: RHO}
    return float(to_components(formula).subs(inner).subs(TENSORS).subs(NUMBERS))


def by_reducing_multiplier(velocity: tuple[float, float]) -> float:
    """N S + (∂N/∂φ P_θ − ∂N/∂θ P_φ) with the signs of (7.10), from T₀ with (ω, k)."""
    dtheta, dphi, dpsi = sp.symbols("dtheta dphi dpsi")
    sine, cosine, turn, across = sp.sin(theta), sp.cos(theta), sp.sin(phi), sp.cos(phi)
    spin = sp.Matrix(
        [
            dpsi * sine * turn + dtheta * across,
            dpsi * sine * across - dtheta * turn,
            dpsi * cosine + dphi,
        ]
    )
    kinetic = spin.dot(sp.diag(*I.symbols) * spin) / 2 + spin.dot(ROTORS)
    kinetic += REACH / 2 * (dtheta**2 + dphi**2 * sine**2)
    (precession,) = sp.solve(sp.diff(kinetic, dpsi) - c, dpsi)
    routh = (kinetic - dpsi * c).subs(dpsi, precession)
    twist = REACH * sine * (dphi * cosine + precession)
    slopes = sp.diff(routh, dtheta), sp.diff(routh, dphi)
    total = RHO * twist - (sp.diff(RHO, phi) * slopes[0] - sp.diff(RHO, theta) * slopes[1])
    return value(total.subs(dict(zip((dtheta, dphi), velocity, strict=True))))


@pytest.mark.slow
@pytest.mark.parametrize("velocity", [(0.35, -0.6), (1.2, 0.9), (-2.0, 0.1)])
def test_the_gyroscopic_term_follows_from_the_reducing_multiplier(velocity):
    derived = by_reducing_multiplier(velocity)
    assert value(gyroscopic(k)) == pytest.approx(derived, rel=1e-12)
    assert abs(value(gyroscopic(-k)) - derived) > MOVED * abs(derived)


@pytest.mark.slow
def test_the_bracket_with_rotors_follows_from_that_of_theorem_9():
    """{L_i, L_j} by (7.14), with the opposite sign, is ε_ijk u_k of the catalogue's bracket."""
    momenta = sp.Matrix(to_components(MOMENTUM)).subs(N, RHO)
    jacobian = momenta.jacobian([theta, phi, p_theta, p_phi])
    twist = (
        to_components(gyroscopic(k)).subs(N, RHO).subs(dict(zip(gamma.symbols, UP, strict=True)))
    )
    found = jacobian * sp.Matrix(gyroscopic_matrix(twist)) * jacobian.T
    u = dict(hamiltonian_form(sp.S.Zero, k).definitions)[Vector("u")]
    here = dict(zip(L.symbols, momenta, strict=True)) | {sp.Symbol("rho", real=True): RHO}
    stated = [component.subs(here) for component in to_components(u)]
    for i, j, third in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        assert value(-found[i, j]) == pytest.approx(value(stated[third]), rel=1e-12)
