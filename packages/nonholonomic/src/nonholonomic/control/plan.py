"""The result of planning: inputs over time, the resulting motion, and its distance to the path."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from scipy.integrate import solve_ivp
from scipy.interpolate import BarycentricInterpolator

from flowlanes.flow.motion import Motion, read_only, unknown_variable
from flowlanes.system.arrays import FloatArray
from flowlanes.system.overview import Overview, WithOverview

from .collocation import Transcription, radau
from .guess import rotation
from .path import PlanePath
from .robot import SphericalRobot

if TYPE_CHECKING:
    import xarray as xr

PLACED = 6
"""Number of state components of attitude and position; joints follow."""
TOLERANCE = 1e-13
"""Relative tolerance of the integration that checks a plan; the absolute one is a tenth."""
SAMPLES = 8
"""Number of times per interval at which the distance to the path is measured."""


@dataclass(frozen=True, eq=False, repr=False)
class MotionPlan(Motion, WithOverview):
    """Inputs that move the contact point along a path, and the resulting motion.

    Attributes
    ----------
    robot : SphericalRobot
    path : PlanePath
    inputs : tuple of str
        Names of the inputs: speeds ``u_1``, … of the rotors (rad/s), rates of the joints.
    state_names : tuple of str
    start : array (n,)
        The state at t = 0, in the order of `state_names`.
    node_times : array (k,)
        Times of the collocation nodes, including the ends of the intervals.
    node_inputs : array (k, m)
        Inputs at the nodes, interpolated by a polynomial in each interval.
    intervals : int
    effort : float
        ½ ∫ |inputs|² dt / T.
    times : array (l,)
        Times of the check.
    states : array (l, n)
        States integrated from the start with these inputs at a tolerance of 1e-13.
    path_error : float
        The greatest distance (m) of the contact from the path point of the same time.
    iterations : int
        Iterations of the optimiser.
    seconds : float
        Computing time of the planning (s).
    """

    robot: SphericalRobot
    path: PlanePath
    inputs: tuple[str, ...]
    state_names: tuple[str, ...]
    start: FloatArray
    node_times: FloatArray
    node_inputs: FloatArray
    intervals: int
    effort: float
    times: FloatArray
    states: FloatArray
    path_error: float
    iterations: int
    seconds: float

    def __post_init__(self) -> None:
        for name in ("start", "node_times", "node_inputs", "times", "states"):
            object.__setattr__(self, name, read_only(getattr(self, name)))

    @property
    def relative_error(self) -> float:
        """The path error relative to the diameter of the path."""
        return self.path_error / self.path.diameter

    def overview(self) -> Overview:
        """Inputs, effort, distance to the path, and cost."""
        return Overview(
            f"Motion of a spherical robot along a path, t = 0 to {self.path.period:.9g}",
            (
                ("inputs", ", ".join(self.inputs)),
                ("effort", f"{self.effort:.6g}"),
                (
                    "path error",
                    f"{self.path_error:.2g} m = {self.relative_error:.2g} of the diameter",
                ),
                ("cost", f"{self.iterations} iterations, {self.seconds:.1f} s"),
            ),
        )

    def inputs_at(self, times: FloatArray) -> FloatArray:
        """Inputs (l, m) at times (l,) of the period."""
        moments = np.asarray(times, dtype=float)
        step = self.path.period / self.intervals
        number = np.clip((moments // step).astype(int), 0, self.intervals - 1)
        values = self.node_inputs.reshape(self.intervals, -1, len(self.inputs))
        c, _ = radau(values.shape[1])
        result = np.empty((len(moments), len(self.inputs)))
        for e in np.unique(number):
            here = number == e
            result[here] = BarycentricInterpolator(c, values[e])(moments[here] / step - e)
        return result

    @property
    def errors(self) -> FloatArray:
        """Distances (l,) to the path at the times of the check."""
        return distances(self.path, self.times, self.states)

    @cached_property
    def _quantities(self) -> dict[str, FloatArray]:
        places = self.states[:, 4:6]
        contact = np.column_stack([places, np.zeros(len(places))])
        quantities = {
            "attitude": self.states[:, :4],
            "contact": contact,
            "centre": np.add(contact, [0, 0, self.robot.radius]),
            "gamma": np.array([rotation(q)[2] for q in self.states[:, :4]]),
            "input": self.inputs_at(self.times),
            "path_error": self.errors,
        }
        quantities |= {
            str(name): self.states[:, place]
            for place, name in enumerate(self.state_names)
            if place >= PLACED
        }
        return {name: read_only(values) for name, values in quantities.items()}

    def __getitem__(self, name: str) -> FloatArray:
        if name not in self._quantities:
            raise unknown_variable("plan", name, self)
        return self._quantities[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._quantities)

    def to_dataset(self) -> xr.Dataset:
        """The motion as a dataset.

        Returns
        -------
        xarray.Dataset
            `attitude`, `contact`, `centre`, `gamma`, `input`, `path_error` and the joints over
            `time`.
        """
        import xarray as xr

        labels = {"axis": [1, 2, 3], "space": ["x", "y", "z"], "quaternion": ["w", "x", "y", "z"]}
        return xr.Dataset(
            {
                name: (_DIMENSIONS.get(name, "time"), self[name], _NOTES.get(name, _JOINT))
                for name in self
            },
            {"time": ("time", self.times, {"units": "s"}), "name": list(self.inputs), **labels},
            {"system": "spherical-robot", "title": "Spherical robot"},
        )


_DIMENSIONS = {
    "attitude": ("time", "quaternion"),
    "contact": ("time", "space"),
    "centre": ("time", "space"),
    "gamma": ("time", "axis"),
    "input": ("time", "name"),
}
_NOTES = {
    "attitude": {"long_name": "attitude quaternion, body to space", "units": ""},
    "contact": {"long_name": "contact point", "units": "m"},
    "centre": {"long_name": "geometric centre", "units": "m"},
    "gamma": {"long_name": "vertical", "units": ""},
    "input": {"long_name": "speed of a rotor or joint", "units": "rad/s"},
    "path_error": {"long_name": "distance to the path", "units": "m"},
}
_JOINT = {"long_name": "joint", "units": "rad"}


def distances(path: PlanePath, times: FloatArray, motion: FloatArray) -> FloatArray:
    """Distances from the contact to the path point at the same time."""
    result: FloatArray = np.linalg.norm(motion[:, 4:6] - path.places(times), axis=1)
    return result


def inputs_motion(
    plan: Transcription, start: FloatArray, inputs: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Times and states of the motion with given inputs, by DOP853, interval by interval.

    It shares only the rates with the collocation; the inputs are the same polynomials.
    """
    c, _ = radau(plan.stages)
    values = inputs.reshape(plan.intervals, plan.stages, -1)
    times, states = [np.zeros(1)], [start[None]]
    for e in range(plan.intervals):
        speeds = BarycentricInterpolator(c, values[e])
        begin = e * plan.step
        moments = begin + plan.step * np.arange(1, SAMPLES + 1) / SAMPLES

        def rates(t: float, z: FloatArray) -> FloatArray:
            point = np.append(z, speeds((t - begin) / plan.step))  # noqa: B023
            rate: FloatArray = plan.equations.rates(point[None])[0]
            return rate

        run = solve_ivp(
            rates,
            (begin, moments[-1]),
            states[-1][-1],
            method="DOP853",
            rtol=TOLERANCE,
            atol=TOLERANCE / 10,
            t_eval=moments,
        )
        times.append(moments)
        states.append(run.y.T)
    return np.concatenate(times), np.concatenate(states)
