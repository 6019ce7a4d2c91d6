"""The hollow ball around a sphere, k = −1, as a Hamiltonian system on e(3) (§8.2, (8.7)).

On the level F₂ = (AM, n) = 0 the equations (8.1) become Hamiltonian in the time τ with
dτ = 𝒩 dt, 𝒩 = (n, Bn)/(2 (An, Bn) √det I_Q), I_Q = J − d n⊗n, B = I_Q A.  The variables are Γ = n
and μ = −𝒩 (M − Bn (n, M)/(n, Bn)), which e(3) calls M again: up to sign the angular momentum of a
point on the sphere |Γ| = 1.  Back leads M = L − Bn (L, An)/(An, Bn) with L = −μ/𝒩.  All in body
axes; J and d as in (8.1).
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import Integral
from flowlanes.system.system import Guard, Parameter, System
from flowlanes.system.vectors import (
    Diagonal,
    dot,
    identity,
    norm_squared,
    real_symbol,
    to_components,
    zero,
)

from ..catalogue_entry import Numbers, entry_with
from ..e3 import Gamma, M, e3_system
from . import ball_around_sphere_chaplygin as chaplygin, ball_on_sphere_equations as ball

J = Diagonal("J")
d = real_symbol("d")

NAME, TITLE = "ball-around-sphere-hamiltonian", "Hollow ball around a sphere, reduced to e(3)"
SUMMARY = (
    "The hollow ball around a sphere of half its radius, with vanishing linear integral, in the "
    "time in which it is Hamiltonian."
)
SOURCE = "§8.2, (8.7)"


def _twice_A() -> MatrixExpr:
    """Ā = 2A = tr J − 2J."""
    return sp.Add(*J.symbols) * identity - 2 * J


def delta(power: int = 2) -> sp.Expr:
    """δ = (γ, JĀ²γ) − d(γ, Āγ)²; the source prints the first Ā with the power 1."""
    tensor = _twice_A()
    return dot(Gamma, J * tensor**power * Gamma) - d * dot(Gamma, tensor * Gamma) ** 2


def _sums() -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    """ρ² = 1 − d(γ, J⁻¹γ), (γ, Bγ) and det J."""
    tensor = _twice_A()
    form = (dot(Gamma, J * tensor * Gamma) - d * dot(Gamma, tensor * Gamma)) / 2
    return 1 - d * dot(Gamma, J**-1 * Gamma), form, sp.Mul(*J.symbols)


def _spread(i: int) -> sp.Expr:
    """γ_i² times the product of J_i − J_k over k ≠ i."""
    moments = J.symbols
    others = [moments[i] - moments[k] for k in range(3) if k != i]
    return sp.Mul(*others) * Gamma.symbols[i] ** 2


def energy(difference: sp.Expr) -> sp.Expr:
    """H of (8.7), with δ given."""
    rho_2, form, det = _sums()
    terms = []
    for i, (moment, momentum) in enumerate(zip(J.symbols, M.symbols, strict=True)):
        share = rho_2 - d * difference / (4 * moment * det)
        terms.append((rho_2 * difference / moment - 4 * _spread(i) * share) * momentum**2)
    return to_components(difference * det / (8 * form**2) * sp.Add(*terms))


def second(difference: sp.Expr) -> sp.Expr:
    """F₂ of (8.7) as printed, with δ given; det J times it is the ball's M²."""
    rho_2, form, _ = _sums()
    tensor = _twice_A()
    drawn = dot(Gamma, J * tensor * Gamma) * dot(Gamma, tensor * Gamma)
    remainder = 2 * d * drawn - dot(Gamma, J * (J + d * identity) * tensor**2 * Gamma)
    terms = [
        _spread(i) * (difference * (moment + d) + remainder) * momentum**2
        for i, (moment, momentum) in enumerate(zip(J.symbols, M.symbols, strict=True))
    ]
    return to_components(
        rho_2 / (4 * form**2) * (difference**2 * norm_squared(M) - 4 * sp.Add(*terms))
    )


def parameters(p: Numbers) -> tuple[Parameter, ...]:
    """J and d."""
    moments = (
        Parameter(s, f"moment of inertia about a tangent along body axis {i}", p[str(s)], "kg m^2")
        for i, s in enumerate(J.symbols, 1)
    )
    meaning = "mass times the square of the ball's radius"
    return (*moments, Parameter(d, meaning, p["d"], "kg m^2", (d >= 0,)))


def reduced_system(hamiltonian: sp.Expr, integral: sp.Expr, p: Numbers) -> System:
    """The flow of H on e(3) at Γ² = 1, (M, Γ) = 0, with a further integral."""
    return e3_system(
        NAME,
        TITLE,
        hamiltonian,
        parameters(p),
        level=(dot(M, Gamma),),
        laws=(
            Integral(
                "second",
                integral,
                "square of the ball's momentum",
                source="(8.7)",
                unit="kg^2 m^4/s^2",
            ),
        ),
        source=SOURCE,
        summary=SUMMARY,
    )


def _tensors() -> tuple[MatrixExpr, MatrixExpr, sp.Expr]:
    """AΓ, BΓ and det I_Q at n = Γ."""
    lever = sp.Rational(1, 2) * _twice_A() * Gamma
    drawn = J * lever - d * dot(Gamma, lever) * Gamma
    det = sp.Mul(*J.symbols) * (1 - d * dot(Gamma, J**-1 * Gamma))
    return lever, drawn, det


def slowness() -> sp.Expr:
    """dt/dτ = 1/𝒩."""
    lever, drawn, det = _tensors()
    return 2 * dot(lever, drawn) / dot(Gamma, drawn) * sp.sqrt(det)


def momentum() -> MatrixExpr:
    """The ball's momentum about the contact point, in the variables of e(3)."""
    lever, drawn, _ = _tensors()
    turning = -slowness() * M
    return turning - dot(turning, lever) / dot(lever, drawn) * drawn


def velocity() -> MatrixExpr:
    """The ball's angular velocity, in the variables of e(3)."""
    total = momentum()
    square = 1 - d * dot(Gamma, J**-1 * Gamma)
    return J**-1 * total + (d / square) * dot(Gamma, J**-1 * total) * J**-1 * Gamma


def to_ball() -> Isomorphism:
    """The map back to the ball, from the time τ to the time t."""
    half = sp.Add(*J.symbols) / 2
    return Isomorphism(
        "ball",
        ball.vanishing_area(),
        {ball.M: momentum(), ball.n: Gamma + zero},
        time=slowness(),
        constants={a: half - moment for a, moment in zip(ball.A.symbols, J.symbols, strict=True)},
        meaning="the ball around the sphere, at vanishing linear integral",
        source="(8.7)",
    )


def build(p: Numbers) -> System:
    """(8.7), with F₂ = M²."""
    system = reduced_system(energy(delta()), sp.Mul(*J.symbols) * second(delta()), p)
    forward = Guard("time", slowness(), "the time of the ball stands still")
    return replace(system, guards=(forward,)).with_laws(to_ball())


ENTRIES = (
    entry_with(
        name=NAME,
        build=build,
        general=chaplygin.reduced_system,
    ),
)
