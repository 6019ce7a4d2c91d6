"""The 1-form of a mechanism, and its admissible fields lifted to one more coordinate.

A function σ with η_β(σ) = θ_β for the admissible fields η_β is a surface z = σ(q) to which the
lifted fields

    η̂_β = η_β + θ_β ∂_z

are tangent.  Commutators of tangent fields are tangent, so σ can exist only if no combination of
the lifted fields and their commutators points along z.  If these span no more than the fields
themselves do, σ exists near the point (Frobenius' theorem).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import count

import sympy as sp

from flowlanes.errors import InputError
from flowlanes.formulas.tape import Derivation, Tape
from flowlanes.system.named_formulas import expand
from flowlanes.system.system import Parameter
from flowlanes.system.vectors import real_symbol

from ..mechanics.constraints.distribution import Distribution
from ..mechanics.lagrangian.constrained_frame import Restriction


@dataclass(frozen=True)
class LiftedFields:
    """Admissible fields with and without their component along z.

    Attributes
    ----------
    theta : tuple of Expr
        θ_β.
    steps : tuple of (Symbol, Expr)
        Definitions used by these and the fields.
    height : Symbol
        z.
    base, lifted : Distribution
        Spanned by η_β and by η̂_β.
    """

    theta: tuple[sp.Expr, ...]
    steps: tuple[tuple[sp.Symbol, sp.Expr], ...]
    height: sp.Symbol
    base: Distribution
    lifted: Distribution
    parameters: tuple[Parameter, ...]


def lift(restriction: Restriction) -> LiftedFields:
    """θ_β = −(div η_β + C^s_βs) and the lifted fields of a mechanism.

    Raises
    ------
    InputError
        If a field does not keep all levels of a relation between the coordinates: the volume is
        then not that of the coordinates.
    """
    mechanism = restriction.mechanism
    q = mechanism.frame.coordinates
    parameters = tuple(p.symbol for p in mechanism.parameters)
    tape = Tape(restriction.definitions, (*q, *mechanism.frame.w, *parameters))
    many = range(len(restriction.velocities))
    theta = []
    for beta in many:
        divergence = sp.Add(
            *(
                tape.along(Derivation(((x, sp.S.One),)), restriction.anchor[i][beta])
                for i, x in enumerate(q)
            )
        )
        trace = sp.Add(*(_bracket(restriction, beta, s)[s] for s in many))
        theta.append(tape.name(tape.short(-divergence - trace), "theta"))
    fields = [
        {x: restriction.anchor[i][beta] for i, x in enumerate(q) if restriction.anchor[i][beta]}
        for beta in many
    ]
    steps = tape.steps([*theta, *(value for field in fields for value in field.values())])
    _check_levels(restriction, fields, dict(steps))
    names = {str(s) for s in (*q, *mechanism.frame.w, *parameters, *(s for s, _ in steps))}
    height = real_symbol(next(n for n in _heights() if n not in names))
    constants = tuple((p.symbol, p.default) for p in mechanism.parameters)

    def span_of(
        own: list[dict[sp.Symbol, sp.Expr]], coordinates: tuple[sp.Symbol, ...]
    ) -> Distribution:
        return Distribution(
            mechanism.name,
            coordinates,
            mechanism.frame.relations,
            restriction.velocities,
            tuple(own),
            steps=steps,
            constants=constants,
        )

    raised = [
        {**field, height: share} if share != 0 else field
        for field, share in zip(fields, theta, strict=True)
    ]
    low, high = span_of(fields, q), span_of(raised, (*q, height))
    return LiftedFields(tuple(theta), steps, height, low, high, mechanism.parameters)


def _heights() -> Iterator[str]:
    """Candidate names of z."""
    return (f"z_sigma{'_' * more}" for more in count())


def _bracket(restriction: Restriction, first: int, second: int) -> tuple[sp.Expr, ...]:
    """C^t of [η_first, η_second] on the distribution."""
    if first == second:
        return (sp.S.Zero,) * len(restriction.velocities)
    if first < second:
        return restriction.structure[first, second]
    return tuple(-c for c in restriction.structure[second, first])


def _check_levels(
    restriction: Restriction,
    fields: list[dict[sp.Symbol, sp.Expr]],
    steps: dict[sp.Symbol, sp.Expr],
) -> None:
    for relation in restriction.mechanism.frame.relations:
        for field in fields:
            rate = sp.Add(*(sp.diff(relation, x) * value for x, value in field.items()))
            if sp.cancel(sp.together(expand(rate, steps))) != 0:
                raise InputError(
                    f"{restriction.mechanism.name}: the frame is tangent to {relation} = 0 but "
                    "not to its other levels; write its rates so that the relation is constant "
                    "identically"
                )
