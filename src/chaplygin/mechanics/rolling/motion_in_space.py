"""Reconstruction of the motion of a rolling body in space."""

from __future__ import annotations

from ...core.named_formulas import Pairs
from ...core.system import Observable, Reconstruction
from ...core.vectors import Vector, constant, cross, real_symbol, to_components
from ..shapes.surfaces import Plane, Surface
from .attitude import (
    attitude,
    attitude_observable,
    attitude_relations,
    quaternion_rate,
    rotation,
    unit_length,
)
from .contact import Contact

omega, gamma, zeta = (Vector(name) for name in ("omega", "gamma", "zeta"))
place, a = Vector("place", 2), real_symbol("a")


def motion_in_space(contact: Contact, surface: Surface, tilting: bool) -> Reconstruction:
    """The equations for attitude and place of a rolling body, driven by its reduced motion.

    Parameters
    ----------
    contact : Contact
    surface : Plane or Sphere
    tilting : bool
        Whether ζ, the vertical in body axes, belongs to the state on a sphere.
    """
    turn = rotation()
    reach = turn * to_components(contact.r)
    if isinstance(surface, Plane):
        # the centre's velocity is r×ω in body axes; its height follows from the position
        velocity = turn * to_components(cross(contact.r, omega))
        x, y = place.symbols
        centre = constant([x, y, contact.height])
        point = constant([x + reach[0], y + reach[1], 0])
        field: Pairs = (
            (attitude, quaternion_rate(omega)),
            (place, constant(velocity[:2])),
        )
        relations = (unit_length(), *attitude_relations(gamma))
    else:
        point = a * turn * to_components(gamma)
        centre = point - reach
        field = ((attitude, quaternion_rate(omega)),)
        relations = (unit_length(),)
        if tilting:
            relations += attitude_relations(zeta)
    return Reconstruction(
        field=field,
        relations=relations,
        observables=(
            attitude_observable(),
            Observable("centre", centre, "centre of mass", "m", "space", "(1.17)"),
            Observable("contact", point, "contact point", "m", "space", "(1.14)"),
        ),
    )
