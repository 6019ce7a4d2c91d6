"""A new surface for homogeneous balls: z = h cos(x/w)."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from flowlanes.system.system import Parameter
from flowlanes.system.vectors import real_symbol
from nonholonomic.mechanics.ball.surface import Point, SmoothSurface

h, w = real_symbol("h"), real_symbol("w")


@dataclass(frozen=True, kw_only=True)
class Wave(SmoothSurface):
    """Waves of some height along x; their period is 2π times the width."""

    height: float
    width: float = 1.0

    kind = "wave"

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """Height and width."""
        return (Parameter(h, "height", self.height, "m"), Parameter(w, "width", self.width, "m"))

    def level(self, point: Point, offset: sp.Expr) -> sp.Expr | None:
        """z − h cos(x/w); its parallel surfaces have no simple equation."""
        return None if offset != 0 else point[2] - h * sp.cos(point[0] / w)
