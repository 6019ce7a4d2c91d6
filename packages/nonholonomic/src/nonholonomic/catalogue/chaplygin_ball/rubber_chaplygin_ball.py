"""The Chaplygin ball with rubber contact (§2.4), equivalent to the Veselova system."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import Integral, Law, Measure
from flowlanes.system.system import System
from flowlanes.system.vectors import Diagonal, cross, dot, norm_squared, vectors, zero

from ...mechanics.rolling.equations import Forces, RollingBody
from ...mechanics.shapes.shapes import Ball
from ...mechanics.shapes.surfaces import Plane
from ..body_entries import catalogue_body
from ..catalogue_entry import bruns_factor, laws_for
from ..file_systems import file_system
from ..fixed_point import veselova
from . import chaplygin_ball

M, gamma, k, omega = vectors("M gamma k omega")
I, J, A = Diagonal("I"), Diagonal("J"), Diagonal("A")

SOURCE = "§2.4"
MOMENTUM_UNIT = chaplygin_ball.MOMENTUM_UNIT


@laws_for("rubber", Plane(), Ball)
def laws(rolling: RollingBody, system: System) -> tuple[Law, ...]:
    """Measure; the square of the horizontal momentum without a potential or with Bruns'."""
    body = rolling.body
    if any(body.shape.centre):
        return ()
    known: tuple[Law, ...] = (_measure(),) if body.principal else ()
    total = M + k if any(body.gyrostat) else M + zero
    value = norm_squared(cross(total, gamma))
    potential = rolling.field.potential
    if potential == 0:
        meaning = "square of the horizontal momentum"
        known = (Integral("momentum", value, meaning, source="(6.4)", unit=MOMENTUM_UNIT), *known)
        return (
            (*known, _onto(file_system("veselova", {}))) if body.principal and total == M else known
        )
    if body.principal and total == M and (factor := bruns_factor(potential)) is not None:
        value = value - factor * sp.Mul(*J.symbols) * dot(gamma, A * gamma)
        meaning = "square of the horizontal momentum, Bruns field"
        law = Integral("momentum", value, meaning, source="Remark 15", unit=MOMENTUM_UNIT)
        return (law, *known)
    return known


def _measure() -> Measure:
    return Measure(
        "measure",
        {dot(gamma, A * gamma): sp.Rational(1, 2)},
        "invariant measure ρ d³ω d³γ",
        source="(6.3)",
    )


def _onto(target: System) -> Isomorphism:
    """The Veselova system with J for I."""
    return Isomorphism(
        "veselova",
        target,
        {omega: omega, gamma: gamma},
        constants=dict(zip(I.symbols, J.symbols, strict=True)),
        meaning="Veselova system with J = I + mR² for I",
        source=SOURCE,
    )


def general_system() -> System:
    """The ball in an arbitrary potential U(γ)."""
    potential = sp.Function("U")(*gamma.symbols)
    rolling = replace(catalogue_body("rubber-chaplygin-ball"), field=Forces(potential=potential))
    system = rolling.system("rubber-chaplygin-ball")
    return system.with_laws(_measure(), _onto(veselova.general()))
