"""The drawn body and the surface that it rolls on."""

from __future__ import annotations

from typing import NamedTuple

from nonholonomic.mechanics.ball.ball import RollingBall
from nonholonomic.mechanics.shapes.surfaces import Plane

from ...experiment.subjects.subject import Subject
from ...geometry.ball_surface import SurfaceGround, ground_of_ball
from ...geometry.mesh import BodyMesh, outline_from_contact
from ..drawing.shading import Ground, PlaneGround, SphereGround


class Scene(NamedTuple):
    """The drawn body and its ground."""

    outline: BodyMesh
    surface: Ground


class BallScene(NamedTuple):
    """The drawn ball and the surface that carries it."""

    outline: BodyMesh
    surface: SurfaceGround


def scene_of(subject: Subject) -> Scene | None:
    """The scene of a body that rolls or slides on a plane or a sphere; None without one."""
    surface, outline = subject.surface, subject.outline
    if surface is None or outline is None:
        return None
    ground = PlaneGround() if isinstance(surface, Plane) else SphereGround(surface.signed_radius)
    return Scene(outline_from_contact(outline), ground)


def ball_scene_of(ball: RollingBall) -> BallScene:
    """The scene of a homogeneous ball on a surface."""
    radius = ball.radius
    return BallScene(outline_from_contact(lambda gamma: -radius * gamma), ground_of_ball(ball))
