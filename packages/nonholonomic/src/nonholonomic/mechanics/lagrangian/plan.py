"""The drawing of a mechanism in the plane: path, links, wheels and blades.

Points are pairs of formulas (x, y); wheels, axles and blades have a third one, the angle between
their heading and the x axis. All are formulas in the state lifted to space, definitions and
parameters.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any, TypeAlias

import numpy as np
import sympy as sp

from flowlanes.arguments import arguments_checked
from flowlanes.system.arrays import FloatArray
from flowlanes.system.vectors import real_symbol

from .mechanism import Mechanism

PlanePoint: TypeAlias = tuple[Any, Any]
Pose: TypeAlias = tuple[Any, Any, Any]

#: Largest number of coordinates of a frame that is inverted symbolically.
_MOST = 8
#: Number of random configurations at which a length must agree to count as constant.
_PLACES = 6
_SAME = 1e-9


@arguments_checked
@dataclass(frozen=True)
class Plan:
    """The drawing of a mechanism in the plane.

    Attributes
    ----------
    path : (x, y)
        The point whose path is drawn.
    links : tuple of (x, y, x, y)
        Straight rods between two points.
    wheels, axles, blades : tuple of (x, y, heading)
        A wheel seen from above, two wheels side by side, a blade.
    points : tuple of (x, y)
        Points marked by a ring, such as a centre of mass.

    Examples
    --------
    >>> import nonholonomic
    >>> import sympy as sp
    >>> x, y = sp.symbols("x y", real=True)
    >>> nonholonomic.mechanics.lagrangian.Plan((x, y)).path
    (x, y)
    """

    path: PlanePoint
    links: tuple[tuple[sp.Expr, sp.Expr, sp.Expr, sp.Expr], ...] = ()
    wheels: tuple[Pose, ...] = ()
    axles: tuple[Pose, ...] = ()
    blades: tuple[Pose, ...] = ()
    points: tuple[PlanePoint, ...] = ()


def plan_of(mechanism: Mechanism) -> Plan | None:
    """The drawing that follows from the constraints; None without coordinates x and y.

    A constraint that forbids sideways motion of a point is drawn as a wheel, if the point is
    reached from (x, y) by rods of constant length along coordinate angles.
    """
    x, y = real_symbol("x"), real_symbol("y")
    coordinates = mechanism.frame.coordinates
    if x not in coordinates or y not in coordinates or real_symbol("z") in coordinates:
        return None
    wheels: list[Pose] = []
    links: list[tuple[sp.Expr, sp.Expr, sp.Expr, sp.Expr]] = []
    for form in _forms(mechanism):
        arms = _arms(mechanism, form)
        if arms is None:
            continue
        joints: list[PlanePoint] = [(x, y)]
        for angle, length in arms:
            before = joints[-1]
            joints.append((before[0] + length * sp.cos(angle), before[1] + length * sp.sin(angle)))
        wheels.append((*joints[-1], sp.atan2(-form[x], form[y])))
        rods = [(*first, *second) for first, second in pairwise(joints)]
        links += [rod for rod in rods if rod not in links]
    return Plan((x, y), tuple(links), tuple(wheels))


def _forms(mechanism: Mechanism) -> list[dict[sp.Symbol, sp.Expr]]:
    """Linear constraints as one-forms in the rates of the coordinates."""
    frame = mechanism.frame
    G = frame.matrix
    if G.rows != G.cols or G.rows > _MOST:
        return []
    inverse = G.inv()
    forms = []
    for constraint in mechanism.f:
        formula = mechanism.expand(constraint)
        row = [sp.diff(formula, w) for w in frame.w]
        if any(entry.free_symbols & set(frame.w) for entry in row):
            continue
        covector = sp.Matrix([row]) * inverse
        forms.append(dict(zip(frame.coordinates, covector, strict=True)))
    return forms


def _arms(
    mechanism: Mechanism, form: dict[sp.Symbol, sp.Expr]
) -> list[tuple[sp.Symbol, float]] | None:
    """Angles and lengths of the rods from (x, y) to the point constrained.

    With n the normal of the heading, the velocity of the point Σ a_θ (cos θ, sin θ) has the
    component Σ a_θ θ̇ (n_y cos θ − n_x sin θ) along n. None if the lengths are not constant.
    """
    x, y = real_symbol("x"), real_symbol("y")
    others = [q for q in mechanism.frame.coordinates if q not in (x, y)]
    formulas = [form[q] for q in (x, y, *others)]
    values = {p.symbol: p.default for p in mechanism.parameters}
    names = [x, y, *others]
    free = set().union(*(formula.free_symbols for formula in formulas)) - {*names, *values}
    if free:
        return None
    function = sp.lambdify([*names, *values], formulas, "numpy")
    places = np.random.default_rng(0).uniform(0.3, 2.8, (_PLACES, len(names)))
    try:
        rows = [np.array(function(*place, *values.values()), dtype=float) for place in places]
    except (ArithmeticError, TypeError, ValueError):
        return None
    return _lengths(others, places, np.stack(rows))


def _lengths(
    angles: Sequence[sp.Symbol], places: FloatArray, rows: FloatArray
) -> list[tuple[sp.Symbol, float]] | None:
    """The lengths from coefficients at several configurations; None unless constant."""
    across = np.hypot(rows[:, 0], rows[:, 1])
    if not np.all(np.isfinite(rows)) or np.any(across < _SAME):
        return None
    n_x, n_y = rows[:, 0] / across, rows[:, 1] / across
    lengths_by_angle = []
    for number, angle in enumerate(angles, 2):
        share = rows[:, number] / across
        if np.all(np.abs(share) < _SAME):
            continue
        swing = n_y * np.cos(places[:, number]) - n_x * np.sin(places[:, number])
        if np.any(np.abs(swing) < _SAME):
            return None
        lengths = share / swing
        if np.ptp(lengths) > _SAME * np.max(np.abs(lengths)):
            return None
        lengths_by_angle.append((angle, float(lengths[0])))
    return lengths_by_angle
