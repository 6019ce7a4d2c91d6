"""The Poincaré section of an experiment: surface, starts and coordinates."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import sympy as sp

from flowlanes.errors import InputError
from flowlanes.flow.devices.graphics import Device
from flowlanes.flow.ensembles.task import Task
from flowlanes.flow.kernel.equations import poincare_section
from flowlanes.flow.sampling.resampling import resampled_level
from flowlanes.flow.sections.poincare_dataset import Quantity, section_task
from flowlanes.flow.sections.poincare_map import PoincareMap, slab
from flowlanes.formulas.array_evaluation import formula, values
from flowlanes.scans.state_coordinates import chart
from flowlanes.scans.system_quantities import meaning
from flowlanes.system.arrays import FloatArray
from flowlanes.system.system import System
from flowlanes.system.tolerance import ENSEMBLE_TOLERANCE

from .scan import VECTORS
from .section_coordinates import is_angle, usual, within_a_turn
from .single_system import without_reconstruction
from .study import Study

#: Functions whose value is an angle.
ANGLES = (sp.atan2, sp.atan, sp.asin, sp.acos)

#: Names of the directions in which a quantity passes its value.
DIRECTIONS: Mapping[str, int] = {"rising": 1, "falling": -1, "both": 0}


@dataclass(frozen=True)
class SectionSurface:
    """The surface of section.

    Attributes
    ----------
    quantity : str
        A formula, or the name of an observable or integral.
    value : float
    direction : str
        One of `DIRECTIONS`.
    angle : bool
        Whether the quantity is an angle, whose value is taken modulo whole turns.
    within : tuple of (str, float)
        Quantities with bounds of their absolute values: a section of the section.
    """

    quantity: str
    value: float = 0.0
    direction: str = "rising"
    angle: bool = False
    within: tuple[tuple[str, float], ...] = ()

    def __str__(self) -> str:
        way = "both ways" if self.direction == "both" else self.direction
        near = "".join(f", |{quantity}| < {width:.10g}" for quantity, width in self.within)
        return f"{self.quantity} = {self.value:.10g}, {way}{near}"


@dataclass(frozen=True)
class Starts:
    """The starts of the motions.

    Attributes
    ----------
    count : int
        Number of starts; a single one is the start of the experiment, unless a level is given.
    level : mapping of str to float
        Values of integrals that define the level of random starts; by default those of the start of
        the experiment.
    seed : int
    """

    count: int = 1
    level: Mapping[str, float] | None = None
    seed: int = 0


def section_of(
    study: Study,
    surface: SectionSurface,
    starts: Starts,
    points: int,
    coordinates: str = "",
    *,
    t_end: float = np.inf,
    tolerance: float = ENSEMBLE_TOLERANCE,
    device: Device = "cpu",
) -> tuple[Task, tuple[str, ...]]:
    """Prepare the section of an experiment; also return the coordinates to be drawn.

    Parameters
    ----------
    study : Study
    surface : SectionSurface
    starts : Starts
    points : int
        Number of returns of each motion.
    coordinates : str
        See :func:`coordinates_of`.
    t_end : float
        Time limit of each motion.
    tolerance : float
        See :mod:`flowlanes.system.tolerance`.
    device : "cpu" or "gpu"
        Device of the computation; see :func:`flowlanes.flow.batch.batch_integrator`.

    Raises
    ------
    InputError
        If place, level or coordinates cannot be used.
    """
    system = without_reconstruction(study)
    if surface.direction not in DIRECTIONS:
        raise InputError(
            f"--direction {surface.direction}: it must be one of {', '.join(DIRECTIONS)}"
        )
    if not t_end > 0:
        raise InputError(f"--until {t_end:g}: it must be positive")
    on = formula(system, surface.quantity, "--on")
    where = poincare_section(
        system, on, surface.value, DIRECTIONS[surface.direction], surface.angle
    )
    for quantity, width in surface.within:
        where = slab(where, formula(system, quantity, "--within"), width)
    names, quantities, columns = coordinates_of(
        system, coordinates, study.variables, surface.quantity
    )
    states, sentence = _starts(study, system, starts)
    returns = PoincareMap(system, where, {}, tolerance, t_end=t_end, device=device)
    task = section_task(
        returns,
        states,
        points,
        quantities,
        columns,
        {
            "section": str(surface),
            "coordinates": list(names),
            "starts": sentence,
            "experiment": study.complete_toml(),
        },
        study.variables,
    )
    return task, names


def _starts(study: Study, system: System, starts: Starts) -> tuple[FloatArray, str]:
    """States at time 0, and a description of how they were chosen."""
    if starts.count < 1:
        raise InputError(f"--starts {starts.count}: there must be one at least")
    own = np.array([[float(value) for value in study.start[: len(system.symbols)]]])
    if starts.level is None and starts.count == 1:
        return own, "the start of the experiment"
    level = dict(starts.level or _level(system, own))
    chosen = resampled_level(system, level)
    constants = ", ".join(f"{name} = {value:.6g}" for name, value in level.items())
    sentence = (
        f"{starts.count} drawn on {constants} by the {chosen.description} (seed {starts.seed})"
    )
    return chosen.draw(starts.count, seed=starts.seed), sentence


def _level(system: System, start: FloatArray) -> dict[str, float]:
    """The unconditional integrals at a start."""
    laws = [law for law in system.integrals if not law.level]
    (numbers,) = values(system, [law.value for law in laws], start)
    return {law.name: float(x) for law, x in zip(laws, numbers, strict=True)}


@dataclass(frozen=True)
class ReducedCoordinates:
    """Two or three coordinates of a chart of the reduced system.

    Attributes
    ----------
    system : System
    chart : str
    names : tuple of str
        Two or three of the chart's.

    Raises
    ------
    InputError
        If there are not two or three, no such chart, or not of this system.
    """

    system: System
    chart: str
    names: tuple[str, ...]

    def __post_init__(self) -> None:
        known = chart(self.system, self.chart).names
        for name in self.names:
            if name not in known:
                raise InputError(
                    f"--coordinates {self.chart}: no {name!r} among {', '.join(known)}"
                )
        if len(self.names) not in (2, 3):
            raise InputError(f"--coordinates {self.chart}: two or three names are needed after it")

    @property
    def quantities(self) -> tuple[Quantity, ...]:
        """The coordinates as quantities, under names without a slash."""
        coordinates = chart(self.system, self.chart)
        unit = {
            name: "rad" if period else ""
            for name, period in zip(coordinates.names, coordinates.periods, strict=True)
        }
        return tuple(
            Quantity(
                name.replace("/", "_over_"),
                None,
                f"coordinate {name} of the chart {self.chart}",
                unit[name] or "unknown",
                name,
            )
            for name in self.names
        )

    def __call__(self, states: FloatArray) -> FloatArray:
        """The coordinates (n, names) of states (n, size)."""
        coordinates = chart(self.system, self.chart)
        points: FloatArray = coordinates.point(states)
        return points[:, [coordinates.names.index(name) for name in self.names]]


def coordinates_of(
    system: System,
    text: str,
    variables: Mapping[str, tuple[str, str]] | None = None,
    condition: str = "",
) -> tuple[tuple[str, ...], tuple[Quantity, ...], ReducedCoordinates | None]:
    """The coordinates in which a section is drawn, and those to be recorded.

    Parameters
    ----------
    system : System
    text : str
        Two or three, separated by commas: variables of the state (``M_1``), integrals and
        observables by name (``energy``), formulas with a name (``phi = atan2(gamma_2, gamma_1)``);
        or reduced coordinates, the name of their chart first (``andoyer: l, L, H``).
        By default they are :func:`chaplygin.experiment.section_coordinates.usual`.
        Variables that are angles are taken up to whole turns.
    variables : mapping of str to (str, str), optional
        Meaning and unit of variables of the state.
    condition : str
        The quantity that defines the section.

    Raises
    ------
    InputError
        If there are not two or three, or one of them cannot be read.
    """
    text = text.strip() or usual(system, condition)
    name, colon, listed = text.partition(":")
    if colon:
        reduced = ReducedCoordinates(
            system, name.strip(), tuple(part.strip() for part in listed.split(","))
        )
        return tuple(item.name for item in reduced.quantities), (), reduced
    parts = _at_commas(text)
    if len(parts) not in (2, 3):
        raise InputError(f"--coordinates {text}: two or three are needed, separated by commas")
    names, quantities = [], []
    for part in parts:
        name, equals, right = (piece.strip() for piece in part.partition("="))
        value = formula(system, right if equals else name, "--coordinates")
        if not equals and value in system.symbols:
            if is_angle(system, value):
                quantities.append(within_a_turn(value, (variables or {}).get(name)))
                name = quantities[-1].name
            names.append(name)
            continue
        names.append(name)
        if not name.isidentifier():
            raise InputError(
                f"--coordinates {text}: the formula {part.strip()} needs a name, as in "
                f"height = {part.strip()}"
            )
        words, unit = meaning(system, name, {**VECTORS, **(variables or {})})
        if equals:
            words, unit = right, "rad" if isinstance(value, ANGLES) else ""
        quantities.append(Quantity(name, value, words, unit or "1"))
    return tuple(names), tuple(quantities), None


def _at_commas(text: str) -> list[str]:
    """Split a text at commas outside brackets."""
    parts, depth = [""], 0
    for letter in text:
        depth += (letter in "([") - (letter in ")]")
        if letter == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += letter
    return parts
