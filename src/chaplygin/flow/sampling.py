"""Start points drawn uniformly on a level of the integrals.

Uniform means: by the invariant measure where one is known, else by the surface measure of the
level in the space of the state.  With δ-functions the invariant measure of a level is
ρ ∏ δ(relations) ∏ δ(held integrals) dx, that is ρ / √det(G Gᵀ) times the surface measure, the rows
of G being the gradients of relations and held integrals (the Gelfand–Leray form).

Points are drawn by rejection, so that they are independent and their distribution exact; each
depends on the seed and its own number alone.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import sympy as sp

from ..errors import InputError
from ..statements import Measure
from ..system import System
from ..vectors import explicit
from .arrays import Sheet, evaluate, numbers
from .dice import normals
from .fibres import Bundle, bundle
from .graph import Term

__all__ = ["Level", "draw", "prepared"]

#: Attempts looked at together.
_BATCH = 1 << 14
#: Attempts from which the bound of the density is taken, and how much is put on top.
_PILOT = 1 << 14
_MARGIN = 1.15
#: Rounds in which the largest densities are followed uphill.
_ROUNDS = 24
_CLIMBERS = 64
#: Attempts for one point after which the level counts as too thin.
_PATIENCE = 10**6
#: Newton steps by which a point is settled on its level.
_NEWTON = 2
#: A condition on parameters holds up to this, relative to the size of its terms.
_ROUNDING = 1e-12
#: The seed of pilot attempts: any number that users will not choose.
_PILOT_SEED = 0x9E3779B97F4A7C15


def draw(
    system: System,
    count: int,
    level: Mapping[str, float],
    parameters: Mapping[Any, float] | None = None,
    *,
    seed: int = 0,
    first: int = 0,
) -> Any:
    """Points drawn uniformly on a level of the integrals.

    Parameters
    ----------
    system : System
    count : int
        How many.
    level : mapping of str to float
        Values of the held integrals by name; the relations of the system hold anyway.
    parameters : mapping of Symbol or name to float, optional
        Values that replace the defaults.
    seed : int
    first : int
        Number of the first point: point k depends on `seed` and k alone.

    Returns
    -------
    array (count, size)
        States in flat order.

    Raises
    ------
    InputError
        If an integral is unknown or does not hold at these parameters, if the level is empty (the
        message names the values that are reached) or not bounded.
    """
    return prepared(system, level, parameters).draw(count, seed=seed, first=first)


@dataclass(frozen=True)
class Level:
    """A level of the integrals from which points can be drawn; made by `prepared`.

    Attributes
    ----------
    system : System
    values : mapping of str to float
        The held integrals.
    parameters : array (p,)
    measure : str
        Which measure the points are drawn by: the name of the invariant measure and its source,
        or "surface measure".
    invariant : bool
        Whether it is invariant under the motion.
    """

    system: System
    values: Mapping[str, float]
    parameters: Any
    measure: str
    invariant: bool
    _bundle: Bundle
    _held: tuple[Term, ...]
    _targets: Any
    _slopes: tuple[Term, ...]
    _density: Term | None
    _bound: float

    def draw(self, count: int, *, seed: int = 0, first: int = 0) -> Any:
        """Points `first` to `first` + `count`; array (count, size).  See :func:`draw`."""
        found = np.empty((count, len(self.system.symbols)))
        pending, attempt, tries = np.arange(count), 0, 8
        while pending.size:
            left = []
            for start in range(0, pending.size, _BATCH // tries):
                some = pending[start : start + _BATCH // tries]
                states, done = self._first(seed, first + some, attempt, tries)
                found[some[done]] = states
                left.append(some[~done])
            pending, attempt = np.concatenate(left), attempt + tries
            tries = min(2 * tries, _BATCH)
            if attempt > _PATIENCE:
                raise InputError(
                    f"{self.system.name}: the level {_shown(self.values)} is too thin: no point "
                    f"of it was met in {attempt} attempts"
                )
        return found

    def _first(self, seed: int, members: Any, attempt: int, tries: int) -> tuple[Any, Any]:
        """The first accepted of some attempts of each member, and which members have one."""
        attempts = attempt + np.arange(tries)
        states, density, dice = self._attempt(
            seed, np.repeat(members, tries), np.tile(attempts, members.size)
        )
        if density.max() > self._bound:
            raise InputError(
                f"{self.system.name}: the density of the level {_shown(self.values)} has no bound "
                "that could be found; it is next to a critical level"
            )
        taken = (dice * self._bound < density).reshape(members.size, tries)
        done = taken.any(axis=1)
        places = np.arange(members.size)[done] * tries + taken.argmax(axis=1)[done]
        return self._settled(states[:, places]).T, done

    def _attempt(self, seed: int, members: Any, attempts: Any) -> tuple[Any, Any, Any]:
        """States, their densities relative to that of the attempts, and a number in (0, 1)."""
        from scipy.special import ndtr

        many = self._bundle.base_numbers + len(self._bundle.fibre)
        gauss = normals(seed, members, attempts, many + 1)
        return *self._weighed(gauss[:many]), ndtr(gauss[many])

    def _weighed(self, gauss: Any) -> tuple[Any, Any]:
        """Points made of normal numbers, and their densities; zero where there is no point."""
        cut = self._bundle.base_numbers
        rays = self._bundle.fill(self._bundle.base(gauss[:cut]), gauss[cut:], self.parameters)
        density = np.zeros(gauss.shape[1])
        real = np.flatnonzero(rays.volume > 0)
        density[real] = rays.volume[real] * self._weight(rays.states[:, real])
        return rays.states, density

    def _weight(self, states: Any) -> Any:
        """The density to be drawn by, relative to ∏ δ(relations) ∏ δ(held integrals) dx."""
        if self._density is not None:
            return np.abs(evaluate([self._density], states, self.parameters)[0])
        slopes = self._gradients(states)
        return np.sqrt(np.linalg.det(slopes @ np.swapaxes(slopes, 1, 2)))

    def _gradients(self, states: Any) -> Any:
        size, k = states.shape
        flat = evaluate(self._slopes, states, self.parameters).T
        return np.ascontiguousarray(flat).reshape(k, len(self._held), size)

    def _settled(self, states: Any) -> Any:
        """States moved onto the level along the shortest way, by Newton's method."""
        for _ in range(_NEWTON):
            defect = evaluate(self._held, states, self.parameters) - self._targets[:, None]
            slopes = self._gradients(states)
            gram = slopes @ np.swapaxes(slopes, 1, 2)
            share = np.linalg.solve(gram, np.ascontiguousarray(defect.T)[:, :, None])
            states = states - (np.swapaxes(slopes, 1, 2) @ share)[:, :, 0].T
        return states


