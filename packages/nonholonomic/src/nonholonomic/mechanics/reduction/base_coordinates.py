"""The two base coordinates of a system with symmetry, whose equations decouple.

Coordinates that occur neither in the Lagrangian nor in the constraints are omitted. Two coordinates
must remain, or a unit vector, with the angles θ, φ of

    γ = (sin θ sin φ, sin θ cos φ, cos θ).
"""

from __future__ import annotations

import random
from collections.abc import Mapping
from dataclasses import dataclass, replace
from itertools import combinations

import sympy as sp
from flint import fmpq, fmpq_mat

from flowlanes.errors import InputError
from flowlanes.system.vectors import Vector, real_symbol

from ..lagrangian.mechanism import Mechanism
from .momenta import ReducedMomenta
from .rational_evaluation import Formulas, plain_symbols, rational_point

SEED = 1949
TRIES = 3


@dataclass(frozen=True)
class Base:
    """Two coordinates with their kinematics.

    Attributes
    ----------
    coordinates : tuple of Symbol
        q₁, q₂.
    place : mapping of Symbol to Expr
        The essential coordinates of the mechanism in terms of q₁ and q₂.
    fixed : mapping of Symbol to Expr
        Arbitrary values of the other coordinates, on which nothing depends.
    rates : Matrix
        ρ of q̇ = ρ u, two rows.
    normal : Vector, optional
        The unit vector, if the base is a sphere.
    motion : ReducedMomenta
        The equations of motion, with `place` substituted.
    """

    coordinates: tuple[sp.Symbol, sp.Symbol]
    place: Mapping[sp.Symbol, sp.Expr]
    fixed: Mapping[sp.Symbol, sp.Expr]
    rates: sp.Matrix
    normal: Vector | None
    motion: ReducedMomenta

    @property
    def inside(self) -> dict[sp.Symbol, sp.Expr]:
        """Values of all coordinates of the mechanism, for formulas of the base."""
        return {**self.place, **self.fixed}


def base(mechanism: Mechanism, motion: ReducedMomenta) -> Base:
    """Two coordinates in which the equations of motion are closed.

    Raises
    ------
    InputError
        If the equations need more than two coordinates, or these do not move freely.
    """
    needed = _essential_coordinates(mechanism, motion)
    vector = _unit_vector(mechanism, motion)
    if vector is not None:
        others = [q for q in needed if q not in vector.symbols]
        if others:
            raise _not_two(mechanism, f"the unit vector {vector.name} and {_list_text(others)}")
        return _sphere(mechanism, motion, vector)
    if motion.relations:
        raise InputError(
            f"{mechanism.name}: its coordinates are redundant; besides independent ones only a "
            "unit vector is understood"
        )
    if len(needed) > 2:
        raise _not_two(mechanism, _list_text(needed))
    return _pair(mechanism, motion, needed)


def _not_two(mechanism: Mechanism, what: str) -> InputError:
    return InputError(
        f"{mechanism.name}: its equations of motion need {what}; a Chaplygin system needs two "
        "coordinates"
    )


def _list_text(names: list[sp.Symbol]) -> str:
    return ", ".join(map(str, names))


def _unit_vector(mechanism: Mechanism, motion: ReducedMomenta) -> Vector | None:
    names = [n for n, _ in mechanism.frame.rates if isinstance(n, Vector) and n.shape[0] == 3]
    for name in names:
        unit = sp.Add(*(s**2 for s in name.symbols)) - 1
        if any(sp.expand(f - unit) == 0 for f in motion.relations):
            return name
    return None


def _entries(motion: ReducedMomenta) -> list[sp.Expr]:
    """All coefficients of the equations of motion, without the potential."""
    return [
        *motion.metric,
        *motion.gyroscopic,
        *motion.constraints,
        *motion.force,
    ]


def _essential_coordinates(mechanism: Mechanism, motion: ReducedMomenta) -> list[sp.Symbol]:
    """The coordinates on which the equations of motion depend."""
    entries = _entries(motion)
    pulled = [q for q in motion.coordinates if sp.diff(motion.potential, q) != 0]
    named = [q for q in motion.coordinates if any(e.has(q) for e in entries) and q not in pulled]
    if not named:
        return pulled
    formulas = Formulas(entries, mechanism.name)
    rng = random.Random(SEED)
    essential = pulled
    for q in named:
        # A coordinate may occur and yet cancel: the coefficients are compared at pairs of rational
        # points that differ in this coordinate alone.
        for _ in range(TRIES):
            first = rational_point([*plain_symbols(formulas.symbols), *motion.coordinates], rng)
            fixed = {s: v for s, v in first.items() if s not in rational_point([q], rng)}
            second = rational_point([q], rng, fixed)
            if formulas.at(first, fmpq(1)) != formulas.at(second, fmpq(1)):
                essential.append(q)
                break
    return essential


