"""A heavy disk with a sharp edge, marble contact: the classical rolling coin."""

from __future__ import annotations

from flowlanes.system.laws import Law, Measure, Rate, Reduction, Symmetry
from flowlanes.system.system import System
from flowlanes.system.vectors import dot, real_symbol, vectors

from ...mechanics.rolling.equations import RollingBody
from ...mechanics.shapes.shapes import Disk
from ...mechanics.shapes.surfaces import Plane
from ..catalogue_entry import laws_for

M, gamma = vectors("M gamma")
m, R, I_1, I_2, I_3 = (real_symbol(name) for name in ("m", "R", "I_1", "I_2", "I_3"))
#: γ₃, the vertical momentum and the momentum about the axis.
u, p, q = (real_symbol(name) for name in ("u", "p", "q"))

M_1, M_2, M_3 = M.symbols
g_1, g_2, g_3 = gamma.symbols
SOURCE = "§4.1, §11.4"


@laws_for("marble", Plane(), Disk)
def laws(rolling: RollingBody, system: System) -> tuple[Law, ...]:
    """Symmetry, measure and the linear equations for the two momenta as functions of γ₃."""
    body = rolling.body
    if (
        any(body.shape.centre)
        or rolling.field.potential != 0
        or any(body.gyrostat)
        or not body.principal
        or body.inertia[0] != body.inertia[1]
    ):
        return ()
    # the entry has one number for both moments, but the equations have two symbols
    level = (I_1 - I_2,)
    share = (p - u * q) / (I_1 * (1 - u**2))
    reach = m * R**2
    return (
        Symmetry(
            "rotation",
            {M_1: -M_2, M_2: M_1, g_1: -g_2, g_2: g_1},
            "rotation about the axis of symmetry",
            level=level,
            source=SOURCE,
        ),
        Measure("measure", {}, "invariant measure d³M d³γ", level=level, source=SOURCE),
        Reduction(
            "momenta",
            {u: g_3, p: dot(M, gamma), q: M_3},
            (
                Rate(q) + reach * share * Rate(u),
                Rate(p) - reach * (q / (I_3 + reach) - u * share) * Rate(u),
            ),
            "linear equations for the vertical momentum p and the axial momentum q by u = γ₃",
            level=level,
            source=SOURCE,
        ),
    )
