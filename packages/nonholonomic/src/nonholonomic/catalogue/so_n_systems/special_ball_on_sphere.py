"""The rubber ball on or in a sphere with the special operator of inertia, I_ij = a_i a_j − m R².

With A = diag(a_1, …, a_n), W = (Aγ, γ), ε = a/(R + a) the equations of :mod:`.ball_on_sphere` are

    ṗ = (u, p)γ + (1 − ε)((Aγ, u)Au − (Au, u)Aγ),    γ̇ = −εu,    u = (A⁻¹p − (A⁻¹p, γ)γ)/W.

As Δ = det ∂p/∂u is W^(n − 2) det A, the invariant measure has the density N^(n − 2) with

    N = W^(1/(2ε) − 1),

and N is Chaplygin's multiplier (Jovanović 2018): in the time dτ = N dt and with q = −N p/ε the
motion is Hamiltonian on the cotangent bundle of the sphere, and

    2H = (p, u) = (ε/N)² (q, A⁻¹q)/W.

With the unit vector e = A^(1/2)γ/√W and its momentum P this is 2H = |P|²/(e, A⁻¹e) for ε = −1, a
ball that surrounds a sphere of half its radius (Gajić and Jovanović 2019).  So |P|² − 2H(e, A⁻¹e)
vanishes: in a further new time e moves as the point of Neumann's system with the potential
−H(e, A⁻¹e), which separates in sphero-conical coordinates.  Its integrals are here

    F_i = (Σ (a_i a_j)² ω_ij²/(a_i − a_j) + 2H a_i γ_i²)/W,    Σ F_i = 2H,    Σ F_i/a_i = 0.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import sympy as sp

from flowlanes.system.laws import ConformallyHamiltonian, Integral, Law, Measure, PoissonStructure
from flowlanes.system.matrices import Column
from flowlanes.system.named_formulas import Pairs
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import dot, norm_squared

from ..so_n.entry_of_dimension import SOURCE, SQUARE, R
from ..so_n.inertia import Inertia, ProductMoments
from ..so_n.motion_in_space import gamma_of, omega_of
from .ball_on_sphere import NORMAL, RATIO, OnSphere, a, epsilon, lift
from .special_inertia import SpecialVeselova, W, cotangent

HALF = sp.Rational(1, 2)
#: The exponent of W in Chaplygin's multiplier, 1/(2ε) − 1.
EXPONENT = (R - a) / (2 * a)


@dataclass(frozen=True, kw_only=True)
class SpecialRubberBallOnSphere(OnSphere, SpecialVeselova):
    """The rubber ball on a sphere, with moments of products."""

    sphere: float = -0.5

    @property
    def settings(self) -> tuple[str, ...]:
        """The factors in place of an inertia."""
        return ("dimension", "factors", "a")

    def variables(self) -> Mapping[str, tuple[str, str]]:
        """Meaning and unit of the variables of the state."""
        return {**super().variables(), "gamma": NORMAL}

    def equations(self, inertia: Inertia, parameters: tuple[Parameter, ...]) -> System:
        """The equations, u in closed form."""
        *ball, _ = parameters
        plain = super().equations(inertia, tuple(ball))
        if not isinstance(inertia, ProductMoments):
            raise TypeError(type(inertia).__name__)
        n, factors = inertia.dimension, inertia.factors
        p, u, gamma = Column("p", n), Column("u", n), gamma_of(n)
        c, d = Column("c", n), Column("d", n)
        direct = sp.ImmutableDenseMatrix(sp.diag(*factors))
        definitions: Pairs = (RATIO, *plain.definitions, (c, direct * gamma), (d, direct * u))
        energy = HALF * dot(p, u)
        laws: tuple[Law, ...] = (
            Integral("energy", energy, "energy", source=SOURCE, unit="J"),
            *_quadratic_integrals(inertia, energy),
            *_hamiltonian(inertia, p, energy),
        )
        return replace(
            plain,
            parameters=(*inertia.parameters, *parameters),
            definitions=definitions,
            field={
                p: dot(u, p) * gamma + (1 - epsilon) * (dot(c, u) * d - dot(d, u) * c),
                gamma: -epsilon * u,
            },
            laws=laws,
            reconstruction=lift(n),
        )


def _quadratic_integrals(inertia: ProductMoments, energy: sp.Expr) -> tuple[Integral, ...]:
    """F_i of a ball that surrounds a sphere of half its radius."""
    n, factors = inertia.dimension, inertia.factors
    omega, y = omega_of(n).entries, gamma_of(n).symbols
    found = []
    for i, own in enumerate(factors):
        turns = (
            (own * other * omega[i, j]) ** 2 / (own - other)
            for j, other in enumerate(factors)
            if j != i
        )
        found.append(
            Integral(
                f"quadratic{i + 1}",
                (sp.Add(*turns) + 2 * energy * own * y[i] ** 2) / W,
                f"quadratic integral of axis {i + 1}, around a sphere of half the radius",
                level=(2 * a + R,),
                source=SOURCE,
                unit=SQUARE,
            )
        )
    return tuple(found)


def structure(inertia: ProductMoments, p: Column) -> sp.ImmutableDenseMatrix:
    """The canonical bracket of the sphere for q = −N p/ε and γ, in p and γ.

    It belongs to {γᵢ, qⱼ} = δᵢⱼ − γᵢγⱼ and {qᵢ, qⱼ} = qᵢγⱼ − qⱼγᵢ.  With s = Aγ and f = −ε/N,

        {γᵢ, pⱼ} = f (δᵢⱼ − γᵢγⱼ),
        {pᵢ, pⱼ} = f ((1/ε − 1)(pᵢγⱼ − pⱼγᵢ) + (1/ε − 2)(sᵢpⱼ − sⱼpᵢ)/W).
    """
    n = inertia.dimension
    x, y = sp.Matrix(p.symbols), sp.Matrix(gamma_of(n).symbols)
    s = sp.Matrix([own * c for own, c in zip(inertia.factors, y, strict=True)])
    ratio = a / (R + a)
    scale = -ratio * W ** (-EXPONENT)
    corner = scale * (sp.eye(n) - y * y.T)
    top = scale * (
        (1 / ratio - 1) * (x * y.T - y * x.T) + (1 / ratio - 2) * (s * x.T - x * s.T) / W
    )
    return sp.ImmutableDenseMatrix(top.row_join(-corner.T).col_join(corner.row_join(sp.zeros(n))))


def _hamiltonian(inertia: ProductMoments, p: Column, energy: sp.Expr) -> tuple[Law, ...]:
    """The measure, and the Hamiltonian form after the change of time dτ = N dt."""
    n = inertia.dimension
    gamma = gamma_of(n)
    bracket = PoissonStructure(
        "bracket",
        structure(inertia, p),
        casimirs=(norm_squared(gamma), cotangent(p, gamma)[1]),
        rank=2 * n - 2,
        meaning="canonical bracket of the sphere for −N p/ε and γ, N = W^(1/(2ε) − 1)",
        source=SOURCE,
    )
    return (
        Measure("measure", {W: (n - 2) * EXPONENT}, "invariant measure", source=SOURCE),
        bracket,
        ConformallyHamiltonian(
            "hamiltonian",
            W**EXPONENT,
            bracket,
            energy,
            "conformally Hamiltonian form, Chaplygin's multiplier W^(1/(2ε) − 1)",
            source=SOURCE,
        ),
    )


BALL = SpecialRubberBallOnSphere(name="special-rubber-ball-on-sphere-nd", rolls=True)

ENTRIES = (BALL.entry(),)
