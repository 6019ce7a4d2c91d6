"""The experiment file, the common input of the command line and Python.

A TOML file describes a body that rolls on a plane or a sphere (`RollingExperiment`) or touches one
with friction (`FrictionExperiment`), a homogeneous ball that rolls on any other surface
(`BallExperiment`), a system of the catalogue, or a user-defined system, by its Lagrangian
(`MechanismExperiment`) or by its equations (`EquationsExperiment`).  It also gives a start and the
computation of the motion.  Most systems of the catalogue are bodies whose start is given by ω and γ
(`SystemExperiment`); for any other system the start gives the state by the names of its variables
(`StateExperiment`).  Keys, their meaning, units and frames are described in the modules `tables`,
`body_tables`, `contact_tables`, `ball_tables` and `mechanism_tables`.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from pydantic import ValidationError

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError, nearest
from flowlanes.files.partial_files import require_file_name
from nonholonomic.system_files.bodies import BodyFile, is_ball_file
from nonholonomic.system_files.source import Source
from nonholonomic.system_files.sourced import mistakes
from nonholonomic.system_files.table import Table
from nonholonomic.system_files.toml import Key, Tables
from nonholonomic.system_files.validation import validation_messages

from ..file.tables import OF_A_DIMENSION
from .ball_model import BallExperiment
from .catalogue_models import StateExperiment, SystemExperiment
from .described_models import EquationsExperiment, MechanismExperiment
from .rolling_model import FrictionExperiment, RollingExperiment

if TYPE_CHECKING:
    from nonholonomic.catalogue import Entry

#: Tables that describe a system by themselves.
DESCRIPTION_TABLES = ("lagrangian", "equations")


Experiment = (
    RollingExperiment
    | FrictionExperiment
    | BallExperiment
    | SystemExperiment
    | StateExperiment
    | MechanismExperiment
    | EquationsExperiment
)
"""Any kind of experiment; ``isinstance`` tells which."""

#: Maximum size of a file: a table of ten thousand numbers has 0.2 MB; reading ten times as much
#: takes seconds.
_MOST_BYTES = 2_000_000


@arguments_checked
def load_experiment(source: str | Path, overrides: Iterable[str] = ()) -> Experiment:
    """Read an experiment file.

    Parameters
    ----------
    source
        Path of the file, or the text itself if it is a str with more than one line.
    overrides
        Options ``KEY=VALUE`` that replace or add keys, such as ``"start.omega=[1, 0, 0]"``; the
        value is a TOML value or a word without quotes.

    Returns
    -------
    Experiment
        The experiment, of the kind described by its tables.

    Raises
    ------
    InputError
        If the file cannot be read, or for all that is wrong in it: one line for each mistake
        with file, line, key and what is allowed.

    Examples
    --------
    >>> import chaplygin as ch
    >>> from pathlib import Path
    >>> from tempfile import TemporaryDirectory
    >>> with TemporaryDirectory() as folder:
    ...     path = Path(folder, "veselova.toml")
    ...     _ = path.write_text('system = {name = "veselova"}')
    ...     experiment = ch.load_experiment(path, overrides=["run.samples=11"])
    >>> experiment.run.samples
    11
    """
    if isinstance(source, str) and "\n" in source:
        return parse_experiment(source, overrides=overrides)
    name = str(source)
    if not name.strip():
        raise InputError("the path is empty; it must be that of an experiment file, or its text")
    require_file_name(Path(source))
    try:
        with Path(source).open("rb") as file:
            content = file.read(_MOST_BYTES + 1)
        # A byte order mark, which some editors write, is not part of the text.
        text = content.decode("utf-8-sig") if len(content) <= _MOST_BYTES else ""
    except FileNotFoundError:
        raise InputError("there is no such file", name) from None
    except IsADirectoryError:
        raise InputError("this is a directory, not an experiment file", name) from None
    except UnicodeDecodeError as error:
        message = f"byte {error.start + 1} is not UTF-8 text; an experiment file is a text file"
        raise InputError(message, name) from None
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) else str(error)
        raise InputError(f"the file cannot be read: {reason}", repr(name)) from None
    if len(content) > _MOST_BYTES:
        message = f"more than {_MOST_BYTES // 1_000_000} MB: an experiment file is far smaller"
        raise InputError(message, name)
    return parse_experiment(text, name, overrides)


@arguments_checked
def parse_experiment(text: str, name: str = "<text>", overrides: Iterable[str] = ()) -> Experiment:
    """Read the text of an experiment file.

    Parameters
    ----------
    text
        The TOML text.
    name
        Name of the text in error messages.
    overrides
        As for `load`.

    Returns
    -------
    Experiment
        The experiment, of the kind described by its tables.

    Raises
    ------
    InputError
        For all that is wrong in it, as `load` does.

    Examples
    --------
    >>> import chaplygin as ch
    >>> experiment = ch.parse_experiment('''
    ... system = {name = "veselova"}
    ... run = {until = 5.0}
    ... ''')
    >>> experiment.run.until, experiment.run.precision
    (5.0, 'double')
    """
    return _read(Source(name, text, tuple(overrides)))


def catalogue_experiment(name: str, overrides: Iterable[str] = ()) -> Experiment:
    """The default experiment of a system of the catalogue.

    Parameters
    ----------
    name
        Name of the system.
    overrides
        As for `load`.

    Raises
    ------
    InputError
        If there is no such system, or for all that is wrong in the overrides.
    """
    from nonholonomic.catalogue import entry

    tables = {"system": {"name": entry(name).name}}
    return _read(Source(name, "", tuple(overrides), tables))


def _read(source: Source) -> Experiment:
    """Read the experiment of a source; raises InputError that lists all mistakes."""
    source = replace(source, short=_short(source))
    tables = source.tables()
    _check_one_description(tables, source)
    model = _model(tables)
    wrong = _decided_by_system(tables) if "system" in tables else {}
    wrong |= _no_keys(tables, model, source)
    accepted = {key: table for key, table in tables.items() if (key,) not in wrong}
    try:
        experiment = model.of_tables(accepted)
    except ValidationError as error:
        wrong |= validation_messages(error, model, accepted)
    if wrong := _first_the_contact(wrong, model):
        raise mistakes(wrong, source)
    experiment._source = source
    return experiment


#: The tables with parameters of a system, besides those of the catalogue.
_PARAMETERS: tuple[Key, ...] = (
    ("parameters",),
    ("body", "shape", "parameters"),
    ("surface", "parameters"),
    ("field", "parameters"),
)


def _short(source: Source) -> dict[str, Key]:
    """The full paths of parameters by their names, which an option may use alone."""
    with_tables = tuple(option for option in source.overrides if "." in option.partition("=")[0])
    tables = replace(source, overrides=with_tables).tables()
    paths: dict[str, Key] = {}
    for place in _PARAMETERS:
        table: object = tables
        for part in place:
            table = table.get(part) if isinstance(table, dict) else None
        if isinstance(table, dict):
            paths |= {name: (*place, name) for name in table}
    if (item := _item(tables)) is not None:
        names = [*item.defaults, *(OF_A_DIMENSION if item.family else ())]
        paths |= {name: ("system", "parameters", name) for name in names}
    return paths


def _no_keys(tables: Tables, model: type[Experiment], source: Source) -> dict[Key, str]:
    """Mistakes in options without a table that name neither a key nor a parameter."""
    wrong: dict[Key, str] = {}
    for option in source.overrides:
        (name, *below), value = source.path(option), option.partition("=")[2].strip()
        if below or name in model.model_fields or name not in tables:
            continue
        tables_with = [
            table
            for table, field in model.model_fields.items()
            if isinstance(field.annotation, type)
            and issubclass(field.annotation, Table)
            and name in field.annotation.model_fields
        ]
        wrong[(name,)] = (
            f"unknown key; a key is written with its table: --set {tables_with[0]}.{name}={value}"
            if tables_with
            else f"unknown key{nearest(name, (*model.model_fields, *source.short))}"
        )
    return wrong


def _item(tables: Tables) -> Entry | None:
    """The catalogue entry that tables name, if it exists."""
    table = tables.get("system")
    name = table.get("name") if isinstance(table, dict) else None
    if not isinstance(name, str):
        return None
    # Importing the systems is slow, and a file with its own body does not need them.
    from nonholonomic.catalogue import CATALOGUE

    return CATALOGUE.get(name)


def _model(tables: Tables) -> type[Experiment]:
    """The kind of experiment that these tables describe."""
    if "system" not in tables:
        return _own_model(tables)
    item = _item(tables)
    return StateExperiment if item and item.start.state is not None else SystemExperiment


def _check_one_description(tables: Tables, source: Source) -> None:
    """Raise an error for a Lagrangian or equations beside another description of the system."""
    first, *others = [n for n in (*DESCRIPTION_TABLES, "system", "body") if n in tables] or [""]
    if first in DESCRIPTION_TABLES and others:
        where = source.where((others[0],))
        raise InputError(f"must be absent, as [{first}] says already what moves", where)


def _own_model(tables: Tables) -> type[Experiment]:
    """The kind of experiment described by tables without a catalogue system."""
    if "equations" in tables:
        return EquationsExperiment
    if "body" not in tables and tables.keys() & {"frame", "lagrangian", "constraints"}:
        return MechanismExperiment
    if _means_friction(tables):
        return FrictionExperiment
    return BallExperiment if is_ball_file(tables) else RollingExperiment


def _means_friction(tables: Tables) -> bool:
    contact = tables.get("contact")
    return isinstance(contact, dict) and contact.get("model") == "friction"


def _first_the_contact(wrong: dict[Key, str], model: type[Experiment]) -> dict[Key, str]:
    """The mistakes without those that another contact model might resolve."""
    of_contact = wrong.keys() & {("contact",), ("contact", "model")}
    if not of_contact or model not in (RollingExperiment, BallExperiment):
        return wrong
    depending = ("contact", "surface", "start", "run")
    # With friction any body may start at a given position.
    of_a_ball = model is BallExperiment
    return {
        key: text
        for key, text in wrong.items()
        if key in of_contact or not (key[0] in depending or (key == ("body",) and of_a_ball))
    }


def _decided_by_system(tables: Tables) -> dict[Key, str]:
    """The tables that are not allowed beside [system]."""
    mechanical = RollingExperiment.model_fields.keys() - BodyFile.model_fields.keys()
    decided = [
        name for name in RollingExperiment.model_fields if name in mechanical & tables.keys()
    ]
    return {
        (name,): f"must be absent, as the table [system] decides the {name}"
        for name in decided
        if name not in SystemExperiment.model_fields
    }
