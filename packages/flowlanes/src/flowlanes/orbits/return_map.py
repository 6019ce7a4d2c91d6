"""The return map of a System to a section, for periodic orbits and circle maps.

A parameter that varies along a branch becomes an additional constant state variable. It is then an
integral like the others, and the variational equations include derivatives with respect to it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from typing import Any

import numpy as np
import sympy as sp

from ..arguments import arguments_checked
from ..errors import InputError
from ..flow.linearisation.state_scales import state_scales_at
from ..flow.sections.poincare_map import PoincareMap
from ..formulas.array_formulas import Formulas
from ..system.arrays import FloatArray
from ..system.laws import Integral
from ..system.parameters import require_parameters
from ..system.system import System
from .maps import ConservedFunctions, Image
from .rotation import average, unwrapped_turns

#: Maximum number of values stored at once for many motions.
AT_ONCE = 1 << 23


def parameters_to_state(system: System, *names: str) -> System:
    """A system with some parameters turned into constant state variables.

    Parameters
    ----------
    system : System
    *names : str
        Parameters; each is also an integral of this name.

    Raises
    ------
    InputError
        If a name is not that of a parameter.

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> x, v, k = sp.symbols("x v k", real=True)
    >>> stiffness = flowlanes.Parameter(k, "stiffness over mass", 4.0)
    >>> spring = flowlanes.System("spring", "Spring", {x: v, v: -k * x}, (stiffness,))
    >>> parameters_to_state(spring, "k").symbols
    (x, v, k)
    """
    known = {str(p.symbol): p for p in system.parameters}
    require_parameters(system.name, known, names)
    chosen = [known[name] for name in names]
    return replace(
        system,
        field=(*system.field, *((p.symbol, sp.S.Zero) for p in chosen)),
        parameters=tuple(p for p in system.parameters if p not in chosen),
        # The parameter is constant along the motion, hence an integral.
        laws=(*system.laws, *(Integral(str(p.symbol), p.symbol, p.meaning) for p in chosen)),
    )


@arguments_checked
@dataclass(frozen=True)
class ReturnMap:
    """The first return to a section.

    Parameters
    ----------
    section : PoincareMap
        The section map, with numbers as parameters, not arrays.
    angles : mapping of str to float
        Periods of state variables that are angles.
    trivial : tuple of str
        Directions with multiplier 1 on every orbit, such as the flow.

    Examples
    --------
    >>> import flowlanes
    >>> import numpy as np
    >>> import sympy as sp
    >>> x, v = sp.symbols("x v", real=True)
    >>> oscillator = flowlanes.System("van-der-pol", "Van der Pol", {x: v, v: (1 - x**2) * v - x})
    >>> section = flowlanes.PoincareMap(oscillator, flowlanes.poincare_section(oscillator, "x"))
    >>> returns = flowlanes.orbits.ReturnMap(section)
    >>> orbit = flowlanes.orbits.find_periodic(returns, np.array([0.0, 2.17]))
    >>> print(orbit.kind, round(orbit.duration, 9))
    attracting 6.663286859
    """

    section: PoincareMap
    angles: Mapping[str, float] = field(default_factory=dict)
    trivial: tuple[str, ...] = ("flow",)

    def __post_init__(self) -> None:
        for name in self.angles:
            _require_variable(self.section, name, "angles")
        for name, value in self.section.parameters.items():
            if np.ndim(value):
                raise InputError(f"{name}: a map has one value of a parameter, not an array")

    @property
    def names(self) -> tuple[str, ...]:
        """The state variables."""
        return tuple(map(str, self.section.system.symbols))

    @property
    def periods(self) -> FloatArray:
        """The period of each variable, infinite if it is not an angle."""
        return np.array([self.angles.get(name, np.inf) for name in self.names])

    @cached_property
    def domain(self) -> ConservedFunctions:
        """Relations and the section."""
        system = self.section.system
        names = (*(f"relation {i}" for i in range(1, len(system.relations) + 1)), "section")
        return self._functions(names, (*system.relations, self.section.section.value))

    @cached_property
    def integrals(self) -> ConservedFunctions:
        """The integrals that hold for these parameters."""
        laws = [law for law in self.section.system.integrals if self._holds(law)]
        return self._functions(tuple(law.name for law in laws), tuple(law.value for law in laws))

    def _functions(
        self, names: tuple[str, ...], formulas: tuple[sp.Expr, ...]
    ) -> ConservedFunctions:
        functions = Formulas(self.section.system, formulas)
        parameters = self.section.parameters
        return ConservedFunctions(
            names,
            partial(functions, parameters=parameters),
            partial(functions.slopes, parameters=parameters),
        )

    def _holds(self, law: Integral) -> bool:
        """True if an integral has only conditions on parameters, and these are satisfied."""
        system = self.section.system
        parameters = {str(name): value for name, value in self.section.parameters.items()}
        values = {s: parameters.get(str(s), default) for s, default in system.defaults.items()}
        conditions = law.scalar.level
        if any(condition.free_symbols - set(values) for condition in conditions):
            return False
        return all(abs(float(condition.subs(values))) < 1e-12 for condition in conditions)

    @arguments_checked
    def sizes(self, points: FloatArray) -> FloatArray:
        """The largest sizes, (size,), of the state vectors among points (n, size)."""
        size = len(self.names)
        if points.ndim != 2 or not len(points) or points.shape[1] != size:
            raise InputError(
                f"ReturnMap.sizes: points must be an array (n, {size}), one row or more, "
                f"not {points.shape}"
            )
        scales: FloatArray = state_scales_at(
            self.section.system, points[None], self.section.parameters
        )[0]
        return scales

    @arguments_checked
    def image(self, points: FloatArray, count: int = 1, *, slopes: bool = False) -> Image:
        """The `count`-th returns of points (n, size)."""
        if slopes:
            derivative = self.section.derivative(points, count)
            return Image(derivative.images, derivative.times, derivative.matrices)
        crossed = self.section.crossings(points, count)
        return Image(crossed.states[:, -1], crossed.times[:, -1])


@arguments_checked
@dataclass(frozen=True)
class Circle:
    """The returns of a flow on a torus, as circle maps of one angle.

    Parameters
    ----------
    section : PoincareMap
        A section on which a second angle passes a value; the state of the system contains the
        first angle, which grows continuously.
    angle : str
        The state variable that is the first angle, in radians.
    parameter : str
        The parameter of the family.
    state : mapping of str to float
        The other state variables on the section.

    Examples
    --------
    >>> import flowlanes
    >>> import numpy as np
    >>> import sympy as sp
    >>> alpha, beta, k = sp.symbols("alpha beta k", real=True)
    >>> speed = flowlanes.Parameter(k, "mean speed of the first angle", 1.0)
    >>> field = {alpha: k + sp.sin(alpha) * sp.cos(beta) / 2, beta: 1}
    >>> torus = flowlanes.System("torus", "Flow on a torus", field, (speed,))
    >>> across = flowlanes.PoincareMap(torus, flowlanes.poincare_section(torus, "beta", angle=True))
    >>> circle = flowlanes.orbits.Circle(across, "alpha", "k", {"beta": 0.0})
    >>> circle(np.array([0.3]), np.array([1.0]), 4).shape
    (1, 5)
    """

    section: PoincareMap
    angle: str
    parameter: str
    state: Mapping[str, float]

    def __post_init__(self) -> None:
        for name in (self.angle, *self.state):
            _require_variable(self.section, name, "state")
        known = [str(symbol) for symbol in self.section.system.defaults]
        require_parameters(self.section.system.name, known, [self.parameter])

    def __call__(self, turns: FloatArray, values: FloatArray, count: int) -> FloatArray:
        """Lifts of orbits, (n, count + 1), in turns; see :mod:`.arnold_tongues`."""
        names = [str(s) for s in self.section.system.symbols]
        place = names.index(self.angle)
        starts = np.array([[self.state.get(name, 0.0) for name in names]]).repeat(len(turns), 0)
        starts[:, place] = 2 * np.pi * turns
        parameters = {**self.section.parameters, self.parameter: np.asarray(values, dtype=float)}
        crossings = replace(self.section, parameters=parameters).crossings(starts, count)
        return np.concatenate([turns[:, None], crossings.states[:, :, place] / (2 * np.pi)], axis=1)


def _require_variable(section: PoincareMap, name: str, where: str) -> None:
    names = [str(symbol) for symbol in section.system.symbols]
    if name not in names:
        raise InputError(f"{where}: {name} is not a state variable; there are {', '.join(names)}")


@dataclass(frozen=True)
class Rotations:
    """Rotation numbers of many motions.

    Attributes
    ----------
    values, errors : arrays (n,)
        Turns per return, and the differences between the two halves; NaN where there is none.
    outcome : array (n,) of int
        0, or the reason why a motion did not return: see `PoincareMap.status_message`; −1 if the
        angle has no lift.
    """

    values: FloatArray
    errors: FloatArray
    outcome: FloatArray


def rotations(section: PoincareMap, starts: FloatArray, angle: Any, count: int = 1000) -> Rotations:
    """Rotation numbers of an angle on a section, for many starts and parameters.

    Parameters
    ----------
    section : PoincareMap
        Its parameters may be arrays with one entry for each start.
    starts : array (n, size)
        In flat order.
    angle : sympy.Expr
        A formula in state, definitions and parameters: radians modulo 2π, such as
        ``atan2(y, x)``.
    count : int
        Number of returns of each motion.
    """
    starts = np.asarray(starts, dtype=float)
    values, errors = np.full(len(starts), np.nan), np.full(len(starts), np.nan)
    outcome = np.zeros(len(starts), dtype=int)
    formula = Formulas(section.system, (sp.sympify(angle),))
    rows = max(1, AT_ONCE // (count * section.size))
    for first in range(0, len(starts), rows):
        part = slice(first, min(first + rows, len(starts)))
        parameters = {
            name: value if np.ndim(value) == 0 else np.asarray(value)[part]
            for name, value in section.parameters.items()
        }
        crossed = replace(section, parameters=parameters).crossings(starts[part], count)
        outcome[part] = crossed.outcome
        angles = formula(crossed.states, parameters)[..., 0]
        for i in np.flatnonzero(crossed.outcome == 0):
            try:
                # The angle is known modulo 2π; consecutive returns determine its continuous lift.
                mean, error = average(np.diff(unwrapped_turns(angles[i])))
            except InputError:
                outcome[first + i] = -1
            else:
                values[first + i], errors[first + i] = mean, error
    return Rotations(values, errors, outcome)
