"""Periodic orbits of maps by Newton's method, with the integrals as unfolding.

The unknowns are all points of an orbit, one lane each. The closure of the orbit, the relations and
the section at each point, and the held integrals are more equations than unknowns, but have a
common solution; a step is the minimum-norm least-squares solution of the linearised equations. If
orbits form families, as they do when an integral is not held, the nearest member is found.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass

import numpy as np

from ..arguments import arguments_checked
from ..errors import InputError, RunError
from ..system.arrays import FloatArray
from .floquet import Multipliers, multipliers
from .maps import Image, Map, normalised_functions

#: Relative size below which a singular value belongs to a family.
FAMILY = 1e-10
#: Maximum number of Newton steps, and of halvings of one step.
STEPS, HALVINGS = 30, 6
#: Relative closure error above which no orbit has been found.
CLOSURE = 1e-10
#: Residual norm below which residuals may increase: at rounding level, and near another orbit.
ROUGH = 1e-8


class NoOrbitError(RunError):
    """No orbit was found; `partial` holds the points at which the search ended.

    Examples
    --------
    >>> import flowlanes
    >>> import numpy as np
    >>> from flowlanes.orbits.maps import ExplicitMap
    >>> shift = ExplicitMap(("x",), lambda z: z + 1.0)
    >>> try:
    ...     flowlanes.orbits.find_periodic(shift, np.array([0.0]))
    ... except flowlanes.orbits.NoOrbitError as error:
    ...     print(error.partial.shape)
    (1, 1)
    """

    def __init__(self, reason: str, points: FloatArray) -> None:
        super().__init__(reason, 0.0, points)

    def __str__(self) -> str:
        return self.reason


@dataclass(frozen=True)
class Orbit:
    """A periodic orbit.

    Attributes
    ----------
    names : tuple of str
        The coordinates.
    points : array (period, size)
        The points of the orbit on the section, in order.
    duration : float
        The period in time; zero for maps without time.
    turns : array (size,)
        Number of periods by which the angles have grown after one round.
    values : mapping of str to float
        Integrals and promoted parameters on the orbit.
    multipliers : Multipliers
        The multipliers, with the stability type.
    gap : float
        The largest distance between the image of a point and the next point.
    error : float
        The last step of Newton's method, limited by rounding. For a System the error of the
        integration comes on top; it depends on the tolerance.

    Examples
    --------
    >>> import flowlanes
    >>> import numpy as np
    >>> from flowlanes.orbits.maps import ExplicitMap
    >>> henon = ExplicitMap(
    ...     ("x", "y"),
    ...     lambda z: np.stack([1 - 1.4 * z[:, 0] ** 2 + z[:, 1], 0.3 * z[:, 0]], axis=1),
    ... )
    >>> orbit = flowlanes.orbits.find_periodic(henon, np.array([0.6, 0.2]))
    >>> orbit.kind, orbit.multipliers.values.real.round(6).tolist()
    ('saddle', [-1.923739, 0.155946])
    """

    names: tuple[str, ...]
    points: FloatArray
    duration: float
    turns: FloatArray
    values: Mapping[str, float]
    multipliers: Multipliers
    gap: float
    error: float

    @property
    def period(self) -> int:
        """The number of points on the section."""
        return len(self.points)

    @property
    def kind(self) -> str:
        """The kind of stability."""
        return self.multipliers.kind


@dataclass(frozen=True)
class Equations:
    """The equations of the points of an orbit.

    Parameters
    ----------
    map : Map
    held_integrals : mapping of str to float
        Integrals with their prescribed values.
    sizes : array (size,)
        The units of the coordinates.
    """

    map: Map
    held_integrals: Mapping[str, float]
    sizes: FloatArray

    def __call__(self, points: FloatArray) -> tuple[FloatArray, FloatArray, Image]:
        """Residuals, their derivatives with respect to all coordinates, and the images.

        The residual of a function is, to first order, the distance to its prescribed value in
        units of the state.
        """
        count, size = points.shape
        image = self.map.image(points, slopes=True)
        if not np.isfinite(image.points).all():
            raise NoOrbitError("a point of the orbit has no image on the section", points)
        assert image.slopes is not None
        gaps, _ = periodic_difference(np.roll(points, -1, axis=0) - image.points, self.map.periods)
        # Block-cyclic matrix: x_{k+1} − f(x_k) has the blocks −S_k at k and 1 at k + 1.
        closing = np.zeros((count, size, count, size))
        for k in range(count):
            closing[k, :, k] -= image.slopes[k] * self.sizes / self.sizes[:, None]
            closing[k, :, (k + 1) % count] += np.eye(size)
        domain = self.map.domain
        places = np.zeros((count, len(domain.names), count, size))
        missed, local = normalised_functions(
            domain.values(points), domain.slopes(points), self.sizes
        )
        for k, slope in enumerate(local):
            places[k, :, k] = slope
        rows = [self.map.integrals.names.index(name) for name in self.held_integrals]
        levels = np.zeros((len(rows), count, size))
        excess = self.map.integrals.values(points[:1])[0, rows] - list(self.held_integrals.values())
        excess, levels[:, 0] = normalised_functions(
            excess, self.map.integrals.slopes(points[:1])[0, rows], self.sizes
        )
        residuals = np.concatenate([(gaps / self.sizes).ravel(), missed.ravel(), excess])
        blocks = (closing, places, levels)
        slopes = np.concatenate([block.reshape(-1, count * size) for block in blocks])
        return residuals, slopes, image


def periodic_difference(
    differences: FloatArray, periods: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Differences of coordinates modulo the periods of angles, and the number of periods."""
    finite = np.where(np.isfinite(periods), periods, 1.0)
    turns = np.where(np.isfinite(periods), np.round(differences / finite), 0.0)
    return differences - turns * finite, turns


