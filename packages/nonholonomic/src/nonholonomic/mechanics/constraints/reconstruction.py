"""The complete configuration space of a frame that was reduced by a symmetry group.

A frame with given structure functions omits cyclic coordinates. Those of rotations and Euclidean
motions are restored, as direction cosines α, β, γ and the position R of the centre of mass, so that
integrals of the constraints can be written down.

On a sphere the relation between γ̇ and ω holds along admissible motions only, and the commutators
of the fields on the coordinates differ from the structure functions. The configuration then
consists of attitude and contact point, with constraints on the angular velocity.
"""

from __future__ import annotations

import random
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TypeAlias

import sympy as sp

from flowlanes.errors import InputError
from flowlanes.formulas.expansion import TaylorExpansion
from flowlanes.formulas.taylor import PRIMES, IrrationalError, Modular, Series
from flowlanes.system.named_formulas import scalars
from flowlanes.system.vectors import Vector, cross, dot

from ..lagrangian.mechanism import Frame, euclidean, rotations
from ..lagrangian.structure_functions import Coefficients, VectorField, structure
from .exact_points import (
    ConfigurationSpace,
    FieldElement,
    NoPointError,
    ParameterValue,
    random_point,
)

Steps: TypeAlias = tuple[tuple[sp.Symbol, sp.Expr], ...]

alpha, beta, gamma, zeta, place = (Vector(n) for n in ("alpha", "beta", "gamma", "zeta", "R"))
SEED = 1911
ATTEMPTS = 8


@dataclass(frozen=True)
class Whole:
    """Coordinates, relations, fields of a frame and its structure functions.

    `structure` is None if the coordinates describe the whole configuration; `admissible` is true if
    the fields are correct along admissible motions only.
    """

    coordinates: tuple[sp.Symbol, ...]
    relations: tuple[sp.Expr, ...]
    fields: tuple[VectorField, ...]
    structure: Coefficients | None
    admissible: bool = False


def whole_configuration(
    frame: Frame,
    formulas: Sequence[sp.Expr],
    steps: Steps,
    constants: Mapping[sp.Symbol, ParameterValue],
) -> Whole:
    """The complete configuration space of a frame.

    Parameters
    ----------
    frame : Frame
    formulas : sequence of formula
        Constraints; coordinates on which neither they nor their rates depend are omitted.
    steps : pairs (Symbol, formula)
        Definitions.
    constants : mapping of Symbol to number
        Parameters.

    Raises
    ------
    InputError
        If the rates of the coordinates contradict the structure functions.
    """
    if frame.structure is None:
        return _whole(frame, None)
    coefficients = structure(frame)
    if _spans_all(frame, steps, constants):
        return _whole(frame, None)
    upright = set(gamma.symbols) & set(frame.coordinates)
    needed = _influential_coordinates(frame, [*formulas, *coefficients.values(), *upright], steps)
    bare = _whole(frame, coefficients, needed)
    used = {*constants, *dict(steps), *frame.w}
    for extra in _extras(frame, coefficients, bare, steps, used):
        if _has_commutators(extra, coefficients, steps, constants):
            return extra
    if _has_commutators(bare, coefficients, steps, constants):
        return bare
    attitude = _attitude_configuration(frame, coefficients, bare, used)
    if attitude is None:
        raise InputError(
            "frame: the rates of the coordinates contradict the structure functions; the "
            "commutators of the fields must be those that the structure functions tell"
        )
    return attitude


def _whole(
    frame: Frame,
    coefficients: Coefficients | None,
    coordinates_needed: set[sp.Symbol] | None = None,
) -> Whole:
    coordinates = [
        q for q in frame.coordinates if coordinates_needed is None or q in coordinates_needed
    ]
    relations = [
        r
        for r in frame.relations
        if not r.free_symbols & (set(frame.coordinates) - set(coordinates))
    ]
    fields = tuple(
        {q: v for q, v in frame.field(i).items() if q in coordinates} for i in range(len(frame.w))
    )
    return Whole(tuple(coordinates), tuple(relations), fields, coefficients)


