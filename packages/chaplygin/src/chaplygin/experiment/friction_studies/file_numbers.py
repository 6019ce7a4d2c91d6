"""The numbers of an experiment file by name, so that they can be varied."""

from __future__ import annotations

import copy
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any, TypeAlias

from flowlanes.errors import InputError
from flowlanes.parsing import nearest
from flowlanes.system.arrays import FloatArray

from ..models.rolling_model import FrictionExperiment

#: Tables, keys and the array index, from the outside in.
Path: TypeAlias = tuple[str | int, ...]

#: Labels of the components of a quaternion; those of a vector are 1, 2, 3.
_QUATERNION = ("w", "x", "y", "z")

#: Units of keys.
_UNITS = {
    "mass": "kg",
    "inertia": "kg m^2",
    "gyrostat": "kg m^2/s",
    "radius": "m",
    "tube": "m",
    "axes": "m",
    "centre": "m",
    "turn": "rad",
    "heading": "rad",
    "turntable": "rad/s",
    "spin_arm": "m",
    "patch": "m",
    "viscous": "kg/s",
    "spin_viscous": "kg m^2/s",
    "rolling": "m",
    "rolling_viscous": "m s",
    "air": "Pa s",
    "gravity": "m/s^2",
    "omega": "rad/s",
    "position": "m",
    "velocity": "m/s",
}


@dataclass(frozen=True)
class FileNumbers:
    """The numbers of an experiment with friction that ensembles and charts may vary.

    A number is named by its key, followed by the index in a vector: ``mu``, ``omega_3``,
    ``attitude_w``; if two tables have the key, by table and key, as in ``surface.radius``.

    Parameters
    ----------
    experiment : FrictionExperiment

    Examples
    --------
    >>> import chaplygin as ch
    >>> from chaplygin.experiment.friction_studies.file_numbers import FileNumbers
    >>> experiment = ch.parse_experiment('''
    ... body = {mass = 1, inertia = [0.4, 0.4, 0.4], shape = {kind = "ball", radius = 1}}
    ... contact = {model = "friction", mu = 0.3}
    ... start = {gamma = [0, 0, 1], omega = [0, 0, 1]}
    ... ''')
    >>> numbers = FileNumbers(experiment)
    >>> numbers.path("omega_3"), numbers.value("contact.mu")
    (('start', 'omega', 2), 0.3)
    """

    experiment: FrictionExperiment

    @cached_property
    def _tables(self) -> dict[str, Any]:
        tables = self.experiment.model_dump()
        start = tables["start"]
        if start["gamma"] is not None and start["slip"] is None:
            start["slip"] = (0.0, 0.0, 0.0)
        return tables

    @cached_property
    def _paths(self) -> dict[str, list[Path]]:
        """Paths by short and by full name."""
        paths: dict[str, list[Path]] = {}
        for table in ("body", "surface", "contact", "field", "start"):
            self._collect((table,), self._tables[table], paths)
        return paths

    def _collect(self, path: Path, value: object, paths: dict[str, list[Path]]) -> None:
        if isinstance(value, dict):
            for key, inner in value.items():
                self._collect((*path, key), inner, paths)
        elif isinstance(value, list | tuple):
            labels = _QUATERNION if len(value) == 4 else tuple(map(str, range(1, 10)))
            for place, (label, inner) in enumerate(zip(labels, value, strict=False)):
                if isinstance(inner, float | int):
                    self._name((*path, place), f"_{label}", paths)
        elif (isinstance(value, float | int) and not isinstance(value, bool)) or (
            value is None and path[0] == "contact" and path[-1] not in ("force", "couple")
        ):
            self._name(path, "", paths)

    def _name(self, path: Path, label: str, paths: dict[str, list[Path]]) -> None:
        keys = [key for key in path if isinstance(key, str)]
        for name in {keys[-1] + label, ".".join(keys) + label}:
            paths.setdefault(name, []).append(path)

    def path(self, name: str) -> Path:
        """The path of a number in the file.

        Raises
        ------
        InputError
            If no number or several have the name.
        """
        paths = self._paths.get(name, [])
        if len(paths) == 1:
            return paths[0]
        if paths:
            full = [n for n, p in self._paths.items() if "." in n and p[0] in paths]
            raise InputError(f"{name}: several numbers have this name; write {' or '.join(full)}")
        short = [known for known in self._paths if "." not in known]
        raise InputError(
            f"{name}: the experiment has no number of this name{nearest(name, short)}; a number is "
            "named by its key, such as mu or omega_3"
        )

    def values_by_name(self) -> dict[str, float]:
        """All numbers with a unique name, with their values."""
        return {
            name: value
            for name, paths in self._paths.items()
            if len(paths) == 1 and (value := self.value(name)) is not None and "." not in name
        }

    def value(self, name: str) -> float | None:
        """The number in the file; None if it is omitted."""
        value: Any = self._tables
        for part in self.path(name):
            value = value[part]
        return None if value is None else float(value)

    def meaning(self, name: str) -> tuple[str, str]:
        """Table and key of a number, and its unit."""
        path = self.path(name)
        keys = [part for part in path if isinstance(part, str)]
        unit = _UNITS.get(keys[-1], "")
        if keys[-1] == "slip":
            unit = "m/s" if keys[0] == "start" else "s/m"
        label = name.rpartition("_")[2] if isinstance(path[-1], int) else ""
        return f"{'.'.join(keys)}{label and f', component {label}'}", unit

    def tables_with(self, values: Mapping[str, float | FloatArray]) -> dict[str, Any]:
        """The tables of the experiment with other numbers; a vector may be given as a whole."""
        tables = copy.deepcopy(self._tables)
        for name, value in values.items():
            if name in ("gamma", "attitude"):
                tables["start"][name] = tuple(map(float, value))  # type: ignore[arg-type]
                continue
            *outer, last = self.path(name)
            table: Any = tables
            owner, key = None, None
            for part in outer:
                owner, key, table = table, part, table[part]
            if isinstance(last, int):
                numbers = list(table)
                numbers[last] = float(value)
                owner[key] = tuple(numbers)  # type: ignore[index]
            else:
                table[last] = float(value)
        return tables
