"""Load a system defined by a Python file of the user.

The file is executed, as the user asked for it.  It defines ``mechanism`` (a Mechanism), ``system``
(a System) or ``study`` (a Study), and optionally ``start`` and ``run``, mappings with the keys of
the tables of the same names, and ``plan`` (a Plan), the drawing in the plane.  Code guarded by
``__name__ == "__main__"`` is not executed.
"""

from __future__ import annotations

import itertools
import runpy
import sys
import traceback
from collections.abc import Iterable, Mapping
from dataclasses import replace
from pathlib import Path
from types import TracebackType
from typing import Any

from pydantic import ValidationError

from flowlanes.errors import InputError
from flowlanes.parsing import nearest
from flowlanes.system.system import Parameter, System
from nonholonomic.mechanics.lagrangian.mechanism import Mechanism
from nonholonomic.mechanics.lagrangian.plan import Plan, plan_of
from nonholonomic.mechanics.lagrangian.poincare_suslov import equations_of_motion
from nonholonomic.system_files.source import Source
from nonholonomic.system_files.toml import Key, Tables
from nonholonomic.system_files.validation import validation_messages, value_text
from nonholonomic.system_files.write import plan_table_of, tables_of, writable_laws

from .models.described_models import EquationsExperiment
from .study import Study
from .subjects.described_system import described_subject
from .subjects.initial_state import lift_of

_SYSTEMS: Mapping[str, type] = {"mechanism": Mechanism, "system": System, "study": Study}
_KINDS: Mapping[str, type] = {**_SYSTEMS, "plan": Plan}
_CHANGEABLE = ("parameters", "run", "start", "title")

#: Maximum number of numbers in a value, and maximum nesting of lists.
_MOST, _DEEPEST = 1000, 3


def load_python(path: Path, overrides: Iterable[str] = ()) -> Study:
    """Execute a Python file and return the study that it defines.

    Parameters
    ----------
    path : Path
    overrides : iterable of str
        Options ``KEY=VALUE``, for keys of ``parameters``, ``start``, ``run`` and the ``title``.

    Raises
    ------
    InputError
        If the file is missing, fails (with its line), or does not define a system.
    """
    definitions = _definitions(path)
    options = tuple(overrides)
    if "study" in definitions:
        if options:
            raise InputError(
                "a study made in Python cannot be changed by --set or --precision", str(path)
            )
        study: Study = definitions["study"]
        return study
    mechanism: Mechanism | None = definitions.get("mechanism")
    with _PlacingErrors(path):
        system: System = definitions.get("system") or equations_of_motion(definitions["mechanism"])
        tables: dict[str, Any] = tables_of(writable_laws(system))
        plan = definitions.get("plan") or (plan_of(mechanism) if mechanism else None)
        if plan is not None:
            tables["plan"] = plan_table_of(plan)
    short = {name: ("parameters", name) for name in tables["parameters"]}
    source = Source(str(path), "", options, short=short)
    text: dict[str, Any] = source.tables()
    for name in text:
        if name not in _CHANGEABLE:
            allowed = nearest(name, (*_CHANGEABLE, *short))
            raise InputError(f"a Python file decides this itself{allowed}", source.where((name,)))
    for name in ("start", "run"):
        with _PlacingErrors(path):
            values = _plain(definitions.get(name, {}), name)
        tables[name] = values | text.get(name, {})
    tables["start"] = lift_of(system, tables["start"]) | tables["start"]
    _change_parameters(tables, text.get("parameters", {}), source)
    tables |= {key: value for key, value in text.items() if key == "title"}
    experiment = _experiment(tables, source)
    parameters = tuple(_with_value(experiment, parameter) for parameter in system.parameters)
    system = replace(system, title=experiment.title or system.title, parameters=parameters)
    return Study(experiment, described_subject(experiment, system, mechanism))


