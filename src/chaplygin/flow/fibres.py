"""A level of integrals as fibres over a compact base.

In the systems of rolling and turning bodies some variables lie on spheres (the normal γ) or are
angles: the base.  In the others, the fibre, the relations and integrals are linear or quadratic:
over every point of the base lie an ellipsoid (a level of the energy) and planes ((M, γ) = const,
(ω, γ) = 0).  Rays from the centre of the section of both give every point of the level once.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import sympy as sp

from ..errors import InputError
from ..system import System
from ..vectors import explicit
from .arrays import Compiled, Sheet
from .dice import normals
from .graph import Term
from .rows import applied, dots, solved, squares

__all__ = ["Bundle", "Condition", "bundle"]

#: Integrals that are tried first as the ones that bound the fibre.
_BOUNDING = ("energy", "hamiltonian")
#: Base points at which boundedness is looked at.
_SAMPLE = 256
#: Least ratio of the axes of an ellipsoid, squared.
_DEFINITE = 1e-12


@dataclass(frozen=True)
class Condition:
    """A formula that has a given value on the level.

    Attributes
    ----------
    name : str
        Name of the integral; empty for a relation.
    term : Term
    target : float or array (k,)
        An array has a value for each point.
    """

    name: str
    term: Term
    target: Any


@dataclass(frozen=True)
class Bundle:
    """Base and fibre of a level, and what is held in the fibre.

    Attributes
    ----------
    size : int
        Number of state variables.
    spheres : tuple of tuples of int
        Places of the variables of each unit vector of the base.
    angles : tuple of int
        Places of the variables of period 2π.
    fibre : tuple of int
        Places of the other variables.
    quadratic : Condition
        Quadratic in the fibre, and bounding it.
    linear : tuple of Condition
        Linear in the fibre.
    further : tuple of Condition
        Held besides, of any form.
    coefficients : Compiled
        Of the linear conditions: slopes row by row, values at zero; of the quadratic one: second
        derivatives row by row, slopes at zero, value at zero.
    """

    size: int
    spheres: tuple[tuple[int, ...], ...]
    angles: tuple[int, ...]
    fibre: tuple[int, ...]
    quadratic: Condition
    linear: tuple[Condition, ...]
    further: tuple[Condition, ...]
    coefficients: Compiled

    @property
    def rays(self) -> int:
        """Dimension of the space in which the rays of a fibre lie."""
        return len(self.fibre) - len(self.linear)

    @property
    def ground(self) -> tuple[int, ...]:
        """Places of the variables of the base: unit vectors, then angles."""
        return (*(place for places in self.spheres for place in places), *self.angles)

    @property
    def balls(self) -> tuple[slice, ...]:
        """The unit vectors among the numbers y that make a point: of the base, and of the ray."""
        sizes = [*map(len, self.spheres)]
        ends = [sum(sizes[: i + 1]) for i in range(len(sizes))]
        start = len(self.ground)
        parts = [slice(end - size, end) for end, size in zip(ends, sizes, strict=True)]
        return (*parts, slice(start, start + len(self.fibre)))

    @property
    def numbers(self) -> int:
        """How many numbers y make a point of the level."""
        return len(self.ground) + len(self.fibre)

    def normed(self, gauss: Any) -> Any:
        """Points y, uniform on the product of spheres and circles, from normal numbers (y, k).

        Angles come by the normal distribution function, uniform in (0, 2π).
        """
        from scipy.special import ndtr

        places = gauss.copy()
        for part in self.balls:
            places[part] = gauss[part] / np.sqrt(squares(gauss[part]))
        for row in range(len(self.ground) - len(self.angles), len(self.ground)):
            places[row] = 2 * np.pi * ndtr(gauss[row])
        return places

    def gauss(self, places: Any) -> Any:
        """Numbers of which `normed` makes the points y."""
        from scipy.special import ndtri

        numbers = places.copy()
        for row in range(len(self.ground) - len(self.angles), len(self.ground)):
            numbers[row] = ndtri(np.mod(places[row] / (2 * np.pi), 1.0))
        return numbers

    def over(self, places: Any, parameters: Any) -> Rays:
        """The points of the level that points y (y, k) make."""
        states = np.zeros((self.size, places.shape[1]))
        states[list(self.ground)] = places[: len(self.ground)]
        return self.fill(states, places[len(self.ground) :], parameters)

    def fill(self, states: Any, directions: Any, parameters: Any) -> Rays:
        """Put points of the level over base points, along rays of given directions.

        Parameters
        ----------
        states : array (size, k)
            Base points; their fibre is filled in.
        directions : array (f, k)
            Vectors in the fibre; the rays are along their parts inside the linear conditions.
        parameters : array (p,)
        """
        n, a, A, b, c = self.parts(states, parameters)
        f, m = len(self.fibre), len(self.linear)
        targets = np.array([condition.target for condition in self.linear])
        corner = np.zeros((states.shape[1], f + m, f + m))
        corner[:, :f, :f], corner[:, :f, f:], corner[:, f:, :f] = A, np.swapaxes(n, 1, 2), n
        saddle = solved(corner, np.concatenate([-b, targets - a], axis=1))
        centre, pull = saddle[:, :f], saddle[:, f:]
        excess = self.quadratic.target - (
            c + dots(b, centre) + 0.5 * dots(centre, applied(A, centre))
        )
        gram = n @ np.swapaxes(n, 1, 2)
        shadow = directions.T
        share = solved(gram, applied(n, shadow))
        shadow = shadow - applied(np.swapaxes(n, 1, 2), share)
        span = np.sqrt(dots(shadow, shadow))
        ray = shadow / span[:, None]
        stiffness = dots(ray, applied(A, ray))
        with np.errstate(invalid="ignore", divide="ignore"):
            length = np.sqrt(2 * np.where(excess > 0, excess, np.nan) / stiffness)
            volume = length ** (self.rays - 2) / stiffness / np.sqrt(np.linalg.det(gram))
        filled = states.copy()
        filled[list(self.fibre)] = (centre + length[:, None] * ray).T
        return Rays(
            states=filled,
            excess=excess,
            volume=np.where(excess > 0, volume, 0.0),
            centre=centre,
            pull=pull,
            ray=ray,
            length=length,
            share=share,
            span=span,
            normals=n,
            saddle=corner,
        )

    def parts(self, states: Any, parameters: Any) -> tuple[Any, ...]:
        """What the conditions are in the fibres over base points.

        Slopes (k, m, f) and values (k, m) of the linear conditions at zero fibre; second
        derivatives (k, f, f), slopes (k, f) and values (k,) of the quadratic one.
        """
        k = states.shape[1]
        f, m = len(self.fibre), len(self.linear)
        flat = np.ascontiguousarray(self.coefficients(states, parameters).T)
        cuts = np.cumsum([m * f, m, f * f, f])
        n, a, A, b, c = np.split(flat, cuts, axis=1)
        return n.reshape(k, m, f), a, A.reshape(k, f, f), b, c[:, 0]


@dataclass(frozen=True)
class Rays:
    """Points at the ends of rays.

    Attributes
    ----------
    states : array (size, k)
        Not-a-number in the fibre where there is no point.
    excess : array (k,)
        How far the quadratic integral is above its least value in the fibre; negative where no
        point lies above this point of the base.
    volume : array (k,)
        The volume δ(conditions) d(fibre) for a unit solid angle of rays; zero where no point is.
    centre, pull : arrays (k, f), (k, m)
        Where the quadratic integral is least in the fibre, and the multipliers of the linear
        conditions there.
    ray, length : arrays (k, f), (k,)
        Unit vectors and lengths of the rays.
    share, span : arrays (k, m), (k,)
        Coefficients of the part of the directions that the linear conditions take away, and the
        length of what is left.
    normals : array (k, m, f)
        Slopes of the linear conditions.
    saddle : array (k, f + m, f + m)
        The matrix of the equations for centre and pull.
    """

    states: Any
    excess: Any
    volume: Any
    centre: Any
    pull: Any
    ray: Any
    length: Any
    share: Any
    span: Any
    normals: Any
    saddle: Any


# --- finding the bundle ----------------------------------------------------------------------


def bundle(system: System, sheet: Sheet, level: Mapping[str, float], values: Any) -> Bundle:
    """How a level of the integrals lies over a base.

    Parameters
    ----------
    system : System
    sheet : Sheet
        Its formulas.
    level : mapping of str to float
        Held integrals by name.
    values : array (p,)
        Parameters.

    Raises
    ------
    InputError
        If the level is not bounded, or is of a form for which no exact method is known here.
    """
    spheres, others = _spheres(system)
    relations = [Condition("", sheet.read(relation), 0.0) for relation in others]
    formulas = {law.name: law.value for law in system.integrals}
    held = [Condition(name, sheet.read(formulas[name]), float(level[name])) for name in level]
    for bound in sorted(held, key=lambda condition: condition.name not in _BOUNDING):
        rest = [condition for condition in held if condition is not bound]
        found = _with_bound(system, sheet, spheres, relations, bound, rest)
        if found is not None and _bounded(found, values):
            return found
    given = " and ".join(f"{name} = {value:.6g}" for name, value in level.items())
    raise InputError(
        f"{system.name}: the level {given or 'of no integral'} is not bounded in a way that can "
        "be seen: among what is held there must be an integral, such as the energy, that is "
        f"quadratic and definite in {_names(system, _loose(system, spheres))}"
    )


def _loose(system: System, spheres: Sequence[Sequence[int]]) -> list[int]:
    inside = {place for places in spheres for place in places}
    return [i for i in range(len(system.symbols)) if i not in inside]


def _names(system: System, places: Sequence[int]) -> str:
    return ", ".join(str(system.symbols[i]) for i in places)


def _with_bound(
    system: System,
    sheet: Sheet,
    spheres: list[tuple[int, ...]],
    relations: list[Condition],
    bound: Condition,
    rest: list[Condition],
) -> Bundle | None:
    """The bundle in which `bound` is the quadratic condition; None where that cannot be."""
    fibre, angles = _loose(system, spheres), list[int]()
    terms = [bound.term, *(relation.term for relation in relations)]
    while curved := sheet.depends(_second(sheet, terms, fibre)) & set(fibre):
        angles += sorted(curved)
        fibre = [i for i in fibre if i not in curved]
    degree = {id(c): _degree(sheet, c.term, fibre) for c in (*relations, bound, *rest)}
    if degree[id(bound)] != 2 or any(degree[id(relation)] != 1 for relation in relations):
        return None
    linear = [*relations, *(c for c in rest if degree[id(c)] == 1)]
    # a fibre needs two rays at least: two points at its ends would have no bounded density
    linear = linear[: max(len(relations), len(fibre) - 2)]
    further = [c for c in rest if c not in linear]
    if len(fibre) - len(linear) < 2:
        return None
    slopes = sheet.slopes([c.term for c in (*linear, bound)])
    second = _second(sheet, [bound.term], fibre)
    coefficients = [
        *(row[i] for row in slopes[:-1] for i in fibre),
        *(c.term for c in linear),
        *second,
        *(slopes[-1][i] for i in fibre),
        bound.term,
    ]
    return Bundle(
        size=len(system.symbols),
        spheres=tuple(spheres),
        angles=tuple(angles),
        fibre=tuple(fibre),
        quadratic=bound,
        linear=tuple(linear),
        further=tuple(further),
        coefficients=Compiled(coefficients),
    )


def _second(sheet: Sheet, terms: Sequence[Term], places: Sequence[int]) -> list[Term]:
    """All second derivatives of terms in some variables."""
    first = [row[i] for row in sheet.slopes(terms) for i in places]
    return [row[i] for row in sheet.slopes(first) for i in places]


def _degree(sheet: Sheet, term: Term, places: Sequence[int]) -> int:
    """The degree of a term as a polynomial in some variables; 3 for anything higher."""
    inside = set(places)
    if not sheet.depends([term]) & inside:
        return 0
    if not sheet.depends([sheet.slopes([term])[0][i] for i in places]) & inside:
        return 1
    return 3 if sheet.depends(_second(sheet, [term], places)) & inside else 2


def _at_random(made: Bundle) -> Any:
    """States over random points of the base, their fibre zero."""
    gauss = normals(0, np.arange(_SAMPLE), np.zeros(_SAMPLE), made.numbers)
    states = np.zeros((made.size, _SAMPLE))
    states[list(made.ground)] = made.normed(gauss)[: len(made.ground)]
    return states


def _bounded(made: Bundle, values: Any) -> bool:
    """Whether the quadratic condition is definite on the fibres over a sample of base points."""
    n, _, A, _, _ = made.parts(_at_random(made), values)
    if not (np.isfinite(n).all() and np.isfinite(A).all()):
        return False
    across = np.eye(len(made.fibre)) - np.linalg.pinv(n) @ n if n.shape[1] else 1.0
    sizes = np.linalg.eigvalsh(across @ A @ across if n.shape[1] else A)[:, n.shape[1] :]
    return bool((sizes[:, 0] > _DEFINITE * sizes[:, -1]).all())


def _spheres(system: System) -> tuple[list[tuple[int, ...]], list[sp.Expr]]:
    """The unit vectors among the variables, and the relations that are left."""
    places = {symbol: i for i, symbol in enumerate(system.symbols)}
    spheres: list[tuple[int, ...]] = []
    others: list[sp.Expr] = []
    for relation in system.relations:
        formula = explicit(relation)
        free = sorted(formula.free_symbols & set(places), key=places.__getitem__)
        unit = sp.Add(*(s**2 for s in free)) - 1
        if free and sp.expand(formula - unit) == 0:
            spheres.append(tuple(places[s] for s in free))
        else:
            others.append(formula)
    return spheres, others
