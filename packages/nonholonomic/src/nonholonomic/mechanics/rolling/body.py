"""A rigid body: mass, inertia, shape, gyrostat, cavities filled with fluid."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import ClassVar, TypeAlias

import numpy as np
import numpy.typing as npt
import sympy as sp

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.parsing.exact_decimals import exact_number
from flowlanes.system.system import Parameter
from flowlanes.system.vectors import Diagonal, Symmetric, Vector, real_symbol

from ..shapes.shape_base import Shape
from .cavity import Cavity
from .cavity_fit import check_cavities
from .fluid import Fluid, fluids_of_cavities
from .inertia import check_inertia

m, k = real_symbol("m"), Vector("k")

Inertia: TypeAlias = tuple[float, float, float] | tuple[tuple[float, ...], ...]


class WithInertia:
    """A shape with principal moments or a full tensor of inertia."""

    mass: float
    inertia: Inertia
    gyrostat: tuple[float, float, float]
    shape: Shape

    buildable: ClassVar[bool] = True
    """Whether the moments obey the triangle inequality, as those of a rigid body must."""

    @property
    def fluids(self) -> tuple[Fluid, ...]:
        """The fluids in its cavities that are not empty, numbered if there are several cavities."""
        return ()

    @property
    def tensor(self) -> np.ndarray:
        """The inertia tensor about the centre of mass, 3×3, body axes."""
        array = np.asarray(self.inertia, dtype=float)
        return np.diag(array) if array.ndim == 1 else array

    @property
    def principal(self) -> bool:
        """Whether the body axes are principal axes of inertia."""
        tensor = self.tensor
        return bool(np.all(tensor == np.diag(np.diag(tensor))))

    @property
    def remarks(self) -> tuple[str, ...]:
        """Warnings about unusual values; empty for an ordinary body.

        A centre of mass outside the shape is allowed, since a massless frame may connect the two,
        but it is more often a mistake.

        Examples
        --------
        >>> import nonholonomic
        >>> nonholonomic.Body(
        ...     1.0, (0.4, 0.5, 0.6), nonholonomic.Ball(1.0, centre=(0, 0, 2))
        ... ).remarks
        ('shape.centre puts the centre of mass outside the body',)
        """
        outside = self.shape.centre_outside
        return ("shape.centre puts the centre of mass outside the body",) if outside else ()


@arguments_checked
@dataclass(frozen=True)
class Body(WithInertia):
    """A rigid body, described in body axes with the centre of mass as origin.

    Parameters
    ----------
    mass : float
        m > 0, in kg.
    inertia : 3 floats or 3×3 floats
        Principal moments about the centre of mass, if the body axes are principal axes, or the
        full symmetric inertia tensor in the body axes (kg m²).
    shape : Shape
        Its surface, with the geometric centre relative to the centre of mass.
    gyrostat : 3 floats
        Constant momentum k of symmetric rotors, body axes (kg m²/s); the total momentum is Iω + k.
    cavity : Cavity or sequence of Cavity
        Ellipsoidal cavities filled with an ideal fluid. Mass, inertia and the centre of mass, the
        origin of the body axes, are those of the solid body without the fluid.

    Raises
    ------
    InputError
        If the mass is not positive, the inertia tensor is not symmetric, not positive definite,
        or breaks the triangle inequality I₁ + I₂ ≥ I₃, or a cavity does not fit into the shape.

    Notes
    -----
    Unusual values that are allowed, such as a centre of mass outside the shape, are listed in
    `remarks`.

    Examples
    --------
    >>> import nonholonomic
    >>> ball = nonholonomic.Body(
    ...     1.0, (0.4, 0.5, 0.6), nonholonomic.Ball(1.0), gyrostat=(0.0, 0.0, 0.2)
    ... )
    >>> nonholonomic.rolling_system(ball).defaults
    {m: 1.0, I_1: 0.4, I_2: 0.5, I_3: 0.6, k_1: 0.0, k_2: 0.0, k_3: 0.2, R: 1.0}
    """

    mass: float
    inertia: Inertia
    shape: Shape
    gyrostat: tuple[float, float, float] = (0.0, 0.0, 0.0)
    cavity: Cavity | Sequence[Cavity] = ()

    def __post_init__(self) -> None:
        check_mass(self.mass)
        check_inertia(self.inertia)
        object.__setattr__(self, "inertia", as_tuple(self.inertia))
        object.__setattr__(self, "gyrostat", tuple(float(x) for x in self.gyrostat))
        if len(self.gyrostat) != 3 or not all(map(math.isfinite, self.gyrostat)):
            raise InputError(f"gyrostat {self.gyrostat}: it must be three finite numbers")
        if not isinstance(self.cavity, Cavity):
            object.__setattr__(self, "cavity", tuple(self.cavity))
        if self.cavities:
            check_cavities(self.shape, self.cavities)

    @property
    def cavities(self) -> tuple[Cavity, ...]:
        """All cavities, also empty ones."""
        return (self.cavity,) if isinstance(self.cavity, Cavity) else tuple(self.cavity)

    @property
    def fluids(self) -> tuple[Fluid, ...]:
        """The fluids in its cavities that are not empty, numbered if there are several cavities."""
        return fluids_of_cavities(self.cavities) if self.cavities else ()


@dataclass(frozen=True)
class EquivalentBody(WithInertia):
    """The rigid body equivalent to a body whose fluid is in potential flow.

    Zhukovsky's theorem: an ideal fluid in potential flow acts on the body that holds it as a rigid
    body of the same mass and centre of mass.  For an ellipsoidal cavity its inertia tensor about
    the centre is K(E − C²) of :mod:`nonholonomic.mechanics.rolling.cavity`. It need not exist as a
    solid: the fluid takes only part in the rotation, and the three moments may break the triangle
    inequality.

    Attributes
    ----------
    mass : float
        Of body and fluid.
    inertia : 3 floats or 3×3 floats
        About their common centre of mass, body axes.
    shape : Shape
        Its centre relative to the common centre of mass.
    gyrostat : 3 floats
        Momentum of the rotors.
    """

    mass: float
    inertia: Inertia
    shape: Shape
    gyrostat: tuple[float, float, float]

    buildable = False


AnyBody = Body | EquivalentBody


def equivalent_body(body: AnyBody) -> AnyBody:
    """The equivalent rigid body; the body itself if it holds no fluid.

    Computed in rational numbers and rounded once, so that equal moments stay equal.
    """
    if isinstance(body, EquivalentBody) or not body.fluids:
        return body
    parts = [(exact_number(body.mass), sp.zeros(3, 1))]
    inertia = sp.Matrix(body.tensor.tolist()).applyfunc(exact_number)
    for cavity in body.cavities:
        centre = sp.Matrix([exact_number(x) for x in cavity.centre])
        parts.append((exact_number(cavity.mass), centre))
        inertia += cavity.equivalent_inertia
    mass = sum(share for share, _ in parts)
    common = sum((share * centre for share, centre in parts), sp.zeros(3, 1)) / mass
    for share, centre in parts:
        arm = centre - common
        # Steiner's theorem for the mass of each part
        inertia += share * (arm.dot(arm) * sp.eye(3) - arm * arm.T)
    offset = sp.Matrix([exact_number(x) for x in body.shape.centre]) - common
    tensor = np.array(inertia.tolist(), dtype=float)
    moments = np.diag(tensor) if inertia.is_diagonal() else tensor
    return EquivalentBody(
        float(mass),
        as_tuple(moments),
        replace(body.shape, centre=(float(offset[0]), float(offset[1]), float(offset[2]))),
        body.gyrostat,
    )


def as_tuple(inertia: npt.ArrayLike) -> Inertia:
    """Principal moments or an inertia tensor as tuples of floats."""
    array = np.asarray(inertia, dtype=float)
    if array.ndim == 2:
        return tuple(tuple(map(float, row)) for row in array)
    first, second, third = map(float, array)
    return first, second, third


def triangle_inequalities(moments: Sequence[sp.Symbol]) -> dict[sp.Symbol, tuple[sp.Basic, ...]]:
    """Conditions on three moments of inertia about orthogonal axes, by moment.

    Each is positive and at most the sum of the other two.
    """
    total = sp.Add(*moments)
    return {moment: (moment > 0, moment <= total - moment) for moment in moments}


def check_mass(mass: float) -> None:
    """Raise InputError unless the mass is positive and finite."""
    if not (math.isfinite(mass) and mass > 0):
        raise InputError(f"mass {mass}: it must be a positive finite number")


def body_parameters(body: WithInertia, inertia: Diagonal | Symmetric) -> tuple[Parameter, ...]:
    """Mass, inertia and gyrostatic momentum of a body, with their numbers."""
    entries = inertia.independent(body.tensor)
    moments = tuple(inertia.entries.diagonal())
    mass, axis = "mass", "moment of inertia about body axis"
    inequalities = triangle_inequalities(moments)
    if not body.principal:
        axis = "entry of the inertia tensor"
    if not body.buildable:
        mass, axis = "mass of body and fluid", axis.replace("inertia", "equivalent inertia")
        inequalities = {moment: (moment > 0,) for moment in moments}
    parameters = [Parameter(m, mass, body.mass, "kg", (m > 0,))]
    for symbol, value in zip(inertia.symbols, entries, strict=True):
        label = str(symbol).removeprefix("I_")
        conditions = inequalities.get(symbol, ())
        parameters.append(Parameter(symbol, f"{axis} {label}", float(value), "kg m^2", conditions))
    if any(body.gyrostat):
        parameters += [
            Parameter(s, f"gyrostatic momentum, body axis {i}", x, "kg m^2/s")
            for i, (s, x) in enumerate(zip(k.symbols, body.gyrostat, strict=True), 1)
        ]
    return tuple(parameters)
