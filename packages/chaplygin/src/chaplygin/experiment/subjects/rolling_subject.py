"""The rolling body described by the tables of an experiment."""

from __future__ import annotations

from nonholonomic.catalogue import known_laws_of
from nonholonomic.mechanics.rolling.equations import RollingBody
from nonholonomic.mechanics.rolling.fluid import Fluid
from nonholonomic.system_files.body_objects import rolling_body
from nonholonomic.system_files.sourced import identifier

from ..models.rolling_model import RollingExperiment
from .subject import BodySubject


def rolling_subject(experiment: RollingExperiment) -> BodySubject:
    """The rolling body of an experiment, with all its known integrals.

    Raises
    ------
    InputError
        If its parts do not fit together; the message names the place in the file.
    """
    rolling = rolling_body(experiment)
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


def _title(rolling: RollingBody) -> str:
    """A title for a body that is not in the catalogue."""
    manner = "" if rolling.contact == "marble" else ", rubber contact"
    filled = " with fluid" if rolling.body.fluids else ""
    return f"{rolling.body.shape.title}{filled} on {rolling.surface.title}{manner}"
