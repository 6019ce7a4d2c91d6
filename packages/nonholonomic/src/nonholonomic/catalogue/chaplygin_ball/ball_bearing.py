"""A ball in a ball bearing: Fedorov's spherical support (§12; Fedorov [110]).

A dynamically asymmetric ball of radius R turns about its fixed centre, which is its centre of mass,
and touches homogeneous balls with fixed centres without slipping.  With the contact force F of a
supporting ball of radius ρ and moment of inertia d, touching in the direction n (fixed in space),

    I ω̇ + ω×I ω = Σ R n×F,    d ω̇' = ρ n×F,    R ω×n = −ρ ω'×n,

so that (ω', n) is constant, ω' = (ω', n) n − (R/ρ)(ω − (ω, n) n), and the momentum

    M = I ω + Σ D (ω − (ω, n) n),    D = d R²/ρ²,

is constant in space.  Here three balls support it, in any directions α, β, γ; since they enter by
the tensor Σ D n⊗n, fixed in space, alone, three do for any number.  A single one gives the
equations of the Chaplygin ball with D = m R².
"""

from __future__ import annotations

from itertools import combinations

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.system.isomorphism import Isomorphism, with_any_parameters
from flowlanes.system.laws import Integral, Law, Measure
from flowlanes.system.system import Observable, Parameter, System, Theorem
from flowlanes.system.vector_operators import outer
from flowlanes.system.vectors import (
    Diagonal,
    Symmetric,
    cross,
    dot,
    identity,
    norm_squared,
    real_symbol,
    vectors,
)

from ...mechanics.rolling.inertia import check_inertia
from ..catalogue_entry import Numbers, entry_with
from ..e3 import inertia_parameters
from ..file_systems import file_system

M, omega, alpha, beta, gamma = vectors("M omega alpha beta gamma")
I = Diagonal("I")
m, R, D_1, D_2, D_3 = (real_symbol(name) for name in ("m", "R", "D_1", "D_2", "D_3"))
SUPPORTS = ((D_1, alpha), (D_2, beta), (D_3, gamma))
HALF = sp.Rational(1, 2)
B, C = Symmetric("B"), Symmetric("C")
Delta = real_symbol("Delta")
MOMENTUM, SOURCE = "kg m^2/s", "§12, problem 2"

TITLE = "Ball in a ball bearing"
SUMMARY = (
    "A dynamically asymmetric ball turns about its fixed centre, in contact without slipping with "
    "homogeneous balls whose centres are fixed too; it is integrable by the Euler–Jacobi theorem, "
    "but no conformally Hamiltonian form is known."
)


#: (x, Bx) = (x, Ix) + Σ D |x×n|² on n² = 1, with D ≥ 0.
POSITIVE = Theorem((), "the tensor B is positive definite", tuple, (Delta,))


#: Directions fixed in space keep their angles.
ANGLES = tuple(
    Integral(
        f"angle_{one}_{other}",
        dot(alpha, beta),
        f"cosine of the angle between the {one} and the {other} ball",
        source=SOURCE,
    )
    for (one, (_, alpha)), (other, (_, beta)) in combinations(
        zip(("first", "second", "third"), SUPPORTS, strict=True), 2
    )
)


def tensor() -> MatrixExpr:
    """B with M = Bω."""
    total = sp.Add(*(weight for weight, _ in SUPPORTS))
    dyads = [weight * outer(axis, axis) for weight, axis in SUPPORTS]
    return I + total * identity - dyads[0] - dyads[1] - dyads[2]


def laws(p: Numbers) -> tuple[Law, ...]:
    """Energy, the momentum in space, a measure; and the Chaplygin ball as a special case."""
    moments = {name: p[name] for name in ("I_1", "I_2", "I_3")}
    return (
        Integral("energy", HALF * dot(M, omega), "energy", source=SOURCE, unit="J"),
        *(
            Integral(
                place,
                dot(M, axis),
                f"momentum about the direction of the {place} ball",
                source=SOURCE,
                unit=MOMENTUM,
            )
            for place, axis in (("first", alpha), ("second", beta), ("third", gamma))
        ),
        *ANGLES,
        Measure("measure", {Delta: -HALF}, "invariant measure", source=SOURCE),
        Isomorphism(
            "chaplygin_ball",
            with_any_parameters(file_system("chaplygin-ball-unreduced", moments)),
            {name: name for name in (M, alpha, beta, gamma)},
            constants={m: D_3, R: sp.S.One},
            meaning="a single supporting ball",
            onto=(norm_squared(alpha) - 1, norm_squared(beta) - 1),
            source=SOURCE,
            level=(D_1, D_2),
        ),
    )


def build(p: Numbers) -> System:
    """The ball on three supporting balls."""
    moments = (p["I_1"], p["I_2"], p["I_3"])
    check_inertia(moments)
    return System(
        name="ball-bearing",
        title=TITLE,
        summary=SUMMARY,
        source=SOURCE,
        parameters=(
            *inertia_parameters(moments),
            *(
                Parameter(
                    weight,
                    f"d R²/ρ² of supporting ball {i}",
                    p[str(weight)],
                    "kg m^2",
                    (weight >= 0,),
                )
                for i, (weight, _) in enumerate(SUPPORTS, 1)
            ),
        ),
        definitions={
            B: tensor(),
            # B⁻¹ = C/Δ, with Δ a quantity of its own: it is the density of the measure
            C: B.entries.adjugate(),
            Delta: B.entries.det(method="berkowitz"),
            omega: C * M / Delta,
        },
        field={
            M: cross(M, omega),
            alpha: cross(alpha, omega),
            beta: cross(beta, omega),
            gamma: cross(gamma, omega),
        },
        relations=(norm_squared(alpha) - 1, norm_squared(beta) - 1, norm_squared(gamma) - 1),
        laws=laws(p),
        theorems=(POSITIVE,),
        observables=(Observable("omega", omega, "angular velocity", "rad/s", "body"),),
    )


ENTRIES = (
    entry_with(
        name="ball-bearing",
        build=build,
    ),
)
