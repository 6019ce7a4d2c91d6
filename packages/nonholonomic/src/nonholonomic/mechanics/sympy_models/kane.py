"""Kane's equations of a SymPy model as a System, with constraints by multipliers.

SymPy eliminates dependent speeds symbolically, which leads to large formulas and division by a
determinant that may vanish. Here the equations of the unconstrained bodies are formed, and the
constraints enter by multipliers:

    A u̇ = F + Bᵀ λ,      B u + b = 0,      d(B u + b)/dt = 0,

which is Kane's method in another order.  Every intermediate result has a name.
"""

from __future__ import annotations

import random
from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import mpmath
import sympy as sp
from sympy.physics.mechanics import KanesMethod, dynamicsymbols

from flowlanes.errors import InputError
from flowlanes.formulas.tape import Derivation, Tape
from flowlanes.system.system import Observable, System
from flowlanes.system.vectors import real_symbol

from ..lagrangian.assembly import balance
from ..lagrangian.generic_points import (
    DIGITS,
    GenericPoint,
    generic_points,
    is_numerically_zero,
    regular_minor,
    with_working_precision,
)
from ..lagrangian.ldl import Factorisation, product
from ..lagrangian.mechanism import TIME, Frame, Mechanism
from .auxiliary import auxiliary_reactions
from .names import Defaults, Inputs, NameTranslation, name_translation


class _Plain(Tape):
    """A tape without simplification: SymPy's formulas are long, and shared parts have names."""

    def short(self, value: sp.Expr, hold: Collection[sp.Symbol] = ()) -> sp.Expr:
        """The formula itself."""
        return value


