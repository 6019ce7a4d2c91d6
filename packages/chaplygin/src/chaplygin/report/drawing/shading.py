"""Light and shadow of a lamp over the viewer's left shoulder."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeAlias

import numpy as np

from flowlanes.system.arrays import FloatArray

from ...geometry.view import View, unit
from .curves import convex_hull

_WRAP = 0.4
"""Negative cosine of the angle to the light at which the darkest part begins."""


@dataclass(frozen=True)
class PlaneGround:
    """The body rolls on the plane z = 0 of space."""


@dataclass(frozen=True)
class SphereGround:
    """The body rolls on a sphere centred at the origin of space.

    Attributes
    ----------
    radius : float
        Signed radius: positive if the body rolls on the outside, negative on the inside.
    """

    radius: float


Ground: TypeAlias = PlaneGround | SphereGround


def shaded_colours(
    colours: FloatArray, normals: FloatArray, view: View, contrast: float
) -> FloatArray:
    """Colours of a lit surface.

    Parameters
    ----------
    colours : (m, 3) array
        Red, green and blue of the surface itself, from 0 to 1.
    normals : (m, 3) array
        Unit normals of the side that is seen, space axes.
    view : View
        The view, with the light over the reader's left shoulder.
    contrast : float
        Darkening of the sides that face away from the light, from 0 to 1.

    Returns
    -------
    (m, 3) array
        Red, green and blue with shade and a soft gleam.
    """
    diffuse = np.clip((normals @ view.light + _WRAP) / (1.0 + _WRAP), 0.0, 1.0)
    gleam = 0.4 * contrast * np.clip(normals @ unit(view.light + view.toward), 0.0, 1.0) ** 28
    lit = colours * (1.04 - contrast + contrast * diffuse)[:, None]
    return np.clip(lit + (1.0 - lit) * gleam[:, None], 0.0, 1.0)


def sphere_shades(
    radius: float, view: View, side: float, levels: int
) -> list[tuple[FloatArray, float]]:
    """Regions of at least a given brightness on a sphere about the origin, nested.

    In projection, the part of a sphere with at least a given brightness is convex: the hull of an
    arc of a circle about the lamp and an arc of the border.

    Parameters
    ----------
    radius : float
        Positive.
    view : View
    side : float
        1 for the near half seen from outside, -1 for the far half seen from inside.
    levels : int
        Number of regions.

    Returns
    -------
    list of (polygon, brightness)
        Corners (k, 2) on paper; the light in the region, from 0 to 1.
    """
    angle = np.linspace(0.0, 2 * np.pi, 121)[:-1, None]
    border = np.cos(angle) * view.right + np.sin(angle) * view.up
    first = unit(np.cross(view.light, view.right))
    second = np.cross(view.light, first)
    shades = []
    for level in range(levels):
        brightness = level / levels
        height = brightness * (1.0 + _WRAP) - _WRAP
        ring = np.sqrt(1.0 - height**2) * (np.cos(angle) * first + np.sin(angle) * second)
        ring = ring + height * view.light
        inside = [ring[view.faces_reader(ring)], border[border @ view.light >= height]]
        normals = np.concatenate(inside) if level else border
        shades.append((convex_hull(side * radius * view.project(normals)), brightness))
    return shades


def cast_shadow(points: FloatArray, ground: Ground, light: FloatArray) -> FloatArray:
    """The shadow of a convex body on its support.

    Parameters
    ----------
    points : (n, 3) array
        Points of the body, space axes.
    ground : PlaneGround or SphereGround
        The ground that receives the shadow. The light enters a bowl through its far side.
    light : (3,) array
        Unit vector towards the lamp, space axes, above the horizon.

    Returns
    -------
    (k, 3) array
        Corners of the shadow on the ground, space axes; empty if the body is on the dark side of a
        sphere.
    """
    if isinstance(ground, PlaneGround):
        flat = points - points[:, 2:] / light[2] * light
        corners = convex_hull(flat[:, :2])
        return np.concatenate([corners, np.zeros((len(corners), 1))], axis=1)
    if ground.radius > 0.0 and points.mean(axis=0) @ light < 0.0:
        return np.empty((0, 3))
    first = unit(np.cross(light, np.array([0.0, 1.0, 0.0])))
    second = np.cross(light, first)
    corners = convex_hull(np.stack([points @ first, points @ second], axis=-1))
    reach = np.linalg.norm(corners, axis=-1, keepdims=True)
    corners = corners * np.minimum(1.0, abs(ground.radius) / np.maximum(reach, 1e-300))
    height = np.sqrt(np.clip(ground.radius**2 - np.sum(corners**2, axis=-1), 0.0, None))
    along = np.copysign(height, ground.radius)
    return np.column_stack([corners, along]) @ np.stack([first, second, light])
