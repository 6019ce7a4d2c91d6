"""The energy theorem (Theorem 1) and its hypotheses."""

from __future__ import annotations

from dataclasses import dataclass

import mpmath
import sympy as sp

from flowlanes.printing.formula import text
from flowlanes.system.named_formulas import scalars

from .assembly import Balance
from .generic_points import ZERO, is_numerically_zero, with_working_precision
from .ldl import product
from .mechanism import TIME


@dataclass(frozen=True)
class EnergyTheorem:
    """Whether Theorem 1 applies.

    Attributes
    ----------
    energy : sympy.Expr
        E = w_i ∂L/∂w_i − L, (3.3).
    work : tuple of sympy.Expr
        w_i ∂f_μ/∂w_i for every constraint; its reaction has the power λ_μ times this.
    failures : tuple of str
        Descriptions of the hypotheses that fail; without any, energy is conserved.
    """

    energy: sp.Expr
    work: tuple[sp.Expr, ...]
    failures: tuple[str, ...]


@with_working_precision
def energy_theorem(parts: Balance) -> EnergyTheorem:
    """The energy, and the hypotheses of Theorem 1 that fail."""
    mechanism, tape = parts.mechanism, parts.tape
    w = mechanism.frame.w
    energy = _energy(parts)
    work = tuple(tape.short(product(row, w)) for row in parts.slopes)
    broken = []
    timed = [*scalars(energy), *parts.constraints, *mechanism.F, *mechanism.Q.values()]
    steps = tape.steps(timed)
    if any(TIME in value.free_symbols for value in (*timed, *(v for _, v in steps))):
        broken.append("time enters the Lagrangian, a force or a constraint")
    for index, (f, row) in enumerate(zip(parts.constraints, parts.slopes, strict=True)):
        # not shortened, since that would substitute solved velocities, and f would vanish
        if not _homogeneous(parts, f, product(row, w)):
            broken.append(
                f"the constraint {index + 1}, {text(f)} = 0, is not homogeneous in velocities"
            )
    power = sp.Add(*(force * s for s, force in mechanism.Q.items()))
    if not is_numerically_zero(power, parts.at([power])):
        broken.append("forces outside the potential do work")
    return EnergyTheorem(energy, work, tuple(broken))


def _energy(parts: Balance) -> sp.Expr:
    """The energy: T + U if the Lagrangian is T − U with T quadratic, else w_i p_i − L."""
    mechanism, tape = parts.mechanism, parts.tape
    virial = product(mechanism.frame.w, parts.momenta)
    terms = sp.Add.make_args(sp.sympify(mechanism.lagrangian))
    kinetic = sp.Add(*(term for term in terms if parts.moves(*scalars(term))))
    defect = virial - 2 * scalars(kinetic)[0]
    idle = {s for s in parts.constraint_of if tape.value(s) == 0}
    if is_numerically_zero(defect, parts.at_any([defect])):
        energy = 2 * kinetic - sp.sympify(mechanism.lagrangian)
        return energy.xreplace(dict.fromkeys(idle, sp.S.Zero))
    return tape.short(virial - mechanism.L, hold={*parts.constraint_of} - idle)


def _homogeneous(parts: Balance, f: sp.Expr, euler: sp.Expr) -> bool:
    """Whether w ∂f/∂w = κ f with one number κ, at all generic points."""
    raw = parts.at_any([f, euler])
    # Euler's theorem: w ∂f/∂w = κ f for a homogeneous f of degree κ; then the reaction does no work
    # where f = 0
    ratios = []
    for point in raw:
        value, slope = point.value(f), point.value(euler)
        if abs(value) < ZERO:
            return bool(abs(slope) < ZERO)
        ratios.append(slope / value)
    return all(abs(ratio - ratios[0]) < mpmath.sqrt(ZERO) for ratio in ratios)
