"""The drawn body and its supporting surface."""

from __future__ import annotations

from typing import NamedTuple

from ...experiment.subjects.subject import Subject
from ...geometry.ball_surface import SurfaceGround, ground_of_ball, ground_of_surface
from ...geometry.mesh import BodyMesh, outline_from_contact
from ..drawing.shading import Ground, PlaneGround, SphereGround


class Scene(NamedTuple):
    """The drawn body and its ground."""

    outline: BodyMesh
    surface: Ground


class SurfaceScene(NamedTuple):
    """The drawn body and the surface f = 0 that carries it."""

    outline: BodyMesh
    surface: SurfaceGround


def scene_of(subject: Subject) -> Scene | None:
    """The scene of a body that rolls or slides on a plane or a sphere; None for other subjects."""
    surface, outline = subject.surface, subject.outline
    if surface is None or outline is None or not surface.is_even:
        return None
    radius = surface.signed_radius
    ground = PlaneGround() if radius is None else SphereGround(radius)
    return Scene(outline_from_contact(outline), ground)


def surface_scene_of(subject: Subject) -> SurfaceScene | None:
    """The scene of a homogeneous ball on a surface, or of a body on neither plane nor sphere."""
    ball, surface, outline = subject.ball, subject.surface, subject.outline
    if ball is not None:
        radius = ball.radius
        mesh = outline_from_contact(lambda gamma: -radius * gamma)
        return SurfaceScene(mesh, ground_of_ball(ball))
    if surface is None or outline is None or surface.is_even:
        return None
    return SurfaceScene(outline_from_contact(outline), ground_of_surface(surface))
