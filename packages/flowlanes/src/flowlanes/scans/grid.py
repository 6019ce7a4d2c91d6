"""Planes of parameters and starts: two numbers vary, and each cell has a motion of its own.

An axis is a parameter, a variable of the start (``x``), a quantity whose level the start
should lie on (``energy``), or a new name from which formulas compute the others (``x =
sin(theta)``). Variables given in this way stay fixed; the rest of the start is projected onto the
phase space and the required levels.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import numpy.typing as npt
import sympy as sp

from ..arguments import Finite, arguments_checked
from ..errors import InputError
from ..flow.level_projection import project_to_level
from ..formulas.array_evaluation import formula
from ..formulas.array_formulas import Formulas
from ..parsing import nearest, parse
from ..system.arrays import BoolArray, FloatArray, IntArray
from ..system.named_formulas import flat
from ..system.parameters import conditions, satisfies
from ..system.system import System, VariablesByName
from ..system.vectors import Vector, norm_squared
from .axis_text import axis_parts
from .system_quantities import quantities_by_name

#: Reasons why a cell has no motion or no number; −1 in a store means not yet computed.
NO_STATE, INADMISSIBLE, NO_NUMBER = -2, -3, -4
REASONS: Mapping[int, str] = {
    NO_STATE: "no state with these values was found",
    INADMISSIBLE: "the parameters are not admissible",
    NO_NUMBER: "the number could not be formed",
}


@arguments_checked
@dataclass(frozen=True)
class Axis:
    """An axis of `count` values from `first` to `last`, both included.

    Examples
    --------
    >>> import flowlanes
    >>> flowlanes.scans.Axis("I_1", 1.0, 2.0, 5).values
    array([1.  , 1.25, 1.5 , 1.75, 2.  ])
    """

    name: str
    first: Finite
    last: Finite
    count: int
    meaning: str = ""
    unit: str = ""

    @property
    def symbol(self) -> sp.Symbol:
        """The symbol that stands for the axis in formulas."""
        return sp.Symbol(self.name, real=True)

    @property
    def values(self) -> FloatArray:
        """The numbers, (count,)."""
        return np.linspace(self.first, self.last, self.count)


@arguments_checked
def axis(text: str, where: str = "") -> Axis:
    """Parse an axis: ``NAME=FIRST:LAST:COUNT``, such as ``k=-2:2:300``.

    Parameters
    ----------
    text : str
        Name, first and last value, and number of values.
    where : str
        Location of the text, for messages.

    Returns
    -------
    Axis

    Raises
    ------
    InputError
        If the text has another form.

    Examples
    --------
    >>> axis("k=-2:2:5").values
    array([-2., -1.,  0.,  1.,  2.])
    """
    name, *ends, count = axis_parts(text, where)
    first, last = (float(parse(end, {}, where)) for end in ends)
    if (first == last) != (count == 1):
        raise InputError(
            f"{text}: a count above 1 needs two ends that differ, and a count of 1 one end", where
        )
    return Axis(name, first, last, count)


@dataclass(frozen=True)
class GridCells:
    """Starts and parameters of motions.

    Attributes
    ----------
    starts : (n, size) array
        States in flat order of the system; NaN where there is none.
    parameters : dict of Symbol to (n,) array
        Parameters that differ from the defaults of the system.
    reasons : (n,) array of int
        0, or the reason why there is no motion; see `REASONS`.
    """

    starts: FloatArray
    parameters: dict[sp.Symbol, FloatArray]
    reasons: IntArray


@dataclass(frozen=True)
class ScanGrid:
    """A plane of motions of a system; created by :func:`scan_grid`.

    Attributes
    ----------
    system : System
        The system of the motions.
    original_system : System
        The system in the variables in which a start is given; its definitions give
        the state of `system`.
    base : tuple of float
        The start that is varied, in flat order of `original_system`.
    x, y : Axis
        y varies from row to row.
    substitutions : tuple of (Symbol, Expr)
        Parameters and variables of the start as formulas in the axes and parameters.
    levels : tuple of (Expr, Expr)
        Quantities of the start and formulas of their values.
    fixed_symbols : tuple of Symbol
        Variables of the start that stay fixed.
    """

    system: System
    original_system: System
    base: tuple[float, ...]
    x: Axis
    y: Axis
    substitutions: tuple[tuple[sp.Symbol, sp.Expr], ...]
    levels: tuple[tuple[sp.Expr, sp.Expr], ...]
    fixed_symbols: tuple[sp.Symbol, ...]

    @arguments_checked
    def cells(self, first: int, last: int) -> GridCells:
        """The cells of rows first, …, last − 1, row by row."""
        if not 0 <= first < min(last, len(self.y.values)):
            raise InputError(
                f"rows {first} to {last} of the grid: it has the rows 0 to {len(self.y.values)}, "
                "the last not included"
            )
        y, x = (
            a.ravel() for a in np.meshgrid(self.y.values[first:last], self.x.values, indexing="ij")
        )
        count = len(x)
        known = {symbol: np.full(count, value) for symbol, value in self.system.defaults.items()}
        known |= {self.x.symbol: x, self.y.symbol: y}
        starts = np.tile(np.array(self.base), (count, 1))
        parameters: dict[sp.Symbol, FloatArray] = {}
        for symbol, formula_value in self.substitutions:
            value = _numbers_of(formula_value, known, count)
            if symbol in self.system.defaults:
                known[symbol] = parameters[symbol] = value
            else:
                starts[:, self.original_system.symbols.index(symbol)] = value
        targets = [_numbers_of(value, known, count) for _, value in self.levels]
        good = np.isfinite(starts).all(axis=1) & _admissible(self.system, known, count)
        reasons = np.where(good, 0, INADMISSIBLE)
        starts[~good] = np.nan
        for symbol, value in parameters.items():
            value[~good] = self.system.defaults[symbol]
        starts, met = self._projected_starts(starts, targets, parameters)
        reasons[good & ~met] = NO_STATE
        states = Formulas(self.original_system, self.system.symbols)(starts, parameters)
        states[reasons != 0] = np.nan
        return GridCells(states, parameters, reasons)

    def _projected_starts(
        self,
        starts: FloatArray,
        targets: Sequence[FloatArray],
        parameters: Mapping[sp.Symbol, FloatArray],
    ) -> tuple[FloatArray, BoolArray]:
        """Starts projected onto the relations and then onto the levels, and a mask of success."""
        relations = self.original_system.scalar.relations
        met: BoolArray = np.asarray(np.isfinite(starts).all(axis=1))
        fixed = {*self.fixed_symbols, *(symbol for symbol, _ in self.substitutions)}
        if relations:
            starts, there = project_to_level(
                Formulas(self.original_system, relations),
                starts,
                0.0,
                parameters,
                self._others(fixed),
            )
            met &= there
        if targets:
            # Directions stay fixed as long as something else can be changed.
            wider = fixed | directions(self.original_system)
            moved = self._others(wider) if any(self._others(wider)) else self._others(fixed)
            wanted = np.stack([*(np.zeros(len(starts)) for _ in relations), *targets], axis=1)
            level = Formulas(
                self.original_system, (*relations, *(value for value, _ in self.levels))
            )
            starts, there = project_to_level(level, starts, wanted, parameters, moved)
            met &= there
        return starts, met

    def _others(self, fixed: Collection[sp.Symbol]) -> list[bool]:
        return [symbol not in fixed for symbol in self.original_system.symbols]


@arguments_checked
def scan_grid(
    system: System,
    x: Axis,
    y: Axis,
    start: Mapping[str, Any],
    *,
    formulas: Mapping[str, str] | None = None,
    fixed: Collection[str] = (),
) -> ScanGrid:
    """Define a plane of motions.

    Parameters
    ----------
    system : System
    x, y : Axis
        y varies from row to row.
    start : mapping of str to number or numbers
        The start that is varied: the state by name, or variables from which it follows.
    formulas : mapping of str to str, optional
        Parameters, variables of the start or levels as formulas in the axes and the parameters.
    fixed : collection of str, optional
        Variables of the start, or vectors of them, that stay fixed.

    Returns
    -------
    ScanGrid
        Rows are the values of y; ``cells`` gives the starts and parameters of some rows.

    Raises
    ------
    InputError
        If a name or a formula is wrong, or an axis has no effect.

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> x, v, k = sp.symbols("x v k", real=True)
    >>> damping = flowlanes.Parameter(k, "damping", 0.1)
    >>> field = {x: v, v: -sp.sin(x) - k * v}
    >>> pendulum = flowlanes.System("pendulum", "Damped pendulum", field, (damping,))
    >>> axes = flowlanes.scans.axis("k=0:1:3"), flowlanes.scans.axis("v=0.5:1:2")
    >>> grid = flowlanes.scans.scan_grid(pendulum, *axes, {"x": 0.5, "v": 0.0})
    >>> isinstance(grid, flowlanes.scans.ScanGrid), grid.cells(0, 2).starts.shape
    (True, (6, 2))
    """
    described, base = _described_system(system, start)
    if x.name == y.name:
        raise InputError(f"{x.name}: the two axes need names that differ")
    texts = dict(formulas or {})
    symbols = {str(s): s for s in (*described.symbols, *system.defaults)}
    for item in (x, y):
        if item.name in texts:
            raise InputError(f"{item.name}: it is an axis and cannot be given by a formula besides")
    known = {str(s): s for s in system.defaults} | {a.name: a.symbol for a in (x, y)}
    values: dict[str, sp.Expr] = {n: parse(t, known, f"{n} = {t}") for n, t in texts.items()}
    used = {s for value in values.values() for s in value.free_symbols}
    levels = {str(s) for s, _ in described.scalar_definitions} | quantities_by_name(
        described
    ).keys()
    for item in (x, y):
        if item.name in symbols.keys() | levels:
            values = {item.name: item.symbol, **values}
        elif item.symbol not in used:
            raise InputError(
                f"{item.name}: {system.name} has neither parameter, variable nor quantity of this "
                f"name, and no formula uses it{nearest(item.name, _useful(described))}"
            )
    assignments: list[tuple[sp.Symbol, sp.Expr]] = []
    conditions: list[tuple[sp.Expr, sp.Expr]] = []
    for name, value in values.items():
        if name in symbols:
            assignments.append((symbols[name], value))
        elif name in levels:
            conditions.append((formula(described, name), value))
        else:
            raise InputError(
                f"{name}: {system.name} has neither parameter, variable nor quantity of this name"
                f"{nearest(name, _useful(described))}"
            )
    # Parameters first: formulas of the start may use them.
    assignments.sort(key=lambda pair: pair[0] not in system.defaults)
    return ScanGrid(
        system,
        described,
        base,
        x,
        y,
        tuple(assignments),
        tuple(conditions),
        _fixed_symbols(described, fixed),
    )


def _useful(system: System) -> list[str]:
    """Names available to users in order of declaration, without intermediate definitions."""
    return list(
        dict.fromkeys(map(str, (*system.defaults, *system.symbols, *quantities_by_name(system))))
    )


def _fixed_symbols(system: System, fixed: Collection[str]) -> tuple[sp.Symbol, ...]:
    parts = {str(name): flat([name]) for name in system.state}
    parts |= {str(symbol): (symbol,) for symbol in system.symbols}
    for name in fixed:
        if name not in parts:
            raise InputError(f"{name}: no variable of the start{nearest(name, parts)}")
    return tuple(symbol for name in fixed for symbol in parts[name])


def _described_system(
    system: System, start: Mapping[str, npt.ArrayLike]
) -> tuple[System, tuple[float, ...]]:
    """A system in the variables of its start, and the start in flat order."""
    names = [name for name in system.state if str(name) in start]
    if len(names) < len(system.state):
        described = _by_velocity(system, start)
        names, system = list(described.state), described
    numbers = [np.atleast_1d(np.asarray(start[str(name)], dtype=np.float64)) for name in names]
    for name, values in zip(names, numbers, strict=True):
        if len(values) != len(flat([name])):
            raise InputError(f"{name}: {len(flat([name]))} numbers are needed, not {len(values)}")
    return system, tuple(float(value) for values in numbers for value in values)


def _by_velocity(system: System, start: Mapping[str, npt.ArrayLike]) -> System:
    """The system with other variables as state, from which its own follow."""
    follow = [
        (name, value) for name, value in system.conventions.start_formulas if name in system.state
    ]
    words = {str(name): name for name, _ in system.definitions}
    words |= {str(name): name for name in (*system.state, *system.start_variables)}
    names = [words[name] for name in start if name in words]
    missing = {*system.state} - {*names, *(name for name, _ in follow)}
    if missing:
        raise InputError(
            f"{system.name}: the start gives no {', '.join(sorted(map(str, missing)))}"
        )
    symbols = set(flat(names))
    follow = [(name, value) for name, value in follow if name not in names]
    before = system.required_definitions([value for _, value in follow], inputs=symbols)
    done = {symbol for symbol, _ in before}
    after = [(s, v) for s, v in system.scalar_definitions if s not in done | symbols]
    return replace(
        system,
        field=tuple((name, 0 * name) for name in names),
        definitions=(*before, *follow, *after),
        reconstruction=None,
        conventions=VariablesByName(),
        guards=(),
    )


def directions(system: System) -> set[sp.Symbol]:
    """Components of the vectors that the relations normalise."""
    relations = system.scalar.relations
    vectors = [name for name in system.state if isinstance(name, Vector)]
    unit = [name for name in vectors if system.scalar.of(norm_squared(name)) - 1 in relations]
    return set(flat(unit))


def _numbers_of(value: sp.Expr, values: Mapping[sp.Symbol, FloatArray], count: int) -> FloatArray:
    """A formula evaluated on arrays; NaN where it has no value."""
    names = sorted(value.free_symbols, key=str)
    function = sp.lambdify(names, value, "numpy")
    with np.errstate(all="ignore"):
        numbers = function(*(values[name] for name in names))
    return np.array(np.broadcast_to(np.asarray(numbers, dtype=np.float64), (count,)))


def _admissible(system: System, values: Mapping[sp.Symbol, FloatArray], count: int) -> BoolArray:
    """Cells in which all parameters are finite and admissible."""
    good = np.ones(count, dtype=bool)
    for parameter in system.parameters:
        good &= np.isfinite(values[parameter.symbol])
    with np.errstate(all="ignore"):
        for _, condition in conditions(system.parameters):
            good &= satisfies(condition, values)
    return good