def prepared(
    system: System,
    level: Mapping[str, float],
    parameters: Mapping[Any, float] | None = None,
) -> Level:
    """A level from which points can be drawn again and again; see :func:`draw`."""
    values = numbers(system, parameters)
    _check(system, level, values)
    sheet = Sheet(system)
    made = bundle(system, sheet, level, values)
    if made.further:
        names = " and ".join(c.name for c in made.further)
        raise InputError(f"{system.name}: {names} cannot be held besides {made.quadratic.name}")
    conditions = [sheet.read(explicit(relation)) for relation in system.relations]
    held = {law.name: sheet.read(law.value) for law in system.integrals if law.name in level}
    conditions += [held[name] for name in level]
    law = _measure(system, sheet, level, values)
    blank = Level(
        system=system,
        values=dict(level),
        parameters=values,
        measure="surface measure" if law is None else _told(law),
        invariant=law is not None,
        _bundle=made,
        _held=tuple(conditions),
        _targets=np.array([0.0] * len(system.relations) + [float(v) for v in level.values()]),
        _slopes=tuple(term for row in sheet.slopes(conditions) for term in row),
        _density=None if law is None else sheet.read(law.value),
        _bound=np.inf,
    )
    return replace(blank, _bound=_MARGIN * _largest_density(blank))


