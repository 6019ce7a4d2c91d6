"""The closed form of a study: its motion at any time and its section of a report."""

from __future__ import annotations

import contextlib
import re
import time as clock
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import sympy as sp
import xarray as xr
from flint import arb
from markupsafe import Markup

from flowlanes.errors import InputError, RunError
from flowlanes.flow.recorded_quantities import recorded_values
from flowlanes.flow.trajectory import Statistics, Trajectory
from flowlanes.printing import numerals
from flowlanes.printing.equations import equations_html
from flowlanes.printing.formula import latex, text
from flowlanes.printing.mathml import mathml
from flowlanes.printing.numerals import typographic_signs, unit
from flowlanes.system.arrays import FloatArray
from flowlanes.system.named_formulas import flat
from flowlanes.system.vectors import real_symbol
from nonholonomic.closed_form.base.problem import Problem
from nonholonomic.closed_form.base.solution import NamedConstant, Solution, times_in_range
from nonholonomic.closed_form.bifurcation import Diagram
from nonholonomic.closed_form.bifurcation.motion_diagram import diagram_of_motion
from nonholonomic.closed_form.solvable_cases import solution_of

from .single_system import single_system
from .study import Study, dataset_of


def solution_of_study(study: Study) -> Solution:
    """The motion of a study in closed form.

    Raises
    ------
    InputError
        If the start is not admissible.
    NoClosedFormError
        If no closed form of this motion is known.
    """
    system = single_system(study)
    solution = solution_of(Problem(system, system.defaults, study.start, study.rolling))
    # Do the set-up here, so that its errors are reported before anything is printed.
    solution.states(np.zeros(1))
    return solution


def known_solution(study: Study) -> Solution | None:
    """The motion of a study in closed form; None if no closed form can be evaluated."""
    with contextlib.suppress(InputError, RunError, ArithmeticError):
        return solution_of_study(study)
    return None


def diagram_if_known(study: Study) -> tuple[Diagram, tuple[float, float]] | None:
    """The bifurcation diagram of a study and its point in it; None if none is known.

    For example, a body with two equal moments has no diagram in a plane of two integrals.
    """
    with contextlib.suppress(InputError):
        system = single_system(study)
        return diagram_of_motion(Problem(system, system.defaults, study.start, study.rolling))
    return None


def in_space(study: Study, solution: Solution) -> bool:
    """Whether a solution includes the motion in space, if the system has one."""
    moves = study.system.reconstruction is not None
    return moves and len(solution.system.symbols) > len(study.system.symbols)


def closed_form_trajectory(
    study: Study, solution: Solution, times: Sequence[float] | FloatArray
) -> Trajectory:
    """A motion at given times, with the same recorded quantities as an integration.

    Parameters
    ----------
    study : Study
    solution : Solution
        A closed form of this study.
    times : array (n,)

    Returns
    -------
    Trajectory
        In double precision.
    """
    began = clock.perf_counter()
    moments = times_in_range(np.asarray(times, dtype=float), solution.phase_rate)
    states = solution.states(moments)
    seconds = clock.perf_counter() - began
    system = study.system_on_level.lifted() if in_space(study, solution) else study.system_on_level
    return Trajectory(
        system,
        system.defaults,
        moments,
        states,
        recorded_values(system, states),
        (),
        Statistics(
            method=f"none: closed form, {solution.form.title}",
            steps=0,
            order=0,
            tolerance=float(np.finfo(float).eps),
            precision="double",
            corrections=0,
            seconds=seconds,
            from_cache=False,
        ),
    )


def dataset(study: Study, trajectory: Trajectory, solution: Solution) -> xr.Dataset:
    """The dataset of a closed form, with the variable names of an integrated trajectory."""
    closed = dataset_of(study, trajectory)
    start = zip(trajectory.system.symbols, study.start, strict=False)
    return closed.assign_attrs(
        start="; ".join(f"{symbol} = {float(value)!r}" for symbol, value in start),
        motion=solution.form.motion,
    )


def units(study: Study, solution: Solution) -> dict[sp.Symbol, str]:
    """The unit of every component of the lifted state, if known."""
    variables = dataset(study, closed_form_trajectory(study, solution, [0.0]), solution)
    by_symbol: dict[sp.Symbol, str] = {}
    for name in solution.system.state:
        unit = str(variables[str(name)].units) if str(name) in variables else "m"
        by_symbol |= dict.fromkeys(flat([name]), "" if unit in ("1", "unknown") else unit)
    return by_symbol


# --- the section of a report ---------------------------------------------------------------


