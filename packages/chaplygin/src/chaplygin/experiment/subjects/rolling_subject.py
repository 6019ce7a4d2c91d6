"""The rolling body described by the tables of an experiment."""

from __future__ import annotations

import sympy as sp

from nonholonomic.catalogue import known_laws_of
from nonholonomic.mechanics.rolling.body import Body
from nonholonomic.mechanics.rolling.equations import Forces, RollingBody
from nonholonomic.mechanics.rolling.fluid import Fluid
from nonholonomic.system_files.sourced import identifier

from ..models.rolling_model import BodyOnSurface, RollingExperiment
from .subject import BodySubject


def rolling_subject(experiment: RollingExperiment) -> BodySubject:
    """The rolling body of an experiment, with all its known integrals.

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
        start_values={
            "omega": start.omega,
            "gamma": start.gamma,
            **start.motion_of_fluids(experiment.body.cavities),
        },
        until=experiment.run.until,
        rolling=rolling,
        from_catalogue=False,
        heading=start.heading,
        normal=start.normal,
        letters=letters_with_fluid(rolling.body.fluids),
    )


def _rolling(experiment: RollingExperiment) -> RollingBody:
    body = body_of(experiment)
    with experiment.placing_errors("surface"):
        ground = experiment.surface.surface()
    return RollingBody(body, ground, experiment.contact.model, forces_of(experiment))


def body_of(experiment: BodyOnSurface) -> Body:
    """The body of an experiment.

    Raises
    ------
    InputError
        If its parts do not fit together; the message names the place in the file.
    """
    with experiment.placing_errors("body", "shape"):
        shape = experiment.body.shape.shape()
    table = experiment.body
    with experiment.placing_errors("body"):
        return Body(table.mass, table.inertia, shape, table.gyrostat, table.cavities)


def letters_with_fluid(fluids: tuple[Fluid, ...], rolls: bool = True) -> dict[str, str]:
    """Meanings of letters in the equations of a body with fluid; empty without fluid."""
    if not fluids:
        return {}
    pivot = "contact point" if rolls else "fixed point"
    centre = "common centre of mass" if rolls else "fixed point"
    letters = {
        "M": f"momentum of body and fluid about the {pivot}",
        "I": f"inertia tensor of the equivalent rigid body about the {centre}",
        "r": "from the common centre of mass to the contact point",
        "c": "from the common centre of mass to the geometric centre",
        "f": "contact force",
    }
    for fluid in fluids:
        where = f" in cavity {fluid.number}" if fluid.number else ""
        letters |= {
            str(fluid.N): f"circulation vector of the fluid{where}",
            str(fluid.C): f"coupling of the body to the fluid{where}",
            str(fluid.W): f"inverse of the inertia that the fluid{where} would have as a solid",
        }
    return letters


def forces_of(experiment: BodyOnSurface) -> Forces:
    """Gravity and potential of an experiment.

    Raises
    ------
    InputError
        If the potential is unusable; the message names the place in the file.
    """
    forces = experiment.field
    with experiment.placing_errors("field"):
        potential = forces.expression(forces.potential) if forces.potential else sp.S.Zero
        return Forces(forces.gravity, potential, forces.parameters)


def _title(rolling: RollingBody) -> str:
    """A name for a body that the catalogue has none for."""
    manner = "" if rolling.contact == "marble" else ", rubber contact"
    filled = " with fluid" if rolling.body.fluids else ""
    return f"{rolling.body.shape.title}{filled} on {rolling.surface.title}{manner}"
