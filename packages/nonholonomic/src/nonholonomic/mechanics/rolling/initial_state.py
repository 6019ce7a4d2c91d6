"""The initial state of a rolling body, from angular velocity and normal.

Everything is computed with 50 digits and rounded once, so that an initial state is as accurate as
the given numbers; a decimal such as 0.1 means one tenth at any precision.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, SupportsFloat

import mpmath
import numpy as np
import sympy as sp

from flowlanes.arguments import Finite, Parameters, arguments_checked
from flowlanes.errors import InputError
from flowlanes.formulas.multiprecision import Multiprecision
from flowlanes.system.named_formulas import Pairs, flat, flat_pairs, in_words, scalar_names, scalars
from flowlanes.system.parameters import parameter_values
from flowlanes.system.system import System
from flowlanes.system.tuple_vectors import cross, dot
from flowlanes.system.vectors import Vector, to_components

from ..conventions import start_vectors
from ..rotations import quaternion_product
from ..shapes.gauss_map import contact_points_of_normals
from .attitude import attitude

DIGITS = 50

#: Largest relative violation of a constraint that is corrected; larger ones are refused.
SLACK = 1e-12

omega, gamma, zeta, r = Vector("omega"), Vector("gamma"), Vector("zeta"), Vector("r")
place = Vector("place", 2)


@arguments_checked
def rolling_state(
    system: System,
    omega: Sequence[float],
    gamma: Sequence[float],
    *,
    heading: Finite = 0.0,
    normal: Sequence[float] = (0.0, 0.0, 1.0),
    parameters: Parameters = None,
    fluid: Sequence[float] | Sequence[Sequence[float]] = (),
) -> tuple[Any, ...]:
    """The state of a rolling body, lifted to space; see :func:`nonholonomic.initial_state`.

    Parameters
    ----------
    system : System
    omega : 3 floats
        Angular velocity, body axes (rad/s).
    gamma : 3 floats
        Outward normal of the supporting surface at the contact, body axes; normalised here.
    heading : float
        Angle (rad) by which the body is turned about the normal, from the attitude that takes γ to
        `normal` along the shortest way.
    normal : 3 floats
        The normal in space axes; (0, 0, 1) on a plane.
    parameters : mapping of Symbol to number, optional
        Values that replace the system's defaults.
    fluid : 3 floats, or a sequence of these
        Motion ξ of the fluid in a cavity relative to the body, body axes (rad/s): its velocity
        there is A(ξ×A⁻¹x).  For several cavities one for each; empty for fluids at rest in the
        body.

    Returns
    -------
    tuple of mpmath.mpf
        In the flat order of ``system.lifted().symbols``.  The contact point starts above or below
        the origin of space.

    Raises
    ------
    InputError
        If γ or the normal is zero or outside the domain of the equations (a body lying flat), or
        ω breaks the constraint (ω, γ) = 0 of a rubber contact; the message then names the
        nearest admissible ω; or if `fluid` does not fit the cavities.
    """
    with mpmath.workdps(DIGITS):
        lifted = system.lifted() if system.reconstruction else system
        _check_determined(system, lifted)
        values = parameter_values(system, parameters)
        known = {s: _number(v) for s, v in values.items()}
        spin = _vector(omega, "omega")
        up = _direction(gamma, "gamma")
        _check_spin(system, spin, up)
        known |= dict(zip(_OMEGA, spin, strict=True)) | dict(zip(_GAMMA, up, strict=True))
        known |= _moving_fluids(system, fluid)
        if r in system.state:
            known |= dict(zip(r.symbols, _contact_point(system, up, known), strict=True))
        turn = attitude_of_normal(up, _direction(normal, "normal"), _number(heading))
        known |= dict(zip(attitude.symbols, turn, strict=True))
        known |= dict(zip(zeta.symbols, _third_row(turn), strict=True))
        known |= _evaluate(system, _of_attitude(system.conventions.start_formulas), known)
        _check_domain(system, known)
        known |= _evaluate(system, system.conventions.start_formulas, known)
        known |= dict(zip(place.symbols, _place(system, known), strict=True))
        return tuple(known[s] for s in lifted.symbols)


_OMEGA, _GAMMA = omega.symbols, gamma.symbols


def _check_determined(system: System, lifted: System) -> None:
    """Refuse a system whose state does not follow from ω and γ of a body in three dimensions."""
    names = (omega, gamma, r, attitude, zeta, place, *start_vectors(system))
    following = {s for name in names for s in name.symbols}
    following |= set(scalar_names(system.conventions.start_formulas))
    missing = [s for s in lifted.symbols if s not in following]
    if missing:
        what = ", ".join(str(n) for n in lifted.state if set(flat([n])) & set(missing))
        raise InputError(
            f"{system.name}: omega and gamma, of three numbers each, do not determine {what}; give "
            f"a state by name: {in_words(system.state)}"
        )


def _moving_fluids(system: System, fluid: Sequence[Any]) -> dict[sp.Symbol, mpmath.mpf]:
    """The motion of each fluid relative to the body, by component."""
    names = start_vectors(system)
    plain = all(isinstance(x, SupportsFloat) for x in fluid)
    rows = list(fluid) if not plain else [fluid] if len(fluid) else []
    if rows and not names:
        raise InputError("fluid: the body has no cavity with fluid in it; leave it out")
    if rows and len(rows) != len(names):
        several = "s" if len(names) > 1 else ""
        raise InputError(
            f"fluid: {len(names)} vector{several} of three numbers are needed, one for each cavity "
            f"with fluid in it, not {len(rows)}"
        )
    rows = rows or [[0.0, 0.0, 0.0]] * len(names)
    return {
        s: x
        for name, row in zip(names, rows, strict=True)
        for s, x in zip(name.symbols, _vector(row, "fluid"), strict=True)
    }


def _number(value: object) -> mpmath.mpf:
    return mpmath.mpf(repr(float(value))) if isinstance(value, (int, float)) else mpmath.mpf(value)


def _vector(values: Sequence[float], name: str) -> list[mpmath.mpf]:
    if len(values) != 3:
        raise InputError(f"{name}: three numbers are needed, not {len(values)}")
    numbers = [_number(x) for x in values]
    if not all(mpmath.isfinite(x) for x in numbers):
        raise InputError(f"{name} {tuple(values)}: all three numbers must be finite")
    return numbers


def _direction(values: Sequence[float], name: str) -> list[mpmath.mpf]:
    numbers = _vector(values, name)
    length = mpmath.sqrt(sum(x * x for x in numbers))
    if length == 0:
        raise InputError(f"{name} is zero: it must point along the normal")
    return [x / length for x in numbers]


def _check_spin(system: System, spin: list[mpmath.mpf], up: list[mpmath.mpf]) -> None:
    """Remove a spin at rounding level; refuse a larger one."""
    if not any(is_no_spin(relation) for relation in system.relations):
        return
    excess = dot(spin, up)
    size = max(abs(x) for x in spin)
    nearest = [x - excess * y for x, y in zip(spin, up, strict=True)]
    # components at the level of the working precision are zeros with rounding errors
    nearest = [x if abs(x) > mpmath.mpf(10) ** (10 - DIGITS) * size else 0 * x for x in nearest]
    if abs(excess) > SLACK * size:
        shown = ", ".join(repr(float(x)) for x in nearest)
        raise InputError(
            f"omega: (omega, gamma) = {float(excess):.6g}, and a body that must not spin about "
            f"the normal needs 0; the nearest admissible omega is [{shown}]"
        )
    spin[:] = nearest


def is_no_spin(relation: sp.Expr) -> bool:
    """Whether a relation is (ω, γ) = 0."""
    product = sp.Add(*(x * y for x, y in zip(_OMEGA, _GAMMA, strict=True)))
    return scalars(relation) == [product]


def _of_attitude(start: Pairs) -> Pairs:
    """The pairs of a start that depend on the attitude alone."""
    return tuple(
        (name, formula)
        for name, formula in start
        if to_components(formula).free_symbols <= set(attitude.symbols)
    )


def _check_domain(system: System, known_values: Mapping[sp.Symbol, mpmath.mpf]) -> None:
    """Refuse a position outside the domain of the equations."""
    for guard in system.scalar.guards:
        if guard.lift_off:
            continue
        try:
            value = evaluate(system, [guard.value], known_values)[0]
        except ZeroDivisionError:
            value = mpmath.mpf(0)
        if not value > 0:
            raise InputError(f"gamma: this start is outside the domain; {guard.message}")


def attitude_of_normal(
    up: list[mpmath.mpf], normal: list[mpmath.mpf], heading: mpmath.mpf
) -> list[mpmath.mpf]:
    """The quaternion from `up` (body) to `normal` (space), turned by `heading`."""
    cosine = dot(up, normal)
    axis = cross(up, normal)
    if cosine < -1 + mpmath.mpf(10) ** -20:
        # opposite vectors: take the half turn about a perpendicular axis, built from the basis
        # vector farthest from `up`
        least = min(range(3), key=lambda i: abs(up[i]))
        axis = cross(up, [mpmath.mpf(int(i == least)) for i in range(3)])
        short = [mpmath.mpf(0), *axis]
    else:
        # (1 + cos α, sin α · axis) is the quaternion of the rotation by α, up to its length 2
        # cos(α/2)
        short = [1 + cosine, *axis]
    half = heading / 2
    turn = [mpmath.cos(half), *(mpmath.sin(half) * x for x in normal)]
    product = quaternion_product(turn, short)
    length = mpmath.sqrt(sum(x * x for x in product))
    return [x / length for x in product]


def _third_row(turn: list[mpmath.mpf]) -> list[mpmath.mpf]:
    """The vertical of space seen from the body."""
    w, x, y, z = turn
    return [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]


def _evaluate(
    system: System, pairs: Pairs, known_values: Mapping[sp.Symbol, mpmath.mpf]
) -> dict[sp.Symbol, mpmath.mpf]:
    """Values of named formulas at known symbols."""
    scalars = dict(flat_pairs(pairs))
    return dict(zip(scalars, evaluate(system, [*scalars.values()], known_values), strict=True))


def evaluate(
    system: System, formulas: Sequence[sp.Expr], known_values: Mapping[sp.Symbol, Any]
) -> list[Any]:
    """Values of scalar formulas of a system, in the working precision of mpmath."""
    numbers = Multiprecision(known_values)
    numbers.define(system.required_definitions(formulas, inputs=known_values))
    return [numbers(formula) for formula in formulas]


def _contact_point(
    system: System, up: list[mpmath.mpf], known_values: Mapping[sp.Symbol, mpmath.mpf]
) -> list[mpmath.mpf]:
    """The point r of an implicit surface f(r − c) = 0 whose outward normal is −γ.

    A solution in double precision is refined by Newton's method for ∇f + ℓγ = 0, f = 0, with
    the length ℓ of the gradient as fourth unknown.
    """
    surface, coordinates = system.scalar.relations[0], r.symbols
    values = {s: v for s, v in known_values.items() if s in surface.free_symbols}
    centre = [known_values.get(s, mpmath.mpf(0)) for s in Vector("c").symbols]
    shifted = surface.subs(values).subs(
        {s: s + v for s, v in zip(coordinates, centre, strict=True)}, simultaneous=True
    )
    guess = contact_points_of_normals(shifted, coordinates, np.array([[float(x) for x in up]]))[0]
    slopes = [shifted.diff(s) for s in coordinates]
    formulas = [shifted, *slopes, *sp.hessian(shifted, coordinates)]
    x = mpmath.matrix([mpmath.mpf(float(v)) for v in guess])
    for _ in range(8):
        numbers = Multiprecision(dict(zip(coordinates, x, strict=True)))
        f, *rest = map(numbers, formulas)
        slope, hessian = rest[:3], rest[3:]
        length = mpmath.sqrt(sum(v * v for v in slope))
        matrix = mpmath.matrix(
            [[*hessian[3 * i : 3 * i + 3], up[i]] for i in range(3)] + [[*slope, 0]]
        )
        defect = mpmath.matrix([*(v + length * u for v, u in zip(slope, up, strict=True)), f])
        try:
            step = mpmath.lu_solve(matrix, -defect)
        except ZeroDivisionError:
            break
        x = x + step[:3, 0]
        if mpmath.norm(step[:3, 0]) < mpmath.mpf(10) ** (5 - DIGITS) * mpmath.norm(x):
            return [v + shift for v, shift in zip(x, centre, strict=True)]
    raise InputError(
        "gamma: no contact point with this normal was found; the surface must be smooth and "
        "strictly convex there"
    )


def _place(system: System, known_values: Mapping[sp.Symbol, mpmath.mpf]) -> list[mpmath.mpf]:
    """The centre of mass that puts the contact point at the origin of the plane."""
    zero = mpmath.mpf(0)
    if system.reconstruction is None or all(
        name != place for name, _ in system.reconstruction.field
    ):
        return [zero, zero]
    origin = {**known_values, **dict.fromkeys(place.symbols, zero)}
    contact = next(o.value for o in system.reconstruction.observables if o.name == "contact")
    return [-x for x in evaluate(system, scalars(contact)[:2], origin)]