def _check(system: System, level: Mapping[str, float], values: Any) -> None:
    """Refuse integrals that the system has not, or not at these parameters."""
    known = {law.name: law for law in system.integrals}
    for name, value in level.items():
        if name not in known:
            raise InputError(
                f"{system.name} has no integral {name!r}; it has {', '.join(known) or 'none'}"
            )
        if not np.isfinite(float(value)):
            raise InputError(f"{system.name}: {name} = {value}: a finite number is needed")
        for condition in known[name].on:
            if not _vanishes(system, condition, level, values):
                raise InputError(
                    f"{system.name}: {name} is an integral only where {explicit(condition)} = 0, "
                    "which does not hold here"
                )


def _vanishes(system: System, formula: Any, level: Mapping[str, float], values: Any) -> bool:
    """Whether a formula is zero at these parameters, or an integral that is held at zero."""
    written = explicit(formula)
    parameters = [p.symbol for p in system.parameters]
    if written.free_symbols <= set(parameters):
        point = dict(zip(parameters, map(float, values), strict=True))
        size = sum(abs(float(term.subs(point))) for term in sp.Add.make_args(sp.expand(written)))
        return abs(float(written.subs(point))) <= _ROUNDING * size
    return any(
        level.get(law.name) == 0 and sp.expand(explicit(law.value) - written) == 0
        for law in system.integrals
    )


def _measure(
    system: System, sheet: Sheet, level: Mapping[str, float], values: Any
) -> Measure | None:
    """The invariant measure that holds here."""
    for law in system.laws:
        if isinstance(law, Measure) and all(
            _vanishes(system, condition, level, values) for condition in law.on
        ):
            return law
    return None


def _told(law: Measure) -> str:
    return f"{law.meaning or 'invariant measure'} {law.source}".strip()


def _shown(level: Mapping[str, float]) -> str:
    return " and ".join(f"{name} = {value:.6g}" for name, value in level.items())


def _largest_density(level: Level) -> float:
    """The largest density that attempts can have."""
    many = level._bundle.base_numbers + len(level._bundle.fibre)
    pilot = normals(_PILOT_SEED, np.arange(_PILOT), np.zeros(_PILOT), many)
    cut = level._bundle.base_numbers

    def excess(gauss: Any) -> Any:
        base = level._bundle.base(gauss[:cut])
        return level._bundle.fill(base, gauss[cut:], level.parameters).excess

    room, place = _climbed(excess, pilot)
    bound = level._bundle.quadratic
    if not room > 0:
        others = _shown({name: v for name, v in level.values.items() if name != bound.name})
        raise InputError(
            f"{level.system.name}: the level {_shown(level.values)} is empty: "
            f"{f'with {others} ' if others else ''}{bound.name} is at least "
            f"{bound.target - room:.6g}"
        )
    near = place[:, None] + 0.0 * pilot[:, :1]
    return float(_climbed(lambda g: level._weighed(g)[1], np.concatenate([pilot, near], axis=1))[0])


def _climbed(height: Callable[[Any], Any], places: Any) -> tuple[float, Any]:
    """The largest value of a function of normal numbers, and where it was met.

    The highest of the given places are followed uphill by random steps that grow shorter.
    """
    heights = height(places)
    for turn in range(_ROUNDS):
        best = np.argsort(-heights, kind="stable")[:_CLIMBERS]
        steps = normals(
            _PILOT_SEED, np.arange(4 * best.size), np.full(4 * best.size, turn + 1), places.shape[0]
        )
        tried = np.repeat(places[:, best], 4, axis=1) + 0.5 * 0.7**turn * steps
        places = np.concatenate([places[:, best], tried], axis=1)
        heights = np.concatenate([heights[best], height(tried)])
    top = int(np.argmax(heights))
    return float(heights[top]), places[:, top]
