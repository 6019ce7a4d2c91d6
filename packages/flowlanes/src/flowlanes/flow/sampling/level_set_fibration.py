"""Level sets as ellipsoids over a product of spheres and circles, for sampling."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence

import numpy as np
import sympy as sp

from ...errors import InputError
from ...formulas.compiled import CompiledTerms, SystemFormulas
from ...formulas.graph import Term
from ...system.arrays import FloatArray
from ...system.system import System
from .counter_rng import counter_normals
from .fibration import Fibration, LevelCondition

#: Integrals that are first tried as bounds of the fibre.
_BOUNDING = ("energy", "hamiltonian")
#: Number of base points at which boundedness is tested.
_SAMPLE = 256
#: Changes below this are taken as zero.
_SAME = 1e-10
#: Smallest squared ratio of the axes of an ellipsoid.
_DEFINITE = 1e-12


def find_fibration(
    system: System, sheet: SystemFormulas, level: Mapping[str, float], values: FloatArray
) -> Fibration:
    """Fibration of a level of the integrals over a compact base.

    Parameters
    ----------
    system : System
    sheet : SystemFormulas
        Formulas of the system.
    level : mapping of str to float
        Values of integrals by name.
    values : array (p,)
        Values of the parameters.

    Raises
    ------
    InputError
        If the level is not bounded, or has a form without an exact method here.
    """
    spheres, others = _ellipsoids(system, values)
    relations = [LevelCondition("", sheet.term_of(relation), 0.0) for relation in others]
    formulas = {law.name: law.value for law in system.integrals}
    conditions = [
        LevelCondition(name, sheet.term_of(formulas[name]), float(level[name])) for name in level
    ]
    for bound in sorted(conditions, key=lambda condition: condition.name not in _BOUNDING):
        further = [condition for condition in conditions if condition is not bound]
        fibration = _fibration_bounded_by(system, sheet, spheres, relations, bound, further)
        if fibration is not None and _is_bounded(fibration, values):
            return fibration
    text = " and ".join(f"{name} = {value:.6g}" for name, value in level.items())
    raise InputError(
        f"{system.name}: the level {text or 'of no integral'} is not bounded in a way that can "
        "be seen: among what is held there must be an integral, such as the energy, that is "
        f"quadratic and definite in {_names(system, _variables_off_ellipsoids(system, spheres))}"
    )


def _variables_off_ellipsoids(system: System, spheres: Iterable[Sequence[int]]) -> list[int]:
    inside = {place for places in spheres for place in places}
    return [i for i in range(len(system.symbols)) if i not in inside]


def _names(system: System, places: Sequence[int]) -> str:
    return ", ".join(str(system.symbols[i]) for i in places)


def _fibration_bounded_by(
    system: System,
    sheet: SystemFormulas,
    spheres: Mapping[tuple[int, ...], tuple[float, ...]],
    relations: list[LevelCondition],
    bound: LevelCondition,
    others: list[LevelCondition],
) -> Fibration | None:
    """Fibration with `bound` as its quadratic condition, or None."""
    fibre, angles = _variables_off_ellipsoids(system, spheres), list[int]()
    terms = [bound.term, *(relation.term for relation in relations)]
    # A variable in the second derivatives makes the condition more than quadratic; it may be an
    # angle of the base instead.
    while curved := sheet.depends(_second_derivatives(sheet, terms, fibre)) & set(fibre):
        angles += sorted(curved)
        fibre = [i for i in fibre if i not in curved]
    degree = {id(c): _degree(sheet, c.term, fibre) for c in (*relations, bound, *others)}
    if degree[id(bound)] != 2 or any(degree[id(relation)] != 1 for relation in relations):
        return None
    linear = [*relations, *(c for c in others if degree[id(c)] == 1)]
    # A fibre needs at least two ray dimensions, because with two end points the density is not
    # bounded.
    linear = linear[: max(len(relations), len(fibre) - 2)]
    further = [c for c in others if c not in linear]
    if len(fibre) - len(linear) < 2:
        return None
    slopes = sheet.slopes([c.term for c in (*linear, bound)])
    second = _second_derivatives(sheet, [bound.term], fibre)
    coefficients = [
        *(row[i] for row in slopes[:-1] for i in fibre),
        *(c.term for c in linear),
        *second,
        *(slopes[-1][i] for i in fibre),
        bound.term,
    ]
    return Fibration(
        size=len(system.symbols),
        spheres=tuple(spheres),
        axes=(*(a for axes in spheres.values() for a in axes), *(1.0 for _ in angles)),
        angles=tuple(angles),
        fibre=tuple(fibre),
        quadratic=bound,
        linear=tuple(linear),
        further=tuple(further),
        coefficients=CompiledTerms(coefficients),
    )


def _second_derivatives(
    sheet: SystemFormulas, terms: Sequence[Term], places: Sequence[int]
) -> list[Term]:
    """All second derivatives of terms with respect to some variables."""
    first = [row[i] for row in sheet.slopes(terms) for i in places]
    return [row[i] for row in sheet.slopes(first) for i in places]


def _degree(sheet: SystemFormulas, term: Term, places: Sequence[int]) -> int:
    """The degree of a term as a polynomial in some variables; 3 for anything higher."""
    inside = set(places)
    if not sheet.depends([term]) & inside:
        return 0
    if not sheet.depends([sheet.slopes([term])[0][i] for i in places]) & inside:
        return 1
    return 3 if sheet.depends(_second_derivatives(sheet, [term], places)) & inside else 2


def _random_base_states(fibration: Fibration) -> FloatArray:
    """States over random base points, with zero fibre."""
    gauss = counter_normals(0, np.arange(_SAMPLE), np.zeros(_SAMPLE), fibration.numbers)
    states = np.zeros((fibration.size, _SAMPLE))
    states[list(fibration.base)] = fibration.base_states(fibration.uniform_points(gauss))
    return states


def _periodic(fibration: Fibration, states: FloatArray, values: FloatArray) -> bool:
    """True if all terms are periodic in the angles of the base."""
    turned = states.copy()
    turned[list(fibration.angles)] += 2 * np.pi
    here, there = (fibration.coefficients(s, values) for s in (states, turned))
    return bool((np.abs(there - here) <= _SAME * (1 + np.abs(here))).all())


def _is_bounded(fibration: Fibration, values: FloatArray) -> bool:
    """True if the quadratic condition is definite at a sample of base points."""
    states = _random_base_states(fibration)
    if not _periodic(fibration, states, values):
        return False
    n, _, A, _, _ = fibration.parts(states, values)
    if not (np.isfinite(n).all() and np.isfinite(A).all()):
        return False
    # Definiteness is required only on the plane of the linear conditions; their normals give the
    # zero eigenvalues that are dropped.
    across = np.eye(len(fibration.fibre)) - np.linalg.pinv(n) @ n if n.shape[1] else 1.0
    sizes = np.linalg.eigvalsh(across @ A @ across if n.shape[1] else A)[:, n.shape[1] :]
    return bool((sizes[:, 0] > _DEFINITE * sizes[:, -1]).all())


def _ellipsoids(
    system: System, values: FloatArray
) -> tuple[dict[tuple[int, ...], tuple[float, ...]], list[sp.Expr]]:
    """Variables on ellipsoids with their semi-axes, and the remaining relations.

    δ(∑ xᵢ²/aᵢ² − 1) dx is the uniform measure of the unit vectors xᵢ/aᵢ, up to a constant.
    """
    places = {symbol: i for i, symbol in enumerate(system.symbols)}
    numbers = dict(zip((p.symbol for p in system.parameters), map(float, values), strict=True))
    ellipsoids: dict[tuple[int, ...], tuple[float, ...]] = {}
    others: list[sp.Expr] = []
    for formula in system.scalar.relations:
        free = sorted(formula.free_symbols & set(places), key=places.__getitem__)
        axes = _half_axes(formula, free, numbers)
        if axes is None or {places[s] for s in free} & {i for own in ellipsoids for i in own}:
            others.append(formula)
        else:
            ellipsoids[tuple(places[s] for s in free)] = axes
    return ellipsoids, others


def _half_axes(
    formula: sp.Expr, free: Sequence[sp.Symbol], numbers: Mapping[sp.Symbol, float]
) -> tuple[float, ...] | None:
    """The semi-axes of an ellipsoid in principal axes; None for any other formula."""
    if not free or not formula.is_polynomial(*free):
        return None
    terms = sp.Poly(formula, *free).as_dict()
    constant = terms.pop((0,) * len(free), sp.S.Zero)
    squares_of = [tuple(2 * int(i == j) for j in range(len(free))) for i in range(len(free))]
    if set(terms) != set(squares_of) or not constant.free_symbols <= set(numbers):
        return None
    ratios = [-constant / terms[square] for square in squares_of]
    if not all(ratio.free_symbols <= set(numbers) for ratio in ratios):
        return None
    sizes = [float(ratio.subs(numbers)) for ratio in ratios]
    return tuple(math.sqrt(size) for size in sizes) if min(sizes) > 0 else None