def _with_value(experiment: EquationsExperiment, parameter: Parameter) -> Parameter:
    """A parameter with the value given by the experiment."""
    name = str(parameter.symbol)
    value = experiment.parameters[name].value
    if not isinstance(value, float):
        where = experiment.where("parameters", name)
        raise InputError(f"must be a finite number, not {value_text(value)}", where)
    return replace(parameter, default=value)


class _PlacingErrors:
    """Reports errors in the user's code with file and line, in one sentence."""

    def __init__(self, path: Path) -> None:
        self.path = path

    def __enter__(self) -> None:
        return None

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        if not isinstance(error, Exception | SystemExit):
            return
        lines = [f.lineno for f in traceback.extract_tb(trace) if Path(f.filename) == self.path]
        if isinstance(error, SyntaxError) and Path(error.filename or "") == self.path:
            lines, words = [error.lineno], f"not valid Python: {error.msg}"
        elif isinstance(error, InputError):
            words = str(error)
        elif isinstance(error, SystemExit):
            words = "the file ends the program before it has defined a system"
        else:
            words = f"{type(error).__name__}: {' '.join(_message(error).split())}".removesuffix(
                ": "
            )
        place = f"{self.path}, line {lines[-1]}" if lines else str(self.path)
        raise InputError(words, place) from None


def _message(error: BaseException) -> str:
    """The message of an exception of the user's code; empty if printing it fails."""
    try:
        return str(error)
    except Exception:
        return ""


def _definitions(path: Path) -> dict[str, Any]:
    """The mechanism, system, study, plan, start and run defined by the file."""
    if not path.is_file():
        raise InputError("there is no such file", str(path))
    folder = str(path.parent)
    sys.path.insert(0, folder)
    try:
        with _PlacingErrors(path):
            names = runpy.run_path(str(path), run_name="<chaplygin>")
    finally:
        sys.path.remove(folder)
    definitions = {name: names[name] for name in (*_KINDS, "start", "run") if name in names}
    for name, kind in _KINDS.items():
        if name in definitions and not isinstance(definitions[name], kind):
            raise InputError(
                f"{name} must be a {kind.__name__}, not {type(definitions[name]).__name__}",
                str(path),
            )
    if not definitions.keys() & _SYSTEMS.keys():
        raise InputError("it must define mechanism, system or study", str(path))
    return definitions


def _plain(table: object, name: str) -> Tables:
    """A mapping of the file with names as keys and plain numbers as values."""
    if not isinstance(table, Mapping):
        raise InputError(f"{name} must be a mapping, not {type(table).__name__}")
    return {str(key): _number(value, f"{name}: {key}") for key, value in table.items()}


def _number(value: object, name: str, depth: int = 0) -> object:
    """Numbers of any library converted to TOML types; texts and booleans are unchanged."""
    if isinstance(value, str | bool | int | float):
        return value
    if not hasattr(value, "__iter__"):
        return float(value) if hasattr(value, "__float__") else value
    parts = list(itertools.islice(value, _MOST + 1))
    if len(parts) > _MOST or depth > _DEEPEST:
        raise InputError(f"{name} must be a finite number, or a few of them in a list")
    return [_number(part, name, depth + 1) for part in parts]


def _change_parameters(tables: dict[str, Any], text: object, source: Source) -> None:
    if not isinstance(text, Mapping):
        raise InputError(f"must be a table, not {value_text(text)}", source.where(("parameters",)))
    for name, value in text.items():
        if name not in tables["parameters"]:
            allowed = nearest(name, tables["parameters"])
            raise InputError(f"unknown parameter{allowed}", source.where(("parameters", name)))
        tables["parameters"][name]["value"] = value


def _experiment(tables: Tables, source: Source) -> EquationsExperiment:
    try:
        experiment = EquationsExperiment.model_validate(tables)
    except ValidationError as error:
        wrong: dict[Key, str] = validation_messages(error, EquationsExperiment, tables)
        lines = (f"{source.where(key)}: {sentence}" for key, sentence in wrong.items())
        raise InputError("\n".join(lines)) from None
    experiment._source = source
    return experiment