def _free_names(mechanism: Mechanism) -> tuple[sp.Symbol, sp.Symbol]:
    used = {
        *mechanism.symbols,
        *(p.symbol for p in mechanism.parameters),
        *(s for s, _ in mechanism.steps),
    }
    names = (real_symbol("theta"), real_symbol("phi"))
    return names if not used & set(names) else (real_symbol("theta_n"), real_symbol("phi_n"))


def _sphere(mechanism: Mechanism, motion: ReducedMomenta, vector: Vector) -> Base:
    theta, phi = _free_names(mechanism)
    sine, cosine = sp.sin(theta), sp.cos(theta)
    turn, across = sp.sin(phi), sp.cos(phi)
    place = dict(zip(vector.symbols, (sine * turn, sine * across, cosine), strict=True))
    index = [motion.coordinates.index(s) for s in vector.symbols]
    first, second, third = (motion.anchor.row(i).xreplace(place) for i in index)
    # With γ = (sin θ sin φ, sin θ cos φ, cos θ): γ̇₃ = −θ̇ sin θ and γ̇₁ cos φ − γ̇₂ sin φ = φ̇ sin
    # θ.
    rates = sp.Matrix.vstack(-third / sine, (across * first - turn * second) / sine)
    fixed = {q: sp.S.Zero for q in motion.coordinates if q not in place}
    moved = on_base(motion, {**place, **fixed})
    if not _spans(mechanism, sp.Matrix.vstack(rates, moved.constraints)):
        raise InputError(
            f"{mechanism.name}: {vector} does not move freely under the constraints, so that it "
            "does not reduce to two coordinates"
        )
    return Base((theta, phi), place, fixed, rates, vector, moved)


def _pair(mechanism: Mechanism, motion: ReducedMomenta, essential: list[sp.Symbol]) -> Base:
    """Two coordinates, the essential ones among them, that move freely."""
    inessential = [q for q in motion.coordinates if q not in essential]
    place = dict.fromkeys(inessential, sp.S.Zero)
    for chosen in combinations(motion.coordinates, 2):
        if not set(essential) <= set(chosen):
            continue
        others = {q: v for q, v in place.items() if q not in chosen}
        rows = motion.anchor.extract(
            [motion.coordinates.index(q) for q in chosen], range(motion.anchor.cols)
        )
        rates = rows.xreplace(others)
        if rates.free_symbols & set(inessential) - set(chosen):
            continue
        moved = on_base(motion, others)
        if _spans(mechanism, sp.Matrix.vstack(rates, moved.constraints)):
            names = (chosen[0], chosen[1])
            return Base(names, {q: q for q in names}, others, rates, None, moved)
    raise InputError(
        f"{mechanism.name}: no two of its coordinates {_list_text(list(motion.coordinates))} move "
        "freely and by themselves under the constraints"
    )


def _spans(mechanism: Mechanism, rows: sp.Matrix) -> bool:
    formulas = Formulas(list(rows), mechanism.name)
    values = formulas.at(
        rational_point(plain_symbols(formulas.symbols), random.Random(SEED), _angles(rows)),
        fmpq(1),
    )
    return bool(fmpq_mat(rows.rows, rows.cols, values).rank() == rows.rows)


def _angles(rows: sp.Matrix) -> dict[sp.Symbol, fmpq]:
    return rational_point(sorted(rows.free_symbols, key=str), random.Random(SEED))


def on_base(motion: ReducedMomenta, place: Mapping[sp.Symbol, sp.Expr]) -> ReducedMomenta:
    """Substitute coordinates into the equations of motion.

    The relations then hold identically, and are dropped.
    """

    def with_values(matrix: sp.Matrix) -> sp.Matrix:
        return matrix.xreplace(dict(place))

    return replace(
        motion,
        relations=(),
        anchor=with_values(motion.anchor),
        constraints=with_values(motion.constraints),
        metric=with_values(motion.metric),
        gyroscopic=with_values(motion.gyroscopic),
        potential=motion.potential.subs(dict(place), simultaneous=True),
        force=with_values(motion.force),
        pull=with_values(motion.pull),
    )
