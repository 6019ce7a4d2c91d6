"""The trajectory of an unfinished study, stored so that the study can be resumed."""

from __future__ import annotations

import io
import json
import zipfile
from dataclasses import asdict
from pathlib import Path

import mpmath
import numpy as np
import numpy.typing as npt

from flowlanes.errors import InputError
from flowlanes.files.cache import entry_name
from flowlanes.flow.taylor.working_numbers import number_type
from flowlanes.flow.trajectory import Event, Statistics, Trajectory
from flowlanes.formulas.digest import digest

from ..experiment.files import atomic_file
from ..experiment.study import Study

#: Number of digits of the start that enter the digest.
_DIGITS = 50


def trajectory_digest(study: Study, pieces: int) -> str | None:
    """A digest of everything that determines a trajectory; None if a part has no digest.

    Parameters
    ----------
    study : Study
    pieces : int
        Pieces into which each sample interval is divided.
    """
    start = [mpmath.nstr(x, _DIGITS) for x in study.start]
    text = study.complete_toml()
    try:
        return entry_name("trajectory", digest((text, study.system_on_level, start, pieces)))
    except InputError:
        return None


def store_trajectory(path: Path, key: str | None, trajectory: Trajectory) -> None:
    """Store a trajectory, unless its numbers have no fixed size in bytes.

    Parameters
    ----------
    path : Path
    key : str or None
        Digest of the trajectory; if None, nothing is written.
    trajectory : Trajectory
    """
    named = {"times": trajectory.times, "states": trajectory.states}
    named |= {f"recorded {name}": values for name, values in trajectory.records.items()}
    arrays = {name: np.asarray(values) for name, values in named.items()}
    if key is None or any(array.dtype.hasobject for array in arrays.values()):
        return
    guards = trajectory.system.guards
    facts = {
        "key": key,
        "statistics": asdict(trajectory.statistics),
        "events": [(e.time, guards.index(e.guard), e.is_terminal) for e in trajectory.events],
        "shapes": {name: array.shape for name, array in arrays.items()},
    }
    # As bytes, since NumPy's own format does not support 34-digit numbers.
    contents = {name: np.frombuffer(array.tobytes(), np.uint8) for name, array in arrays.items()}
    with atomic_file(path) as temporary, temporary.open("wb") as stream:
        np.savez(stream, allow_pickle=False, **{"": np.array(json.dumps(facts)), **contents})


def read_trajectory(path: Path, key: str | None, study: Study) -> Trajectory | None:
    """The trajectory stored with a digest; None if there is none.

    Parameters
    ----------
    path : Path
    key : str or None
        See :func:`trajectory_digest`.
    study : Study
    """
    try:
        # Read as a whole: NumPy would leave a damaged file open.
        with np.load(io.BytesIO(path.read_bytes()), allow_pickle=False) as stored:
            facts = json.loads(str(stored[""]))
            if key is None or facts["key"] != key:
                return None
            kind = np.dtype(number_type(study.experiment.run.precision))
            arrays = {
                name: _numbers(stored[name], kind, shape) for name, shape in facts["shapes"].items()
            }
    except (OSError, ValueError, KeyError, zipfile.BadZipFile):
        return None
    system = study.system_on_level
    lifted = system.lifted() if system.reconstruction else system
    return Trajectory(
        lifted,
        lifted.defaults,
        arrays.pop("times"),
        arrays.pop("states"),
        {name.removeprefix("recorded "): values for name, values in arrays.items()},
        tuple(Event(time, lifted.guards[i], stopped) for time, i, stopped in facts["events"]),
        Statistics(**facts["statistics"]),
    )


def _numbers(
    content: npt.NDArray[np.uint8], kind: np.dtype[np.generic], shape: list[int]
) -> npt.NDArray[np.generic]:
    return content.view(kind).reshape(shape).copy()
