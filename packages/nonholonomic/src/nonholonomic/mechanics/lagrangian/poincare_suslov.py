"""The Poincaré–Suslov equations (1.9) in closed form: a Mechanism becomes a System.

With p_i = ∂L/∂w_i and the constraints f_μ = 0, the equations

    ṗ_i − c_ji^k p_k w_j − E_i(L) = Q_i + λ_μ ∂f_μ/∂w_i,      q̇ = G w

(Chetaev's rule where a constraint is not linear) are linear in ẇ and λ. Velocities that occur in a
constraint with a numerical coefficient are solved for and become definitions; the equations of the
others follow from virtual displacements that satisfy these constraints. The other multipliers
follow from the time derivatives of the other constraints. In the frame of the coordinates
themselves these are the equations of Ferrers, (1.3)–(1.5).

Cyclic coordinates are not part of the System and are reconstructed from its motion.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

import sympy as sp

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.printing.formula import text
from flowlanes.system.laws import Integral, Law, of_kind
from flowlanes.system.named_formulas import Pairs, expand, flat, in_components, scalars
from flowlanes.system.system import Name, Observable, Reconstruction, System
from flowlanes.system.vectors import constant

from .accelerations import Accelerations, accelerations
from .assembly import Balance, balance
from .definitions import name_definitions
from .energy import EnergyTheorem, energy_theorem
from .mechanism import TIME, Mechanism
from .power import power_theorem
from .units import momentum_units, multiplier_units


@dataclass(frozen=True)
class DerivedEquations:
    """The equations of motion of a mechanism, from which a System is built.

    Attributes
    ----------
    parts : Balance
    solution : Accelerations
    energy : EnergyTheorem
    """

    parts: Balance
    solution: Accelerations
    energy: EnergyTheorem


def derive(mechanism: Mechanism) -> DerivedEquations:
    """Accelerations, multipliers and the energy theorem of a mechanism.

    Raises
    ------
    InputError
        If the frame does not span, constraints are dependent or contradictory, or the mass matrix
        is singular on the velocities that the constraints allow.
    """
    parts = balance(mechanism)
    solution = accelerations(parts)
    for symbol, value in solution.multipliers:
        parts.tape.define(symbol, value)
    return DerivedEquations(parts, solution, energy_theorem(parts))


@arguments_checked
def equations_of_motion(mechanism: Mechanism) -> System:
    """The closed equations of motion of a mechanism.

    Parameters
    ----------
    mechanism : Mechanism

    Returns
    -------
    System
        State: the coordinates that are not cyclic, the velocities that are not solved for, and the
        time if it occurs. Relations: those of the frame, position constraints, and the constraints
        that are not solved for a velocity. The multipliers are observables, named ``lambda_1``, …
        in the order of the constraints. Its laws are the energy integral, if the hypotheses of
        Theorem 1 hold, and the momenta of cyclic velocities; otherwise ``energy`` and ``power`` are
        observables.

    Raises
    ------
    InputError
        As :func:`~nonholonomic.mechanics.lagrangian.poincare_suslov.derive`.

    Examples
    --------
    >>> import nonholonomic
    >>> import sympy as sp
    >>> x, y, z, xdot, ydot, zdot = sp.symbols("x y z xdot ydot zdot", real=True)
    >>> lagrangian, constraint = (xdot**2 + ydot**2 + zdot**2) / 2, zdot - y * xdot
    >>> particle = nonholonomic.Mechanism(
    ...     "particle", nonholonomic.coordinates(x, y, z), lagrangian, (constraint,)
    ... )
    >>> dict(nonholonomic.equations_of_motion(particle).field)
    {y: ydot, xdot: -xdot*y*ydot/(y**2 + 1), ydot: 0}
    """
    derived = derive(mechanism)
    parts = derived.parts
    relevant = _state_coordinates(derived)
    irrelevant = _irrelevant_coordinates(parts, relevant)
    laws = (*_energy_law(derived), *_momenta(parts), *mechanism.laws)
    observables = tuple(
        replace(o, value=_without_irrelevant(parts, irrelevant, o.value))
        for o in (*_observables(derived), *mechanism.observables)
    )
    relations = tuple(
        _without_irrelevant(parts, irrelevant, f)
        for f in (*mechanism.frame.relations, *mechanism.F)
    )
    following = {
        name: _without_irrelevant(parts, irrelevant, rate)
        for name, rate in mechanism.frame.rates
        if name not in relevant
    }
    unsolved = [f for i, f in enumerate(parts.constraints) if i not in parts.constraint_of.values()]
    rates = _velocity_rates(mechanism, derived.solution)
    names = name_definitions(
        parts,
        [
            *(f for _, f in rates),
            *(rate for name, rate in mechanism.frame.rates if name in relevant),
            *following.values(),
            *(o.value for o in observables),
            *(g.value for g in mechanism.guards),
            *(law.value for law in of_kind(laws, Integral)),
            *unsolved,
            *relations,
        ],
    )
    observables = tuple(replace(o, value=names(o.value)) for o in observables)
    here = tuple(o for o in observables if not _depends(parts, [o.value], irrelevant))
    timed = _depends(parts, _driving(derived), (TIME,))
    theorem = (
        None
        if derived.energy.failures
        else power_theorem(parts, derived.solution, names, relations)
    )
    if not (relevant or rates or timed):
        raise InputError(
            f"{mechanism.name}: the constraints leave nothing free to move, and no place matters"
        )
    return System(
        name=mechanism.name,
        title=mechanism.title,
        field=(
            *((name, rate) for name, rate in mechanism.frame.rates if name in relevant),
            *((name, names(rate)) for name, rate in rates),
            *(((TIME, sp.S.One),) if timed else ()),
        ),
        parameters=mechanism.parameters,
        definitions=names.definitions,
        relations=(
            *(f for f in relations if not _depends(parts, [f], irrelevant)),
            *(names(f) for f in unsolved),
        ),
        laws=tuple(
            replace(law, value=names(law.value)) if isinstance(law, Integral) else law
            for law in laws
        ),
        observables=here,
        guards=mechanism.guards,
        reconstruction=Reconstruction(
            field={name: names(rate) for name, rate in following.items()},
            relations=tuple(f for f in relations if _depends(parts, [f], irrelevant)),
            observables=tuple(o for o in observables if o not in here),
        )
        if following
        else None,
        source=mechanism.source or "(1.9)",
        summary=" ".join(filter(None, (mechanism.summary, *_energy_warning(derived.energy)))),
        theorems=() if theorem is None else (theorem,),
    )


# --- the state ------------------------------------------------------------------------------


def _driving(equations: DerivedEquations) -> list[sp.Expr]:
    """Formulas whose variables belong to the state."""
    parts = equations.parts
    mechanism = parts.mechanism
    values: list[sp.Basic] = [
        *equations.solution.rates.values(),
        *(value for _, value in equations.solution.multipliers),
        equations.energy.energy,
        *parts.constraints,
        *parts.constraint_of,
        *(g.value for g in mechanism.guards),
        *(law.value for law in of_kind((*mechanism.laws, *_momenta(parts)), Integral)),
    ]
    return values


def _uses(parts: Balance, formulas: Iterable[sp.Basic]) -> set[sp.Symbol]:
    values = scalars(tuple(formulas))
    symbols = {s for value in values for s in value.free_symbols}
    for symbol, value in parts.tape.steps(values):
        symbols |= {symbol} | value.free_symbols
    return symbols


def _depends(parts: Balance, formulas: Iterable[sp.Basic], symbols: Iterable[sp.Symbol]) -> bool:
    return bool(_uses(parts, formulas) & set(symbols))


def _state_coordinates(equations: DerivedEquations) -> set[Name]:
    """Coordinates, as whole vectors, on which the motion depends."""
    parts = equations.parts
    frame = parts.mechanism.frame
    used = _uses(parts, _driving(equations))
    relevant: set[Name] = set()
    while True:
        more = {n for n, _ in frame.rates if n not in relevant and set(flat((n,))) & used}
        if not more:
            return relevant
        relevant |= more
        used |= _uses(parts, [rate for name, rate in frame.rates if name in more])


def _irrelevant_coordinates(parts: Balance, relevant: set[Name]) -> tuple[sp.Symbol, ...]:
    return flat(name for name, _ in parts.mechanism.frame.rates if name not in relevant)


def _without_irrelevant(
    parts: Balance, irrelevant: Sequence[sp.Symbol], formula: sp.Basic
) -> sp.Basic:
    """A formula with definitions that depend on irrelevant coordinates substituted."""
    far: dict[sp.Symbol, sp.Expr] = {}
    # each step comes after those it uses
    for symbol, value in parts.tape.steps(scalars(formula)):
        if value.free_symbols & {*irrelevant, *far}:
            far[symbol] = value
    return expand(in_components(formula), far) if far else formula


# --- laws and observables ------------------------------------------------------------------


def _energy_law(equations: DerivedEquations) -> tuple[Law, ...]:
    if equations.energy.failures:
        return ()
    return (
        Integral("energy", equations.energy.energy, "energy", source="(3.3), Theorem 1", unit="J"),
    )


def _energy_warning(energy: EnergyTheorem) -> tuple[str, ...]:
    """A sentence about the hypotheses that fail; empty if energy is conserved."""
    if not energy.failures:
        return ()
    return (f"Theorem 1 does not give an energy integral: {'; '.join(energy.failures)}.",)


def _momenta(parts: Balance) -> tuple[Law, ...]:
    """Integrals p_i = const. of velocities without force, reaction and structure terms."""
    momenta = {
        s: parts.momenta[i]
        for i, s in enumerate(parts.mechanism.frame.w)
        if parts.push[i] == 0 and all(row[i] == 0 for row in parts.slopes)
    }
    units = momentum_units(parts.mechanism) if any(momenta.values()) else {}
    return tuple(
        Integral(f"momentum_{s}", p, f"momentum of {text(s)}", source="(1.9)", unit=units[s])
        for s, p in momenta.items()
        if p != 0
    )


def _observables(equations: DerivedEquations) -> tuple[Observable, ...]:
    mechanism = equations.parts.mechanism
    constraints = (*mechanism.f, *mechanism.F)
    shown = tuple(
        Observable(str(symbol), symbol, f"multiplier of {text(f)} = 0", unit, source="(1.9)")
        for (symbol, _), f, unit in zip(
            equations.solution.multipliers, constraints, multiplier_units(mechanism), strict=True
        )
    )
    if not equations.energy.failures:
        return shown
    symbols = [symbol for symbol, _ in equations.solution.multipliers]
    reactions = sp.Add(*(x * y for x, y in zip(symbols, equations.energy.work, strict=True)))
    forces = sp.Add(*(force * s for s, force in mechanism.Q.items()))
    power = reactions + forces - sp.diff(mechanism.L, TIME)
    return (
        *shown,
        Observable("energy", equations.energy.energy, "energy, not conserved", "J", source="(3.3)"),
        Observable("power", power, "rate of the energy", "W", source="(3.3)"),
    )


# --- the System ----------------------------------------------------------------------------


def _velocity_rates(mechanism: Mechanism, solution: Accelerations) -> Pairs:
    """Rates of the free velocities; a vector is kept if all its components are free."""
    pairs: list[tuple[sp.Basic, sp.Basic]] = []
    for name in mechanism.frame.velocities:
        parts = [s for s in flat((name,)) if s in solution.rates]
        if not isinstance(name, sp.Symbol) and len(parts) == len(name.symbols):
            pairs.append((name, constant([solution.rates[s] for s in parts])))
        else:
            pairs.extend((s, solution.rates[s]) for s in parts)
    return tuple(pairs)
