"""Replacement of angles in the conditions by points of the unit circle.

If a relation or level contains sines or cosines of a state variable or parameter φ, the prover
uses s = sin φ and c = cos φ with s² + c² = 1 as variables in place of φ. The angle must not occur
in any other way in the system and the law.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, fields, replace
from functools import reduce
from typing import Any

import sympy as sp
from sympy.functions.elementary.trigonometric import TrigonometricFunction

from flowlanes.formulas.errors import OutOfReachError
from flowlanes.formulas.jets import MOST_MULTIPLES, angle_terms
from flowlanes.system.laws import Law
from flowlanes.system.named_formulas import expand, in_components, scalars
from flowlanes.system.system import Parameter, System, VariablesByName
from flowlanes.system.vectors import real_symbol


@dataclass(frozen=True)
class Circles:
    """A system whose angles are replaced by points of circles.

    Attributes
    ----------
    system : System
        With scalar state; ``sin_phi`` and ``cos_phi`` replace ``phi``.
    meaning : mapping of Symbol to Expr
        The functions of angles for which the new variables stand.
    table : mapping of Expr to Expr
        Replacements of the trigonometric functions.
    replaced_angles : mapping of Symbol to (Symbol, Symbol, Rational)
        For each angle: symbols of sine and cosine, and the multiple of the angle in them, which is
        a number or a formula in parameters, such as the frequency in sin νt.
    """

    system: System
    meaning: Mapping[sp.Symbol, sp.Expr]
    table: Mapping[sp.Expr, sp.Expr]
    replaced_angles: Mapping[sp.Symbol, tuple[sp.Symbol, sp.Symbol, sp.Expr]]

    def law(self, law: Law) -> Law:
        """A law in the new variables."""
        return law.under(self)

    def formula(self, value: Any) -> Any:
        """A value with its formulas in the new variables."""
        if isinstance(value, tuple):
            return tuple(self.formula(part) for part in value)
        if isinstance(value, sp.Basic) and not isinstance(value, sp.Symbol):
            return in_components(value).xreplace(dict(self.table))
        if isinstance(value, Law):
            return self.law(value)
        return value

    def vector_field(
        self, field: Iterable[tuple[sp.Symbol, sp.Expr]]
    ) -> tuple[tuple[sp.Symbol, sp.Expr], ...]:
        """A vector field in the new variables."""
        components: dict[sp.Symbol, sp.Expr] = {}
        for symbol, value in field:
            rate = value.xreplace(dict(self.table))
            components |= (
                dict(_rates_on_circle(self.replaced_angles[symbol], rate))
                if symbol in self.replaced_angles
                else {}
            )
            if symbol not in self.replaced_angles:
                components[symbol] = rate
        return tuple(components.items())

    def bracket(self, matrix: sp.MatrixBase) -> sp.ImmutableDenseMatrix:
        """A bracket in the new variables: {s, x} = c {φ, x}, {c, x} = −s {φ, x}."""
        old = self._old
        # The new bracket is D J Dᵀ with the differentials D of the new variables.
        rows = [[(old.index(s), factor) for s, factor in self._old_of(n)] for n in self.new]
        return sp.ImmutableDenseMatrix(
            [
                [
                    sp.Add(
                        *(
                            f * g * matrix[i, j].xreplace(dict(self.table))
                            for i, f in row
                            for j, g in column
                        )
                    )
                    for column in rows
                ]
                for row in rows
            ]
        )

    @property
    def new(self) -> tuple[sp.Symbol, ...]:
        """The state in the new variables."""
        return self.system.symbols

    @property
    def _old(self) -> tuple[sp.Symbol, ...]:
        """The state in the old variables, in order."""
        back = {s: angle for angle, (s, _, _) in self.replaced_angles.items()}
        gone = {c for _, c, _ in self.replaced_angles.values()}
        return tuple(back.get(n, n) for n in self.new if n not in gone)

    def _old_of(self, symbol: sp.Symbol) -> list[tuple[sp.Symbol, sp.Expr]]:
        """The differential of a new variable in terms of the differentials of the old ones."""
        for angle, (s, c, unit) in self.replaced_angles.items():
            if symbol == s:
                return [(angle, unit * c)]
            if symbol == c:
                return [(angle, -unit * s)]
        return [(symbol, sp.S.One)]


def circles(
    system: System, on: Iterable[sp.Expr] = (), also: Iterable[sp.Expr] = ()
) -> Circles | None:
    """The system with circles for the angles in its conditions; None if there are none.

    Parameters
    ----------
    on : iterable of formulas
        The level, in addition to the relations.
    also : iterable of formulas
        Other formulas in which the angles may occur.

    Raises
    ------
    OutOfReachError
        If an angle occurs outside sines and cosines, or in combination with another symbol.
    """
    steps = dict(system.scalar_definitions)
    conditions = [expand(c, steps) for c in (*system.scalar.relations, *scalars(tuple(on)))]
    nodes = {n for c in conditions for n in c.atoms(TrigonometricFunction)}
    angles = _angles(system, nodes)
    if not angles:
        return None
    formulas = [*system.rates, *steps.values(), *conditions, *scalars(tuple(also))]
    formulas += [g.value for g in system.scalar.guards]
    functions = {n for f in formulas for n in f.atoms(TrigonometricFunction)}
    table, lost = _replacements(functions, angles, steps)
    names = {*system.symbols, *steps, *(p.symbol for p in system.parameters)}
    for f in formulas:
        left = f.xreplace(table).free_symbols & set(angles)
        if left:
            raise OutOfReachError(
                f"the conditions hold the sine or cosine of {min(map(str, left))}, which occurs "
                "elsewhere by itself"
            )
    meaning: dict[sp.Symbol, sp.Expr] = {}
    for angle, (s, c, unit) in lost.items():
        if {s, c} & names:
            raise OutOfReachError(f"the names {s} and {c} are taken")
        meaning |= {s: sp.sin(unit * angle), c: sp.cos(unit * angle)}
    return Circles(_with_circles(system, table, lost), meaning, table, lost)


def without_angles(system: System, law: Law) -> tuple[System, Law]:
    """A system and a law with circles for the angles in the conditions.

    Raises
    ------
    OutOfReachError
        As :func:`circles`.
    """
    points = circles(system, law.level, formulas_of(law))
    return (system, law) if points is None else (points.system, points.law(law))


def _angles(system: System, nodes: Iterable[sp.Expr]) -> list[sp.Symbol]:
    """State variables in the arguments of the functions, and parameters that shift them."""
    state = set(system.symbols)
    symbols = {
        s
        for node in nodes
        for s in node.free_symbols
        if s in state or sp.diff(node.args[0], s).is_Rational
    }
    return sorted(symbols, key=str)


def formulas_of(value: object) -> list[sp.Expr]:
    """All formulas in a law."""
    if isinstance(value, sp.Basic):
        return [value]
    if isinstance(value, tuple):
        return [f for part in value for f in formulas_of(part)]
    if isinstance(value, Law):
        if value.by_components:
            # The scalar form has the functions of a moved angle, not the angle by itself.
            return list(value.scalar.formulas)
        skip = {"target", "as_printed", "onto"}
        parts = [getattr(value, f.name) for f in fields(value) if f.name not in skip]
        return [f for part in parts for f in formulas_of(part)]
    return []


def angle_parts(system: System, law: Law) -> dict[sp.Expr, int]:
    """Number of parts of each angle whose multiples occur in a law and its system.

    Sines and cosines of x and x/2 are polynomials in those of x/2, so that x has two parts.
    """
    formulas = [*system.rates, *(value for _, value in system.scalar_definitions)]
    formulas += [*system.relations, *law.level, *formulas_of(law)]
    parts: dict[sp.Expr, int] = {}
    for formula in scalars(formulas):
        for node in formula.atoms(TrigonometricFunction):
            for number, angle in angle_terms(node):
                if number.is_Rational:
                    parts[angle] = int(sp.ilcm(parts.get(angle, 1), number.q))
    return {angle: count for angle, count in parts.items() if count > 1}


def _rates_on_circle(
    circle: tuple[sp.Symbol, sp.Symbol, sp.Expr], rate: sp.Expr
) -> tuple[tuple[sp.Symbol, sp.Expr], ...]:
    s, c, unit = circle
    return (s, unit * rate * c), (c, -unit * rate * s)


def _replacements(
    nodes: Iterable[sp.Expr], angles: Iterable[sp.Symbol], steps: Mapping[sp.Symbol, sp.Expr]
) -> tuple[dict[sp.Expr, sp.Expr], dict[sp.Symbol, tuple[sp.Symbol, sp.Symbol, sp.Expr]]]:
    """Trigonometric functions as formulas in sines and cosines, with one circle for each angle."""
    angles = list(angles)
    concerned = [n for n in nodes if n.free_symbols & set(angles)]
    lost = {}
    for angle in angles:
        multiples = [m for m in (sp.diff(node.args[0], angle) for node in concerned) if m != 0]
        ratios = [sp.cancel(multiple / multiples[0]) for multiple in multiples]
        if not all(ratio.is_Rational for ratio in ratios) or multiples[0].has(*angles):
            raise OutOfReachError(f"{angle} stands in sines and cosines by different multiples")
        # With the common divisor of all multiples, every function is rational in one sine and one
        # cosine.
        unit = multiples[0] * reduce(sp.gcd, map(abs, ratios))
        unit = abs(unit) if unit.is_Rational else unit
        whole = unit == 1 or not unit.is_Rational
        label = str(angle) if whole else f"{angle}_{unit.p}_{unit.q}"
        lost[angle] = (real_symbol(f"sin_{label}"), real_symbol(f"cos_{label}"), unit)
    halves = {angle: sp.Dummy(real=True) for angle in angles}
    table = {}
    for node in concerned:
        # In units of the common divisor, so that only integer multiples have to be expanded.
        multiples = [abs(sp.diff(node.args[0], a) / lost[a][2]) for a in angles]
        if any(m.is_Rational and m > MOST_MULTIPLES for m in multiples):
            raise OutOfReachError(f"{node} holds a high multiple of an angle that stands elsewhere")
        scaled = node.xreplace({angle: halves[angle] / lost[angle][2] for angle in angles})
        opened = sp.expand_trig(_by_sine_and_cosine(node, scaled))
        value = opened.xreplace(
            {
                f: circle[index]
                for angle, circle in lost.items()
                for index, f in enumerate((sp.sin(halves[angle]), sp.cos(halves[angle])))
            }
        )
        if value.free_symbols & set(halves.values()):
            raise OutOfReachError(f"{node} is not a rational function of sines and cosines")
        table[node] = value
    return table, lost


def _by_sine_and_cosine(node: sp.Expr, multiple: sp.Expr) -> sp.Expr:
    argument = multiple.args[0]
    sine, cosine = sp.sin(argument), sp.cos(argument)
    forms = {
        sp.sin: sine,
        sp.cos: cosine,
        sp.tan: sine / cosine,
        sp.cot: cosine / sine,
        sp.sec: 1 / cosine,
        sp.csc: 1 / sine,
    }
    if node.func not in forms:
        raise OutOfReachError(f"{node} is not a rational function of sines and cosines")
    return forms[node.func]


def _with_circles(
    system: System,
    table: Mapping[sp.Expr, sp.Expr],
    circles: Mapping[sp.Symbol, tuple[sp.Symbol, sp.Symbol, sp.Expr]],
) -> System:
    field: dict[sp.Symbol, sp.Expr] = {}
    for symbol, rate in zip(system.symbols, system.rates, strict=True):
        value = rate.xreplace(dict(table))
        if symbol in circles:
            field |= dict(_rates_on_circle(circles[symbol], value))
        else:
            field[symbol] = value
    parameters: list[Parameter] = []
    for p in system.parameters:
        if p.symbol in circles:
            s, c, unit = circles[p.symbol]
            # A parameter that is an angle becomes two parameters on a circle.
            angle = float(unit) * p.default
            parameters.append(replace(p, symbol=s, default=float(sp.sin(angle)), admissible=()))
            parameters.append(replace(p, symbol=c, default=float(sp.cos(angle)), admissible=()))
        else:
            parameters.append(p)
    return replace(
        system,
        field=field,
        definitions=tuple((s, v.xreplace(dict(table))) for s, v in system.scalar_definitions),
        relations=(
            *(c.xreplace(dict(table)) for c in system.scalar.relations),
            *(s**2 + c**2 - 1 for s, c, _ in circles.values()),
        ),
        parameters=tuple(parameters),
        guards=tuple(replace(g, value=g.value.xreplace(dict(table))) for g in system.scalar.guards),
        laws=(),
        observables=(),
        reconstruction=None,
        conventions=VariablesByName(),
    )
