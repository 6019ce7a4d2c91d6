"""What is to be drawn of a study: the body's outline and what it rolls on."""

from __future__ import annotations

from typing import NamedTuple

from ..mechanics.points import contact_points
from ..mechanics.surfaces import Plane
from .drawing import Ground, Outline, PlaneGround, SphereGround, outline_from_contact
from .prepare import Study

__all__ = ["Scene", "scene_of", "weight_of"]


class Scene(NamedTuple):
    """The drawn body and its ground."""

    outline: Outline
    surface: Ground


def scene_of(study: Study) -> Scene | None:
    """The scene of a study; None where nothing rolls."""
    if study.rolling is None:
        return None
    surface = study.rolling.surface
    ground = PlaneGround() if isinstance(surface, Plane) else SphereGround(surface.radius)
    return Scene(outline_from_contact(contact_points(study.rolling.body.shape)), ground)


def weight_of(study: Study) -> float | None:
    """m g, with which the normal force is compared; None without gravity."""
    if study.rolling is None or not study.rolling.field.gravity:
        return None
    return study.rolling.body.mass * study.rolling.field.gravity
