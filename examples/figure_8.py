"""The three-dimensional section of the unbalanced ball (Fig. 8 of Borisov and Mamaev, 2008).

    python examples/figure_8.py [FOLDER]

writes two pictures, one motion and many motions on the same level of both integrals, and prints
what was measured: do the points lie on one surface, what do motions come to, what do they leave.
The paper gives neither body nor start; those below were chosen by search and could be built: a
body of mass m inside a ball of radius R, its centre of mass at a distance c from the centre, needs
(I₁ + I₂ + I₃)/2 ≤ m (R² − c²).
"""

from __future__ import annotations

import sys
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from scipy.spatial import KDTree

from chaplygin import PoincareMap
from chaplygin.experiment.poincare import coordinates_of
from chaplygin.report.figures import save
from chaplygin.report.figures.poincare import draw_section
from flowlanes import poincare_section, sample_level as drawn
from flowlanes.flow import project_to_level
from flowlanes.flow.ensembles import compute
from flowlanes.flow.sections.poincare_dataset import section_task
from flowlanes.formulas import Formulas
from flowlanes.system import to_components
from nonholonomic.catalogue import entry

#: kg, kg m² and m, principal axes at the centre of mass.
BODY: Mapping[str, float] = {
    **{"m": 1.0, "R": 1.0},
    **{"I_1": 0.07, "I_2": 0.6, "I_3": 0.64},
    **{"c_1": -0.08, "c_2": 0.34, "c_3": -0.36},
}
#: Values of the integrals (10.2) and (10.3).
LEVEL: Mapping[str, float] = {"energy": 1.0, "quadratic": 0.7}
#: The momentum by direction in the body (angle and height) and by its share along the normal.
COORDINATES = "l = atan2(M_1, M_2), L = M_3/sqrt(dot(M, M)), H = dot(M, gamma)/sqrt(dot(M, M))"
#: Motions, and their returns.
STARTS, DEPARTURES, RETURNS = 200, 100, 2001
#: Points that are drawn: of the one motion after it has arrived, of each of the many.
FURTHER, SHOWN_OF_MANY = 60, 400
#: How near a point comes to itself that counts as a cycle.
CLOSED = 1e-6
#: How far from a cycle a motion begins, in the size of the state.
AWAY = 1e-3
SEED = 1

SYSTEM = entry("unbalanced-ball").system(BODY)
RETURN = PoincareMap(SYSTEM, poincare_section(SYSTEM, "gamma_3"), t_end=3e4)
NAMES, _PLAIN, _ = coordinates_of(SYSTEM, COORDINATES)
QUANTITIES = tuple(
    replace(item, label=label) for item, label in zip(_PLAIN, ("l", "L/G", "H/G"), strict=True)
)
PLACES = Formulas(SYSTEM, tuple(item.formula for item in QUANTITIES))
KEPT = Formulas(
    SYSTEM,
    (to_components(SYSTEM.relations[0]), *(to_components(law.value) for law in SYSTEM.integrals)),
)


@dataclass(frozen=True)
class Cycle:
    """A periodic point of the section map that attracts.

    Attributes
    ----------
    points : array (period, size)
    multiplier : float
        The largest by absolute value of those along the level: below 1 for an attractor.
    share : float
        Of the motions that were followed, those that come to it.
    """

    points: Any
    multiplier: float
    share: float

    @property
    def period(self) -> int:
        """Returns after which it closes."""
        return len(self.points)


def cycles(states: Any) -> list[Cycle]:
    """What motions come to, the most frequent first; states (motions, returns, size)."""
    groups: list[list[Any]] = []
    for points in states:
        orbit = closing(points)
        if orbit is None:
            continue
        for members in groups:
            if np.abs(members[0] - orbit[-1]).max(axis=1).min() < 100 * CLOSED:
                members.append(orbit)
                break
        else:
            groups.append([orbit])
    groups.sort(key=len, reverse=True)
    return [Cycle(m[0], multiplier(m[0]), len(m) / len(states)) for m in groups]


def closing(points: Any) -> Any:
    """The cycle at the end of a motion; None if it has not come to one of period below 25."""
    misses = np.abs(points[-25:-1][::-1] - points[-1]).max(axis=1)
    closed = np.flatnonzero(misses < CLOSED)
    return points[-1 - closed[0] :] if closed.size else None


def multiplier(orbit: Any) -> float:
    """The largest multiplier of a cycle, integrals and relation left out.

    The derivative of the map has the eigenvalue 1 for each of the three functions that are kept
    and 0 along the flow.
    """
    matrix = RETURN.derivative(orbit[-1:], len(orbit)).matrices[0]
    values = np.linalg.eigvals(matrix)
    return float(np.sort(np.abs(values[np.argsort(np.abs(values - 1.0))][3:]))[-1])


def reversed_of(point: Any) -> Any:
    """A point of the reversed motion on the section: M to −M, time to −t, on to the section."""
    return RETURN(np.concatenate([-point[:3], point[3:]]))


def departure(point: Any, number: int) -> Any:
    """A start on the level near a point; another for each number."""
    random = np.random.default_rng((SEED, number))
    moved = point + AWAY * random.normal(size=len(point))
    targets = [0.0, *(LEVEL[law.name] for law in SYSTEM.integrals)]
    (start,), _ = project_to_level(KEPT, moved[None], targets)
    return start


