"""``chaplygin bifurcation``: which tori there are over the plane of two integrals."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from .terminal.options import Force, Json, Override, inform, print_json, study_of
from .terminal.output_destination import check_figure, check_output
from .terminal.progress import waiting

if TYPE_CHECKING:
    from ..explicit.bifurcation import Diagram


def command(
    what: Annotated[
        str,
        typer.Argument(
            metavar="NAME|FILE",
            help="A catalogue name, an experiment file, or a plane listed in docs/bifurcations.md.",
        ),
    ],
    figure: Annotated[
        Path | None,
        typer.Option(
            "-o", "--output", metavar="FILE.png", help="Figure to write: .png, .svg or .pdf."
        ),
    ] = None,
    overrides: Override = None,
    force: Force = False,
    json: Json = False,
) -> None:
    """Compute the bifurcation diagram of an integrable system exactly, and locate the motion in it.

    In the plane of two integrals: every region with its number of tori, and every
    boundary with the motions on it, stable or unstable.
    """
    if figure is not None:
        check_figure("--output", figure)
        check_output("--output", figure, force, json, what)
    with waiting(f"computing the diagram of {what}"):
        diagram, mark = _diagram(what, overrides)
    if figure is not None:
        from ..report.drawing.files import save
        from ..report.figures.bifurcation import draw_bifurcation_diagram

        save(draw_bifurcation_diagram(diagram, mark), figure)
    result = _result(diagram, mark)
    if json:
        print_json(result | {"figure": None if figure is None else str(figure)})
        return
    _print(result)
    if figure is not None:
        inform(f"figure: {figure}")


def _diagram(what: str, overrides: list[str] | None) -> tuple[Diagram, tuple[float, float] | None]:
    """The diagram of an experiment with its motion in it, or that of a plane."""
    from ..errors import InputError
    from ..experiment.single_system import single_system
    from ..explicit.base.problem import Problem
    from ..explicit.bifurcation import bifurcation_diagram
    from ..explicit.bifurcation.families import PLANES
    from ..explicit.bifurcation.motion_diagram import diagram_of_motion

    if what in PLANES:
        return bifurcation_diagram(what, _numbers(overrides or [])), None
    study = study_of(what, overrides)
    system = single_system(study)
    diagram = diagram_of_motion(Problem(system, system.defaults, study.start, study.rolling))
    if diagram is None:
        raise InputError(
            f"no bifurcation diagram of {system.title} is known at this start: its motions do not "
            "separate on a plane of two integrals (docs/bifurcations.md lists those that do)"
        )
    return diagram


def _numbers(overrides: list[str]) -> dict[str, str]:
    """Parameters of a plane, as decimals that are taken at their word."""
    from ..errors import InputError

    numbers = {}
    for text in overrides:
        name, equals, value = (part.strip() for part in text.partition("="))
        try:
            float(value)
        except ValueError:
            equals = ""
        if not equals:
            raise InputError(f"--set {text}: of a plane a parameter is set, such as I_2=1.7")
        numbers[name] = value
    return numbers


def _result(diagram: Diagram, mark: tuple[float, float] | None) -> dict[str, Any]:
    from ..printing.formula import text

    here = None if mark is None else diagram.region(*mark)
    return {
        "title": diagram.plane.title,
        "axes": [
            {"symbol": text(axis.symbol), "meaning": axis.meaning, "unit": axis.unit}
            for axis in diagram.axes
        ],
        "motion": mark,
        "region_of_motion": None if here is None else here.number,
        "regions": [
            {"number": region.number, "tori": region.tori}
            for region in diagram.regions
            if region.number
        ],
        "boundaries": [
            {
                "motions": boundary.words,
                "circles": boundary.circles,
                "stable": boundary.stable,
                "curve": f"{text(boundary.curve)} = 0",
            }
            for boundary in diagram.boundaries
        ],
        "equilibria": [
            {
                "place": [float(x) for x in equilibrium.place],
                "axis": equilibrium.axis,
                "stable": equilibrium.centres == 2,
            }
            for equilibrium in diagram.equilibria
        ],
    }


def _print(result: dict[str, Any]) -> None:
    typer.echo(result["title"])
    for axis in result["axes"]:
        unit = f" ({axis['unit']})" if axis["unit"] else ""
        typer.echo(f"    {axis['symbol']}  {axis['meaning']}{unit}".rstrip())
    typer.echo("")
    for region in result["regions"]:
        here = " — this motion" if region["number"] == result["region_of_motion"] else ""
        typer.echo(
            f"  region {region['number']}: {_count_text(region['tori'], 'torus', 'tori')}{here}"
        )
    for boundary in result["boundaries"]:
        kind = "stable" if boundary["stable"] else "unstable"
        circles = _count_text(boundary["circles"], "circle", "circles")
        typer.echo(f"  {boundary['motions']}: {circles}, {kind}; {boundary['curve']}")
    for equilibrium in result["equilibria"]:
        kind = "stable" if equilibrium["stable"] else "unstable"
        place = ", ".join(f"{x:.6g}" for x in equilibrium["place"])
        typer.echo(f"  equilibrium on axis {equilibrium['axis']}: {kind}; at ({place})")
    if result["motion"] is not None:
        values = ", ".join(
            f"{axis['symbol']} = {value:.9g}"
            for axis, value in zip(result["axes"], result["motion"], strict=True)
        )
        place = "" if result["region_of_motion"] else ", on a boundary"
        typer.echo(f"  this motion: {values}{place}")


def _count_text(number: int, one: str, many: str) -> str:
    return f"{number} {one if number == 1 else many}"
