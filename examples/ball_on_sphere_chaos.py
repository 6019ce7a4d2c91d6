"""A ball that rolls on a sphere without slipping: for which ratios of the radii is it chaotic?

    python examples/ball_on_sphere_chaos.py [FOLDER]

With k = a/(a + R), a the radius of the sphere and R that of the ball, the momentum M about the
contact and the normal n obey Ṁ = M×ω, ṅ = k n×ω (body axes).  The script searches for integrals
at several k, says which Lyapunov exponents they force to be zero, measures the others, counts the
chaotic ones among many starts on one level of the integrals, draws a chart of the largest
exponent over k and a coordinate of the start, and sections at six values of k.
"""

from __future__ import annotations

import resource
import sys
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure

from chaplygin import Integral, System, find_laws, lyapunov_spectrum
from chaplygin.report.drawing.style import COMPONENTS, FAINT, INK, QUIET, SERIES, STYLE, WIDTH
from chaplygin.report.figures import save
from chaplygin.report.figures.scan import chart as draw_chart
from flowlanes import batch_integrator
from flowlanes.flow import Section, project_to_level
from flowlanes.flow.ensembles import compute
from flowlanes.formulas import Formulas
from flowlanes.lyapunov import Spectrum, maximal_exponent, megno
from flowlanes.scans import Scan, axis, scan, scan_grid
from flowlanes.system import dot, to_components
from nonholonomic.catalogue.ball_on_sphere.ball_on_sphere_equations import (
    M,
    equations_on_sphere,
    k,
    n,
)

#: The integrals of the cases k = 1 and k = 0; that of k = −1 is among the laws of the equations.
AREA = Integral("area", dot(M, n), "area integral", level=(k - 1,))
FIXED = tuple(Integral(str(s), s, "fixed normal", level=(k,)) for s in n.symbols)
SYSTEM: System = equations_on_sphere().with_laws(AREA, *FIXED)

#: The level on which everything happens: M² in kg² m⁴/s², and an energy, in J, that is possible
#: wherever the contact is.  Moments of inertia are 1, 1.5, 2.1 kg m², and mR² is 1 kg m².
MOMENTUM, ENERGY = "4", "4/4.4"
LEVEL = np.array([4 / 4.4, 4.0])
ON_LEVEL = Formulas(SYSTEM, tuple(to_components(law.value) for law in SYSTEM.integrals[:2]))

#: A start is called chaotic where MEGNO is larger; on regular motions it tends to 2.
CHAOTIC = 4.0
SEED = 1873


@dataclass(frozen=True)
class Size:
    """How much is computed."""

    cells: int = 300
    until: float = 1000.0
    starts: int = 500
    followed: float = 4000.0
    long: float = 50_000.0
    returns: int = 1500
    orbits: int = 110
    degree: int = 4


FULL = Size()
RATIOS = (-2, -1.5, -1.2, -1.05, -1, -0.95, -0.8, -0.5, -0.25, -0.1, 0)
RATIOS += (0.1, 0.25, 0.5, 0.8, 0.95, 1, 1.05, 1.2, 1.5, 2)
SHOWN = (-1.0, -0.7, -0.3, 0.3, 0.7, 1.0)


# --- what holds, and what is forced ---------------------------------------------------------


def proven_integrals(condition: str, degree: int) -> list[str]:
    """Integrals polynomial in M and n up to a degree in each, at a condition on k; all proven."""
    found = find_laws(
        equations_on_sphere(), degree=degree, gamma_degree=degree, at=[condition] * bool(condition)
    )
    return [f"{law.formula} ({'proven' if law.proven else 'not proven'})" for law in found]


def starts(count: int) -> Any:
    """States on the level: n uniform on the sphere, M of random direction moved onto it."""
    dice = np.random.default_rng(SEED)
    normals = dice.normal(size=(count, 3))
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    guess = np.concatenate([dice.normal(size=(count, 3)), normals], axis=1)
    states, met = project_to_level(ON_LEVEL, guess, LEVEL, movable=[True] * 3 + [False] * 3)
    return states[met]


# --- how much is chaotic --------------------------------------------------------------------


@dataclass(frozen=True)
class Row:
    """What many starts show at one k."""

    ratio: float
    share: float
    highest: float
    wildest: Any


def shares(size: Size, ratios: Sequence[float] = RATIOS) -> Iterator[Row]:
    """The share of chaotic starts, the largest MEGNO and the start that has it."""
    states = starts(size.starts)
    for ratio in ratios:
        numbers = np.full(len(states), float(ratio))
        found = megno(SYSTEM, size.followed)(states, {k: numbers})["value"]
        worst = int(np.nanargmax(found))
        yield Row(ratio, float(np.mean(found > CHAOTIC)), float(found[worst]), states[worst])


def exponents(row: Row, until: float) -> Spectrum:
    """The Lyapunov spectrum of the wildest motion at one k."""
    intervals = max(200, round(until / 50))
    return lyapunov_spectrum(SYSTEM, row.wildest, {k: row.ratio}, t_end=until, intervals=intervals)


def table_row(row: Row, spectrum: Spectrum) -> str:
    """A line of the table."""
    values = ", ".join(f"{e.value:+.5f} ± {e.error:.5f}" for e in spectrum.exponents)
    forced = ", ".join(item.name for item, _ in spectrum.trivial if item.kind != "relation")
    word = "no chaos seen" if spectrum.halves_agree else "not settled"
    return (
        f"{row.ratio:6g}  {100 * row.share:5.1f} %  {row.highest:7.2f}  {values:40s}  "
        f"{'chaotic' if spectrum.chaotic else word}; forced to zero: {forced}"
    )


