"""The equations (4.7) as a System, with its laws and the map to the original."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

import sympy as sp

from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import ConformallyHamiltonian, Integral, Law, Measure, PoissonStructure
from flowlanes.system.named_formulas import definition_values
from flowlanes.system.system import Observable, Parameter, System
from flowlanes.system.vectors import real_symbol

from ..lagrangian.mechanism import Mechanism
from .base_coordinates import Base
from .closed_form import ClosedFormParts
from .multiplier import Multiplier

N, S = real_symbol("N"), real_symbol("S")
V = real_symbol("V")
h_11, h_12, h_22 = (real_symbol(f"h_{i}") for i in ("11", "12", "22"))
HALF = sp.Rational(1, 2)

LEVEL = 0.8
"""Default value of the constant of a linear integral."""


def momenta(base: Base) -> tuple[sp.Symbol, sp.Symbol]:
    """The momenta P₁, P₂."""
    first, second = (real_symbol(f"P_{q}") for q in base.coordinates)
    return first, second


def speeds(base: Base) -> tuple[sp.Symbol, sp.Symbol]:
    """The velocities q̇₁, q̇₂."""
    first, second = (real_symbol(f"{q}dot") for q in base.coordinates)
    return first, second


def chaplygin_system(
    mechanism: Mechanism,
    base: Base,
    constants: tuple[sp.Symbol, ...],
    closed: ClosedFormParts,
    potential: sp.Expr,
    multiplier: Multiplier | None,
) -> System:
    """The system (4.7) in the coordinates of the base, with the laws of Theorem 6.

    Parameters
    ----------
    mechanism : Mechanism
    base : Base
    constants : tuple of Symbol
        Constants of linear integrals; they become parameters.
    closed : ClosedFormParts
    potential : Expr
        The part of E₀ not contained in `closed`.
    multiplier : Multiplier or None
    """
    q, P, v = base.coordinates, momenta(base), speeds(base)
    level = closed.rest + potential
    hamiltonian = HALF * (h_11 * P[0] ** 2 + 2 * h_12 * P[0] * P[1] + h_22 * P[1] ** 2) + V
    place = {} if base.normal is None else {base.normal: sp.Matrix(list(base.place.values()))}
    powers = () if multiplier is None else multiplier.powers
    definitions = {
        **place,
        **dict(zip((h_11, h_12, h_22), closed.inverse, strict=True)),
        v[0]: h_11 * P[0] + h_12 * P[1],
        v[1]: h_12 * P[0] + h_22 * P[1],
        V: level,
        S: _gyroscopic(base, closed, multiplier),
        **({} if multiplier is None else {N: multiplier.value}),
    }
    force = [_by_place(base, closed, level, i) for i in (0, 1)]
    return System(
        name=f"{mechanism.name}-chaplygin",
        title=f"{mechanism.title} as a generalised Chaplygin system",
        summary=f"{mechanism.title} in the two coordinates that move by themselves.",
        source="(4.7)",
        parameters=(*mechanism.parameters, *map(_level, constants)),
        definitions=definitions,
        field={
            q[0]: v[0],
            q[1]: v[1],
            P[0]: force[0] + v[1] * S,
            P[1]: force[1] - v[0] * S,
        },
        laws=(
            Integral("energy", hamiltonian, "energy of (4.4)", source="Theorem 1"),
            *(theorem_6(hamiltonian, powers) if multiplier is not None else ()),
        ),
        observables=(Observable("gyroscopic", S, "coefficient S of the gyroscopic forces"),),
    )


def _level(constant: sp.Symbol) -> Parameter:
    return Parameter(constant, "value of the linear integral", LEVEL)


def _gyroscopic(base: Base, closed: ClosedFormParts, multiplier: Multiplier | None) -> sp.Expr:
    """S; with a multiplier it is P₂ ∂ln N/∂q₁ − P₁ ∂ln N/∂q₂ + b."""
    if multiplier is None:
        v = speeds(base)
        return closed.a[0] * v[0] + closed.a[1] * v[1] + closed.b
    P = momenta(base)
    slopes = []
    for q in base.coordinates:
        terms = []
        for factor, exponent in multiplier.powers:
            slope = sp.diff(in_base_coordinates(base, factor), q)
            terms.append(exponent * slope / factor)
        slopes.append(sp.Add(*terms))
    return P[1] * slopes[0] - P[0] * slopes[1] + closed.b


def in_base_coordinates(base: Base, formula: sp.Expr) -> sp.Expr:
    """A formula in the coordinates of the base alone."""
    return formula if base.normal is None else formula.xreplace(dict(base.place))


def _by_place(base: Base, closed: ClosedFormParts, level: sp.Expr, index: int) -> sp.Expr:
    """−∂H/∂q_i."""
    q, P = base.coordinates[index], momenta(base)
    h11, h12, h22 = (sp.diff(in_base_coordinates(base, h), q) for h in closed.inverse)
    square = h11 * P[0] ** 2 + 2 * h12 * P[0] * P[1] + h22 * P[1] ** 2
    return -HALF * square - sp.diff(in_base_coordinates(base, level), q)


def bracket(on: tuple[sp.Expr, ...] = ()) -> PoissonStructure:
    """The bracket (4.6) in q, P: {q_i, P_j} = δ_ij/N, {P₁, P₂} = S/N.

    With p = N P these are {q_i, p_j} = δ_ij and {p₁, p₂} = S̄ for S̄ of (4.5).
    """
    # Division by N is the factor of dτ = N dt: q and p = N P are canonical up to S̄.
    pair = sp.eye(2) / N
    turn = sp.Matrix([[0, S], [-S, 0]]) / N
    return PoissonStructure(
        "bracket",
        sp.zeros(2).row_join(pair).col_join((-pair).row_join(turn)),
        rank=4,
        meaning="canonical bracket of q and p = N P, with {p₁, p₂} = S̄",
        level=on,
        source="(4.6)",
    )


def theorem_6(
    hamiltonian: sp.Expr,
    powers: Iterable[tuple[sp.Expr, sp.Expr]] = ((N, sp.S.One),),
    on: tuple[sp.Expr, ...] = (),
) -> tuple[Law, ...]:
    """The laws of Theorem 6: measure with density N, given by its factors, bracket and form."""
    structure = bracket(on)
    return (
        Measure(
            "measure",
            tuple(powers),
            "measure whose density depends on the coordinates alone",
            level=on,
            source="Theorem 6",
        ),
        structure,
        ConformallyHamiltonian(
            "form",
            N,
            structure,
            hamiltonian,
            "conformally Hamiltonian form, dτ = N dt",
            level=on,
            source="Theorem 6",
        ),
    )


def with_base(original: System, base: Base) -> System:
    """The original system, extended by coordinates of the base that it omits."""
    if original.reconstruction is None:
        return original
    missing = [(x, rate) for x, rate in original.reconstruction.field if x in base.coordinates]
    return replace(original, field=(*missing, *original.field), reconstruction=None)


def _velocities_on_base(base: Base, closed: ClosedFormParts) -> dict[sp.Symbol, sp.Expr]:
    """Coordinates and velocities of the mechanism in terms of the base."""
    v = speeds(base)
    known = dict(base.place)
    for u, (first, second, rest) in zip(base.motion.velocities, closed.lifted, strict=True):
        known[u] = first * v[0] + second * v[1] + rest
    return known


def with_carried_coordinates(
    form: System, base: Base, closed: ClosedFormParts, original: System
) -> System | None:
    """(4.7) with the additional coordinates of the original system; None if there are none."""
    known = _velocities_on_base(base, closed)
    missing = [s for s in original.symbols if s not in known]
    if not missing:
        return None
    rates = dict(zip(original.symbols, original.rates, strict=True))
    steps = original.required_definitions([rates[s] for s in missing])
    known = definition_values(steps, known)
    further = tuple((s, rates[s].xreplace(known)) for s in missing)
    return replace(form, name=f"{form.name}-lifted", field=(*form.field, *further), laws=())


def motion_law(
    base: Base, closed: ClosedFormParts, original: System, level: tuple[sp.Expr, ...]
) -> Isomorphism:
    """The motion of the original system, on a level of its linear integrals.

    Parameters
    ----------
    base : Base
    closed : ClosedFormParts
    original : System
        In coordinates of the mechanism and velocities u.
    level : tuple of Expr
        Expressions that vanish on the level, in the same coordinates and velocities.
    """
    known = _velocities_on_base(base, closed)
    return Isomorphism(
        "motion",
        original,
        {s: known.get(s, s) for s in original.symbols},
        meaning="the motion of the original system",
        onto=level,
        source="(4.4)",
    )