def _influential_coordinates(
    frame: Frame, formulas: Sequence[sp.Expr], steps: Steps
) -> set[sp.Symbol]:
    """Coordinates on which formulas depend, directly or through rates and relations."""
    uses = {q: rate.free_symbols for q, rate in zip(frame.coordinates, frame.qdot, strict=True)}
    uses |= {s: value.free_symbols for s, value in steps}
    waiting = {s for f in formulas for s in f.free_symbols}
    reached: set[sp.Symbol] = set()
    while waiting:
        symbol = waiting.pop()
        reached.add(symbol)
        waiting |= uses.get(symbol, set()) - reached
        for relation in frame.relations:
            if symbol in relation.free_symbols & set(frame.coordinates):
                waiting |= relation.free_symbols & set(frame.coordinates) - reached
    return reached


def _spin(frame: Frame, coefficients: Coefficients) -> tuple[Vector, Vector | None] | None:
    """The angular velocity, and the linear one if any, with the structure functions of the frame.

    Other velocities, such as those of wheels, must commute with all.
    """
    names = [name for name in frame.velocities if isinstance(name, Vector)]
    kinds: list[tuple[Vector, Vector | None]] = [(spin, None) for spin in names]
    kinds += [(spin, speed) for spin in names for speed in names if spin != speed]
    for spin, speed in kinds:
        expected = rotations(spin) if speed is None else euclidean(spin, speed)
        if structure(replace(frame, structure=expected)) == coefficients:
            return spin, speed
    return None


def _extras(
    frame: Frame, coefficients: Coefficients, bare: Whole, steps: Steps, used: set[sp.Symbol]
) -> list[Whole]:
    """Configurations with direction cosines and position added, as far as names are free."""
    velocities = _spin(frame, coefficients)
    if velocities is None:
        return []
    spin, speed = velocities
    free = [d for d in (alpha, beta) if not set(d.symbols) & used]
    known = {*bare.coordinates, *dict(steps)}
    upright = set(gamma.symbols) <= known
    cosines = free if len(free) == 2 and set(gamma.symbols) <= set(bare.coordinates) else []
    rates = {d: scalars(cross(d, spin)) for d in cosines}
    relations = [dot(d, d) - 1 for d in cosines]
    if cosines:
        relations += [dot(alpha, beta), dot(alpha, gamma), dot(beta, gamma)]
    added = {s: rate for d, v in rates.items() for s, rate in zip(d.symbols, v, strict=True)}
    if speed is not None and not set(place.symbols) & used:
        axes = [*cosines, *([gamma] if upright else [])]
        for direction in axes:
            axis = (alpha, beta, gamma).index(direction)
            (added[place.symbols[axis]],) = scalars(dot(direction, speed))
    new = {s: rate for s, rate in added.items() if s not in bare.coordinates}
    return [_with_coordinates(frame, bare, new, relations)] if new else []


def _with_coordinates(
    frame: Frame, bare: Whole, new: Mapping[sp.Symbol, sp.Expr], relations: Sequence[sp.Expr]
) -> Whole:
    fields = []
    for field, w in zip(bare.fields, frame.w, strict=True):
        more = {s: sp.diff(rate, w) for s, rate in new.items()}
        fields.append({**field, **{s: v for s, v in more.items() if v != 0}})
    return replace(
        bare,
        coordinates=(*bare.coordinates, *new),
        relations=tuple(dict.fromkeys((*bare.relations, *scalars(tuple(relations))))),
        fields=tuple(fields),
    )