# --- pictures -------------------------------------------------------------------------------


def exponent_chart(size: Size) -> Any:
    """The largest exponent over k and a coordinate of the start."""
    grid = scan_grid(
        SYSTEM,
        axis(f"k=-2:2:{size.cells}"),
        axis(f"theta=0:pi:{size.cells}"),
        {"M": (1.0, 1.0, 1.0), "n": (0.0, 0.6, 0.8)},
        formulas={
            "n_1": "0.8*sin(theta)",
            "n_2": "0.6*sin(theta)",
            "n_3": "cos(theta)",
            "momentum": MOMENTUM,
            "energy": ENERGY,
        },
    )
    rule = maximal_exponent(SYSTEM, size.until, samples=100)
    return compute(scan(Scan(grid, rule, "lyapunov", "largest Lyapunov exponent", "1/s")))


def section_starts(count: int) -> Any:
    """States of the level with M₃ = 0, n spread evenly over the sphere."""
    place = np.arange(count) + 0.5
    height, turn = 1 - 2 * place / count, np.pi * (1 + 5**0.5) * place
    width = np.sqrt(1 - height**2)
    normals = np.stack([width * np.cos(turn), width * np.sin(turn), height], axis=1)
    guess = np.concatenate([np.tile([2.0, 0.3, 0.0], (count, 1)), normals], axis=1)
    states, met = project_to_level(ON_LEVEL, guess, LEVEL, movable=[True, True] + [False] * 4)
    return states[met]


def sections(size: Size) -> Figure:
    """Sections M₃ = 0 (rising, M₁ > 0) at six values of k, on the sphere of normals.

    Where M₃ = 0 rises through zero, n and the level give M up to its sign: there is one point of
    the section for each n.  The coordinates keep areas on the sphere.
    """
    state = {str(symbol): symbol for symbol in SYSTEM.symbols}
    flow = batch_integrator(SYSTEM, section=Section(state["M_3"], 1, state["M_1"]), tolerance=1e-12)
    begun = section_starts(size.orbits)
    with mpl.rc_context(STYLE):
        figure = Figure(figsize=(WIDTH, 5.0), layout="constrained")
        figure.set_label("Sections of a ball on a sphere")
        panels = figure.subplots(2, 3, sharex=True, sharey=True)
        for axes, ratio in zip(panels.flat, SHOWN, strict=True):
            run = flow.crossings(begun, size.returns, {k: ratio}, t_end=100.0 * size.returns)
            for orbit, points in enumerate(run.states):
                axes.plot(
                    np.arctan2(points[:, 4], points[:, 3]),
                    points[:, 5],
                    ",",
                    color=SERIES[orbit % len(SERIES)],
                    alpha=0.8,
                    rasterized=True,
                )
            axes.set_title(f"$k = {ratio:g}$")
            axes.set_xlim(-np.pi, np.pi)
            axes.set_ylim(-1.0, 1.0)
            axes.set_xticks([-np.pi, 0.0, np.pi], ["$-\\pi$", "0", "$\\pi$"])
        for axes in panels[1]:
            axes.set_xlabel("azimuth of $n$  (rad)")
        for axes in panels[:, 0]:
            axes.set_ylabel("$n_3$")
    return figure


def share_figure(rows: Sequence[Row]) -> Figure:
    """The share of chaotic starts against k."""
    ratios, parts = [row.ratio for row in rows], [100 * row.share for row in rows]
    with mpl.rc_context(STYLE):
        figure = Figure(figsize=(WIDTH, 2.6), layout="constrained")
        figure.set_label("Share of chaotic starts")
        axes = figure.add_subplot()
        for special in (-1, 0, 1):
            axes.axvline(special, color=FAINT, linewidth=0.8)
        axes.plot(ratios, parts, "-", color=QUIET, linewidth=0.8)
        axes.plot(ratios, parts, "o", color=COMPONENTS[0], markeredgecolor=INK, markersize=4)
        axes.set_xlabel("ratio  $k = a/(a + R)$")
        axes.set_ylabel("chaotic starts  (%)")
        axes.set_ylim(bottom=-2.0)
    return figure


def main(folder: Path, size: Size = FULL) -> None:
    """Search, measure, draw."""
    print("Integrals that are polynomials in M and n")
    for condition in ("k = 1", "k = -1", "k = 0"):
        print(f"  {condition}, to degree 2 in each: {'; '.join(proven_integrals(condition, 2))}")
    for condition in ("", "k = 1/2", "k = -1/2", "k = 2", "k = -2"):
        formulas = "; ".join(proven_integrals(condition, size.degree))
        print(f"  {condition or 'any k'}, to degree {size.degree} in each: {formulas}", flush=True)
    print("     k  chaotic    MEGNO  exponents of the wildest start, 1/s")
    rows = []
    for row in shares(size):
        rows.append(row)
        print(table_row(row, exponents(row, size.long)), flush=True)
    save(share_figure(rows), folder / "ball_on_sphere_shares.png")
    began, busy = time.perf_counter(), time.process_time()
    chart = exponent_chart(size)
    seconds, work = time.perf_counter() - began, time.process_time() - busy
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    values = chart["lyapunov"].values
    print(f"chart of {values.size} cells until {size.until:g}: {seconds:.0f} s", end="")
    print(f", {work:.0f} s of processor time")
    print(f"  the whole run has taken {memory:.0f} MB of memory at most")
    sure = values > chart["lyapunov_error"].values
    print(f"  positive beyond its error in {100 * sure.mean():.1f} % of the cells")
    save(draw_chart(chart), folder / "ball_on_sphere_chart.png")
    save(sections(size), folder / "ball_on_sphere_sections.png")


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path())