@dataclass(frozen=True)
class Kane:
    """A Kane model in plain symbols.

    Attributes
    ----------
    name, title : str
    words : NameTranslation
        Translation of the model's formulas to plain symbols.
    coordinates, speeds : tuple of Symbol
    rates : tuple of Expr
        Rates of the coordinates, in terms of the speeds.
    mass : tuple of tuples of Expr
        The mass matrix A of the unconstrained bodies.
    force : tuple of Expr
        F: generalised active forces plus the inertia forces at u̇ = 0.
    active : tuple of Expr
        Generalised active forces alone.
    kinetic : Expr
        Kinetic energy.
    positions : tuple of Expr
        Configuration constraints.
    slopes : tuple of tuples of Expr
        B.
    constraints : tuple of Expr
        B u + b.
    reactions : tuple of (Symbol, Expr)
        Forces that auxiliary speeds determine; they may contain `accelerations` and multipliers
        ``lambda_1``, ….
    accelerations : tuple of Symbol
        Symbols of u̇ in the reactions.
    """

    name: str
    title: str
    words: NameTranslation
    coordinates: tuple[sp.Symbol, ...]
    speeds: tuple[sp.Symbol, ...]
    rates: tuple[sp.Expr, ...]
    mass: tuple[tuple[sp.Expr, ...], ...]
    force: tuple[sp.Expr, ...]
    active: tuple[sp.Expr, ...]
    kinetic: sp.Expr
    positions: tuple[sp.Expr, ...]
    slopes: tuple[tuple[sp.Expr, ...], ...]
    constraints: tuple[sp.Expr, ...]
    reactions: tuple[tuple[sp.Symbol, sp.Expr], ...]
    accelerations: tuple[sp.Symbol, ...]

    def system(self) -> System:
        """The closed equations of motion.

        Raises
        ------
        InputError
            If the mass matrix is singular on the speeds that the constraints allow, or the
            constraints depend on each other.
        """
        tape, shared = self._shared_formulas()
        mass, force, slopes, rates, constraints, kinetic = shared
        along = self._derivation(tape, rates)
        defect = [tape.name(-tape.along(along, f)) for f in constraints]
        if self._deficient(tape, mass):
            mass, force = _with_constraint_inertia(tape, mass, force, slopes, defect)
            if self._deficient(tape, mass):
                raise InputError(
                    f"{self.name}: the mass matrix is singular on the speeds that the constraints "
                    "allow; a speed moves no mass"
                )
        accelerations, multipliers = self._accelerations_and_multipliers(
            tape, mass, force, slopes, defect
        )
        timed = TIME in self._used_symbols(tape, (*accelerations, *rates))
        labels = [real_symbol(f"lambda_{i + 1}") for i in range(len(multipliers))]
        observables = [
            Observable(str(s), value, f"multiplier of {_brief(f)} = 0")
            for s, value, f in zip(labels, multipliers, self.constraints, strict=True)
        ]
        moving = dict(zip(self.accelerations, accelerations, strict=True))
        moving |= dict(zip(labels, multipliers, strict=True))
        observables += [
            Observable(str(s), value.xreplace(moving), f"reaction {s}")
            for s, value in self.reactions
        ]
        observables.append(Observable("kinetic_energy", kinetic, "kinetic energy", "J"))
        field = {
            **dict(zip(self.coordinates, rates, strict=True)),
            **dict(zip(self.speeds, accelerations, strict=True)),
            **({TIME: sp.S.One} if timed else {}),
        }
        wanted = [*field.values(), *constraints, *(o.value for o in observables)]
        return System(
            name=self.name,
            title=self.title,
            field=field,
            definitions=tape.steps(wanted),
            parameters=self.words.parameters,
            relations=(*self.positions, *constraints),
            observables=tuple(observables),
            source="SymPy, Kane's method",
        )

    def mechanism(self) -> Mechanism:
        """The model as a mechanism with Lagrangian T and Kane's active forces.

        Raises
        ------
        InputError
            If speeds and coordinates do not correspond.
        """
        if self.reactions:
            names = ", ".join(str(s) for s, _ in self.reactions)
            raise InputError(
                f"{self.name}: auxiliary speeds bring out {names}, which a mechanism does not "
                "record; take the model as a System"
            )
        still = dict.fromkeys(self.speeds, sp.S.Zero)
        drifting = [q for q, r in zip(self.coordinates, self.rates, strict=True) if r.subs(still)]
        if len(self.speeds) != len(self.coordinates) or drifting:
            raise InputError(
                f"{self.name}: {len(self.speeds)} speeds for {len(self.coordinates)} coordinates: "
                "a mechanism needs as many, related linearly and homogeneously; take the model as "
                "a System"
            )
        free = Mechanism(
            name=self.name,
            title=self.title,
            frame=Frame(dict(zip(self.coordinates, self.rates, strict=True)), self.speeds),
            lagrangian=self.kinetic,
            positions=self.positions,
            forces=dict(zip(self.speeds, self.active, strict=True)),
            parameters=self.words.parameters,
            source="SymPy, Kane's method",
        )
        return replace(free, constraints=self._independent_of_positions(free))

    @with_working_precision
    def _independent_of_positions(self, free: Mechanism) -> tuple[sp.Expr, ...]:
        """The velocity constraints that do not follow from the position constraints."""
        rates = [
            [
                sp.Add(
                    *(
                        sp.diff(f, q) * sp.diff(rate, s)
                        for q, rate in zip(self.coordinates, self.rates, strict=True)
                    )
                )
                for s in self.speeds
            ]
            for f in self.positions
        ]
        point = generic_points(self.name, free.frame, free)[0]
        rows = [[point.value(e) for e in row] for row in (*rates, *self.slopes)]
        chosen = regular_minor(rows)[0]
        return tuple(f for i, f in enumerate(self.constraints, len(rates)) if i in chosen)

    @with_working_precision
    def require_same_motion(self, mechanism: Mechanism) -> None:
        """Refuse a mechanism whose equations without constraints differ from Kane's.

        Compared at generic points, with 50 digits.
        """
        parts = balance(replace(mechanism, constraints=(), positions=()))
        for i, (push, p) in enumerate(zip(parts.push, parts.momenta, strict=True)):
            lagrange = push - parts.tape.along(parts.time, p)
            if not is_numerically_zero(lagrange - self.force[i], parts.at([lagrange])):
                raise InputError(
                    f"{self.name}: Lagrange's equation of the speed {self.speeds[i]} is not "
                    "Kane's: a constraint was built into the velocities of points (a contact "
                    "point at rest), which is no kinematics of the unconstrained bodies; take the "
                    "model as a System, or write the constraint as a velocity constraint"
                )

    def _shared_formulas(self) -> tuple[Tape, tuple[Any, ...]]:
        """A tape of common subexpressions, and the formulas in terms of its names."""
        groups: list[Sequence[sp.Expr]] = [
            *self.mass, self.force, *self.slopes, self.rates, self.constraints, (self.kinetic,)
        ]  # fmt: skip
        used = {*self.coordinates, *self.speeds, TIME, *(p.symbol for p in self.words.parameters)}
        names = (s for s in sp.numbered_symbols("x_", real=True, start=1) if s not in used)
        steps, short = sp.cse([e for group in groups for e in group], names, list=True)
        tape = _Plain(steps, used)
        left = iter(short)
        rows = [tuple(next(left) for _ in group) for group in groups]
        size = len(self.speeds)
        count = len(self.slopes)
        return tape, (
            rows[:size],
            rows[size],
            rows[size + 1 : size + 1 + count],
            rows[size + 1 + count],
            rows[size + 2 + count],
            rows[size + 3 + count][0],
        )

    def _derivation(self, tape: Tape, rates: Sequence[sp.Expr]) -> Derivation:
        """The rate of change at u̇ = 0."""
        still = tuple((s, sp.S.Zero) for s in self.speeds)
        return Derivation((*zip(self.coordinates, rates, strict=True), *still, (TIME, sp.S.One)))

    def _accelerations_and_multipliers(
        self,
        tape: Tape,
        mass: Sequence[Sequence[sp.Expr]],
        force: Sequence[sp.Expr],
        slopes: Sequence[Sequence[sp.Expr]],
        defect: Sequence[sp.Expr],
    ) -> tuple[list[sp.Expr], list[sp.Expr]]:
        """u̇ and λ of A u̇ = F + Bᵀ λ, B u̇ = d."""
        solver = Factorisation(tape, mass)
        if not slopes:
            return solver.solve(force), []
        # B u̇ = d with u̇ = A⁻¹(F + Bᵀλ) gives (B A⁻¹ Bᵀ) λ = d − B A⁻¹F
        bare = solver.solve(force)
        columns = [solver.solve(row) for row in slopes]
        gram = [[tape.name(product(row, column)) for column in columns] for row in slopes]
        if self._deficient(tape, gram):
            raise InputError(f"{self.name}: the velocity constraints depend on each other")
        missing = [tape.name(d - product(row, bare)) for d, row in zip(defect, slopes, strict=True)]
        multipliers = [tape.name(x) for x in Factorisation(tape, gram).solve(missing)]
        moved = [
            tape.name(x + product(multipliers, [column[i] for column in columns]))
            for i, x in enumerate(bare)
        ]
        return moved, multipliers

    def _deficient(self, tape: Tape, matrix: Sequence[Sequence[sp.Expr]]) -> bool:
        """Whether a matrix is singular at a generic point."""
        rng = random.Random(2007)
        with mpmath.workdps(DIGITS):
            values: dict[sp.Symbol, mpmath.mpf] = {
                s: mpmath.mpf(rng.randint(-999, 999)) / 1000 + mpmath.mpf(1) / 7001
                for s in (*self.coordinates, *self.speeds, TIME)
            }
            values |= {p.symbol: mpmath.mpf(repr(p.default)) for p in self.words.parameters}
            point = GenericPoint(values, tape.steps([e for row in matrix for e in row]))
            numbers = [[point.value(e) for e in row] for row in matrix]
            return len(regular_minor(numbers)[0]) < len(numbers)

    def _used_symbols(self, tape: Tape, formulas: Iterable[sp.Expr]) -> set[sp.Symbol]:
        listed = list(formulas)
        steps = tape.steps(listed)
        return {s for f in (*listed, *(v for _, v in steps)) for s in f.free_symbols}


