"""Laws of rolling bodies with fluid in cavities (docs/fluid.md).

The laws of a rigid body do not hold with fluid unchanged; these do.
"""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from flowlanes.system.laws import Integral, Law, Measure
from flowlanes.system.vectors import (
    Diagonal,
    Symmetric,
    Vector,
    cross,
    dot,
    norm_squared,
    real_symbol,
    zero,
)

from ..mechanics.rolling.equations import RollingBody
from ..mechanics.rolling.fluid import Fluid

M, gamma, k = Vector("M"), Vector("gamma"), Vector("k")
ratio = real_symbol("k")
HALF = sp.Rational(1, 2)
SOURCE = "docs/fluid.md"
SQUARE, SPIN = "kg^2 m^4/s^2", "kg m^2/s"


def laws_with_fluid(rolling: RollingBody) -> tuple[Law, ...]:
    """The laws of a body with fluid besides energy and circulation."""
    body, field = rolling.equivalent.body, rolling.field
    known: list[Law] = []
    plane = rolling.surface.is_flat
    # gravity acts at the centre of a balanced ball, and does nothing on a plane
    balanced = body.shape.is_balanced_ball and rolling.surface.is_even
    free = field.potential == 0 and (plane or not field.gravity)
    if balanced:
        total = M + k if any(body.gyrostat) else M + zero
        of_contact = _marble_ball if rolling.contact == "marble" else _rubber_ball
        known += of_contact(total, plane, free)
        known += _measure(rolling, Diagonal if body.principal else Symmetric, plane)
    for fluid in rolling.body.fluids:
        if len(set(fluid.cavity.axes)) == 1:
            known += laws_of_sphere(fluid, plane, balanced and free and rolling.contact == "marble")
    return tuple(known)


def _marble_ball(total: sp.MatrixExpr, plane: bool, free: bool) -> Iterator[Law]:
    if plane:
        yield Integral("area", dot(total, gamma), "area integral", source=SOURCE, unit=SPIN)
    if free:
        square, meaning = norm_squared(total), "square of the momentum"
        yield Integral("momentum", square, meaning, source=SOURCE, unit=SQUARE)


def _rubber_ball(total: sp.MatrixExpr, plane: bool, free: bool) -> Iterator[Law]:
    if plane and free:
        square, meaning = norm_squared(cross(total, gamma)), "square of the horizontal momentum"
        yield Integral("momentum", square, meaning, source=SOURCE, unit=SQUARE)


def _measure(
    rolling: RollingBody, kind: type[Diagonal] | type[Symmetric], plane: bool
) -> Iterator[Law]:
    """The measure of the equivalent balanced ball; on γ² = 1 is (Iγ, Aγ) = 1 − mR²(γ, Aγ)."""
    I, A = kind("I"), kind("A")
    if rolling.contact == "rubber":
        exponent = HALF if plane else HALF / ratio
        density, meaning = {dot(gamma, A * gamma): exponent}, "invariant measure in ω, γ, N"
    else:
        density, meaning = {dot(I * gamma, A * gamma): -HALF}, "invariant measure in M, γ, N"
    yield Measure("measure", density, meaning, source=SOURCE)


def laws_of_sphere(fluid: Fluid, plane: bool, momentum_fixed: bool) -> Iterator[Law]:
    """A spherical cavity: the vorticity of its fluid is fixed in space."""
    where, name = fluid.number and f" in cavity {fluid.number}", fluid.number
    first, *others = fluid.W.symbols
    level = (*(s - 1 for s in fluid.C.symbols), *(first - s for s in others))
    if plane:
        value, meaning = dot(fluid.N, gamma), f"vertical vorticity of the fluid{where}"
        yield Integral(f"vorticity{name}", value, meaning, level=level, source=SOURCE, unit=SPIN)
    if plane and momentum_fixed:
        value, meaning = dot(fluid.N, M), f"angle of momentum and vorticity of the fluid{where}"
        yield Integral(f"angle{name}", value, meaning, level=level, source=SOURCE, unit=SQUARE)
