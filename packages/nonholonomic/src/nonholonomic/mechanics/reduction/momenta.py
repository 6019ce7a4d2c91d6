"""Momenta and forces of a mechanism on its admissible velocities (§1.1).

Velocities that occur in a constraint with a numerical coefficient are eliminated, w = Z u; the
remaining constraints are C u = 0. With T = ½(u, Gu) + (l, u) and m = ∂L/∂u the equations are

    d/dt m_s = f_s(q, u) + λ_μ C_μs,    q̇ = A(q) u.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from flowlanes.errors import InputError
from flowlanes.system.vectors import real_symbol

from ..lagrangian.mechanism import TIME, Mechanism
from ..lagrangian.structure_functions import structure
from .rational_evaluation import is_rational


@dataclass(frozen=True)
class ReducedMomenta:
    """The equations of motion in free velocities u.

    Attributes
    ----------
    coordinates, velocities : tuple of Symbol
        q and u.
    relations : tuple of Expr
        Relations between the coordinates and position constraints.
    anchor : Matrix
        A of q̇ = A u.
    constraints : Matrix
        C of C u = 0; it may have no rows.
    metric : Matrix
        G of the kinetic energy ½(u, Gu).
    gyroscopic : Matrix
        l, the momenta at rest.
    potential : Expr
        U, minus the part of L without velocities.
    force : Matrix
        f without the forces of the potential, quadratic in u.
    pull : Matrix
        The forces of the potential; derivatives that are not rational are replaced by symbols.
    """

    coordinates: tuple[sp.Symbol, ...]
    velocities: tuple[sp.Symbol, ...]
    relations: tuple[sp.Expr, ...]
    anchor: sp.Matrix
    constraints: sp.Matrix
    metric: sp.Matrix
    gyroscopic: sp.Matrix
    potential: sp.Expr
    force: sp.Matrix
    pull: sp.Matrix

    @property
    def momenta(self) -> sp.Matrix:
        """m = Gu + l."""
        return self.metric * sp.Matrix(self.velocities) + self.gyroscopic

    def rate(self, value: sp.Expr) -> sp.Expr:
        """The time derivative of a function of the coordinates, linear in u."""
        rates = self.anchor * sp.Matrix(self.velocities)
        return sp.Add(
            *(sp.diff(value, q) * r for q, r in zip(self.coordinates, rates, strict=True))
        )


def gradient_by(value: sp.Expr, names: tuple[sp.Symbol, ...]) -> sp.Matrix:
    """The column ∂value/∂names."""
    return sp.Matrix([sp.diff(value, s) for s in names])


def motion(mechanism: Mechanism) -> ReducedMomenta:
    """The equations of motion of a mechanism with linear constraints.

    Raises
    ------
    InputError
        If the Lagrangian is not quadratic in the velocities or depends on time, if a constraint
        is not linear and homogeneous in them, or if forces without a potential act.
    """
    frame, name = mechanism.frame, mechanism.name
    w, q = frame.w, frame.coordinates
    lagrangian = mechanism.expand(mechanism.L)
    constraints = [mechanism.expand(f) for f in mechanism.f]
    _check(mechanism, lagrangian, constraints)
    dependent, remaining = _explicit_velocities(constraints, w)
    free = tuple(s for s in w if s not in dependent)
    at_rest = dict.fromkeys(w, sp.S.Zero)
    potential = -lagrangian.xreplace(at_rest)
    kinetic = lagrangian + potential
    Z = sp.Matrix([[sp.diff(dependent.get(s, s), u) for u in free] for s in w])
    mass = sp.hessian(lagrangian, w)
    carried = gradient_by(lagrangian, w).xreplace(at_rest)
    velocities = Z * sp.Matrix(free)
    momenta = mass * velocities + carried
    G = sp.Matrix(frame.matrix).applyfunc(mechanism.expand)
    anchor = G * Z
    rates = anchor * sp.Matrix(free)
    place = dict(zip(w, velocities, strict=True))
    push = []
    for i in range(len(w)):
        along = G.col(i).dot(gradient_by(kinetic, q))
        push.append(along.xreplace(place))
    # Poincaré's equations (1.9): ṗ_j = E_j(T) + c_ij^k w_i p_k + …, with c_ji^k = −c_ij^k.
    for (i, j, k), value in structure(frame, name).items():
        push[j] += value * momenta[k] * velocities[i]
        push[i] -= value * momenta[k] * velocities[j]
    # m = Zᵀp: its rate has the additional term Żᵀp
    turned = sp.Matrix(
        [
            sp.Add(
                *(
                    sp.diff(Z[i, s], x) * r * momenta[i]
                    for i in range(len(w))
                    for x, r in zip(q, rates, strict=True)
                )
            )
            for s in range(len(free))
        ]
    )
    return ReducedMomenta(
        coordinates=q,
        velocities=free,
        relations=(*frame.relations, *mechanism.F),
        anchor=anchor,
        constraints=sp.Matrix(
            len(remaining), len(free), [sp.diff(f, u) for f in remaining for u in free]
        ),
        metric=Z.T * mass * Z,
        gyroscopic=Z.T * carried,
        potential=potential,
        force=Z.T * sp.Matrix(push) + turned,
        pull=-anchor.T * sp.Matrix([_slope(potential, x) for x in q]),
    )


def _slope(potential: sp.Expr, coordinate: sp.Symbol) -> sp.Expr:
    """∂U/∂q, or a symbol in its place if it is not rational."""
    slope = sp.diff(potential, coordinate)
    return slope if is_rational(slope) else real_symbol(f"[dU/d{coordinate}]")


def _check(mechanism: Mechanism, lagrangian: sp.Expr, constraints: list[sp.Expr]) -> None:
    name, w = mechanism.name, mechanism.frame.w
    if lagrangian.has(TIME) or any(f.has(TIME) for f in constraints):
        raise InputError(f"{name}: it depends on time; a Chaplygin system does not")
    if any(force != 0 for force in mechanism.Q.values()):
        raise InputError(
            f"{name}: the forces along {', '.join(map(str, mechanism.Q))} have no potential; a "
            "Chaplygin system has forces of a potential alone"
        )
    velocities = set(w)
    if any(e.free_symbols & velocities for e in sp.hessian(lagrangian, w)):
        raise InputError(f"{name}: the Lagrangian is not quadratic in the velocities")
    for f in constraints:
        if any(sp.diff(f, s).free_symbols & velocities for s in w):
            raise InputError(f"{name}: the constraint {f} = 0 is not linear in the velocities")
        if sp.expand(f.xreplace(dict.fromkeys(w, sp.S.Zero))) != 0:
            raise InputError(
                f"{name}: the constraint {f} = 0 is affine: it does not vanish at rest; a "
                "Chaplygin system has constraints homogeneous in the velocities"
            )


def _explicit_velocities(
    constraints: list[sp.Expr], w: tuple[sp.Symbol, ...]
) -> tuple[dict[sp.Symbol, sp.Expr], list[sp.Expr]]:
    """Solved velocities in terms of the free ones, and the remaining constraints."""
    dependent: dict[sp.Symbol, sp.Expr] = {}
    remaining = []
    for constraint in constraints:
        f = constraint.xreplace(dependent)
        # the last velocities first, so that translations follow from rotations
        for s in reversed(w):
            slope = sp.diff(f, s)
            if s not in dependent and slope.is_Number and slope != 0:
                value = -f.xreplace({s: sp.S.Zero}) / slope
                dependent = {known: v.xreplace({s: value}) for known, v in dependent.items()}
                dependent[s] = value
                break
        else:
            remaining.append(f)
    return dependent, [f.xreplace(dependent) for f in remaining]