def held_values(
    section_map: Map, point: FloatArray, hold: Mapping[str, float] | Iterable[str]
) -> dict[str, float]:
    """Values of the held integrals: those given, or those at a point.

    Raises
    ------
    InputError
        If a name is not an integral of the map.
    """
    known = dict(
        zip(
            section_map.integrals.names,
            section_map.integrals.values(point[None])[0].tolist(),
            strict=True,
        )
    )
    for name in hold:
        if name not in known:
            allowed = ", ".join(known) or "none"
            raise InputError(f"hold: {name!r} is not an integral of this map; it has {allowed}")
    if isinstance(hold, Mapping):
        return {name: float(value) for name, value in hold.items()}
    return {name: known[name] for name in hold}


def minimal_norm_step(slopes: FloatArray, residuals: FloatArray) -> FloatArray:
    """The minimum-norm least-squares solution of the linearised equations."""
    solution = np.linalg.lstsq(slopes, -residuals, rcond=FAMILY)[0]
    return np.asarray(solution, dtype=np.float64)


def projection_to_domain(section_map: Map, points: FloatArray, sizes: FloatArray) -> FloatArray:
    """The points of the domain of a map nearest to given ones, up to rounding."""
    # Newton steps with the pseudo-inverse move each point normal to the level sets.
    for _ in range(8):
        misses, slopes = normalised_functions(
            section_map.domain.values(points), section_map.domain.slopes(points), sizes
        )
        if not misses.size or np.abs(misses).max() < 1e-15:
            break
        inverse = np.linalg.pinv(slopes, rcond=FAMILY)
        points = points - np.einsum("nij,nj->ni", inverse, misses) * sizes
    return points


def newton_solution(
    equations: Equations, points: FloatArray, row: tuple[FloatArray, float] | None = None
) -> tuple[FloatArray, float]:
    """A solution by damped Newton steps, and the size of the last step.

    Parameters
    ----------
    equations : Equations
    points : array (period, size)
        Initial guess.
    row : pair of array (period·size,) and float, optional
        An additional linear equation: the inner product with all scaled coordinates has this
        value.

    Raises
    ------
    NoOrbitError
        If the iteration does not converge to an orbit.
    """
    sizes = equations.sizes

    def scaled_residuals(place: FloatArray) -> tuple[FloatArray, FloatArray]:
        residuals, slopes, _ = equations(place)
        if row is not None:
            direction, value = row
            residuals = np.append(residuals, direction @ (place / sizes).ravel() - value)
            slopes = np.concatenate([slopes, direction[None]])
        return residuals, slopes

    points = projection_to_domain(equations.map, points, sizes)
    residuals, slopes = scaled_residuals(points)
    last = np.inf
    for _ in range(STEPS):
        step = minimal_norm_step(slopes, residuals).reshape(points.shape)
        size, scale = float(np.abs(step).max()), 1.0 + float(np.abs(points / sizes).max())
        # The steps no longer shrink: rounding level is reached.
        if size >= 0.9 * last and size < 1e-10 * scale:
            break
        moved = _damped_step(
            equations, scaled_residuals, points, step * sizes, float(np.linalg.norm(residuals))
        )
        if moved is None:
            break
        points, residuals, slopes = moved
        last = size
        if size < 1e-15 * scale:
            break
    scale = 1.0 + float(np.abs(points / sizes).max())
    if np.abs(residuals).max() > CLOSURE * scale:
        raise NoOrbitError("Newton's method found no periodic orbit near the guess", points)
    last_step = minimal_norm_step(slopes, residuals).reshape(points.shape) * sizes
    return points, float(np.abs(last_step).max())


