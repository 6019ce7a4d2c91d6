"""The protocol of all shapes, and checks that they share.

A shape is described by its support function h(ν), the distance of the tangent plane with outward
normal ν from the geometric centre.  The contact point with ν = −γ is ∇h, and its derivative,
the *spread* W = ∂²h, is a symmetric operator on the tangent plane whose eigenvalues are the
principal radii of curvature.  A new shape derives from `SupportShape` and gives its Gauss map;
rolling, sliding, drawings and messages use only the methods below.
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import lru_cache
from typing import ClassVar

import numpy as np
import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.errors import InputError
from flowlanes.system.arrays import FloatArray
from flowlanes.system.system import Guard, Parameter
from flowlanes.system.vectors import Vector, dot, norm_squared, zero

from .gauss_map import GaussMap, points_of_map
from .kinds import Registered
from .kinematics import Contact, gamma, r, rdot
from .rays import directions
from .surfaces import Surface

c = Vector("c")

#: Number of tangent planes examined.
PLANES = 2000


def convexity(product: sp.Expr, total: sp.Expr) -> tuple[Guard, Guard]:
    """Guards on product and sum of the principal curvatures, both positive."""
    message = "the contact leaves the convex part of the body"
    return Guard("convex", product, message), Guard("convex", total, message)


def length(symbol: sp.Symbol, meaning: str, value: float) -> Parameter:
    """A positive length as a parameter."""
    return Parameter(symbol, meaning, value, "m", (symbol > 0,))


def require_positive(shape: str, **lengths: float) -> None:
    """Raise InputError unless all lengths are positive."""
    for name, value in lengths.items():
        if not (math.isfinite(value) and value > 0):
            raise InputError(f"{name} {value} of the {shape}: it must be a positive finite number")


def require_symbols(
    what: str, used: set[sp.Symbol], symbols: set[sp.Symbol], variables: str
) -> None:
    """Raise InputError if a formula uses a symbol that is not known."""
    unknown = sorted(map(str, used - symbols))
    if unknown:
        raise InputError(
            f"{what}: {', '.join(unknown)} is not known; it may use {variables} and the "
            "parameters of the shape"
        )


def check_centre(centre: tuple[float, float, float]) -> None:
    """Raise InputError unless a centre is three finite numbers."""
    if len(centre) != 3 or not all(math.isfinite(x) for x in centre):
        raise InputError(f"centre {centre}: it must be three finite numbers")


@dataclass(frozen=True)
class AxialSymmetry:
    """Conditions under which a shape is a body of revolution about body axis 3.

    Attributes
    ----------
    conditions : tuple of sympy.Expr
        Expressions in the parameters that vanish if the shape is one of revolution.
    support : sympy.Expr
        The support function in ``gamma_3`` under these conditions.
    """

    conditions: tuple[sp.Expr, ...]
    support: sp.Expr


@dataclass(frozen=True)
class Shape(Registered, ABC):
    """The surface of a convex body; the base of all shapes.

    Parameters
    ----------
    centre : 3 floats
        Geometric centre minus centre of mass, body axes (m).

    Notes
    -----
    A class that sets `kind` is known by that word to experiment files as soon as its module is
    imported; its fields are the keys of the table [body.shape].

    Examples
    --------
    >>> import nonholonomic
    >>> from nonholonomic.mechanics.shapes.shape_base import Shape
    >>> isinstance(nonholonomic.Disk(1.0), Shape), Shape.of_kind("disk") is nonholonomic.Disk
    (True, True)
    """

    centre: tuple[float, float, float] = field(default=(0.0, 0.0, 0.0), kw_only=True)

    by_equation: ClassVar[bool] = False
    """Whether the shape is given by an equation f = 0, so that r replaces γ in the state."""
    has_flat_face: ClassVar[bool] = False
    """Whether the normals ±e₃ have no unique point: the equations fail when the body lies flat."""
    numbers_are_parameters: ClassVar[bool] = False
    """Whether all members with positive numbers have the same equations."""
    is_ellipsoid: ClassVar[bool] = False
    """Whether it is an ellipsoid with the semi-axes b_1, b_2, b_3."""

    @property
    def title(self) -> str:
        """Name of the shape for titles."""
        return self.kind.replace("_", " ").replace("-", " ").capitalize()

    @property
    def offset(self) -> MatrixExpr:
        """The vector c from the centre of mass to the geometric centre, or zero."""
        return c if any(self.centre) else zero

    @property
    def offset_parameters(self) -> tuple[Parameter, ...]:
        """The components of c, if it is not zero."""
        if not any(self.centre):
            return ()
        return tuple(
            Parameter(s, f"geometric centre minus centre of mass, body axis {i}", x, "m")
            for i, (s, x) in enumerate(zip(c.symbols, self.centre, strict=True), 1)
        )

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """The parameters of the surface."""
        return self.gauss().parameters

    def level(self, point: Vector) -> sp.Expr | None:
        """f at a point from the geometric centre; None for shapes given by a Gauss map."""
        return None

    @property
    def signed_radius(self) -> float | None:
        """Radius of a spherical surface, negative if hollow; None for other shapes.

        Its absolute value is R of the equations.
        """
        return None

    @property
    def is_ball(self) -> bool:
        """Whether the surface is a sphere."""
        return self.signed_radius is not None

    @property
    def is_balanced_ball(self) -> bool:
        """Whether its surface is a sphere about the centre of mass."""
        return self.is_ball and not any(self.centre)

    @property
    def hollow(self) -> bool:
        """Whether the inner surface makes contact, with the support inside."""
        return False

    @property
    def is_turned(self) -> bool:
        """Whether the axes of symmetry are rotated against the body axes."""
        return False

    @property
    def edge_radius(self) -> float | None:
        """Radius of the circular edge of a shape that touches only there; None for others."""
        return None

    @property
    def axial_symmetry(self) -> AxialSymmetry | None:
        """Conditions for symmetry about body axis 3; None if they are not known."""
        return None

    @abstractmethod
    def gauss(self) -> GaussMap:
        """The inverse Gauss map γ ↦ r − c in closed form.

        Raises
        ------
        InputError
            If there is none.
        """

    @abstractmethod
    def contact(self, surface: Surface, swing: MatrixExpr, radius: sp.Expr) -> Contact:
        """The kinematics of the contact with a surface.

        Parameters
        ----------
        surface : Surface
        swing : MatrixExpr
            γ×ω + K u; see :mod:`nonholonomic.mechanics.shapes.kinematics`.
        radius : sympy.Expr
            The symbol a, or the radius of a sphere concentric to the support.

        Raises
        ------
        InputError
            If the body fits the surface nowhere.
        """

    @abstractmethod
    def _points(self) -> Callable[[FloatArray], FloatArray]:
        """Construct the function of `contact_points`."""

    def contact_points(self) -> Callable[[FloatArray], FloatArray]:
        """The function γ ↦ r in numbers, for unit vectors (n, 3) in body axes.

        r runs from the centre of mass to the point of the surface whose outward normal is −γ.
        """
        return _points_of(self)

    @property
    def centre_outside(self) -> bool:
        """Whether the centre of mass lies outside the shape, tested on many tangent planes.

        For a hollow ball: outside its sphere. A disk or a torus is the rim of a rolling body, such
        as a cylinder or a cup of any height: the centre is outside if it is farther from the axis
        than the rim.
        """
        return any(self.centre) and bool((self.heights(-directions(PLANES)) < 0).any())

    def heights(self, normals: FloatArray) -> FloatArray:
        """Extent from the centre of mass along unit vectors (n, 3)."""
        heights: FloatArray = np.einsum("ni,ni->n", self.contact_points()(-normals), normals)
        return heights

    @property
    def half_breadth(self) -> float:
        """Half the largest distance between points with opposite normals, sampled."""
        return _half_breadth(self)


@lru_cache(maxsize=64)
def _points_of(shape: Shape) -> Callable[[FloatArray], FloatArray]:
    """Cached `contact_points` of a shape: many initial states share one body."""
    return shape._points()


@lru_cache(maxsize=64)
def _half_breadth(shape: Shape) -> float:
    if shape.signed_radius is not None:
        return abs(shape.signed_radius)
    normals = directions(PLANES)
    points = shape.contact_points()
    chords = points(normals) - points(-normals)
    return float(np.nanmax(np.linalg.norm(chords, axis=1))) / 2


@dataclass(frozen=True)
class SupportShape(Shape):
    """A shape defined by a closed-form inverse Gauss map.

    Examples
    --------
    >>> import nonholonomic
    >>> from nonholonomic.mechanics.shapes.shape_base import SupportShape
    >>> (
    ...     isinstance(nonholonomic.Disk(1.0), SupportShape),
    ...     isinstance(nonholonomic.ImplicitShape, SupportShape),
    ... )
    (True, False)
    """

    def contact(self, surface: Surface, swing: MatrixExpr, radius: sp.Expr) -> Contact:
        """The contact kinematics of r(γ): (E + KW) γ̇ = γ×ω + K u on the tangent plane."""
        body = self.gauss()
        moving = surface.under_map(body, swing, radius)
        return Contact(
            state=((gamma, moving.rate), *moving.state),
            relations=(norm_squared(gamma) - 1, *moving.relations),
            parameters=body.parameters + self.offset_parameters + surface.parameters,
            definitions=(
                *body.definitions,
                (r, self.offset + body.reach),
                *moving.definitions,
                (rdot, -body.spread(moving.rate)),
            ),
            guards=body.guards + moving.guards,
            r=r,
            rdot=rdot,
            gammadot=moving.rate,
            square=norm_squared(r),
            height=body.support - dot(self.offset, gamma),
            spread=body.spread,
            pull=moving.pull,
            volume=moving.volume,
            start=moving.start,
        )

    def _points(self) -> Callable[[FloatArray], FloatArray]:
        return points_of_map(self.gauss(), self.centre)