def kane(
    model: KanesMethod,
    name: str,
    title: str,
    parameters: Defaults,
    inputs: Inputs,
) -> Kane:
    """A `KanesMethod` object in plain symbols.

    Raises
    ------
    InputError
        If the object has no bodies or kinematic equations yet, or a name is missing.
    """
    bodies, loads = model.bodies, model.loads
    if not bodies:
        raise InputError(
            f"{name}: the KanesMethod object has no bodies; call its kanes_equations(bodies, loads)"
        )
    q, u, extra = list(model.q), list(model.u), list(model._uaux)
    try:
        kinematics = model.kindiffdict()
    except AttributeError:
        raise InputError(
            f"{name}: the KanesMethod object has no kinematic differential equations (kd_eqs)"
        ) from None
    # the same bodies without constraints; SymPy itself sets auxiliary speeds to zero
    free = KanesMethod(
        model._inertial,
        q_ind=q,
        u_ind=u,
        kd_eqs=[rate - value for rate, value in kinematics.items()],
        u_auxiliary=extra,
    )
    active, inertia = free.kanes_equations(list(bodies), list(loads) if loads else None)
    size = len(u)
    absent = {f: 0 for s in extra for f in (s, s.diff(dynamicsymbols._t))}
    zero = {**absent, **{s.diff(dynamicsymbols._t): 0 for s in u}}
    active = list(sp.Matrix(active[:size]).xreplace(zero))
    mass = free._k_d
    bare = list(sp.Matrix(inertia[:size]).xreplace(zero))
    kinetic = sum(body.kinetic_energy(model._inertial) for body in bodies)
    kinetic = sp.sympify(kinetic).xreplace(kinematics).xreplace(zero)
    slopes = model._k_nh.tolist() if len(model._k_nh) else []
    whole = list(model._k_nh * sp.Matrix(u) + model._f_nh) if slopes else []
    constraints = [f.xreplace(absent) for f in whole]
    multipliers = [sp.Function(f"lambda_{i + 1}")(dynamicsymbols._t) for i in range(len(whole))]
    # generalised forces of the constraint reactions along the auxiliary speeds
    work = [
        sp.Add(*(x * sp.diff(f, s) for x, f in zip(multipliers, whole, strict=True))) for s in extra
    ]
    reactions = auxiliary_reactions(name, free, absent, work, [*q, *u], inputs)
    formulas = [
        *(*mass, *active, *bare, kinetic, *constraints, *model._f_h, *kinematics.values()),
        *reactions.values(),
    ]
    accelerations = {s.diff(dynamicsymbols._t): real_symbol(f"{s.func}dot") for s in u}
    plain = {**kinematics, **accelerations, **{x: _multiplier(x) for x in multipliers}}
    words = name_translation(name, formulas, [*q, *u], plain, parameters, inputs)
    return Kane(
        name=name,
        title=title,
        words=words,
        coordinates=tuple(map(words, q)),
        speeds=tuple(map(words, u)),
        rates=tuple(words(kinematics[x.diff(dynamicsymbols._t)]) for x in q),
        mass=tuple(tuple(words.all(mass.row(i))) for i in range(size)),
        force=tuple(words(a + b) for a, b in zip(active, bare, strict=True)),
        active=tuple(words.all(active)),
        kinetic=words(kinetic),
        positions=tuple(words.all(model._f_h)),
        slopes=tuple(tuple(words.all(row)) for row in slopes),
        constraints=tuple(words.all(constraints)),
        reactions=tuple((real_symbol(str(f.func)), words(x)) for f, x in reactions.items()),
        accelerations=tuple(accelerations.values()),
    )


def _multiplier(function: sp.Expr) -> sp.Symbol:
    """The symbol of a multiplier in the reactions."""
    return real_symbol(str(function.func))


def _with_constraint_inertia(
    tape: Tape,
    mass: Sequence[Sequence[sp.Expr]],
    force: Sequence[sp.Expr],
    slopes: Sequence[Sequence[sp.Expr]],
    defect: Sequence[sp.Expr],
) -> tuple[list[list[sp.Expr]], list[sp.Expr]]:
    """A + BᵀB and F + Bᵀd, equivalent because B u̇ = d; every speed then has inertia."""
    columns = list(zip(*slopes, strict=True)) if slopes else [()] * len(force)
    return (
        [
            [tape.name(a + product(p, r)) for a, r in zip(row, columns, strict=True)]
            for row, p in zip(mass, columns, strict=True)
        ],
        [tape.name(f + product(p, defect)) for f, p in zip(force, columns, strict=True)],
    )


def _brief(formula: sp.Expr) -> str:
    text = str(formula)
    return text if len(text) <= 60 else "a velocity constraint"
