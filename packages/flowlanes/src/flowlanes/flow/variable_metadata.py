"""Meaning, unit, source and axes of state variables, for datasets."""

from __future__ import annotations

import math
from itertools import combinations

from ..system.matrices import Column, NamedMatrix, Skew
from ..system.system import System

#: Frames in which vectors are given: name of the axis, and labels of its components.
FRAMES = {
    "body": ("axis", (1, 2, 3)),
    "space": ("space", ("x", "y", "z")),
    "quaternion": ("quaternion", ("w", "x", "y", "z")),
}

#: Labels of these axes.
LABELS = {
    "axis": "body axis",
    "space": "space axis",
    "quaternion": "component of the quaternion",
    "pair": "plane of two body axes",
    "body_axis": "body axis",
    "space_axis": "space axis",
    "plane_axis": "coordinate of the hyperplane",
}

#: Dimensions of the vectors and matrices of n-dimensional systems.
N_DIMENSIONAL = ("pair", "body_axis", "space_axis", "plane_axis")

#: Variables of an n-dimensional lift to space: meaning, unit, dimensions.
_N_DIMENSIONAL = {
    "attitude": ("attitude, rows the space axes seen from the body", "1"),
    "contact": ("contact point in the hyperplane, space axes", "m"),
}

#: Three-component vectors in body axes: meaning, unit, source.
_BODY = {
    "omega": ("angular velocity", "rad/s", "(1.13)"),
    "gamma": ("unit vector fixed in space", "1", "(1.10)"),
    "M": ("angular momentum", "kg m^2/s", ""),
    "r": ("contact point from the centre of mass", "m", "(1.14)"),
    "zeta": ("upward vertical", "1", ""),
}

#: Vectors of a body that touches a surface.
_TOUCHING = {
    **_BODY,
    "gamma": ("normal of the surface at the contact", "1", "(1.10)"),
    "M": ("angular momentum about the contact point", "kg m^2/s", "(7.1)"),
}

#: Unit of a variable without metadata.
UNKNOWN = "unknown"


def cf_attributes(meaning: str, unit: str, source: str = "") -> dict[str, str]:
    """Attributes of a variable of a dataset, by the CF conventions."""
    return {"long_name": meaning, "units": unit or "1", "source": source}


def system_attributes(system: System) -> dict[str, str]:
    """Attributes of a dataset that name its system."""
    return {
        "Conventions": "CF-1.11",
        "system": system.title,
        "system_name": system.name,
        "summary": system.summary,
        "source": system.source,
    }


def dimensions_of(variable: Column | NamedMatrix) -> tuple[str, ...]:
    """The dimensions of a column or matrix in a dataset, besides time."""
    match variable:
        case Skew():
            return ("pair",)
        case NamedMatrix():
            return "space_axis", "body_axis"
    known = {"contact": "plane_axis", "w": "w_component"}
    return (known.get(str(variable), "body_axis"),)


def labels_of(dimension: str, size: int) -> list[int] | list[str]:
    """The labels along such a dimension: 1, 2, … or 12, 13, …."""
    if dimension != "pair":
        return list(range(1, size + 1))
    n = (1 + math.isqrt(1 + 8 * size)) // 2
    return [f"{i}{j}" for i, j in combinations(range(1, n + 1), 2)]


def variable_metadata(
    system: System, name: str, size: int, description: tuple[str, str] | None = None
) -> tuple[str, str, str, str]:
    """Meaning, unit, source and frame of a variable of the state, from its name.

    Parameters
    ----------
    system : System
    name : str
    size : int
        Number of components; 1 for a scalar.
    description : (str, str), optional
        Meaning and unit.

    Returns
    -------
    meaning, unit, source, frame : str
        The frame is ``"body"`` or ``"quaternion"``, empty for a scalar, and
        ``"<name>_component"`` for a vector in no known frame.
    """
    variable = next((v for v in system.state if str(v) == name), None)
    if isinstance(variable, Column | NamedMatrix):
        frame = dimensions_of(variable)[-1]
        meaning, units = description or _N_DIMENSIONAL.get(name, (name, UNKNOWN))
        return meaning, units, system.source, frame
    if name == "attitude":
        return "attitude quaternion, body to space", "", "", "quaternion"
    touching = any(item.name == "contact" for item in system.observables)
    known = (_TOUCHING if touching else _BODY) if size == 3 else {}
    if name in _circulation_vectors(system):
        known = {name: ("circulation vector of the fluid", "kg m^2/s", "")}
    meaning, units, source = (
        (*description, "") if description else known.get(name, (name, UNKNOWN, ""))
    )
    if name in known:
        return meaning, units, source, "body"
    return meaning, units, source, "" if size == 1 else f"{name}_component"


def _circulation_vectors(system: System) -> set[str]:
    """Names of the circulation vectors of fluids in cavities: N, or N1, N2, … of several."""
    names = [item.name for item in system.observables if item.frame == "body"]
    return {"N" + name.removeprefix("fluid") for name in names if name.startswith("fluid")}
