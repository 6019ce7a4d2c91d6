"""The data of a study in a page, as JSON; the types are those of ``web/src/model.ts``."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
import xarray as xr

from flowlanes.errors import InputError
from flowlanes.flow.variable_metadata import variable_metadata
from flowlanes.formulas.array_evaluation import values
from flowlanes.printing.formula import latex
from flowlanes.printing.mathml import mathml
from flowlanes.printing.system import law_latex
from flowlanes.system.arrays import FloatArray
from flowlanes.system.system import Parameter, System
from lawproof.proof.verdict import Verdict
from nonholonomic.mechanics.conventions import FRAMES

from ..experiment.contact.mode_intervals import mode_intervals
from ..experiment.section_coordinates import is_angle
from ..experiment.study import Study
from .columns import Column, Scalar, columns_of, scalars_of, symbol_mathml
from .encoding import deflate, doubles
from .page_start import start_inputs
from .page_systems import reduced_system
from .scene_model import Json, scene_model
from .sections import section_choice, sectionable
from .slider_range import parameter_range
from .wasm_module import SECTION_TOLERANCE, TOLERANCE, page_module

#: Maximum number of samples of a motion in a page.
MOST_SAMPLES = 1201


def page_model(
    study: Study,
    dataset: xr.Dataset | None = None,
    verdicts: Mapping[str, Verdict] | None = None,
) -> dict[str, Json]:
    """The model of a page without a module, which shows the motion of a dataset, if there is one.

    Parameters
    ----------
    study : Study
    dataset : xarray.Dataset, optional
        The motion, as returned by :func:`chaplygin.experiment.study.dataset_of`.
    verdicts : mapping of str to Verdict, optional
        Verdicts on the laws, by name.

    Returns
    -------
    dict
        Data for :func:`json.dumps`; see ``packages/chaplygin/web/src/model.ts``.

    Raises
    ------
    InputError
        If the start is not admissible.

    Examples
    --------
    >>> import chaplygin as ch
    >>> study = ch.Study.from_experiment(ch.parse_experiment('system = {name = "veselova"}'))
    >>> model = page_model(study)
    >>> model["title"], model["reduced"], [column["name"] for column in model["columns"]][:3]
    ('Veselova system', 6, ['omega', 'gamma', 'spin_torque'])
    """
    reduced = reduced_system(study)
    if study.subject.changes_equations:
        columns = () if dataset is None else columns_of_dataset(dataset)
        formulas = _NO_FORMULAS
    else:
        columns = columns_of(study)
        formulas = _formulas(study, reduced, verdicts or {})
    run = study.experiment.run
    return {
        **formulas,
        "format": 1,
        "name": study.system.name,
        "title": study.system.title,
        "kind": study.subject.kind,
        "experiment": study.complete_toml(),
        "reduced": len(study.system.symbols),
        "direction": -1 if run.direction == "backward" else 1,
        "until": study.until,
        "samples": min(run.samples, MOST_SAMPLES),
        "tolerance": TOLERANCE,
        "section_tolerance": SECTION_TOLERANCE,
        "columns": [
            {
                "name": column.name,
                "width": len(column.formulas),
                "axes": column.axes,
                "unit": column.unit,
                "meaning": column.meaning,
                "mathml": column.mathml,
            }
            for column in columns
        ],
        "guards": [{"message": guard.message} for guard in reduced.guards],
        "bifurcation": None,
        "scene": scene_model(study, columns, dataset),
        "recorded": None if dataset is None else motion_record(study, columns, dataset),
        "wasm": None,
        "wasm_tables": None,
    }


def live_page_model(
    study: Study,
    dataset: xr.Dataset | None = None,
    verdicts: Mapping[str, Verdict] | None = None,
) -> dict[str, Json]:
    """The model of a page with a module, which computes motions itself and needs no dataset.

    Parameters
    ----------
    study, dataset, verdicts
        See :func:`page_model`.

    Raises
    ------
    InputError
        If the start is not admissible, or the page cannot compute; see
        :func:`chaplygin.page.wasm_module.page_module`.
    """
    module = page_module(study)
    computing: dict[str, Json] = {
        "wasm": deflate(module.code),
        "wasm_tables": module.tables,
    }
    return page_model(study, dataset, verdicts) | computing


#: Formulas of a motion through several modes, which has no single system of equations.
_NO_FORMULAS: dict[str, Json] = {
    "state": [],
    "parameters": [],
    "start": [],
    "start_inputs": [],
    "laws": [],
    "quantities": [],
    "section": None,
}


def _formulas(study: Study, reduced: System, verdicts: Mapping[str, Verdict]) -> dict[str, Json]:
    """State, parameters, laws and quantities of a page, as formulas."""
    scalars = scalars_of(study, reduced)
    whole = study.system.lifted() if study.system.reconstruction else study.system
    return {
        "state": _state(study, whole),
        "parameters": [_parameter(p, study) for p in study.system.parameters],
        "start": [float(x) for x in study.start],
        "start_inputs": start_inputs(study),
        "laws": _laws(study, verdicts),
        "quantities": [_quantity(scalar) for scalar in scalars],
        "section": section_choice(study, reduced, sectionable(reduced, scalars)),
    }


def _state(study: Study, whole: System) -> list[Json]:
    rows: list[Json] = []
    for variable in whole.state:
        symbols = getattr(variable, "symbols", (variable,))
        meaning, unit, _, _ = variable_metadata(
            whole, str(variable), len(symbols), study.variables.get(str(variable))
        )
        rows += [
            {
                "name": str(symbol),
                "mathml": symbol_mathml(str(symbol)),
                "unit": unit or "1",
                "meaning": meaning,
                "angle": len(symbols) == 1 and is_angle(whole, symbol),
            }
            for symbol in symbols
        ]
    return rows


def _parameter(parameter: Parameter, study: Study) -> Json:
    low, high = parameter_range(parameter, study.system)
    return {
        "name": str(parameter.symbol),
        "mathml": mathml(latex(parameter.symbol)),
        "meaning": parameter.meaning,
        "unit": parameter.unit or "1",
        "value": float(parameter.default),
        "low": low,
        "high": high,
    }


def _laws(study: Study, verdicts: Mapping[str, Verdict]) -> list[Json]:
    observed = {law.name for law in study.system_on_level.integrals}
    return [
        {
            "name": law.name,
            "meaning": str(getattr(law, "meaning", "")),
            "unit": str(getattr(law, "unit", "")) or "1",
            "column": f"law_{law.name}" if law.name in observed else None,
            "mathml": mathml(law_latex(law, study.system)),
            "verdict": verdicts[law.name].statement if law.name in verdicts else "not tried",
            "source": law.source,
            "text": verdicts[law.name].words if law.name in verdicts else "",
        }
        for law in study.system.laws
    ]


def _quantity(scalar: Scalar) -> Json:
    return {
        "name": scalar.name,
        "formula": scalar.text,
        "mathml": scalar.mathml,
        "unit": scalar.unit,
        "meaning": scalar.meaning,
        "angle": scalar.angle,
    }


# --- the recorded motion -----------------------------------------------------------------------


def columns_of_dataset(dataset: xr.Dataset) -> tuple[Column, ...]:
    """The columns of a motion through several modes, without formulas."""
    frames = {dimension: frame for frame, (dimension, _) in FRAMES.items()}
    columns = []
    for name, variable in dataset.data_vars.items():
        if variable.dims[:1] != ("time",) or not np.issubdtype(variable.dtype, np.number):
            continue
        width = int(np.prod(variable.shape[1:]))
        axes = str(variable.dims[-1]) if len(variable.dims) > 1 else ""
        notes = variable.attrs
        columns.append(
            Column(
                str(name),
                (np.nan,) * width,
                frames.get(axes, axes),
                str(notes.get("units", "1")),
                str(notes.get("long_name", "")),
                symbol_mathml(str(name), width),
            )
        )
    return tuple(columns)


def motion_record(study: Study, columns: Sequence[Column], dataset: xr.Dataset) -> dict[str, Json]:
    """A motion as stored in a page; a long one is subsampled evenly."""
    size = dataset.sizes["time"]
    chosen = np.unique(np.linspace(0, size - 1, min(size, MOST_SAMPLES)).round().astype(int))
    part = dataset.isel(time=chosen)
    written: dict[str, Json] = {}
    for column in columns:
        if column.name in part:
            numbers = np.asarray(part[column.name].transpose("time", ...).to_numpy(), np.float64)
        else:
            numbers = _column_from_state(study, column, part)
        written[column.name] = doubles(numbers)
    complete = bool(dataset.attrs.get("complete", 1))
    events = str(dataset.attrs.get("events", "")).splitlines()
    end: Json = None
    last = float(dataset["time"][-1])
    if not complete or abs(last) < study.until:
        end = {"time": last, "reason": events[-1] if events else "the integration failed"}
    return {
        "times": doubles(part["time"].to_numpy()),
        "columns": written,
        "modes": _modes(dataset),
        "events": _events(dataset),
        "end": end,
    }


def _modes(dataset: xr.Dataset) -> list[dict[str, Json]]:
    """The intervals between mode changes of a contact; empty if there are no modes."""
    intervals = mode_intervals(dataset) if "mode" in dataset else []
    return [{"mode": i.mode, "begin": i.begin, "end": i.end} for i in intervals]


def _events(dataset: xr.Dataset) -> list[dict[str, Json]]:
    """The changes of a contact by name; empty if there are no modes."""
    if "mode" not in dataset:
        return []
    kinds = map(str, dataset["event_kind"].values)
    times = map(float, dataset["event_time"].values)
    return [{"kind": kind, "time": time} for kind, time in zip(kinds, times, strict=True)]


def _column_from_state(study: Study, column: Column, dataset: xr.Dataset) -> FloatArray:
    """A column that is not in the dataset, computed from the state."""
    whole = study.system.lifted() if study.system.reconstruction else study.system
    parts = []
    for variable in map(str, whole.state):
        if variable == "place":
            block = dataset["centre"].to_numpy()[:, :2]
        elif variable in dataset:
            block = dataset[variable].transpose("time", ...).to_numpy()
        else:
            raise InputError(f"the dataset has no {variable}, which {column.name} needs")
        parts.append(np.asarray(block, np.float64).reshape(len(block), -1))
    return values(whole, column.formulas, np.concatenate(parts, axis=1))
