"""A homogeneous ball on a surface as a mechanism.

From it :func:`nonholonomic.mechanics.lagrangian.poincare_suslov.equations_of_motion` derives the
equations that :mod:`nonholonomic.mechanics.ball.equations` states in closed form; a test compares
them.
"""

from __future__ import annotations

import sympy as sp

from flowlanes.arguments import NamedFormulas
from flowlanes.system.system import Parameter
from flowlanes.system.vector_operators import gradient
from flowlanes.system.vectors import cross, dot, norm_squared, real_symbol, vectors

from ..lagrangian.mechanism import Frame, Mechanism, rotations
from .equations import Contact

R, omega, v, n, r, df = vectors("R omega v n r df")
m, mu, b, ell = (real_symbol(name) for name in ("m", "mu", "b", "ell"))


def ball_mechanism(
    contact: Contact,
    surface: sp.Expr,
    potential: sp.Expr,
    parameters: tuple[Parameter, ...],
    name: str = "ball-on-surface",
) -> Mechanism:
    """A ball whose centre moves on `surface` = 0, with ω and v in space axes.

    The rotations enter through ω alone; their structure constants in space axes are those in body
    axes with the opposite sign. f stays constant because v = r×ω is tangent to the surface.

    Parameters
    ----------
    contact : ``"marble"`` or ``"rubber"``
        v + ω×r = 0; for rubber also (ω, n) = 0.
    surface, potential : sympy.Expr
        f and U in ``R_1``, ``R_2``, ``R_3``; both may be unspecified functions.
    parameters : tuple of Parameter
        m, μ, b and those in both formulas.
    """
    structure: NamedFormulas = {
        pair: {k: -c for k, c in row.items()} for pair, row in rotations(omega).items()
    }
    half = sp.Rational(1, 2)
    slip = v + cross(omega, r)
    return Mechanism(
        name=name,
        frame=Frame({R: v}, (omega, v), structure=structure),
        lagrangian=half * m * norm_squared(v) + half * mu * norm_squared(omega) - potential,
        constraints=(slip,) if contact == "marble" else (slip, dot(omega, n)),
        definitions={
            df: gradient(surface, R, "f"),
            ell: sp.sqrt(norm_squared(df)),
            n: df / ell,
            r: -b * n,
        },
        parameters=parameters,
        source="(2.6), (2.10)",
    )
