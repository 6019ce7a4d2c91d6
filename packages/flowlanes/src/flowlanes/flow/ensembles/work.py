"""Work of an ensemble: the integration of some of its members."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
import numpy.typing as npt

from ...errors import InputError
from ...formulas.array_evaluation import values
from ...system.arrays import FloatArray, IntArray
from ...system.system import System
from ..batch import BatchIntegrator, batch_integrator
from ..devices.graphics import Device
from ..initial_states import flat_starts
from ..motion import by_name
from ..recorded_quantities import RecordedQuantity, recorded_quantities
from ..sampling.level_sampler import LevelSampler, level_sampler
from .members import ListedMembers, Members, SampledMembers
from .task import Arrays


def quantities_by_name(system: System, names: Sequence[str]) -> tuple[RecordedQuantity, ...]:
    """Observables and integrals by name; an integral is recorded as ``law_<name>``.

    Raises
    ------
    InputError
        If the system has no such observable or integral.
    """
    known = {quantity.name: quantity for quantity in recorded_quantities(system)}
    quantities = []
    for name in names:
        label = name if name in known else f"law_{name}"
        if label not in known:
            raise InputError(
                f"{system.name}: there is no {name} to be recorded; there are "
                f"{', '.join(sorted(known, key=_is_observable)) or 'no observables'}"
            )
        quantities.append(known[label])
    return tuple(quantities)


def _is_observable(name: str) -> bool:
    """True for an observable, False for an integral; integrals are listed first."""
    return not name.startswith("law_")


@dataclass(frozen=True, eq=False)
class EnsembleWork:
    """Work of an ensemble; see :class:`flowlanes.flow.ensembles.task.Work`.

    Parameters
    ----------
    system : System
    members : Members
    times : tuple of float
    parameters : mapping of str to float
        Values for all members.
    tolerance : float
    record : tuple of str
        Names of observables and integrals.
    offset : int
        Number of the first member.
    device : "cpu" or "gpu"
    """

    system: System
    members: Members
    times: tuple[float, ...]
    parameters: Mapping[str, float]
    tolerance: float
    record: tuple[str, ...]
    offset: int = 0
    device: Device = "cpu"

    @property
    def lanes(self) -> BatchIntegrator:
        """Compiled integrator."""
        return batch_integrator(
            self.system,
            tolerance=self.tolerance,
            backward=self.times[-1] < 0,
            device=self.device,
        )

    @property
    def varied_parameters(self) -> tuple[str, ...]:
        """Parameters that vary between members."""
        known = {str(p.symbol) for p in self.system.parameters}
        return tuple(name for name in self.members.names if name in known)

    def __call__(self, first: int, last: int) -> Arrays:
        """Motions first, …, last − 1 as arrays by name, one row per motion."""
        try:
            starts, parameters, points = self.starts(first, last)
            motions = self.lanes.propagate(starts, self.times, parameters)
        except InputError as error:
            runs = f"runs {first} to {last - 1}" if last > first + 1 else f"run {first}"
            raise InputError(error.message, runs) from error
        arrays: dict[str, npt.NDArray[np.number]] = {
            name: np.asarray(parameters[name]) for name in self.varied_parameters
        }
        if points is not None:
            arrays["start"] = points
        states = motions.states.reshape(-1, motions.states.shape[-1])
        for variable in map(str, self.system.state):
            block = by_name(self.system, states, variable)
            arrays[variable] = block.reshape(*motions.states.shape[:2], *block.shape[1:])
        for item in quantities_by_name(self.system, self.record):
            block = values(self.system, item.formulas, motions.states, parameters)
            arrays[item.name] = block if item.frame else block[..., 0]
        arrays["outcome"] = motions.outcome.astype(np.int8)
        arrays |= {"ended": motions.end_times, "steps": motions.steps}
        return {name: np.ascontiguousarray(array) for name, array in arrays.items()}

    def part(self, first: int, last: int) -> EnsembleWork:
        """Work restricted to these members, without the listed rows of others."""
        if self.members.draw is not None:
            return self
        rows, _ = self.members.rows(first - self.offset, last - self.offset)
        return replace(self, members=Members((ListedMembers(rows),)), offset=first)

    def starts(
        self, first: int, last: int
    ) -> tuple[FloatArray, dict[str, float | FloatArray], IntArray | None]:
        """Initial states, parameters, and indices of the random starts, for some members."""
        rows, points = self.members.rows(first - self.offset, last - self.offset)
        varied = {name: rows.pop(name) for name in self.varied_parameters}
        parameters: dict[str, float | FloatArray] = {**self.parameters, **varied}
        if self.members.draw is None or points is None:
            return flat_starts(self.system, rows, parameters), parameters, None
        if rows:
            raise InputError(
                f"{self.system.name}: starts are drawn, so only parameters can be given besides, "
                f"not {', '.join(rows)}"
            )
        return self._random_starts(self.members.draw, varied, points), parameters, points

    def _random_starts(
        self, draw: SampledMembers, parameters: Mapping[str, FloatArray], points: IntArray
    ) -> FloatArray:
        """Random starts by index, each on the level at its own parameters."""
        starts = np.empty((len(points), len(self.system.symbols)))
        rows = np.column_stack([np.zeros(len(points)), *parameters.values()])
        sets, which = np.unique(rows, axis=0, return_inverse=True)
        for number, row in enumerate(sets[:, 1:].tolist()):
            indices = np.flatnonzero(which.ravel() == number)
            numbers, begin = points[indices], int(points[indices].min())
            level = self.level(dict(zip(parameters, row, strict=True)))
            starts[indices] = level.draw(
                int(numbers.max()) - begin + 1, seed=draw.seed, first=begin
            )[numbers - begin]
        return starts

    def level(self, parameters: Mapping[str, float]) -> LevelSampler:
        """Level for random starts, for given values of the varying parameters."""
        level = self.members.draw.level if self.members.draw is not None else {}
        values = {**self.parameters, **parameters}
        return _level(self.system, tuple(level.items()), tuple(values.items()))


@lru_cache(maxsize=512)
def _level(
    system: System, level: tuple[tuple[str, float], ...], values: tuple[tuple[str, float], ...]
) -> LevelSampler:
    return level_sampler(system, dict(level), dict(values))
