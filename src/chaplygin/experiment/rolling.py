"""From the tables of an experiment to the rolling body that they describe."""

from __future__ import annotations

import sympy as sp

from ..catalogue import known_laws_of
from ..mechanics.rolling.body import Body
from ..mechanics.rolling.equations import Forces, Rolling
from ..mechanics.rolling.surfaces import Plane, Sphere
from ..printing.numerals import number
from .file.models import RollingExperiment
from .file.shape_tables import shape_name
from .file.tables import PlaneTable
from .mechanism import identifier
from .subject import BodySubject


def rolling_subject(experiment: RollingExperiment) -> BodySubject:
    """The rolling body of an experiment, with all integrals that are known of it.

    Raises
    ------
    InputError
        If its parts do not fit together; the message names the place in the file.
    """
    rolling = _rolling(experiment)
    with experiment.placing_errors("body"):
        title = experiment.title or _title(rolling)
        system = rolling.system(identifier(title), title)
    start = experiment.start
    return BodySubject(
        system=system.with_laws(*known_laws_of(rolling, system)),
        start_values={"omega": start.omega, "gamma": start.gamma},
        until=experiment.run.until,
        setting=rolling_setting(rolling),
        rolling=rolling,
        from_catalogue=False,
        heading=start.heading,
        normal=start.normal,
    )


def _rolling(experiment: RollingExperiment) -> Rolling:
    with experiment.placing_errors("body", "shape"):
        shape = experiment.body.shape.shape()
    table = experiment.body
    with experiment.placing_errors("body"):
        body = Body(table.mass, table.inertia, shape, table.gyrostat)
    surface = experiment.surface
    ground = Plane() if isinstance(surface, PlaneTable) else Sphere(surface.radius, surface.side)
    forces = experiment.field
    with experiment.placing_errors("field"):
        potential = forces.expression(forces.potential) if forces.potential else sp.S.Zero
        field = Forces(forces.gravity, potential, forces.values)
    return Rolling(body, ground, experiment.contact.model, field)


def _title(rolling: Rolling) -> str:
    """A name for a body that the catalogue has none for."""
    ground = "a plane"
    if isinstance(rolling.surface, Sphere):
        ground = "a sphere" if rolling.surface.side == "outside" else "the inside of a sphere"
    manner = "" if rolling.contact == "marble" else ", rubber contact"
    return f"{shape_name(rolling.body.shape)} on {ground}{manner}"


def rolling_setting(rolling: Rolling) -> str:
    """The body, its support, the contact and the forces in one line."""
    surface = rolling.surface
    ground = "a horizontal plane"
    if not isinstance(surface, Plane):
        ground = f"a sphere of radius {surface.radius:g}, {surface.side}"
    manner = "without slipping"
    if rolling.contact == "rubber":
        manner = "with neither slipping nor spinning"
    gravity = rolling.field.gravity
    field = f"gravity {number(gravity, 6)} m/s²" if gravity else "no gravity"
    if rolling.field.potential != 0:
        field += ", a potential U(γ)"
    if any(rolling.body.gyrostat):
        field += "; with rotors"
    return f"{shape_name(rolling.body.shape)} on {ground}, {manner}; {field}"
