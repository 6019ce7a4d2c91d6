"""Meaning, unit, source and axes of state variables, for datasets."""

from __future__ import annotations

import math
from itertools import combinations

from ..system.system import Metadata, System


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


def labels_of(dimension: str, size: int) -> list[int] | list[str]:
    """The labels along such a dimension: 1, 2, … or 12, 13, …."""
    if dimension != "pair":
        return list(range(1, size + 1))
    n = (1 + math.isqrt(1 + 8 * size)) // 2
    return [f"{i}{j}" for i, j in combinations(range(1, n + 1), 2)]


def variable_metadata(
    system: System, name: str, size: int, description: tuple[str, str] | None = None
) -> Metadata:
    """Meaning, unit, source and frame of a variable of the state, by the system's conventions.

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
        The frame is one of the system's conventions, empty for a scalar, and
        ``"<name>_component"`` for a vector in no known frame.
    """
    return system.conventions.metadata(system, name, size, description)
