"""Ensembles: many motions of one System, sampled at the same times, in blocks."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from importlib.metadata import version
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from ...arguments import Numbers, Parameters, arguments_checked
from ...errors import InputError
from ...formulas.array_evaluation import as_float_array
from ...formulas.digest import canonical
from ...system.system import Conventions, System
from ...system.tolerance import ENSEMBLE_TOLERANCE
from ..cost import TooMuchError
from ..devices.graphics import Device
from ..kernel.outcomes import STATUS_MESSAGES
from ..validation import moments
from ..variable_metadata import cf_attributes, system_attributes, variable_metadata
from .computation import compute
from .members import Members, from_lists
from .task import Coordinate, Progress, Task, Variable
from .work import EnsembleWork, quantities_by_name

if TYPE_CHECKING:
    import xarray as xr
    from distributed import Client


#: Largest number of members of a block, and largest number of its values.
_MEMBERS: Mapping[Device, int] = {"cpu": 4096, "gpu": 1 << 17}
_NUMBERS = 1 << 22

#: Smallest number of blocks on a cluster.
SHARES = 64


@arguments_checked
def ensemble(
    system: System,
    members: npt.ArrayLike | Members,
    times: Numbers,
    parameters: Parameters = None,
    *,
    record: Sequence[str] = (),
    tolerance: float = ENSEMBLE_TOLERANCE,
    device: Device = "cpu",
    block: int | None = None,
    store: str | Path | None = None,
    client: Client | str | int | None = None,
    progress: Progress | None = None,
) -> xr.Dataset:
    """Integrate many motions of a system, each with its own start and parameters.

    Parameters
    ----------
    system : System
        The system to integrate; ``system.lifted()`` includes its motion in space.
    members : Members or array (n, size)
        Starts and parameters, by :func:`~flowlanes.flow.ensembles.members.from_lists`,
        :func:`~flowlanes.flow.ensembles.members.grid`,
        :func:`~flowlanes.flow.ensembles.members.single`,
        :func:`~flowlanes.flow.ensembles.members.random_starts` and products of them with ``*``; or
        only starts, in flat order.
    times : array (k,)
        Times in s, all ≥ 0 and increasing, or all ≤ 0 and decreasing; motions begin at time 0.
    parameters : mapping of Symbol or name to float, optional
        Values that replace the defaults for all motions.
    record : sequence of str
        Observables and integrals to record as well.
    tolerance : float
        See :mod:`flowlanes.system.tolerance`.
    device : "cpu" or "gpu"
        Device for the computation.
    block : int, optional
        Number of members that are computed and written together; by default chosen by their size.
    store, client, progress
        Store on disk, cluster, and function for progress reports; see
        :func:`~flowlanes.flow.ensembles.compute`.

    Returns
    -------
    State variables and recorded quantities over ``run`` and ``time`` (and ``axis``, …);
    ``outcome`` (the reason for the end of a motion, with a legend in its attributes), ``ended``
    and ``steps`` over ``run``; varying parameters as coordinates of ``run``.
        parameters that vary as coordinates of ``run``.

    Raises
    ------
    InputError
        If an argument is not valid.
    IncompleteError
        If a store could not be completed.

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> a, b, c = sp.symbols("a b c", real=True)
    >>> energy = flowlanes.Integral("energy", a**2 + b**2 / 2 + c**2 / 3)
    >>> field = {a: -b * c, b: 4 * a * c, c: -3 * a * b}
    >>> top = flowlanes.System("top", "Euler's top", field, laws=(energy,))
    >>> starts = flowlanes.sample_level(top, 100, {"energy": 2.0}, seed=1)
    >>> runs = flowlanes.ensemble(top, starts, [0.0, 10.0], record=["energy"])
    >>> dict(runs.sizes), bool(abs(runs["law_energy"] - 2.0).max() < 1e-9)
    ({'run': 100, 'time': 2}, True)
    """
    task = ensemble_task(
        system,
        members,
        times,
        parameters,
        record=record,
        tolerance=tolerance,
        device=device,
        block=block,
        shares=1 if client is None else SHARES,
    )
    return compute(task, store, client=client, progress=progress)


def ensemble_task(
    system: System,
    members: npt.ArrayLike | Members,
    times: Numbers,
    parameters: Parameters = None,
    *,
    record: Sequence[str] = (),
    tolerance: float = ENSEMBLE_TOLERANCE,
    device: Device = "cpu",
    block: int | None = None,
    shares: int = 1,
) -> Task:
    """Prepare an ensemble without computing it; see :func:`ensemble`.

    Unless the block size is given, there are at least `shares` blocks with at least 16 members, so
    that several workers have enough work.
    """
    everyone = members if isinstance(members, Members) else from_lists(state=members)
    work = EnsembleWork(
        canonical(system),
        everyone,
        _times(times),
        _constants(system, parameters),
        tolerance,
        tuple(record),
        device=device,
    )
    twice = sorted({str(name) for name in parameters or ()} & set(work.varied_parameters))
    if twice:
        raise InputError(f"{system.name}: {', '.join(twice)} is given twice")
    lanes = work.lanes
    # The first member is checked now, so that a mistake is found before a store is created.
    first, parameters, points = work.starts(0, 1)
    try:
        lanes.require_reach(first[0], work.times[-1], parameters)
    except TooMuchError:
        raise
    except InputError as error:
        raise InputError(error.message, "runs 0 to 0") from error
    variables = _variables(work, points is not None)
    share = max(16, math.ceil(everyone.size / shares))
    numbers = sum(math.prod(variable.shape) for variable in variables.values())
    fitting = max(1, min(_MEMBERS[device], _NUMBERS // numbers, everyone.size, share))
    return Task(
        work,
        everyone.size,
        fitting if block is None else block,
        variables,
        "run",
        sample_coordinates(work.system.conventions, work.times, variables),
        {**_attributes(work), **_draw(work, parameters)},
    )


def _times(times: Numbers) -> tuple[float, ...]:
    """Sampling times of an ensemble; InputError if they are not valid."""
    row = np.atleast_1d(as_float_array("times", times))
    moments(row, backward=bool(row.size) and bool(row.flat[-1] < 0))
    return tuple(row.tolist())


def _constants(system: System, parameters: Parameters) -> dict[str, float]:
    """Parameter values by name, without those that equal the default."""
    constants, defaults = {}, dict(system.default_values)
    for name, value in (parameters or {}).items():
        number = as_float_array(f"{system.name}: {name}", value)
        if number.ndim:
            raise InputError(
                f"{system.name}: {name} must be one number; what varies belongs to the members"
            )
        if defaults.get(str(name)) != float(number):
            constants[str(name)] = float(number)
    return constants


def _variables(work: EnsembleWork, are_random: bool) -> dict[str, Variable]:
    """Output variables of `EnsembleWork`."""
    system, moments = work.system, len(work.times)
    text = {str(p.symbol): p for p in system.parameters}
    variables = {
        name: Variable(
            attributes=cf_attributes(text[name].meaning, text[name].unit), coordinate=True
        )
        for name in work.varied_parameters
    }
    if are_random:
        notes = cf_attributes("number of the start among those drawn", "1")
        variables["start"] = Variable(dtype="int64", attributes=notes, coordinate=True)
    for item, place in system.slices:
        size = place.stop - place.start
        *about, frame = variable_metadata(system, str(item), size)
        variables[str(item)] = sampled_variable(system.conventions, moments, size, frame, *about)
    for item in quantities_by_name(system, work.record):
        about = [item.meaning, item.unit, item.source]
        variables[item.name] = sampled_variable(
            system.conventions, moments, len(item.formulas), item.frame, *about
        )
    variables["outcome"] = Variable(dtype="int8", attributes=_outcomes(work))
    variables["ended"] = Variable(attributes=cf_attributes("time that was reached", "s"))
    variables["steps"] = Variable(dtype="int64", attributes=cf_attributes("steps tried", "1"))
    return variables


def sampled_variable(
    conventions: Conventions,
    moments: int,
    size: int,
    frame: str,
    meaning: str,
    unit: str,
    source: str,
) -> Variable:
    """Description of a quantity sampled along the motions."""
    notes = cf_attributes(meaning, unit, source)
    if not frame:
        return Variable(("time",), (moments,), attributes=notes)
    axis = frame
    if frame in conventions.frames:
        axis = conventions.frames[frame][0]
        notes["frame"] = f"{frame} axes"
    return Variable(("time", axis), (moments, size), attributes=notes)


def _outcomes(work: EnsembleWork) -> dict[str, object]:
    """Flag values for the reasons for the end of a motion."""
    codes = range(len(STATUS_MESSAGES) + len(work.system.guards))
    reasons = [
        "the last time was reached",
        *(work.lanes.status_message(code) for code in codes[1:]),
    ]
    return {
        **cf_attributes("why the motion ended", "1"),
        "flag_values": list(codes),
        "flag_meanings": " ".join("_".join(re.findall(r"\w+", reason)) for reason in reasons),
        "reasons": reasons,
    }


def sample_coordinates(
    conventions: Conventions, times: Sequence[float], variables: Mapping[str, Variable]
) -> dict[str, Coordinate]:
    """Coordinates for the times and for the axes in use."""
    used = {dimension for variable in variables.values() for dimension in variable.dimensions}
    meanings = conventions.axis_meanings
    axes = {
        axis: Coordinate((axis,), np.array(labels), cf_attributes(meanings[axis], "1"))
        for axis, labels in conventions.frames.values()
        if axis in used
    }
    return {"time": Coordinate(("time",), list(times), cf_attributes("time", "s")), **axes}


def _attributes(work: EnsembleWork) -> dict[str, object]:
    """Attributes of the whole ensemble."""
    system = work.system
    constants = {str(p.symbol): p.default for p in system.parameters} | dict(work.parameters)
    text = [f"{s} = {float(v)!r}" for s, v in constants.items() if s not in work.varied_parameters]
    return {
        **system_attributes(system),
        "parameters": "; ".join(text),
        "members": str(work.members),
        "tolerance": work.tolerance,
        "integrator": "explicit Runge–Kutta of order 8, a lane for each motion",
        "versions": ", ".join(
            f"{name} {version(name)}" for name in ("flowlanes", "llvmlite", "numpy", "sympy")
        ),
    }


def _draw(work: EnsembleWork, parameters: Mapping[str, npt.ArrayLike]) -> dict[str, object]:
    """Seed and measure of the random starts, at the parameters of the first member."""
    draw = work.members.draw
    if draw is None:
        return {}
    first = {name: float(np.asarray(parameters[name])[0]) for name in work.varied_parameters}
    return {"seed": draw.seed, "measure": work.level(first).measure}
