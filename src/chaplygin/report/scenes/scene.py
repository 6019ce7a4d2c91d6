"""The drawn body and the surface that it rolls on."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
import sympy as sp

from ...contact.equations.situation import FrictionalContact
from ...core.arrays import FloatArray
from ...core.vectors import Vector
from ...mechanics.ball.ball import RollingBall
from ...mechanics.rolling.equations import Rolling
from ...mechanics.rolling.gauss_map import contact_points
from ...mechanics.rolling.surfaces import Plane
from ..drawing.mesh import BodyMesh, outline_from_contact
from ..drawing.shading import Ground, PlaneGround, SphereGround
from .implicit_surface import SurfaceGround


class Scene(NamedTuple):
    """The drawn body and its ground."""

    outline: BodyMesh
    surface: Ground


class BallScene(NamedTuple):
    """The drawn ball and the surface that carries it."""

    outline: BodyMesh
    surface: SurfaceGround


def scene_of(rolling: Rolling | FrictionalContact) -> Scene:
    """The scene of a body that rolls or slides on a plane or a sphere."""
    surface = rolling.surface
    ground = PlaneGround() if isinstance(surface, Plane) else SphereGround(surface.signed_radius)
    # the recorded centre is that of body and fluid
    body = rolling.equivalent.body if isinstance(rolling, Rolling) else rolling.body
    return Scene(outline_from_contact(contact_points(body.shape)), ground)


def ball_scene_of(ball: RollingBall) -> BallScene:
    """The scene of a homogeneous ball on a surface."""
    radius = ball.radius
    return BallScene(outline_from_contact(lambda gamma: -radius * gamma), _ground(ball))


def _ground(ball: RollingBall) -> SurfaceGround:
    """The surface that carries the ball, by its own equation where it has one."""
    symbols = Vector("x").symbols
    numbers = {p.symbol: p.default for p in ball.surface.parameters}
    shift = 0.0 if ball.carrier == "support" else ball.radius
    below = ball.surface.equation(symbols, -sp.Float(shift)) if shift else ball.carrying
    f = (ball.carrying if below is None else below).subs(numbers)

    def values(formula: sp.Expr) -> Callable[[FloatArray], FloatArray]:
        function = sp.lambdify(symbols, formula, "numpy")

        def values_at(points: FloatArray) -> FloatArray:
            heights = np.asarray(function(*points.T), dtype=np.float64)
            return np.broadcast_to(heights, points.shape[:1])

        return values_at

    slopes = [values(f.diff(s)) for s in symbols]
    level, guards = values(f), [values(g.value) for g in ball.surface.domain(symbols)]

    def values_on_domain(points: FloatArray) -> FloatArray:
        """f, where there is any surface."""
        valid = np.all([guard(points) > 0.0 for guard in guards], axis=0)
        return np.where(valid, level(points), np.nan)

    return SurfaceGround(
        values_on_domain,
        lambda points: np.stack([slope(points) for slope in slopes], axis=-1),
        shift if below is None else 0.0,
    )
