"""A laboratory for nonholonomic mechanics: say what rolls on what.

>>> import chaplygin
>>> ball = chaplygin.Body(1.0, (1.0, 1.5, 2.1), chaplygin.Ball(1.0))
>>> system = chaplygin.roll(ball, chaplygin.Plane(), "marble")
>>> print(system.title)
Rolling body

Names are imported when first used, so that importing the package costs nothing.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

from ._version import __version__

if TYPE_CHECKING:
    from .errors import InputError, RunError
    from .flow.trajectory import Trajectory, integrate
    from .mechanics.body import Body
    from .mechanics.rolling import Field, Rolling, roll
    from .mechanics.shapes import Ball, Disk, Ellipsoid, Implicit, Revolution, Torus
    from .mechanics.start import starting_state
    from .mechanics.surfaces import Plane, Sphere
    from .statements import Integral
    from .study.dataset import read, to_dataset, write
    from .study.experiment import load, loads
    from .study.prepare import Study, prepare
    from .system import System
    from .systems import CATALOGUE, from_catalogue

_HOME = {
    "Ball": "mechanics.shapes",
    "Body": "mechanics.body",
    "CATALOGUE": "systems",
    "Disk": "mechanics.shapes",
    "Ellipsoid": "mechanics.shapes",
    "Field": "mechanics.rolling",
    "Implicit": "mechanics.shapes",
    "InputError": "errors",
    "Integral": "statements",
    "Plane": "mechanics.surfaces",
    "Revolution": "mechanics.shapes",
    "Rolling": "mechanics.rolling",
    "RunError": "errors",
    "Sphere": "mechanics.surfaces",
    "Study": "study.prepare",
    "System": "system",
    "Torus": "mechanics.shapes",
    "Trajectory": "flow.trajectory",
    "from_catalogue": "systems",
    "integrate": "flow.trajectory",
    "load": "study.experiment",
    "loads": "study.experiment",
    "prepare": "study.prepare",
    "read": "study.dataset",
    "roll": "mechanics.rolling",
    "starting_state": "mechanics.start",
    "to_dataset": "study.dataset",
    "write": "study.dataset",
}

__all__ = [
    "CATALOGUE",
    "Ball",
    "Body",
    "Disk",
    "Ellipsoid",
    "Field",
    "Implicit",
    "InputError",
    "Integral",
    "Plane",
    "Revolution",
    "Rolling",
    "RunError",
    "Sphere",
    "Study",
    "System",
    "Torus",
    "Trajectory",
    "__version__",
    "from_catalogue",
    "integrate",
    "load",
    "loads",
    "prepare",
    "read",
    "roll",
    "starting_state",
    "to_dataset",
    "write",
]


def __getattr__(name: str) -> Any:
    if name not in _HOME:
        raise AttributeError(f"module 'chaplygin' has no attribute {name!r}")
    return getattr(import_module(f".{_HOME[name]}", __name__), name)


def __dir__() -> list[str]:
    return sorted(__all__)
