"""The conventions of rigid bodies: starts by ω and γ, and the meanings of their variables.

The angular velocity ω and the unit vector γ are given in body axes.  In n dimensions ω is a skew
matrix, γ a column, and the attitude a matrix whose last row is γ.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from types import MappingProxyType
from typing import Any, final

import numpy as np
import numpy.typing as npt
import sympy as sp

from flowlanes.arguments import NamedFormulas, Parameters
from flowlanes.errors import InputError
from flowlanes.flow.initial_states import checked_shape
from flowlanes.formulas.array_evaluation import values
from flowlanes.system.arrays import FloatArray
from flowlanes.system.matrices import Column, NamedMatrix, Skew, SquareMatrix
from flowlanes.system.named_formulas import Pairs, as_pairs, flat, flat_pairs
from flowlanes.system.system import UNKNOWN, Conventions, Metadata, Name, System
from flowlanes.system.vectors import Vector

from .rotations import finite_numbers, rotation_near, upright, upright_matrix

#: Frames in which vectors are given: name of the axis, and labels of its components.
FRAMES: Mapping[str, tuple[str, tuple[int | str, ...]]] = MappingProxyType(
    {
        "body": ("axis", (1, 2, 3)),
        "space": ("space", ("x", "y", "z")),
        "quaternion": ("quaternion", ("w", "x", "y", "z")),
    }
)

#: Meanings of these axes, and of those of n-dimensional vectors and matrices.
AXIS_MEANINGS: Mapping[str, str] = MappingProxyType(
    {
        "axis": "body axis",
        "space": "space axis",
        "quaternion": "component of the quaternion",
        "pair": "plane of two body axes",
        "body_axis": "body axis",
        "space_axis": "space axis",
        "plane_axis": "coordinate of the hyperplane",
    }
)

#: Variables of an n-dimensional lift to space: meaning, unit.
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

#: Tolerance for γ against the last row of an attitude, and for ω against the constraint.
_SLACK, _OF_SPIN = 1e-12, 1e-9

omega, gamma, zeta = Vector("omega"), Vector("gamma"), Vector("zeta")


@final
@dataclass(frozen=True)
class BodyConventions(Conventions):
    """A rigid body: a start may give ω and γ, and variables have the meanings of mechanics.

    Parameters
    ----------
    formulas : mapping of Vector, matrix or Symbol to formula
        How state variables follow from ω, γ and the attitude; the others (γ itself, or ω where it
        belongs to the state) are taken as given.

    Examples
    --------
    >>> import nonholonomic
    >>> ball = nonholonomic.from_catalogue("chaplygin-ball")
    >>> [str(name) for name in ball.start_variables]
    ['omega', 'gamma']
    """

    formulas: NamedFormulas = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "formulas", as_pairs(self.formulas))

    @property
    def start_formulas(self) -> Pairs:
        """State variables by ω, γ and the attitude."""
        return as_pairs(self.formulas)

    def start_variables(self, system: System) -> tuple[Name, ...]:
        """ω and γ, and the motion of each fluid."""
        return (*_spin_and_direction(system), *_further_vectors(system))

    def states(
        self, system: System, given: Mapping[str, FloatArray], parameters: Parameters
    ) -> Mapping[str, FloatArray]:
        """The state that follows from ω and γ, which is normalised; otherwise what was given."""
        if "omega" in given and ("gamma" in given or "omega" not in map(str, system.state)):
            return _state_from_omega(system, given, parameters)
        return given

    def split_motion(
        self, system: System, start: Mapping[str, npt.ArrayLike]
    ) -> tuple[dict[str, npt.ArrayLike], dict[str, list[Any]]]:
        """Take the motion in space of an n-dimensional body out of a start."""
        named, lift = dict(start), system.reconstruction
        lifted = lift.field if lift else ()
        matrix = next((x for x, _ in lifted if isinstance(x, SquareMatrix)), None)
        if lift is None or matrix is None:
            return named, {}
        placed: dict[str, list[Any]] = {}
        for name, _ in lift.field:
            if str(name) in named and name != matrix:
                count = len(flat([name]))
                placed[str(name)] = finite_numbers(str(name), named.pop(str(name)), count)
        if str(matrix) in named:
            rows = rotation_near(named.pop(str(matrix)), int(matrix.shape[0]))
            placed[str(matrix)] = [x for row in rows for x in row]
            last = [float(x) for x in rows[-1]]
            # On a sphere the normal γ moves in space, and no relation ties it to the attitude.
            ties = {str(s) for relation in lift.relations for s in relation.free_symbols}
            if "gamma" in named and "gamma_1" not in ties:
                return named, placed
            direction = np.asarray(named.setdefault("gamma", last), dtype=float)
            if direction.shape != (len(last),) or not np.allclose(
                direction / (np.linalg.norm(direction) or 1.0), last, rtol=0.0, atol=_SLACK
            ):
                raise InputError(
                    "gamma: must be the last row of the attitude; one of them may be left out"
                )
        return named, placed

    def first_values(self, system: System, name: Name, state: Mapping[str, Any]) -> Sequence[Any]:
        """Zeros, and an attitude that turns ζ, or else γ, upward."""
        if isinstance(name, SquareMatrix):
            normal = [state[str(s)] for s in Column("gamma", int(name.shape[0])).symbols]
            return [x for row in upright_matrix(normal) for x in row]
        if str(name) == "attitude":
            up = next((n for n in (zeta, gamma) if n in system.state), None)
            return upright([state[str(s)] for s in up.symbols]) if up else [1.0, 0.0, 0.0, 0.0]
        return [0.0] * len(flat([name]))

    def metadata(
        self, system: System, name: str, size: int, description: tuple[str, str] | None
    ) -> Metadata:
        """What mechanics calls a variable of this name."""
        variable = next((v for v in system.state if str(v) == name), None)
        if isinstance(variable, Column | NamedMatrix):
            frame = self.dimensions(variable)[-1]
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

    @property
    def frames(self) -> Mapping[str, tuple[str, tuple[int | str, ...]]]:
        """Body, space, and the quaternion of an attitude."""
        return FRAMES

    @property
    def axis_meanings(self) -> Mapping[str, str]:
        """Of these, and of the axes of n dimensions."""
        return AXIS_MEANINGS

    def dimensions(self, variable: Any) -> tuple[str, ...]:
        """The dimensions of a column or a matrix of n dimensions."""
        match variable:
            case Skew():
                return ("pair",)
            case NamedMatrix():
                return "space_axis", "body_axis"
        known = {"contact": "plane_axis", "w": "w_component"}
        return (known.get(str(variable), "body_axis"),)

    @property
    def unrecorded(self) -> frozenset[str]:
        """The horizontal position of the centre of mass, an observable of the lift as well."""
        return frozenset({"place"})

    @property
    def charts(self) -> Mapping[str, Callable[..., Any]]:
        """Coordinates of the states of a body; see `flowlanes.scans.state_coordinates.chart`."""
        from .charts.charts import CHARTS

        return CHARTS


#: Of bodies whose state is given as it is.
BODY = BodyConventions()


def start_vectors(system: System) -> tuple[Vector, ...]:
    """The vectors besides ω and γ from which the state follows at a start."""
    return tuple(v for v in system.start_variables[2:] if isinstance(v, Vector))


def _further_vectors(system: System) -> tuple[Vector, ...]:
    """The vectors besides ω and γ on which the formulas of a start depend."""
    formulas = system.conventions.start_formulas
    known = {s for s, _ in system.scalar_definitions} | {p.symbol for p in system.parameters}
    known |= {s for s, _ in flat_pairs(formulas)} | set(system.symbols)
    # how the body lies in space is known before what follows from it
    known |= {
        s for s, _ in flat_pairs(system.reconstruction.field if system.reconstruction else ())
    }
    used = {s for _, formula in flat_pairs(formulas) for s in formula.free_symbols} - known
    names = dict.fromkeys(sorted(str(s).rpartition("_")[0] for s in used))
    return tuple(Vector(name) for name in names if name not in ("omega", "gamma"))


def _state_from_omega(
    system: System, arrays: Mapping[str, FloatArray], parameters: Parameters
) -> dict[str, Any]:
    """The variables of the state that follow from ω and γ, and the remaining ones."""
    formulas = system.conventions.start_formulas
    if not formulas and omega not in system.state:
        raise InputError(f"{system.name}: its state does not follow from omega; give the state")
    if "gamma" not in arrays:
        raise InputError(f"{system.name}: omega is given, but gamma is not")
    spin, direction, *further = system.start_variables
    turning = checked_shape(system, "omega", arrays["omega"], len(spin.symbols))
    normal = checked_shape(system, "gamma", arrays["gamma"], len(direction.symbols))
    lengths = np.linalg.norm(normal, axis=1, keepdims=True)
    if not np.all(lengths > 0):
        raise InputError(f"{system.name}: gamma is zero: it must point along the normal")
    others = [
        checked_shape(system, str(v), arrays.get(str(v), np.zeros_like(turning)), 3)
        for v in further
    ]
    points = np.column_stack([turning, normal / lengths, *others])
    auxiliary, symbols = _spinning(system)
    numbers = values(auxiliary, symbols, points, parameters)
    following = {str(s): numbers[:, i] for i, s in enumerate(symbols)}
    if isinstance(spin, Skew):
        _require_spin(system, spin, np.column_stack([numbers, normal / lengths]), turning)
    read = ("omega", "gamma", *map(str, further))
    rest = {name: array for name, array in arrays.items() if name not in read}
    unchanged = {
        str(name): block
        for name, block in ((spin, turning), (direction, normal / lengths))
        if name in system.state
    }
    return {**following, **unchanged, **rest}


def _require_spin(system: System, spin: Skew, states: FloatArray, omega: FloatArray) -> None:
    """Raise an error for an ω that violates the constraint of an n-dimensional body."""
    has = values(system, list(spin.symbols), states)
    excess = np.abs(has - omega).max(axis=1)
    if np.any(excess > _OF_SPIN * np.abs(omega).max(axis=1)):
        raise InputError(f"{system.name}: the constraint does not admit this omega")


def _spin_and_direction(system: System) -> tuple[Vector | Skew, Vector]:
    """The names of ω and γ: vectors, or for n dimensions a skew matrix and a column."""
    direction = next((v for v in system.state if str(v) == "gamma"), gamma)
    if not isinstance(direction, Column):
        return omega, gamma
    return Skew("omega", int(direction.shape[0])), direction


@lru_cache(maxsize=16)
def _spinning(system: System) -> tuple[System, tuple[sp.Symbol, ...]]:
    """A system with the state ω, γ, whose other variables are definitions."""
    start = system.conventions.start_formulas
    state = system.start_variables
    still = {name: sp.ImmutableDenseMatrix.zeros(*name.shape) for name in state}
    known = flat(state)
    before = system.required_definitions([formula for _, formula in start], known)
    auxiliary = System(
        system.name,
        system.title,
        still,
        system.parameters,
        definitions=(*before, *start),
    )
    return auxiliary, flat([name for name, _ in start])


def _circulation_vectors(system: System) -> set[str]:
    """Names of the circulation vectors of fluids in cavities: N, or N1, N2, … of several."""
    names = [item.name for item in system.observables if item.frame == "body"]
    return {"N" + name.removeprefix("fluid") for name in names if name.startswith("fluid")}
