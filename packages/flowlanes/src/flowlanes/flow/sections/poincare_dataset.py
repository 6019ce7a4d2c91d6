"""Sections as datasets: the points of many motions, in memory or in a store on disk."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from importlib.metadata import version
from typing import Any, Protocol

import numpy as np
import numpy.typing as npt
import sympy as sp

from ...errors import InputError
from ...formulas.array_evaluation import parameter_rows
from ...formulas.array_formulas import Formulas
from ...system.arrays import FloatArray
from ...system.vectors import Vector
from ..ensembles.task import Coordinate, Task, Variable
from ..kernel.outcomes import STATUS_MESSAGES
from ..motion import by_name
from ..variable_metadata import cf_attributes, system_attributes, variable_metadata
from .poincare_map import PoincareMap

#: Approximate block size in bytes, and number of points evaluated at once; both limit the use of
#: memory.
BLOCK, PIECE = 2**26, 2**15
#: Approximate largest size of one motion in bytes.
MOST = 2**29


@dataclass(frozen=True)
class Quantity:
    """Function on the section that is recorded at every point.

    Attributes
    ----------
    name : str
        Name in the dataset.
    formula : sympy.Expr
        Formula in state, definitions and parameters.
    meaning, unit : str
    label : str
        Label in figures, instead of the name.
    """

    name: str
    formula: sp.Expr
    meaning: str
    unit: str = "1"
    label: str = ""


class Columns(Protocol):
    """Functions on the section without a formula, such as coordinates defined by cases.

    An instance is a frozen dataclass with ``__call__``, so it can be pickled and identified by
    name.
    """

    @property
    def quantities(self) -> tuple[Quantity, ...]:
        """Names, meanings and units; the formulas are ignored."""

    def __call__(self, states: FloatArray) -> FloatArray:
        """Columns (n, quantities) at states (n, size)."""


@dataclass(frozen=True)
class Returns:
    """Work of a section: the returns of the motions first, …, last − 1.

    Attributes
    ----------
    returns : PoincareMap
        Map with the same parameters for all motions.
    starts : array (n, size)
    count : int
        Number of returns of each motion.
    quantities : tuple of Quantity
    columns : Columns, optional
    """

    returns: PoincareMap
    starts: FloatArray
    count: int
    quantities: tuple[Quantity, ...]
    columns: Columns | None = None

    def __call__(self, first: int, last: int) -> dict[str, npt.NDArray[np.generic]]:
        """Arrays of a block, by their names in the dataset."""
        crossed = self.returns.crossings(self.starts[first:last], self.count)
        arrays: dict[str, Any] = {
            "time": crossed.times,
            "points": crossed.counts.astype("int64"),
            "outcome": crossed.outcome.astype("int64"),
            "ended": crossed.end_times,
        }
        system = self.returns.system
        flat = crossed.states.reshape(-1, self.returns.size)
        for name in map(str, system.state):
            rows = by_name(system, flat, name)
            arrays[name] = np.ascontiguousarray(rows.reshape(*crossed.times.shape, *rows.shape[1:]))
        formulas = Formulas(system, [item.formula for item in self.quantities])
        groups: list[tuple[Sequence[Quantity], Callable[[FloatArray], FloatArray]]] = [
            (self.quantities, lambda x: formulas(x, self.returns.parameters))
        ]
        if self.columns is not None:
            groups.append((self.columns.quantities, self.columns))
        for quantities, columns in groups:
            for item in quantities:
                arrays[item.name] = np.empty(crossed.times.shape)
            # In parts, because every operation of a formula allocates an array.
            for place in range(0, len(flat), PIECE):
                values = columns(flat[place : place + PIECE])
                for item, column in zip(quantities, values.T, strict=True):
                    arrays[item.name].reshape(-1)[place : place + PIECE] = column
        return arrays


def section_task(
    returns: PoincareMap,
    starts: Sequence[Sequence[float]] | FloatArray,
    count: int,
    quantities: Sequence[Quantity] = (),
    columns: Columns | None = None,
    attributes: Mapping[str, object] | None = None,
    meanings: Mapping[str, tuple[str, str]] | None = None,
) -> Task:
    """Task that computes the returns of many motions to a section.

    The result has the dimensions ``run`` and ``section_point``: the state at each point, the time
    since the start, every unconditional integral as ``law_<name>``, and the `quantities`; for each
    run the number of points (``points``), the reason for which there are not more (``outcome``)
    and the time of its end.  Values after the last point of a run are NaN.

    Parameters
    ----------
    returns : PoincareMap
        Map with the same parameters for all motions.
    starts : array (n, size)
        States, on the section or not.
    count : int
        Number of returns of each motion.
    quantities : sequence of Quantity, optional
        Further quantities to record.
    columns : Columns, optional
        Further functions without a formula.
    attributes : mapping, optional
        Further attributes of the result, such as a seed.
    meanings : mapping of str to (str, str), optional
        Meaning and unit of variables of the state, by name.

    Raises
    ------
    InputError
        If there are no starts, the number of returns is zero or too large, parameters differ
        between motions, or a quantity has the name of another variable.
    """
    if count < 1:
        raise InputError(f"{count} points: there must be one at least")
    if any(np.ndim(value) for value in returns.parameters.values()):
        raise InputError("a section has the same parameters for all its motions")
    system = returns.system
    laws = [
        Quantity(f"law_{law.name}", law.value, law.meaning, law.unit or "1")
        for law in system.scalar.integrals
        if not law.level
    ]
    recorded = (*laws, *quantities)
    variables = {
        "time": _variable(count, "time since the start", "s"),
        "points": Variable(dtype="int64", attributes=cf_attributes("number of points", "1")),
        "outcome": Variable(dtype="int64", attributes=_outcome(returns)),
        "ended": Variable(attributes=cf_attributes("time at the last point, or at the end", "s")),
    }
    coordinates: dict[str, Coordinate] = {}
    for named in system.state:
        name = str(named)
        size = len(named.symbols) if isinstance(named, Vector) else 1
        meaning, unit, source, frame = variable_metadata(
            system, name, size, (meanings or {}).get(name)
        )
        notes = cf_attributes(meaning, unit or "1", source)
        if not frame:
            variables[name] = Variable(("section_point",), (count,), attributes=notes)
            continue
        frames, axis_meanings = system.conventions.frames, system.conventions.axis_meanings
        dim, labels = frames.get(frame, (frame, tuple(range(1, size + 1))))
        notes |= {"frame": "body axes"} if frame == "body" else {}
        variables[name] = Variable(("section_point", dim), (count, size), attributes=notes)
        label = axis_meanings.get(dim, f"component of {name}")
        coordinates[dim] = Coordinate((dim,), np.array(labels), cf_attributes(label, "1"))
    for item in (*recorded, *(() if columns is None else columns.quantities)):
        if item.name in variables:
            raise InputError(f"the quantity {item.name} bears the name of something else")
        notes = cf_attributes(item.meaning, item.unit) | (
            {"label": item.label} if item.label else {}
        )
        variables[item.name] = Variable(("section_point",), (count,), attributes=notes)
    width = sum(int(np.prod(item.shape[1:])) for item in variables.values())
    if 8 * width * count > MOST:
        raise InputError(
            f"{count} points of one motion do not fit into memory at once: ask for no more than "
            f"{MOST // (8 * width)}, and for more motions"
        )
    return Task(
        work=Returns(returns, np.asarray(starts, dtype=np.float64), count, recorded, columns),
        size=len(starts),
        block=max(1, BLOCK // (8 * width * count)),
        variables=variables,
        member="run",
        coordinates=coordinates,
        attributes={**_facts(returns), **(attributes or {})},
    )


def _variable(count: int, meaning: str, unit: str) -> Variable:
    return Variable(("section_point",), (count,), attributes=cf_attributes(meaning, unit))


def _outcome(returns: PoincareMap) -> dict[str, object]:
    """Attributes of the outcome codes of a run, by the CF conventions."""
    reasons = {0: "all its points"}
    reasons |= {
        code: returns.status_message(code)
        for code in range(1, len(STATUS_MESSAGES) + len(returns.system.guards))
    }
    return {
        **cf_attributes("why a run has no more points", "1"),
        "flag_values": list(reasons),
        "flag_meanings": " ".join(text.replace(" ", "_") for text in reasons.values()),
    }


def _facts(returns: PoincareMap) -> dict[str, object]:
    system = returns.system
    (numbers,) = parameter_rows(system, returns.parameters, 1)
    names = [str(item.symbol) for item in system.parameters]
    return {
        **system_attributes(system),
        "parameters": "; ".join(f"{n} = {float(x)!r}" for n, x in zip(names, numbers, strict=True)),
        "section_value": str(returns.section.value),
        "section_where": "" if returns.section.where is None else str(returns.section.where),
        "section_direction": returns.section.direction,
        "backward": int(returns.backward),
        "tolerance": returns.tolerance,
        "versions": ", ".join(f"{name} {version(name)}" for name in ("flowlanes", "numpy")),
    }
