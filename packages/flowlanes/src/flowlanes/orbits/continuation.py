"""Pseudo-arclength continuation of periodic orbits, through folds and bifurcations.

A parameter is treated as one more integral
(:func:`flowlanes.orbits.return_map.parameters_to_state`), so that there is only one kind of
continuation: in the value of an integral. The orbits with fixed values of the other integrals form
a curve in the space of all their points. Each step goes along the tangent of the curve and is
corrected orthogonally to it, so that folds need no special treatment (Keller 1977). Folds are
detected on the way, and multipliers that pass through 1, −1 or, as a pair, the unit circle.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field

import numpy as np

from ..arguments import arguments_checked
from ..errors import InputError
from ..system.arrays import FloatArray
from ..system.overview import Overview, WithOverview
from .floquet import Multipliers
from .maps import Map
from .periodic import (
    FAMILY,
    Equations,
    NoOrbitError,
    Orbit,
    held_values,
    newton_solution,
    orbit_from_points,
)

#: Maximum number of halvings of a step before the branch ends, and of iterations that locate an
#: event.
SHORTENED, LOCATED = 12, 50
#: A step is lengthened by this factor if the tangent turns by less than `_STRAIGHT` radians, and
#: shortened if it turns by more than twice that.
LONGER, _STRAIGHT = 1.5, 0.1
#: A test function is significant if it exceeds its error by this factor.
CLEAR = 100.0


@dataclass(frozen=True)
class Event:
    """A bifurcation, fold or end on a branch.

    Attributes
    ----------
    kind : str
        ``"fold"``: the varied value has an extremum; ``"branch"``: a multiplier passes through 1
        without a fold (known to about five digits, since two branches meet there); ``"doubling"``:
        one passes through −1; ``"torus"``: a complex pair passes through the unit circle.
    place : float
        The varied value there.
    orbit : Orbit
    """

    kind: str
    place: float
    orbit: Orbit


@dataclass(frozen=True, repr=False)
class Branch(WithOverview):
    """Periodic orbits along a curve.

    Attributes
    ----------
    parameter : str
        The integral or promoted parameter that varies.
    orbits : tuple of Orbit
    events : tuple of Event
        Events in order.
    reason : str
        The reason why the branch ends.

    Examples
    --------
    >>> import flowlanes
    >>> import numpy as np
    >>> from flowlanes.orbits.maps import ExplicitMap
    >>> henon = ExplicitMap(
    ...     ("x", "y", "a"),
    ...     lambda z: np.stack(
    ...         [1 - z[:, 2] * z[:, 0] ** 2 + z[:, 1], 0.3 * z[:, 0], z[:, 2]], axis=1
    ...     ),
    ...     keeps={"a": lambda z: z[:, 2]},
    ... )
    >>> orbit = flowlanes.orbits.find_periodic(henon, np.array([0.6, 0.2, 1.4]), hold=("a",))
    >>> branch = flowlanes.orbits.continue_orbit(henon, orbit, "a", 0.2)
    >>> branch.orbits[-1].kind, branch.reason
    ('attracting node', 'a reached 0.2')
    """

    parameter: str
    orbits: tuple[Orbit, ...]
    events: tuple[Event, ...] = field(repr=False)
    reason: str

    def overview(self) -> Overview:
        """Kinds of orbits along the branch, events, and the end."""
        places = self.places
        kinds = dict.fromkeys(orbit.kind for orbit in self.orbits)
        return Overview(
            f"Branch of {len(self.orbits):,} periodic orbits, {self.parameter} = {places[0]:.9g} "
            f"to {places[-1]:.9g}",
            (
                ("orbits", ", ".join(kinds)),
                ("events", ", ".join(dict.fromkeys(event.kind for event in self.events))),
                ("ends", self.reason),
            ),
        )

    @property
    def places(self) -> FloatArray:
        """The varied values, shape (orbits,)."""
        return np.array([orbit.values[self.parameter] for orbit in self.orbits])


@dataclass(frozen=True)
class _BranchPoint:
    """An orbit of the branch with its unit tangent and dλ/ds for the varied value λ."""

    orbit: Orbit
    tangent: FloatArray
    speed: float


@dataclass(frozen=True)
class _BranchTracer:
    equations: Equations
    parameter: str

    def place(self, points: FloatArray, error: float, ahead: FloatArray | None) -> _BranchPoint:
        """A point of the branch, with the tangent oriented along `ahead`."""
        _, slopes, _ = self.equations(points)
        # The tangent spans the kernel of the linearised equations; a larger kernel means a family
        # of more dimensions.
        _, sizes, other = np.linalg.svd(slopes)
        free = points.size - int((sizes > FAMILY * sizes[0]).sum())
        if free > 1:
            raise InputError(
                f"hold: the orbits are a family of {free} dimensions; hold further integrals so "
                f"that they depend on {self.parameter} alone"
            )
        tangent = other[-1]
        map = self.equations.map
        row = map.integrals.names.index(self.parameter)
        rate = map.integrals.slopes(points[:1])[0, row]
        speed = float((rate * self.equations.sizes) @ tangent[: points.shape[1]])
        turned = speed < 0 if ahead is None else float(ahead @ tangent) < 0
        if turned:
            tangent, speed = -tangent, -speed
        return _BranchPoint(orbit_from_points(map, points, error), tangent, speed)

    def step(self, here: _BranchPoint, length: float) -> _BranchPoint:
        """The point of the branch at a given distance along the tangent."""
        sizes = self.equations.sizes
        way = length * here.tangent.reshape(here.orbit.points.shape)
        guess = here.orbit.points + way * sizes
        # The additional equation keeps the projection onto the tangent, so that the correction is
        # orthogonal to it.
        row = (here.tangent, float(here.tangent @ (guess / sizes).ravel()))
        points, error = newton_solution(self.equations, guess, row)
        return self.place(points, error, here.tangent)


@arguments_checked
def continue_orbit(
    section_map: Map,
    orbit: Orbit,
    parameter: str,
    until: float,
    hold: Iterable[str] | Mapping[str, float] = (),
    *,
    step: float = 0.05,
    max_step: float = 0.5,
    max_iterations: int = 400,
) -> Branch:
    """Continue a periodic orbit along a branch.

    Parameters
    ----------
    section_map : Map
    orbit : Orbit
        The first orbit.
    parameter : str
        An integral or promoted parameter whose value changes.
    until : float
        The branch starts in the direction of this value and ends where it is reached.
    hold : names, or mapping of str to float
        Integrals with fixed values (for names: those of the orbit).
    step, max_step : float
        First and largest step, in the space of all points of the orbit, in units of the state.
    max_iterations : int
        Maximum number of orbits.

    Returns
    -------
    Branch
        The orbits in order, the events between them, and the reason for the end.

    Raises
    ------
    InputError
        If a name is unknown, or the orbits form a family of more than one dimension.

    Examples
    --------
    >>> import flowlanes
    >>> import numpy as np
    >>> from flowlanes.orbits.maps import ExplicitMap
    >>> henon = ExplicitMap(
    ...     ("x", "y", "a"),
    ...     lambda z: np.stack(
    ...         [1 - z[:, 2] * z[:, 0] ** 2 + z[:, 1], 0.3 * z[:, 0], z[:, 2]], axis=1
    ...     ),
    ...     keeps={"a": lambda z: z[:, 2]},
    ... )
    >>> orbit = flowlanes.orbits.find_periodic(henon, np.array([0.6, 0.2, 1.4]), hold=("a",))
    >>> branch = flowlanes.orbits.continue_orbit(henon, orbit, "a", 0.2)
    >>> [(event.kind, round(event.place, 6)) for event in branch.events], branch.reason
    ([('doubling', 0.3675)], 'a reached 0.2')
    """
    values = held_values(section_map, orbit.points[0], hold)
    start = held_values(section_map, orbit.points[0], [parameter])[parameter]
    if parameter in values:
        raise InputError(f"hold: {parameter} cannot be held and varied")
    follower = _BranchTracer(
        Equations(section_map, values, section_map.sizes(orbit.points)), parameter
    )
    here = follower.place(orbit.points, orbit.error, None)
    if (until - start) * here.speed < 0:
        here = _BranchPoint(here.orbit, -here.tangent, -here.speed)
    places, events, length, reason = [here], [], step, f"after {max_iterations} orbits"
    while len(places) < max_iterations:
        advanced = _advance(follower, here, min(length, max_step))
        if advanced is None:
            reason = "no orbit was found however short the step"
            break
        there, length_taken = advanced
        turn = _turn(here, there)
        events.extend(_events(follower, here, there, length_taken))
        end = _locate_event(
            follower,
            here,
            there,
            length_taken,
            lambda p: p.orbit.values[parameter] - until,
            "passed",
        )
        if end is not None:
            places.append(
                there if end.orbit is there.orbit else _BranchPoint(end.orbit, here.tangent, 0)
            )
            events.append(end)
            reason = f"{parameter} reached {until:g}"
            break
        if len(places) > 2 and _passes(here, there, places[0], follower.equations.sizes):
            reason = "the branch is closed"
            break
        # The step grows on straight parts of the branch; `_advance` shortens it on curved ones.
        length = length_taken * (LONGER if turn < _STRAIGHT else 1.0)
        here = there
        places.append(here)
    orbits = tuple(place.orbit for place in places)
    return Branch(parameter, orbits, tuple(e for e in events if e.kind != "passed"), reason)


def _advance(
    follower: _BranchTracer, here: _BranchPoint, length: float
) -> tuple[_BranchPoint, float] | None:
    """The next point and its distance; None if no step succeeds."""
    for _ in range(SHORTENED):
        try:
            there = follower.step(here, length)
        except NoOrbitError:
            length /= 2
            continue
        if _turn(here, there) < 2 * _STRAIGHT:
            return there, length
        length /= 2
    return None


def _turn(here: _BranchPoint, there: _BranchPoint) -> float:
    """The angle between two tangents."""
    return float(np.arccos(np.clip(here.tangent @ there.tangent, -1.0, 1.0)))


def _passes(
    here: _BranchPoint, there: _BranchPoint, first: _BranchPoint, sizes: FloatArray
) -> bool:
    """True if a step passes the first orbit of the branch in the same direction."""
    begin, step = here.orbit.points / sizes, (there.orbit.points - here.orbit.points) / sizes
    length = float(np.linalg.norm(step))
    # Any cyclic permutation of the points represents the same orbit.
    for k in range(len(begin)):
        way = np.roll(first.orbit.points, k, axis=0) / sizes - begin
        tangent = np.roll(first.tangent.reshape(begin.shape), k, axis=0).ravel()
        share = float((way * step).sum()) / length**2
        aside = float(np.linalg.norm(way - share * step))
        if 0 < share <= 1 and aside < _STRAIGHT * length and tangent @ here.tangent > 0.9:
            return True
    return False


def _unit_multiplier_test(multipliers: Multipliers, sign: float) -> tuple[float, float]:
    """∏(μ − sign), which changes sign when a multiplier passes ±1, and its error."""
    factors = multipliers.values - sign
    value = float(np.prod(factors).real)
    return value, _product_error(factors, multipliers.errors)


def _torus_test(multipliers: Multipliers) -> tuple[float, float]:
    """∏(μ μ̄ − 1) over complex pairs, and its error; 1 if there are none."""
    pairs = multipliers.values[multipliers.values.imag > 0]
    errors = multipliers.errors[multipliers.values.imag > 0]
    factors = np.abs(pairs) ** 2 - 1
    return float(np.prod(factors)), _product_error(factors, 2 * np.abs(pairs) * errors)


def _product_error(factors: FloatArray, errors: FloatArray) -> float:
    """The error of a product from those of its factors."""
    sizes = np.abs(factors)
    return float(np.prod(sizes + errors) - np.prod(sizes))


def _events(
    follower: _BranchTracer, here: _BranchPoint, there: _BranchPoint, length: float
) -> list[Event]:
    events = []
    fold = _locate_event(follower, here, there, length, lambda p: p.speed, "fold")
    tests: dict[str, Callable[[Multipliers], tuple[float, float]]] = {
        "doubling": lambda m: _unit_multiplier_test(m, -1.0),
        "torus": _torus_test,
    }
    if fold is not None:
        events.append(fold)
    else:
        tests["branch"] = lambda m: _unit_multiplier_test(m, 1.0)
    for kind, test in tests.items():
        ends = [test(place.orbit.multipliers) for place in (here, there)]
        if all(abs(value) > CLEAR * error for value, error in ends) and _same_pairs(
            kind, here, there
        ):

            def value(
                place: _BranchPoint, test: Callable[..., tuple[float, float]] = test
            ) -> float:
                return test(place.orbit.multipliers)[0]

            event = _locate_event(follower, here, there, length, value, kind)
            if event is not None:
                events.append(event)
    return events


def _same_pairs(kind: str, here: _BranchPoint, there: _BranchPoint) -> bool:
    """True if the number of complex multipliers is equal at both ends; needed for a torus."""
    counts = [int((p.orbit.multipliers.values.imag > 0).sum()) for p in (here, there)]
    return kind != "torus" or counts[0] == counts[1] > 0


def _locate_event(
    follower: _BranchTracer,
    here: _BranchPoint,
    there: _BranchPoint,
    length: float,
    test: Callable[[_BranchPoint], float],
    kind: str,
) -> Event | None:
    """The zero of a test function between two points, by the Illinois method; None if none."""
    ends = [(0.0, test(here), here), (length, test(there), there)]
    if ends[0][1] * ends[1][1] > 0 or ends[0][1] == 0:
        return None
    best = ends[1]
    for _ in range(LOCATED):
        (a, f, _), (b, g, _) = ends
        if abs(b - a) < 1e-14 or g == 0:
            break
        middle = b - g * (b - a) / (g - f)
        try:
            place = follower.step(here, middle)
        except NoOrbitError:
            break
        value = test(place)
        moved = abs(middle - best[0])
        best = (middle, value, place)
        # Illinois: halve the retained value if the new point lies on the same side, so that the
        # end does not stay fixed as in regula falsi.
        if value * g < 0:
            ends[0] = ends[1]
        else:
            ends[0] = (a, f / 2, ends[0][2])
        ends[1] = best
        if moved < 1e-13 or value == 0:
            break
    orbit = best[2].orbit
    return Event(kind, orbit.values[follower.parameter], orbit)