def _damped_step(
    equations: Equations,
    scaled_residuals: Callable[[FloatArray], tuple[FloatArray, FloatArray]],
    points: FloatArray,
    step: FloatArray,
    norm: float,
) -> tuple[FloatArray, FloatArray, FloatArray] | None:
    """The largest of the step, half of it, … that reduces the residuals; None if none does."""
    for power in range(HALVINGS):
        place = projection_to_domain(equations.map, points + step * 0.5**power, equations.sizes)
        try:
            residuals, slopes = scaled_residuals(place)
        except NoOrbitError:
            continue
        if np.linalg.norm(residuals) < norm or norm < ROUGH:
            return place, residuals, slopes
    return None


@arguments_checked
def find_periodic(
    section_map: Map,
    guess: FloatArray,
    period: int = 1,
    hold: Mapping[str, float] | Iterable[str] = (),
) -> Orbit:
    """Find the periodic orbit near a guess.

    Parameters
    ----------
    section_map : Map
    guess : array (size,) or (period, size)
        A point near the orbit, or one near each of its points.
    period : int
        Number of steps after which it closes.
    hold : mapping of str to float, or names
        Integrals with the values that the orbit must have; for names, those at the guess. If the
        orbits still form a family, the nearest one is found.

    Returns
    -------
    Orbit
        Points in the coordinates of the map, multipliers (no unit), and duration (s).

    Raises
    ------
    InputError
        If the guess or a name is invalid.
    NoOrbitError
        If there is no orbit near the guess, or the map ends there.

    Examples
    --------
    >>> import numpy as np
    >>> from flowlanes.orbits.maps import ExplicitMap
    >>> henon = ExplicitMap(
    ...     ("x", "y"),
    ...     lambda z: np.stack([1 - 1.4 * z[:, 0] ** 2 + z[:, 1], 0.3 * z[:, 0]], axis=1),
    ... )
    >>> orbit = find_periodic(henon, np.array([0.6, 0.2]))
    >>> print(orbit.kind, orbit.points[0, 0].round(12))
    saddle 0.63135447709
    """
    points = np.atleast_2d(np.asarray(guess, dtype=float))
    if period < 1:
        raise InputError(f"period = {period}: it must be at least 1")
    names = section_map.names
    if points.shape[1] != len(names) or len(points) not in (1, period):
        raise InputError(
            f"guess: its shape {points.shape} must be ({len(names)},) or ({period}, {len(names)}) "
            f"for the coordinates {', '.join(names)}"
        )
    sizes = section_map.sizes(points)
    points = projection_to_domain(section_map, points, sizes)
    values = held_values(section_map, points[0], hold)
    while len(points) < period:
        points = np.concatenate([points, section_map.image(points[-1:]).points])
    points, error = newton_solution(Equations(section_map, values, sizes), points)
    return orbit_from_points(section_map, points, error)


def orbit_from_points(section_map: Map, points: FloatArray, error: float) -> Orbit:
    """An orbit with all derived quantities, from its points."""
    image = section_map.image(points, slopes=True)
    assert image.slopes is not None
    gaps, _ = periodic_difference(np.roll(points, -1, axis=0) - image.points, section_map.periods)
    _, turns = periodic_difference((image.points - points).sum(axis=0), section_map.periods)
    # Chain rule: the derivative of the return map is the product of those of its steps.
    slope = np.eye(points.shape[1])
    for local in image.slopes:
        slope = local @ slope
    values = section_map.integrals.values(points[:1])[0].tolist()
    return Orbit(
        names=section_map.names,
        points=points,
        duration=float(image.times.sum()),
        turns=turns.astype(int),
        values=dict(zip(section_map.integrals.names, values, strict=True)),
        multipliers=multipliers(section_map, points[0], slope),
        gap=float(np.abs(gaps).max()),
        error=error,
    )
