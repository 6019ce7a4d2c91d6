"""The rubber ball on a sphere as a family in the ratio k: (9.2) for any k and inertia J.

k = a/(a + b) for a ball of radius b on a sphere of signed radius a, and J = I + mb².  k = 1 is
the plane (and the Veselova system with J for I); k = −1 a hollow ball around a sphere of half
its radius.  As a family it is integrable for k = 1 and k = −1 and conformally Hamiltonian for
every k: in

    M = Ñ J^(1/2) ω,   γ = J^(−1/2) n / ρ,   ρ² = (n, J⁻¹n),   Ñ = (√det J / k) ρ^(1/k)

and the time dτ = ρ^(1/k − 2) dt it is the system of :mod:`.rubber_ball_on_e3`.
"""

from __future__ import annotations

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import Identity, Integral, Law, Measure, Rate
from flowlanes.system.system import Observable, System
from flowlanes.system.vectors import (
    Components,
    Diagonal,
    constant,
    cross,
    dot,
    norm_squared,
    real_symbol,
    vectors,
    zero,
)

from . import power_potential_on_sphere, rubber_ball_on_e3
from .rubber_ball_on_e3 import DEFAULTS, parameters

omega, n, X, torque = vectors("omega n X Q")
J, A = Diagonal("J"), Diagonal("A")
k, lambda_0 = real_symbol("k"), real_symbol("lambda_0")

J_1, J_2, J_3 = J.symbols
DET_J = J_1 * J_2 * J_3
#: (n, J⁻¹n), the square of ρ in (9.9).
RHO_SQUARED = dot(n, A * n)

NAME, TITLE = "rubber-ball-of-ratio", "Rubber ball on a sphere, by its ratio k"
SUMMARY = (
    "A balanced, dynamically asymmetric ball rolls with neither slipping nor spinning on a sphere: "
    "its equations as a family with the parameters k = a/(a + b) and J = I + mb²."
)
SOURCE = "§9, (9.2)–(9.4), (9.11)–(9.14)"


def multiplier(couple: MatrixExpr = zero) -> sp.Expr:
    """λ of (9.2), for which (ω, n) stays constant."""
    return -dot(A * n, cross(J * omega, omega) + couple) / RHO_SQUARED


def rolling(couple: MatrixExpr = zero, spin_torque: sp.Expr | None = None) -> System:
    """(9.2) with an external couple M_Q in body axes.

    Parameters
    ----------
    couple : MatrixExpr
        M_Q, a function of n.
    spin_torque : sympy.Expr, optional
        λ; by default the one that keeps (ω, n) = 0.

    Returns
    -------
    System
        State ω, n; relations n² = 1 and (ω, n) = 0; no laws.
    """
    pull = torque if couple != zero else zero
    definitions = {torque: couple} if couple != zero else {}
    return System(
        name=NAME,
        title=TITLE,
        summary=SUMMARY,
        source=SOURCE,
        parameters=parameters(DEFAULTS),
        definitions={
            **definitions,
            A: J**-1,
            X: cross(J * omega, omega) + pull,
            lambda_0: multiplier(pull) if spin_torque is None else spin_torque,
        },
        field={omega: A * (X + lambda_0 * n), n: k * cross(n, omega)},
        relations=(norm_squared(n) - 1, dot(omega, n)),
        observables=(
            Observable("spin_torque", lambda_0, "torque about the normal", "N m", source="(9.2)"),
        ),
    )


def any_couple() -> MatrixExpr:
    """M_Q(n) with components that are unspecified functions of n."""
    return constant([sp.Function(f"Q_{i}")(*n.symbols) for i in (1, 2, 3)])


ENERGY = Integral(
    "energy", sp.Rational(1, 2) * dot(J * omega, omega), "energy", source="§9.2", unit="J"
)
CONSTRAINT = Integral(
    "constraint", dot(omega, n), "the constraint, kept by λ", source="(9.1)", unit="rad/s"
)
MEASURE = Measure("measure", {RHO_SQUARED: 1 / (2 * k)}, "invariant measure", source="(9.3)")
ON_PLANE = Integral(
    "momentum",
    norm_squared(cross(J * omega, n)),
    "square of the horizontal momentum, k = 1",
    level=(k - 1,),
    source="§9.2",
    unit="kg^2 m^4/s^2",
)
AROUND = Integral(
    "quadratic",
    (norm_squared(J * omega) + DET_J * dot(omega, J * omega) * norm_squared(A * n)) / RHO_SQUARED,
    "quadratic integral of the case k = −1",
    level=(k + 1,),
    source="(9.4)",
    unit="kg^2 m^4/s^2",
)


def root(matrix: Diagonal, exponent: sp.Rational) -> Components:
    """A power of a diagonal tensor."""
    return Components(sp.diag(*(s**exponent for s in matrix.symbols)))


HALF = sp.Rational(1, 2)
#: N of (9.9), with dτ = N dt.
REDUCING = RHO_SQUARED ** (1 / (2 * k) - 1)
#: Ñ, with the second of the two printed expressions.
N_TILDE = sp.sqrt(DET_J) / k * RHO_SQUARED ** (1 / (2 * k))
#: M and γ of (9.11).
MOMENTUM = N_TILDE * (root(J, HALF) * omega)
DIRECTION = root(J, -HALF) * n / sp.sqrt(RHO_SQUARED)


def to_e3() -> Isomorphism:
    """(9.11)–(9.14): onto a Hamiltonian system on e(3), in the time dτ = N dt."""
    target = rubber_ball_on_e3.hamiltonian_form()
    return Isomorphism(
        "e(3)",
        target,
        {rubber_ball_on_e3.M: MOMENTUM, rubber_ball_on_e3.gamma: DIRECTION},
        time=REDUCING,
        meaning="Hamiltonian form on e(3) after a change of time",
        source="(9.11)–(9.14)",
    )


def to_sphere() -> Isomorphism:
    """(9.16), (9.17): onto a point on a sphere in a potential, on a level of the energy."""
    energy = dot(J * omega, omega) / 2
    return Isomorphism(
        "sphere",
        power_potential_on_sphere.moving(),
        {rubber_ball_on_e3.M: MOMENTUM, rubber_ball_on_e3.gamma: DIRECTION},
        time=REDUCING * k**2 / DET_J / RHO_SQUARED ** (1 / k),
        constants={power_potential_on_sphere.h: DET_J / k**2 * energy},
        meaning="trajectories of a point on a sphere in the potential −h (γ, Jγ)^(−1/k)",
        onto=(power_potential_on_sphere.HAMILTONIAN,),
        source="(9.16), (9.17)",
    )


def laws_for(ratio: float) -> tuple[Law, ...]:
    """The laws that hold for a ratio k given as a number."""
    special = {1.0: (ON_PLANE,), -1.0: (AROUND,)}.get(ratio, ())
    return (ENERGY, MEASURE, to_e3(), to_sphere(), *special)


def general() -> System:
    """The family in an arbitrary couple M_Q(n)."""
    return rolling(any_couple()).with_laws(CONSTRAINT, MEASURE)


def velocity_from_normal() -> Identity:
    """ω = k⁻¹ ṅ×n."""
    rate = constant([Rate(s) for s in n.symbols])
    return Identity(
        "velocity", omega - cross(rate, n) / k, "ω from the motion of the normal", source="§9.3"
    )
