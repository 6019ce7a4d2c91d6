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
    from .analysis.classification.classifier import classify
    from .analysis.lyapunov.compute import lyapunov_spectrum
    from .analysis.orbits.reversing_symmetries import reversors
    from .analysis.orbits.rotation import rotation_number
    from .borisov_mamaev.audit import audit
    from .catalogue import CATALOGUE, from_catalogue
    from .core.isomorphism import Isomorphism
    from .core.laws import (
        ConformallyHamiltonian,
        Identity,
        Integral,
        Measure,
        PoissonStructure,
        Rate,
        Reduction,
        Separation,
        Symmetry,
    )
    from .core.system import Parameter, System
    from .errors import InputError, RunError
    from .experiment.dataset import read, to_dataset, write
    from .experiment.file.models import load, loads
    from .experiment.study import Study, prepare
    from .explicit.base.solution import Solution
    from .explicit.solver import solve
    from .flow.batch import batch_integrator, poincare_section
    from .flow.ensemble.run import ensemble
    from .flow.gauss import gauss_integrator
    from .flow.integrator import Trajectory, integrate
    from .flow.linear_stability import linear_stability
    from .flow.sampling.draw import sample_level
    from .flow.sections.poincare_map import PoincareMap
    from .measures.existence import measure_exists
    from .mechanics.ball.ball import RollingBall
    from .mechanics.constraints.integrability import nonholonomy
    from .mechanics.lagrangian.mechanism import Frame, Mechanism, coordinates
    from .mechanics.lagrangian.poincare_suslov import equations
    from .mechanics.lagrangian.sympy_import import from_sympy, mechanism_from_sympy
    from .mechanics.reduction.chaplygin import chaplygin_form
    from .mechanics.rolling.body import Body
    from .mechanics.rolling.equations import Forces, Rolling, roll
    from .mechanics.rolling.initial_state import initial_state
    from .mechanics.rolling.mechanism import rolling_mechanism
    from .mechanics.rolling.shapes import Ball, Disk, Ellipsoid, Implicit, Revolution, Torus
    from .mechanics.rolling.surfaces import Plane, Sphere
    from .printing.code import lambdify, source_code
    from .proof.prover import prove
    from .proof.verdict import Verdict

_HOME = {
    "Ball": "mechanics.rolling.shapes",
    "Body": "mechanics.rolling.body",
    "CATALOGUE": "catalogue",
    "ConformallyHamiltonian": "core.laws",
    "Disk": "mechanics.rolling.shapes",
    "Ellipsoid": "mechanics.rolling.shapes",
    "Forces": "mechanics.rolling.equations",
    "Frame": "mechanics.lagrangian.mechanism",
    "Identity": "core.laws",
    "Implicit": "mechanics.rolling.shapes",
    "InputError": "errors",
    "Integral": "core.laws",
    "Isomorphism": "core.isomorphism",
    "Measure": "core.laws",
    "Mechanism": "mechanics.lagrangian.mechanism",
    "Parameter": "core.system",
    "Plane": "mechanics.rolling.surfaces",
    "PoissonStructure": "core.laws",
    "Rate": "core.laws",
    "Reduction": "core.laws",
    "Revolution": "mechanics.rolling.shapes",
    "Rolling": "mechanics.rolling.equations",
    "RollingBall": "mechanics.ball.ball",
    "RunError": "errors",
    "PoincareMap": "flow.sections.poincare_map",
    "Separation": "core.laws",
    "Solution": "explicit.base.solution",
    "Sphere": "mechanics.rolling.surfaces",
    "Study": "experiment.study",
    "Symmetry": "core.laws",
    "System": "core.system",
    "Torus": "mechanics.rolling.shapes",
    "Trajectory": "flow.integrator",
    "Verdict": "proof.verdict",
    "audit": "borisov_mamaev.audit",
    "chaplygin_form": "mechanics.reduction.chaplygin",
    "coordinates": "mechanics.lagrangian.mechanism",
    "sample_level": "flow.sampling.draw",
    "ensemble": "flow.ensemble.run",
    "equations": "mechanics.lagrangian.poincare_suslov",
    "from_catalogue": "catalogue",
    "from_sympy": "mechanics.lagrangian.sympy_import",
    "integrate": "flow.integrator",
    "batch_integrator": "flow.batch",
    "lambdify": "printing.code",
    "linear_stability": "flow.linear_stability",
    "load": "experiment.file.models",
    "loads": "experiment.file.models",
    "measure_exists": "measures.existence",
    "mechanism_from_sympy": "mechanics.lagrangian.sympy_import",
    "nonholonomy": "mechanics.constraints.integrability",
    "classify": "analysis.classification.classifier",
    "gauss_integrator": "flow.gauss",
    "prepare": "experiment.study",
    "prove": "proof.prover",
    "read": "experiment.dataset",
    "reversors": "analysis.orbits.reversing_symmetries",
    "roll": "mechanics.rolling.equations",
    "rolling_mechanism": "mechanics.rolling.mechanism",
    "rotation_number": "analysis.orbits.rotation",
    "poincare_section": "flow.batch",
    "solve": "explicit.solver",
    "source_code": "printing.code",
    "lyapunov_spectrum": "analysis.lyapunov.compute",
    "initial_state": "mechanics.rolling.initial_state",
    "to_dataset": "experiment.dataset",
    "write": "experiment.dataset",
}

__all__ = [
    "CATALOGUE",
    "Ball",
    "Body",
    "ConformallyHamiltonian",
    "Disk",
    "Ellipsoid",
    "Forces",
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
    "PoincareMap",
    "PoissonStructure",
    "Rate",
    "Reduction",
    "Revolution",
    "Rolling",
    "RollingBall",
    "RunError",
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
    "batch_integrator",
    "chaplygin_form",
    "classify",
    "coordinates",
    "ensemble",
    "equations",
    "from_catalogue",
    "from_sympy",
    "gauss_integrator",
    "initial_state",
    "integrate",
    "lambdify",
    "linear_stability",
    "load",
    "loads",
    "lyapunov_spectrum",
    "measure_exists",
    "mechanism_from_sympy",
    "nonholonomy",
    "poincare_section",
    "prepare",
    "prove",
    "read",
    "reversors",
    "roll",
    "rolling_mechanism",
    "rotation_number",
    "sample_level",
    "solve",
    "source_code",
    "to_dataset",
    "write",
]


def __getattr__(name: str) -> Any:
    if name not in _HOME:
        raise AttributeError(f"module 'chaplygin' has no attribute {name!r}")
    return getattr(import_module(f".{_HOME[name]}", __name__), name)


def __dir__() -> list[str]:
    return sorted(__all__)
