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
    from .explicit.solution import Solution
    from .explicit.solve import solve
    from .explore.hierarchy import place
    from .explore.lyapunov import spectrum
    from .explore.reversors import reversors
    from .explore.rotation import rotation_number
    from .flow.ensemble import ensemble
    from .flow.lanes import lanes, section
    from .flow.linearise import linearise
    from .flow.precise import precise
    from .flow.sampling import draw
    from .flow.section import SectionMap
    from .flow.trajectory import Trajectory, integrate
    from .laws.prove import prove
    from .laws.unimodular import measure_exists
    from .laws.verdict import Verdict
    from .mechanics.body import Body
    from .mechanics.constraints import nonholonomy
    from .mechanics.imported import from_sympy, mechanism_from_sympy
    from .mechanics.quasivelocity import Frame, Mechanism, coordinates
    from .mechanics.reduction import chaplygin_form
    from .mechanics.rolling import Field, Rolling, roll
    from .mechanics.rolling_ball import RollingBall
    from .mechanics.rolling_mechanism import rolling_mechanism
    from .mechanics.shapes import Ball, Disk, Ellipsoid, Implicit, Revolution, Torus
    from .mechanics.start import starting_state
    from .mechanics.surfaces import Plane, Sphere
    from .mechanics.suslov import equations
    from .statements import (
        ConformallyHamiltonian,
        Identity,
        Integral,
        Isomorphism,
        Measure,
        PoissonStructure,
        Rate,
        Reduction,
        Separation,
        Symmetry,
    )
    from .study.audit import audit
    from .study.dataset import read, to_dataset, write
    from .study.experiment import load, loads
    from .study.prepare import Study, prepare
    from .system import Parameter, System
    from .systems import CATALOGUE, from_catalogue

_HOME = {
    "Ball": "mechanics.shapes",
    "Body": "mechanics.body",
    "CATALOGUE": "systems",
    "ConformallyHamiltonian": "statements",
    "Disk": "mechanics.shapes",
    "Ellipsoid": "mechanics.shapes",
    "Field": "mechanics.rolling",
    "Frame": "mechanics.quasivelocity",
    "Identity": "statements",
    "Implicit": "mechanics.shapes",
    "InputError": "errors",
    "Integral": "statements",
    "Isomorphism": "statements",
    "Measure": "statements",
    "Mechanism": "mechanics.quasivelocity",
    "Parameter": "system",
    "Plane": "mechanics.surfaces",
    "PoissonStructure": "statements",
    "Rate": "statements",
    "Reduction": "statements",
    "Revolution": "mechanics.shapes",
    "Rolling": "mechanics.rolling",
    "RollingBall": "mechanics.rolling_ball",
    "RunError": "errors",
    "SectionMap": "flow.section",
    "Separation": "statements",
    "Solution": "explicit.solution",
    "Sphere": "mechanics.surfaces",
    "Study": "study.prepare",
    "Symmetry": "statements",
    "System": "system",
    "Torus": "mechanics.shapes",
    "Trajectory": "flow.trajectory",
    "Verdict": "laws.verdict",
    "audit": "study.audit",
    "chaplygin_form": "mechanics.reduction",
    "coordinates": "mechanics.quasivelocity",
    "draw": "flow.sampling",
    "ensemble": "flow.ensemble",
    "equations": "mechanics.suslov",
    "from_catalogue": "systems",
    "from_sympy": "mechanics.imported",
    "integrate": "flow.trajectory",
    "lanes": "flow.lanes",
    "linearise": "flow.linearise",
    "load": "study.experiment",
    "loads": "study.experiment",
    "measure_exists": "laws.unimodular",
    "mechanism_from_sympy": "mechanics.imported",
    "nonholonomy": "mechanics.constraints",
    "place": "explore.hierarchy",
    "precise": "flow.precise",
    "prepare": "study.prepare",
    "prove": "laws.prove",
    "read": "study.dataset",
    "reversors": "explore.reversors",
    "roll": "mechanics.rolling",
    "rolling_mechanism": "mechanics.rolling_mechanism",
    "rotation_number": "explore.rotation",
    "section": "flow.lanes",
    "solve": "explicit.solve",
    "spectrum": "explore.lyapunov",
    "starting_state": "mechanics.start",
    "to_dataset": "study.dataset",
    "write": "study.dataset",
}

__all__ = [
    "CATALOGUE",
    "Ball",
    "Body",
    "ConformallyHamiltonian",
    "Disk",
    "Ellipsoid",
    "Field",
    "Frame",
    "Identity",
    "Implicit",
    "InputError",
    "Integral",
    "Isomorphism",
    "Measure",
    "Mechanism",
    "Parameter",
    "Plane",
    "PoissonStructure",
    "Rate",
    "Reduction",
    "Revolution",
    "Rolling",
    "RollingBall",
    "RunError",
    "SectionMap",
    "Separation",
    "Solution",
    "Sphere",
    "Study",
    "Symmetry",
    "System",
    "Torus",
    "Trajectory",
    "Verdict",
    "__version__",
    "audit",
    "chaplygin_form",
    "coordinates",
    "draw",
    "ensemble",
    "equations",
    "from_catalogue",
    "from_sympy",
    "integrate",
    "lanes",
    "linearise",
    "load",
    "loads",
    "measure_exists",
    "mechanism_from_sympy",
    "nonholonomy",
    "place",
    "precise",
    "prepare",
    "prove",
    "read",
    "reversors",
    "roll",
    "rolling_mechanism",
    "rotation_number",
    "section",
    "solve",
    "spectrum",
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