@dataclass(frozen=True)
class ClosedFormSection:
    """The section of a report on a closed form.

    Attributes
    ----------
    title, motion, source : str
    equations : tuple of Markup
        The curve, the differential equations and the time rescaling.
    rows : tuple of (symbol, value, meaning)
        Constants, roots, frequencies, with error bounds and units.
    ovals : tuple of str
        The intervals of the separated variables.
    caption : str
        Caption of the figure.
    difference : str
        The largest distance of any component of the state from the integrated trajectory.
    """

    title: str
    motion: str
    source: str
    equations: tuple[Markup, ...]
    rows: tuple[tuple[str, str, str], ...]
    ovals: tuple[str, ...]
    caption: str
    difference: str


_CAPTION = (
    "The curve over the real line, each oval scaled to its own height, with its roots and the "
    "intervals of the separated variables; and nine turns on the torus of the two phases."
)
_CAPTION_OF_MORE = _CAPTION.replace("the two phases", "the phases, seen in the first two of them")
_CAPTION_OF_ONE = "The interval on which the separated variable moves."


def _captions(ovals: int) -> str:
    """The caption of the figure for a number of intervals."""
    if ovals <= 1:
        return _CAPTION_OF_ONE
    return _CAPTION if ovals == 2 else _CAPTION_OF_MORE


def closed_form_section(solution: Solution, trajectory: Trajectory) -> ClosedFormSection:
    """The text and formulas of a closed form, and its distance from an integration.

    Parameters
    ----------
    solution : Solution
    trajectory : Trajectory
        The same motion, integrated.
    """
    form = solution.form
    states = solution.states(trajectory.times.astype(float))
    integrated = trajectory.states[:, : states.shape[1]].astype(float)
    distance = np.abs(states - integrated).max()
    return ClosedFormSection(
        title=form.title,
        motion=form.motion,
        source=form.source,
        equations=tuple(
            Markup(equations_html([("", equation(left, right))])) for left, right in form.equations
        ),
        rows=tuple(
            (_symbol(figure.symbol), typeset_value(number(figure)), letters(figure.meaning))
            for figure in form.constants
        ),
        ovals=tuple(typographic_signs(f"[{low:.12g}, {high:.12g}]") for low, high in form.ovals),
        caption=_captions(len(form.ovals)),
        difference=numerals.number(float(distance), 2),
    )


#: A differential before another factor.
_AFTER = re.compile(
    r"(\\text\{d[a-z]+\}(?:_\{\w+\})?) (?:\\, )?"
    r"((?:\w|\\(?!text)[a-z]+)(?:_\{\w+\})?(?:\^\{\w+\})?)(?=[}\s])"
)


def equation(left: sp.Expr, right: sp.Expr) -> str:
    """An equation in LaTeX, with names such as dz and dtau as differentials."""

    def differential(match: re.Match[str]) -> str:
        return rf"\mathrm{{d}}{latex(sp.Symbol(match[1]))}"

    written = f"{latex(left)} = {latex(right)}".replace(r"\text{varphi}", r"\varphi")
    # Put differentials after other factors: z₁ dz₁, not dz₁ z₁.
    written = _AFTER.sub(r"\2 \, \1", written)
    return re.sub(r"\\text\{d([a-z]+)\}", differential, written)


def typeset_value(value: str) -> str:
    """A value with its error and unit, with signs, powers of ten and units as in print."""
    return unit(typographic_signs(value))


def _symbol(text: str) -> str:
    """A symbol as a formula; other expressions, such as V_1/V_2, as words."""
    return Markup(mathml(latex(real_symbol(text)))) if text.isidentifier() else letters(text)


def letters(words: str) -> str:
    """Words in which z_1, dtau and Omega are written z₁, dτ and Ω."""
    named = r"(?<=\bd)tau\b|\b(?:tau|theta|phi|psi|rho|omega|Omega|lambda|Lambda)\b|[A-Za-z]+_\w+"
    return re.sub(named, lambda match: text(real_symbol(match[0])), words)


def number(figure: NamedConstant, digits: int = 20) -> str:
    """The value of a constant with its error bound and unit."""
    middle, radius = ball(figure.value, digits)
    unit = "" if figure.unit in ("", "1") else f" {figure.unit}"
    return f"{middle}{unit}" if radius == "0" else f"{middle} ± {radius}{unit}"


def ball(value: arb, digits: int) -> tuple[str, str]:
    """Midpoint and radius of a ball in decimals; rounding enlarges the radius."""
    middle, _, radius = value.str(digits).strip("[]").partition("+/-")
    return middle.strip() or "0", radius.strip() or "0"
