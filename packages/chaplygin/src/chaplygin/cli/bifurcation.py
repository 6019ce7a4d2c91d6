"""``chaplygin bifurcation``: the tori over the plane of two integrals."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import typer

from .terminal.options import inform, print_json, study_of
from .terminal.output_destination import check_figure, check_output
from .terminal.progress import waiting

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from nonholonomic.closed_form.base.problem import Problem
    from nonholonomic.closed_form.bifurcation import Diagram
    from nonholonomic.closed_form.revolution.diagram import Diagram as RevolutionDiagram

#: Planes that are not systems of the catalogue.
PLANES = ("chaplygin-ball-area", "bruns")


class _Answer(NamedTuple):
    """Facts of a diagram, their text, and its figure."""

    facts: dict[str, Any]
    lines: list[str]
    draw: Callable[[], Figure]


def command(
    what: str,
    figure: Path | None = None,
    overrides: list[str] | None = None,
    force: bool = False,
    json: bool = False,
) -> None:
    """Compute the bifurcation diagram of an integrable system exactly, and locate the motion in it.

    In the plane of two integrals: every region with its number of tori, and every
    boundary with the motions on it, stable or unstable.
    """
    if figure is not None:
        check_figure("--output", figure)
        check_output("--output", figure, force, json, what)
    answer = _answer(what, overrides)
    if figure is not None:
        from ..report.drawing.files import save

        save(answer.draw(), figure)
    if json:
        print_json(answer.facts | {"figure": None if figure is None else str(figure)})
        return
    for line in answer.lines:
        typer.echo(line)
    if figure is not None:
        inform(f"figure: {figure}")


def _answer(what: str, overrides: list[str] | None) -> _Answer:
    """Diagram of an experiment with its motion, or diagram of a plane."""
    from flowlanes.errors import InputError

    task = f"computing the diagram of {what}"
    if what in PLANES:
        with waiting(task):
            from nonholonomic.closed_form.bifurcation import bifurcation_diagram

            return _of_tori(bifurcation_diagram(what, _numbers(overrides or [])), None)
    study = study_of(what, overrides)
    with waiting(task):
        from nonholonomic.closed_form.base.problem import Problem
        from nonholonomic.closed_form.bifurcation.motion_diagram import diagram_of_motion
        from nonholonomic.closed_form.revolution.motion_diagram import diagram_of_body_of_revolution

        from ..experiment.single_system import single_system

        system = single_system(study)
        problem = Problem(system, system.defaults, study.start, study.rolling)
        if (revolution := diagram_of_body_of_revolution(problem)) is not None:
            return _of_revolution(*revolution, problem)
        diagram = diagram_of_motion(problem)
    if diagram is None:
        raise InputError(
            f"no bifurcation diagram of {system.title} is known at this start: its motions do not "
            "separate on a plane of two integrals (nonholonomic/docs/bifurcations.md lists those "
            "that do)"
        )
    return _of_tori(*diagram)


def _of_tori(diagram: Diagram, mark: tuple[float, float] | None) -> _Answer:
    from ..report.figures.bifurcation import draw_bifurcation_diagram

    facts = _facts(diagram, mark)
    return _Answer(facts, _lines(facts), lambda: draw_bifurcation_diagram(diagram, mark))


def _of_revolution(
    diagram: RevolutionDiagram, mark: tuple[float, float], problem: Problem
) -> _Answer:
    """Permanent rotations of a body of revolution, and the motions between them."""
    from nonholonomic.closed_form.revolution.motion_diagram import column_of

    from ..report.figures.bifurcation_revolution import draw_revolution_diagram

    h, K = mark
    column = column_of(problem, K)
    facts: dict[str, Any] = {
        "title": problem.system.title,
        "axes": [
            {"symbol": "h", "meaning": "energy", "unit": "J"},
            {
                "symbol": "K",
                "meaning": "integral (5.1), linear in the angular velocity",
                "unit": "kg^0.5 m/s",
            },
        ],
        "motion": mark,
        "motions": None if column is None else column.motions_at(h),
        "rotations": [
            {"cos_theta": float(rest.u), "h": float(rest.h), "stable": rest.stable}
            for rest in (column.rests if column else ())
        ],
        "families": [
            {
                "stable": stable,
                "K": [float(curve[0, 1]), float(curve[-1, 1])],
                "cos_theta": [float(curve[0, 2]), float(curve[-1, 2])],
            }
            for curve, stable in zip(diagram.curves, diagram.stable, strict=True)
        ],
    }
    lines = [problem.system.title]
    lines += _axes(facts)
    lines += ["", "  families of permanent rotations, by |K|:"]
    for family in facts["families"]:
        (first, last), (begin, end) = family["K"], family["cos_theta"]
        spins = f"|K| = {first:.6g} to {last:.6g}"
        lines.append(f"    {_kind(family)}: {spins}, cos θ = {begin:.6g} to {end:.6g}")
    if facts["rotations"]:
        lines.append("  permanent rotations with the K of this motion:")
    lines += [
        f"    {_kind(rest)}: cos θ = {rest['cos_theta']:.6g}, h = {rest['h']:.9g}"
        for rest in facts["rotations"]
    ]
    count = facts["motions"]
    shared = (
        "" if count is None else f"; {_count_text(count, 'motion', 'motions')} with these values"
    )
    lines.append(f"  this motion: h = {h:.9g}, K = {K:.9g}{shared}")
    return _Answer(facts, lines, lambda: draw_revolution_diagram(diagram, [mark]))


def _kind(item: dict[str, Any]) -> str:
    return "stable" if item["stable"] else "unstable"


def _numbers(overrides: list[str]) -> dict[str, str]:
    """Parameters of a plane, as exact decimals."""
    from flowlanes.errors import InputError

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


def _facts(diagram: Diagram, mark: tuple[float, float] | None) -> dict[str, Any]:
    from flowlanes.printing.formula import text

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


def _axes(facts: dict[str, Any]) -> list[str]:
    """A line for each axis, with its meaning and unit."""
    from flowlanes.printing.numerals import unit

    units = (f" ({unit(axis['unit'])})" if axis["unit"] else "" for axis in facts["axes"])
    return [
        f"    {axis['symbol']}  {axis['meaning']}{words}".rstrip()
        for axis, words in zip(facts["axes"], units, strict=True)
    ]


def _lines(facts: dict[str, Any]) -> list[str]:
    lines = [facts["title"]]
    lines += [*_axes(facts), ""]
    for region in facts["regions"]:
        here = " — this motion" if region["number"] == facts["region_of_motion"] else ""
        count = _count_text(region["tori"], "torus", "tori")
        lines.append(f"  region {region['number']}: {count}{here}")
    for boundary in facts["boundaries"]:
        circles = _count_text(boundary["circles"], "circle", "circles")
        lines.append(f"  {boundary['motions']}: {circles}, {_kind(boundary)}; {boundary['curve']}")
    for equilibrium in facts["equilibria"]:
        place = ", ".join(f"{x:.6g}" for x in equilibrium["place"])
        lines.append(
            f"  equilibrium on axis {equilibrium['axis']}: {_kind(equilibrium)}; at ({place})"
        )
    if facts["motion"] is not None:
        values = ", ".join(
            f"{axis['symbol']} = {value:.9g}"
            for axis, value in zip(facts["axes"], facts["motion"], strict=True)
        )
        place = "" if facts["region_of_motion"] else ", on a boundary"
        lines.append(f"  this motion: {values}{place}")
    return lines


def _count_text(number: int, one: str, many: str) -> str:
    return f"{number} {one if number == 1 else many}"
