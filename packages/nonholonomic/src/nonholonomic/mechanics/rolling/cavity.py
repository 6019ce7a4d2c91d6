"""Ellipsoidal cavities filled with an ideal fluid whose motion has uniform vorticity.

Relative to the body the fluid moves with the velocity A(ξ×A⁻¹x), x from the centre of the cavity,
where the symmetric tensor A has the semi-axes as its eigenvalues (Poincaré, Zhukovsky, Hough).
Its kinetic energy about its centre is

    ½(ω, Kω) + (ω, KCξ) + ½(ξ, Kξ),

with two tensors K and C that have the axes of the cavity: K is the inertia tensor that the fluid
would have if it were solid, with the moments (m/5)(b₂² + b₃²), …, and C has the principal values
2b₂b₃/(b₂² + b₃²), … (docs/fluid.md).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.parsing.exact_decimals import exact_number

from ..rotations import rotation_rows

IDENTITY = (1.0, 0.0, 0.0, 0.0)


@arguments_checked
@dataclass(frozen=True)
class Cavity:
    """An ellipsoidal cavity filled with an ideal fluid.

    Parameters
    ----------
    axes : 3 floats
        Semi-axes b₁, b₂, b₃ > 0 (m).
    mass : float
        Mass of the fluid, not negative (kg); the mass of the body does not contain it.  An empty
        cavity, of mass zero, has no influence.
    turn : 4 floats
        Attitude of the cavity in the body: the quaternion (w, x, y, z), of any length, of the
        rotation from cavity axes to body axes.
    centre : 3 floats
        Centre of the cavity minus centre of mass of the solid body, without the fluid; body axes
        (m).

    Raises
    ------
    InputError
        If a semi-axis is not positive, the mass is negative, or the quaternion is zero.

    Examples
    --------
    >>> import nonholonomic
    >>> cavity = nonholonomic.Cavity((0.5, 0.4, 0.3), mass=0.8)
    >>> ball = nonholonomic.Body(1.0, (0.4, 0.5, 0.6), nonholonomic.Ball(1.0), cavity=cavity)
    >>> nonholonomic.rolling_system(ball).state
    (M, gamma, N)
    """

    axes: tuple[float, float, float]
    mass: float
    turn: tuple[float, float, float, float] = IDENTITY
    centre: tuple[float, float, float] = (0.0, 0.0, 0.0)

    def __post_init__(self) -> None:
        for name, size in (("axes", 3), ("turn", 4), ("centre", 3)):
            numbers = tuple(float(x) for x in getattr(self, name))
            object.__setattr__(self, name, numbers)
            if len(numbers) != size or not all(map(math.isfinite, numbers)):
                words = {3: "three", 4: "four"}[size]
                raise InputError(
                    f"{name} {numbers} of the cavity: {words} finite numbers are needed"
                )
        for i, value in enumerate(self.axes, 1):
            if not value > 0:
                raise InputError(f"semi-axis {i} {value} of the cavity: it must be positive")
        if not (math.isfinite(self.mass) and self.mass >= 0):
            raise InputError(
                f"mass {self.mass} of the fluid in the cavity: it must be finite and not negative"
            )
        if not any(self.turn):
            raise InputError("turn of the cavity: a quaternion that turns must not be zero")

    @property
    def rotation(self) -> sp.ImmutableDenseMatrix:
        """The rotation matrix from cavity to body axes, with rational entries."""
        turn = [exact_number(x) for x in self.turn]
        return sp.ImmutableDenseMatrix(rotation_rows(turn, 2 / sp.Add(*(x * x for x in turn))))

    @property
    def solid_inertia(self) -> sp.ImmutableDenseMatrix:
        """K, the inertia tensor about the cavity's centre of the fluid if it were solid, exact."""
        b = self._squares
        share = exact_number(self.mass) / 5
        return self._in_body_axes([share * (b[i - 2] + b[i - 1]) for i in range(3)])

    @property
    def coupling(self) -> sp.ImmutableDenseMatrix:
        """C with the principal values 2b_j b_k/(b_j² + b_k²), exact; E for a sphere."""
        b, squares = [exact_number(x) for x in self.axes], self._squares
        return self._in_body_axes(
            [2 * b[i - 2] * b[i - 1] / (squares[i - 2] + squares[i - 1]) for i in range(3)]
        )

    @property
    def equivalent_inertia(self) -> sp.ImmutableDenseMatrix:
        """K(E − C²), the inertia tensor of the fluid in potential flow (Zhukovsky), exact."""
        return self.solid_inertia * (sp.eye(3) - self.coupling**2)

    @property
    def _squares(self) -> list[sp.Rational]:
        return [exact_number(x) ** 2 for x in self.axes]

    def _in_body_axes(self, principal: Sequence[sp.Rational]) -> sp.ImmutableDenseMatrix:
        turn = self.rotation
        return turn * sp.diag(*principal) * turn.T
