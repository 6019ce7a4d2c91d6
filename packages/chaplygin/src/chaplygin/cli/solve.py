"""``chaplygin solve``: the state at any time, in closed form."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import product
from pathlib import Path
from typing import TYPE_CHECKING

import typer

from .terminal.options import complain, console, inform, print_json, study_of
from .terminal.output_destination import beside, check_figure, check_output, deliver, name_of
from .terminal.progress import progress, waiting

if TYPE_CHECKING:
    from flint import arb

    from nonholonomic.closed_form.base.solution import Solution

    from ..experiment.study import Study

#: Maximum number of printed times, and number of printed times of a longer list.
MANY, FEW = 12, 5
#: Largest value of `--digits`.
MOST_DIGITS = 1000

#: Name, unit, label of a component, and its values at the times.
Row = tuple[str, str, list[str]]


def command(
    what: str,
    at: str | None = None,
    digits: int | None = None,
    output: Path | None = None,
    figure: Path | None = None,
    overrides: list[str] | None = None,
    force: bool = False,
    json: bool = False,
) -> None:
    """Compute the state at any time in closed form; exit 1 if none is known."""
    from flowlanes.errors import InputError

    from ..experiment.formats import check_output as check_trajectory

    moments = None if at is None else _times(at)
    if digits is not None and not 1 <= digits <= MOST_DIGITS:
        raise InputError(f"--digits {digits}: it must be from 1 to {MOST_DIGITS}")
    if output is not None:
        check_output("--output", output, force, json, what, place=check_trajectory)
    if figure is not None:
        check_figure("--figure", figure)
        check_output("--figure", figure, force, json, what)
    study = study_of(what, overrides)
    from nonholonomic.closed_form.base.no_closed_form import NoClosedFormError

    from ..experiment.closed_form import solution_of_study

    if moments is None:
        moments = [Fraction(float(t)) for t in study.times]
    try:
        with waiting("solving"):
            solution = solution_of_study(study)
            # The constants of the form are computed on first use.
            _ = solution.form
    except NoClosedFormError as refused:
        complain(str(refused))
        raise typer.Exit(1) from None
    with beside(output):
        if json:
            print_json(_record(study, solution, moments, digits))
        else:
            _print(study, solution, moments, digits)
    if output is not None:
        _write(study, solution, moments, output, force)
    if figure is not None:
        _draw(study, solution, figure)


def _times(text: str) -> list[Fraction]:
    """Exact times from the text of the user.

    Raises
    ------
    InputError
        If one of them is not a finite number.
    """
    from flowlanes.errors import InputError

    try:
        times = [Fraction(word.strip()) for word in text.split(",")]
        # A time must also be representable as a double.
        _ = [float(time) for time in times]
    except (ValueError, ZeroDivisionError, OverflowError):
        raise InputError(
            f"--at {text}: it must be finite numbers separated by commas, such as 0,1,1e6"
        ) from None
    return times


# --- what is printed -----------------------------------------------------------------------


def _print(study: Study, solution: Solution, moments: list[Fraction], digits: int | None) -> None:
    from rich import box
    from rich.markup import escape
    from rich.table import Table

    from flowlanes.printing.numerals import unit as unit_text

    from ..experiment.closed_form import in_space, letters, number

    form = solution.form
    shown = _moments_shown(moments)
    # Errors must be raised before anything is printed.
    rows = list(_rows(study, solution, shown, digits))
    titles = dict.fromkeys((study.system.title, form.title))
    typer.echo(f"{': '.join(titles)}, {form.source}".rstrip(", "))
    typer.echo(f"{form.motion[:1].upper()}{form.motion[1:]}")
    shown_on = console()
    facts = Table(box=None, pad_edge=False, show_header=False)
    facts.add_column(style="bold", no_wrap=True)
    facts.add_column(no_wrap=True)
    facts.add_column(style="dim")
    for item in form.constants:
        facts.add_row(escape(letters(item.symbol)), number(item), escape(letters(item.meaning)))
    shown_on.print(facts)
    for some in _blocks(shown, rows, shown_on.width):
        table = Table(box=box.SIMPLE_HEAD, pad_edge=False, show_edge=False)
        table.add_column("", style="bold", no_wrap=True)
        table.add_column("", style="dim", no_wrap=True)
        for index in some:
            table.add_column(f"t = {_plain(shown[index])}", justify="right", no_wrap=True)
        for name, unit, values in rows:
            table.add_row(escape(name), escape(unit_text(unit)), *(values[index] for index in some))
        typer.echo()
        shown_on.print(table)
    if study.system.reconstruction is not None and not in_space(study, solution):
        inform("the attitude and the position in space are not part of this closed form")
    out_of_reach = any("nan" in values for _, _, values in rows)
    if solution.not_rigorous and (digits is not None or out_of_reach):
        inform(solution.not_rigorous)
    if len(shown) < len(moments):
        inform(
            f"{len(shown)} of {len(moments)} times are shown; --json prints and -o writes all "
            "of them"
        )


def _moments_shown(moments: list[Fraction]) -> list[Fraction]:
    """All times, or a few of many."""
    if len(moments) <= MANY:
        return moments
    last = len(moments) - 1
    return [moments[round(last * i / (FEW - 1))] for i in range(FEW)]


def _blocks(moments: Sequence[Fraction], rows: Sequence[Row], width: int) -> Iterator[range]:
    """Blocks of times that fit a terminal."""
    head = sum(max(len(row[column]) for row in rows) + 2 for column in (0, 1))
    cells = [len(text) for _, _, values in rows for text in values]
    heads = [len(f"t = {_plain(time)}") for time in moments]
    each = max(cells + heads, default=1) + 2
    count = max(1, (width - head) // each)
    for first in range(0, len(moments), count):
        yield range(first, min(first + count, len(moments)))


def _plain(time: Fraction) -> str:
    """Time in plain notation."""
    return f"{float(time):.15g}"


def _rows(
    study: Study, solution: Solution, moments: Sequence[Fraction], digits: int | None
) -> Iterator[Row]:
    """Quantities at the given times, one row per component."""
    if digits is not None:
        yield from _balls(study, solution, moments, digits)
        return
    from ..experiment.closed_form import closed_form_trajectory, dataset

    variables = dataset(study, closed_form_trajectory(study, solution, _doubles(moments)), solution)
    for name in map(str, variables.data_vars):
        if name == "energy":  # the same as law_energy
            continue
        variable = variables[name]
        unit = "" if variable.units in ("1", "unknown") else str(variable.units)
        label = name.removeprefix("law_")
        if variable.ndim == 1:
            yield label, unit, [_double(x) for x in variable.values]
            continue
        dims = [d for d in variable.dims if d != "time"]
        indices = [
            variables[d].values if d in variables.coords else range(1, variable.sizes[d] + 1)
            for d in dims
        ]
        columns = variable.transpose(*dims, "time").values.reshape(-1, variable.sizes["time"])
        for place, column in zip(product(*indices), columns, strict=True):
            index = "".join(map(str, place))
            yield f"{label}_{index}", unit, [_double(x) for x in column]


def _double(value: float) -> str:
    return f"{value:.12g}"


def _doubles(moments: Sequence[Fraction]) -> list[float]:
    return [float(time) for time in moments]


def _balls(
    study: Study, solution: Solution, moments: Sequence[Fraction], digits: int
) -> Iterator[Row]:
    """State with error bounds."""
    from ..experiment.closed_form import ball, units

    states = list(_rigorous_states(solution, moments, digits))
    unit = units(study, solution)
    for symbol, values in zip(solution.system.symbols, zip(*states, strict=True), strict=True):
        parts = [ball(value, digits) for value in values]
        yield (
            str(symbol),
            unit[symbol],
            [_with_error(middle, radius) for middle, radius in parts],
        )


def _with_error(middle: str, radius: str) -> str:
    if radius == "inf":
        return "left open"
    return middle if radius == "0" else f"{middle} ± {radius}"


def _rigorous_states(
    solution: Solution, moments: Sequence[Fraction], digits: int
) -> Iterator[tuple[arb, ...]]:
    """States with error bounds, with a progress bar, because this takes longest."""
    with progress(f"computing bounds to {digits} digits") as report:
        for count, time in enumerate(moments):
            if count:
                report(count / len(moments))
            yield solution.rigorous(time, digits)


# --- what other programs read --------------------------------------------------------------


def _record(
    study: Study, solution: Solution, moments: list[Fraction], digits: int | None
) -> dict[str, object]:
    from ..experiment.closed_form import ball, equation

    form = solution.form
    values = []
    for figure in form.constants:
        middle, radius = ball(figure.value, digits or 17)
        values.append(
            {
                "symbol": figure.symbol,
                "value": middle,
                "error": radius,
                "meaning": figure.meaning,
                "unit": figure.unit,
            }
        )
    return {
        "system": study.system.name,
        "title": form.title,
        "motion": form.motion,
        "equations": [equation(left, right) for left, right in form.equations],
        "figures": values,
        "ovals": [list(oval) for oval in form.ovals],
        "source": form.source,
        "states": list(_states(study, solution, moments, digits)),
    }


def _states(
    study: Study, solution: Solution, moments: list[Fraction], digits: int | None
) -> Iterator[dict[str, object]]:
    """Objects for all times, with the variables by name."""
    if digits is not None:
        from ..experiment.closed_form import ball

        names = [str(symbol) for symbol in solution.system.symbols]
        for time, state in zip(moments, _rigorous_states(solution, moments, digits), strict=True):
            balls = [ball(value, digits) for value in state]
            parts = [{"value": middle, "error": radius} for middle, radius in balls]
            yield {"time": float(time), **dict(zip(names, parts, strict=True))}
        return
    from ..experiment.closed_form import closed_form_trajectory, dataset

    variables = dataset(study, closed_form_trajectory(study, solution, _doubles(moments)), solution)
    for index, time in enumerate(moments):
        at = variables.isel(time=index)
        yield {
            "time": float(time),
            **{str(name): at[name].values.tolist() for name in variables.data_vars},
        }


def _write(
    study: Study, solution: Solution, moments: list[Fraction], output: Path, force: bool
) -> None:
    from ..experiment.closed_form import closed_form_trajectory, dataset

    trajectory = closed_form_trajectory(study, solution, _doubles(moments))
    deliver(dataset(study, trajectory, solution), output, force)
    inform(f"written to {name_of(output)}")


def _draw(study: Study, solution: Solution, path: Path) -> None:
    from ..report.figures import save
    from ..report.figures.closed_form import closed_form

    save(closed_form(study.system.title, solution.form), path)
    inform(f"figure: {path}")