def _attitude_configuration(
    frame: Frame, coefficients: Coefficients, bare: Whole, used: set[sp.Symbol]
) -> Whole | None:
    """The configuration of attitude (direction cosines) and contact point."""
    velocities = _spin(frame, coefficients)
    rows = (alpha, beta, zeta)
    if velocities is None or any(set(d.symbols) & {*used, *bare.coordinates} for d in rows):
        return None
    spin, _ = velocities
    rates = {
        s: rate for d in rows for s, rate in zip(d.symbols, scalars(cross(d, spin)), strict=True)
    }
    relations = [dot(d, d) - 1 for d in rows]
    relations += [dot(alpha, beta), dot(alpha, zeta), dot(beta, zeta)]
    extended = _with_coordinates(frame, bare, rates, relations)
    return replace(extended, structure=None, admissible=True)


def _has_commutators(
    whole: Whole,
    coefficients: Coefficients,
    steps: Steps,
    constants: Mapping[sp.Symbol, ParameterValue],
) -> bool:
    """Whether the fields have the commutators given by the structure functions."""
    formulas = [*(v for field in whole.fields for v in field.values()), *coefficients.values()]
    germs = _germs(whole, formulas, steps, constants)
    return germs is not None and _commutes(whole, coefficients, germs)


def _spans_all(frame: Frame, steps: Steps, constants: Mapping[sp.Symbol, ParameterValue]) -> bool:
    """Whether the coordinates describe the whole configuration."""
    if len(frame.coordinates) < len(frame.w):
        return False
    whole = _whole(frame, None)
    germs = _germs(whole, frame.qdot, steps, constants)
    if germs is None:
        return False
    size = len(whole.coordinates)
    rows = [
        [germs.series(field.get(q, sp.S.Zero)).value for q in whole.coordinates]
        for field in whole.fields
    ]
    # The dimension of the configuration is the number of coordinates minus the rank of the
    # gradients of the relations; the fields span it if they are as many and independent.
    normals = [[germs.series(r).derivative(q).value for q in range(size)] for r in whole.relations]
    bound = int(germs.numbers.matrix(normals, size).rank()) if normals else 0
    return int(germs.numbers.matrix(rows, size).rank()) == len(frame.w) == size - bound


def _germs(
    whole: Whole,
    formulas: Sequence[sp.Expr],
    steps: Steps,
    constants: Mapping[sp.Symbol, ParameterValue],
) -> TaylorExpansion | None:
    """First-order series about a generic point modulo a prime; None if no point is found."""
    space = ConfigurationSpace(
        whole.coordinates, whole.relations, steps, tuple(formulas), tuple(constants.items())
    )
    rng = random.Random(SEED)
    for prime in PRIMES * ATTEMPTS:
        try:
            germs = random_point(space, Modular(prime), rng).germs(space, 1)
            for field in whole.fields:
                for value in field.values():
                    germs.series(value)
        except (NoPointError, IrrationalError, ZeroDivisionError):
            continue
        return germs
    return None


def _commutes(whole: Whole, coefficients: Coefficients, germs: TaylorExpansion) -> bool:
    number = {q: i for i, q in enumerate(whole.coordinates)}
    fields = [{number[q]: germs.series(v) for q, v in field.items()} for field in whole.fields]
    zero: FieldElement = germs.numbers.number(0)

    def rate(by: Mapping[int, Series], entry: Series | None) -> FieldElement:
        if entry is None:
            return zero
        total: FieldElement = sum(
            (v.value * entry.derivative(q).value for q, v in by.items()), zero
        )
        return total

    # [E_i, E_j] = c_ij^k E_k (1.8), component by component at one random point modulo a large
    # prime: an equation that does not hold identically fails there almost certainly.
    for i, first in enumerate(fields):
        for j in range(i + 1, len(fields)):
            second = fields[j]
            for q in number.values():
                left = rate(first, second.get(q)) - rate(second, first.get(q))
                for k, third in enumerate(fields):
                    c = coefficients.get((i, j, k))
                    if c is not None and q in third:
                        left = left - germs.series(sp.sympify(c)).value * third[q].value
                if left != 0:
                    return False
    return True