def thickness(places: Any, neighbours: int = 40) -> float:
    """How thick a cloud of points is where it is seen near: 0 for a surface, some tenths in space.

    For each point of a sample, the smallest over the middle extent of its neighbours.
    """
    tree = KDTree(places)
    sample = places[:: max(1, len(places) // 2000)]
    _, near = tree.query(sample, neighbours)
    groups = places[near] - places[near].mean(axis=1, keepdims=True)
    extents = np.linalg.svd(groups, compute_uv=False)
    return float(np.median(extents[:, 2] / extents[:, 1]))


def in_space(states: Any) -> Any:
    """Points in the coordinates of the pictures, the angle as a direction: (n, 4)."""
    angle, height, share = PLACES(states).T
    return np.stack([np.cos(angle), np.sin(angle), height, share], axis=1)


def departures(target: Cycle) -> tuple[Any, Any]:
    """Motions that begin near the reversed cycle: starts and paths."""
    origin = reversed_of(target.points[-1])
    starts = np.array([departure(origin, number) for number in range(DEPARTURES)])
    return starts, RETURN.crossings(starts, RETURNS).states


def fates(paths: Any) -> str:
    """What motions come to, by the periods of cycles."""
    counts: Counter[str] = Counter()
    for path in paths:
        whole = bool(np.isfinite(path[-1, 0]))
        cycle = closing(path) if whole else None
        if cycle is None:
            counts["none of these" if whole else "no more points"] += 1
        else:
            share = float(PLACES(cycle)[:, 2].mean())
            counts[f"a cycle of {len(cycle)}, H/G = {share:+.2f} in the mean"] += 1
    return "; ".join(f"{count} to {fate}" for fate, count in counts.most_common())


def dataset(starts: Any, returns: int) -> Any:
    """The section of some motions."""
    notes = {"section": "gamma_3 = 0, rising"}
    return compute(section_task(RETURN, starts, returns, QUANTITIES, attributes=notes))


def point_list(points: Any) -> str:
    """Points by the coordinates of the pictures."""
    return "; ".join(", ".join(f"{x:+.4f}" for x in place) for place in PLACES(points).tolist())


def main(folder: Path) -> None:
    """Write the pictures, print what was measured."""
    many = dataset(drawn(SYSTEM, STARTS, LEVEL, seed=SEED), RETURNS)
    states = np.concatenate([many["M"].values, many["gamma"].values], axis=2)
    whole = many["points"].values == RETURNS
    print(f"{STARTS} motions on energy = 1, F_2 = {LEVEL['quadratic']}, {RETURNS} returns each;")
    print(f"  {int((~whole).sum())} of them never come to the section or too rarely")
    attractors = cycles(states[whole])
    for cycle in attractors:
        print(
            f"  {cycle.share:.0%} come to a cycle of {cycle.period} points, "
            f"largest multiplier {cycle.multiplier:.4f}"
        )
        print(f"    (l, L/G, H/G) = {point_list(cycle.points)}")
    apart = float(abs(many["law_quadratic"] - LEVEL["quadratic"]).max())
    print(f"  F_2 stays what it is within {apart:.1e}")
    middle = states[whole][:, :: RETURNS // 100].reshape(-1, states.shape[2])
    free = dataset(drawn(SYSTEM, STARTS, {"energy": 1.0}, seed=SEED), 100)
    apart_free = np.concatenate([free["M"].values, free["gamma"].values], axis=2)
    apart_free = apart_free[free["points"].values == 100].reshape(-1, states.shape[2])
    print(f"  thickness of the cloud of points: {thickness(in_space(middle)):.3f};")
    print(f"  with any F_2 at the same energy:  {thickness(in_space(apart_free)):.3f}")

    target = attractors[0]
    starts, paths = departures(target)
    print(f"{DEPARTURES} motions that begin near the reversed cycle come:")
    print(f"  {fates(paths)}")
    counts = [last_beyond(distances(path, target.points), 1e-4) for path in paths]
    quickest = int(np.argmin(counts))
    start = starts[quickest]
    one = dataset(start[None], counts[quickest] + FURTHER)
    print(f"The quickest of those that come to the cycle starts at {start.tolist()}")
    print(f"  leaves (l, L/G, H/G) = {point_list(start[None])}")
    (path,) = np.concatenate([one["M"].values, one["gamma"].values], axis=2)
    origin = reversed_of(target.points[-1])
    left = distances(path, RETURN.crossings(origin[None], target.period).states[0])
    print(f"  is 0.1 away from the reversed cycle after {int(np.argmax(left > 0.1))} returns")
    away = distances(path, target.points)
    for near in (1e-1, 1e-3, 1e-6):
        print(f"  stays within {near:g} of the cycle after {last_beyond(away, near)} returns")
    save(draw_section(one, NAMES), folder / "figure_8.png")
    save(
        draw_section(many.isel(section_point=slice(0, SHOWN_OF_MANY)), NAMES),
        folder / "figure_8_many.png",
    )


def distances(path: Any, cycle: Any) -> Any:
    """How far each point of a path is from a cycle."""
    return np.abs(path[:, None] - cycle[None]).max(axis=2).min(axis=1)


def last_beyond(away: Any, near: float) -> int:
    """Returns until a motion stays near."""
    beyond = np.flatnonzero(~(away < near))
    return int(beyond[-1]) + 1 if beyond.size else 0


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path())
