"""The Hamiltonian form in the time τ with momenta p = N P + w, S̄ = dw."""

from __future__ import annotations

import sympy as sp

from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import ConformallyHamiltonian, Integral, PoissonStructure
from flowlanes.system.system import System
from flowlanes.system.vectors import real_symbol

from .base_coordinates import Base
from .closed_form import ClosedFormParts
from .multiplier import Multiplier
from .reduced_system import N, h_11, h_12, h_22, in_base_coordinates, momenta

HALF = sp.Rational(1, 2)
V = real_symbol("V")


def _names(base: Base) -> tuple[sp.Symbol, sp.Symbol]:
    first, second = (real_symbol(f"p_{q}") for q in base.coordinates)
    return first, second


def canonical(
    form: System,
    base: Base,
    closed: ClosedFormParts,
    potential: sp.Expr,
    multiplier: Multiplier,
    w: tuple[sp.Expr, sp.Expr],
) -> System:
    """H = ½ h_ij (p_i − w_i)(p_j − w_j)/N² + V in canonical variables.

    Parameters
    ----------
    form : System
        The system (4.7), for its parameters.
    base : Base
    closed : ClosedFormParts
    potential : Expr
        The part of E₀ not contained in `closed`.
    multiplier : Multiplier
    w : tuple of Expr
        w₁, w₂ with S̄ = ∂w₂/∂q₁ − ∂w₁/∂q₂.
    """
    q, p = base.coordinates, _names(base)
    # With P = (p − w)/N the kinetic energy ½ h P² is ½ (h/N²)(p − w)².
    slowed = [in_base_coordinates(base, h / multiplier.value**2) for h in closed.inverse]
    level = in_base_coordinates(base, closed.rest + potential)
    first, second = (a - b for a, b in zip(p, w, strict=True))

    def energy(h: list[sp.Expr], v: sp.Expr) -> sp.Expr:
        square = h[0] * first**2 + 2 * h[1] * first * second + h[2] * second**2
        return HALF * square + v

    named = energy([h / N**2 for h in (h_11, h_12, h_22)], V)
    structure = PoissonStructure(
        "bracket",
        sp.Matrix([[0, 0, 1, 0], [0, 0, 0, 1], [-1, 0, 0, 0], [0, -1, 0, 0]]),
        rank=4,
        meaning="canonical bracket",
        source="Theorem 6",
    )
    place = {} if base.normal is None else {base.normal: sp.Matrix(list(base.place.values()))}
    by_place = [sp.diff(energy(slowed, level), x) for x in q]
    return System(
        name=f"{form.name}-hamiltonian",
        title=f"{form.title}, in canonical variables",
        summary="The Hamiltonian form in the time τ, dτ = N dt.",
        source="Theorem 6",
        parameters=form.parameters,
        definitions={
            **place,
            N: multiplier.value,
            **dict(zip((h_11, h_12, h_22), closed.inverse, strict=True)),
            V: closed.rest + potential,
        },
        field={
            q[0]: sp.diff(named, p[0]),
            q[1]: sp.diff(named, p[1]),
            p[0]: -by_place[0],
            p[1]: -by_place[1],
        },
        laws=(
            Integral("energy", named, "Hamiltonian", source="Theorem 6"),
            structure,
            ConformallyHamiltonian(
                "hamiltonian", sp.S.One, structure, named, "Hamiltonian form", source="Theorem 6"
            ),
        ),
    )


def canonical_law(base: Base, target: System, w: tuple[sp.Expr, sp.Expr]) -> Isomorphism:
    """The map from (4.7) to the canonical variables, with the time τ."""
    q, P, p = base.coordinates, momenta(base), _names(base)
    known = dict(zip(q, q, strict=True))
    for name, old, shift in zip(p, P, w, strict=True):
        known[name] = N * old + shift
    return Isomorphism(
        "canonical",
        target,
        known,
        N,
        meaning="canonical variables, in the time τ",
        source="Theorem 6",
    )
