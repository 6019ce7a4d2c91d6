"""Systems of mechanics with known integrals, and slips in them that a point shows to be wrong.

A slip adds or changes a term; what is wrong is shown by the rate of the formula, which is computed
exactly at a rational point of the phase space and is not zero there.
"""

from __future__ import annotations

import random
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import sympy as sp
from sympy.core.function import AppliedUndef

from flowlanes.system.laws import Identity, Integral, Law, Rate
from flowlanes.system.system import Parameter
from fuzz.case import Case, Family, parameter, real, system
from fuzz.levels import number

__all__ = ["MECHANICAL", "MECHANISMS", "Mechanism"]

M, G = real("M_1:4"), real("gamma_1:4")
x, y, z, p, q, r, s, u = real("x y z p q r s u")
a, b, c = real("a b c")
half = sp.Rational(1, 2)

Start = Callable[[random.Random], dict[sp.Symbol, Any]]


@dataclass(frozen=True)
class Mechanism:
    """A system with integrals that are known from the books.

    Parameters
    ----------
    field : mapping of Symbol to formula
    integrals : tuple of sympy.Expr
    parameters : tuple of Parameter
    relations : tuple of sympy.Expr
    on : tuple of sympy.Expr
        A level on which alone the last integral is one.
    start : callable, optional
        A point of the phase space; by default any rational numbers.
    guards : tuple of sympy.Expr
    """

    field: dict[sp.Symbol, Any]
    integrals: tuple[sp.Expr, ...]
    parameters: tuple[Parameter, ...] = ()
    relations: tuple[sp.Expr, ...] = ()
    on: tuple[sp.Expr, ...] = ()
    start: Start | None = None

    def point(self, rng: random.Random) -> dict[sp.Symbol, Any]:
        """A point of the phase space with rational coordinates."""
        found: dict[sp.Symbol, Any] = {n: number(rng) for n in self.field}
        found |= {k.symbol: number(rng, positive=True) for k in self.parameters}
        return found if self.start is None else {**found, **self.start(rng)}

    def scaled(self, rng: random.Random) -> Mechanism:
        """The same in other units, so that each symbol s stands for unit · s."""
        names = [*self.field, *(k.symbol for k in self.parameters)]
        units = {n: sp.Integer(10) ** rng.randint(-12, 12) for n in names}
        change = {n: unit * n for n, unit in units.items()}

        def told(formulas: tuple[sp.Expr, ...]) -> tuple[sp.Expr, ...]:
            return tuple(f.xreplace(change) for f in formulas)

        def start(generator: random.Random) -> dict[sp.Symbol, Any]:
            return {n: v / units[n] for n, v in self.point(generator).items()}

        return Mechanism(
            {n: sp.sympify(v).xreplace(change) / units[n] for n, v in self.field.items()},
            told(self.integrals),
            tuple(
                parameter(k.symbol, float(sp.Rational(repr(k.default)) / units[k.symbol]),
                          *told(k.admissible))
                for k in self.parameters
            ),
            told(self.relations),
            told(self.on),
            start,
        )  # fmt: skip

    def rate(self, formula: sp.Expr) -> sp.Expr:
        """The time derivative of a formula."""
        return sp.Add(*(sp.diff(formula, n) * v for n, v in self.field.items()))


def _positive(*names: sp.Symbol) -> tuple[Parameter, ...]:
    return tuple(
        parameter(n, value, n > 0) for n, value in zip(names, (1.2, 0.7, 1.9, 2.3), strict=False)
    )


def _cross(first: Any, second: Any) -> list[sp.Expr]:
    return list(sp.Matrix(first).cross(sp.Matrix(second)))


def _dot(first: Any, second: Any) -> sp.Expr:
    return sp.Add(*(i * j for i, j in zip(first, second, strict=True)))


def _unit(rng: random.Random) -> dict[sp.Symbol, Any]:
    """A rational point of the sphere of γ."""
    choice = rng.choice([(1, 2, 2, 3), (2, 3, 6, 7), (1, 4, 8, 9), (4, 4, 7, 9), (2, 6, 9, 11)])
    return {g: sp.Rational(n, choice[3]) for g, n in zip(G, choice, strict=False)}


def _pythagoras(rng: random.Random) -> dict[sp.Symbol, Any]:
    first, second = rng.choice([(3, 4), (5, 12), (8, 15)])
    return {x: sp.Integer(first), y: -sp.Integer(second)}


def _spun(inertia: tuple[Any, ...], force: list[Any]) -> dict[sp.Symbol, Any]:
    """M' = M × ω + force, γ' = γ × ω."""
    omega = [m / i for m, i in zip(M, inertia, strict=True)]
    moment = [sp.expand(m + f) for m, f in zip(_cross(M, omega), force, strict=True)]
    return {**dict(zip(M, moment, strict=True)), **dict(zip(G, _cross(G, omega), strict=True))}


def _energy(inertia: tuple[Any, ...]) -> sp.Expr:
    return sp.Add(*(m**2 / (2 * i) for m, i in zip(M, inertia, strict=True)))


def _top(
    inertia: tuple[Any, ...], centre: tuple[Any, ...], *more: sp.Expr, **others: Any
) -> Mechanism:
    """A heavy top: M' = M × ω + γ × r, with H = T − (r, γ) … and (M, γ)."""
    field = _spun(inertia, _cross(G, centre))
    energy = _energy(inertia) + _dot(centre, G)
    return Mechanism(
        field,
        (energy, _dot(M, G), *more),
        relations=(_dot(G, G) - 1,),
        **{"start": _unit, **others},
    )


U, V = sp.Function("U"), sp.Function("V")
RADIUS = sp.sqrt(x**2 + y**2)
EULER = (a, b, c)
_lotka = {x: x * (a - b * y), y: y * (c * x - s)}
_chain = [sp.exp(x - y), sp.exp(y - z)]

MECHANISMS: dict[str, Mechanism] = {
    "Euler top": Mechanism(
        _spun(EULER, [0, 0, 0]),
        (_energy(EULER), _dot(M, M), _dot(M, G), _dot(G, G)),
        _positive(a, b, c),
    ),
    "Euler top on a sphere": Mechanism(
        _spun(EULER, [0, 0, 0]),
        (_energy(EULER), _dot(M, M), _dot(M, G)),
        _positive(a, b, c),
        (_dot(G, G) - 1,),
        start=_unit,
    ),
    "Lagrange top": _top((a, a, b), (0, 0, c), M[2], parameters=_positive(a, b, c)),
    "Kovalevskaya top": _top(
        (2, 2, 1),
        (1, 0, 0),
        sp.expand((M[0] ** 2 / 4 - M[1] ** 2 / 4 - G[0]) ** 2 + (M[0] * M[1] / 2 - G[1]) ** 2),
    ),
    "Goryachev-Chaplygin top": _top(
        (4, 4, 1),
        (1, 0, 0),
        M[2] * (M[0] ** 2 + M[1] ** 2) / 4 - M[0] * G[2],
        on=(_dot(M, G),),
        start=lambda rng: {
            **(at := _unit(rng)),
            M[0]: (first := number(rng)),
            M[1]: (second := number(rng)),
            M[2]: -(first * at[G[0]] + second * at[G[1]]) / at[G[2]],
        },
    ),
    "Kepler problem": Mechanism(
        {x: p, y: q, p: -a * x / RADIUS**3, q: -a * y / RADIUS**3},
        (
            (p**2 + q**2) / 2 - a / RADIUS,
            x * q - y * p,
            q * (x * q - y * p) - a * x / RADIUS,
            -p * (x * q - y * p) - a * y / RADIUS,
        ),
        _positive(a),
        start=_pythagoras,
    ),
    "harmonic oscillators": Mechanism(
        {x: p, y: q, p: -(a**2) * x, q: -(b**2) * y},
        (p**2 + a**2 * x**2, q**2 + b**2 * y**2),
        _positive(a, b),
    ),
    "isotropic oscillator": Mechanism(
        {x: p, y: q, p: -(a**2) * x, q: -(a**2) * y},
        (p**2 + a**2 * x**2, x * q - y * p, p * q + a**2 * x * y),
        _positive(a),
    ),
    "oscillators one to two": Mechanism(
        {x: p, y: q, p: -x, q: -4 * y},
        (p**2 + x**2, q**2 + 4 * y**2, (p**2 - x**2) * q + 4 * x * y * p),
    ),
    "Lotka-Volterra": Mechanism(
        _lotka,
        (c * x - s * sp.log(x) + b * y - a * sp.log(y),),
        _positive(a, b, c, s),
        start=lambda rng: {x: number(rng, positive=True), y: number(rng, positive=True)},
    ),
    "sleigh": Mechanism(
        {u: a * r**2, r: -b * a * u * r / (c + b * a**2), x: u},
        (b * u**2 + (c + b * a**2) * r**2,),
        _positive(a, b, c),
    ),
    "Toda chain": Mechanism(
        {x: p, y: q, z: r, p: -_chain[0], q: _chain[0] - _chain[1], r: _chain[1]},
        (
            p + q + r,
            (p**2 + q**2 + r**2) / 2 + _chain[0] + _chain[1],
            p * q * r - r * _chain[0] - p * _chain[1],
        ),
        start=lambda rng: dict.fromkeys((x, y, z), sp.S.Zero),
    ),
    "pendulum": Mechanism(
        {x: p, p: -a * sp.sin(x)}, (p**2 / 2 - a * sp.cos(x),), _positive(a),
        start=lambda rng: {x: sp.pi / 2},
    ),
    "Hénon-Heiles": Mechanism(
        {x: p, y: q, p: -x - 2 * x * y, q: -y - x**2 - y**2},
        (
            (p**2 + q**2 + x**2 + y**2) / 2 + x**2 * y + y**3 / 3,
            p * q + x * y + x * y**2 + x**3 / 3,
        ),
    ),
    "Calogero-Moser": Mechanism(
        {x: p, y: q, p: 2 * a / (x - y) ** 3, q: -2 * a / (x - y) ** 3},
        (p + q, (p**2 + q**2) / 2 + a / (x - y) ** 2),
        _positive(a),
        start=lambda rng: {x: sp.S(3), y: sp.S(1)},
    ),
    "Volterra chain": Mechanism(
        {x: x * y, y: y * (z - x), z: -z * y},
        (x + y + z, x * z),
        start=lambda rng: {n: number(rng, positive=True) for n in (x, y, z)},
    ),
    "spherical pendulum": Mechanism(
        {x: p, y: q, z: r, **dict(zip((p, q, r), (
            -x * (p**2 + q**2 + r**2 - z), -y * (p**2 + q**2 + r**2 - z),
            -1 - z * (p**2 + q**2 + r**2 - z)), strict=True))},
        ((p**2 + q**2 + r**2) / 2 + z, x * q - y * p),
        (),
        (x**2 + y**2 + z**2 - 1, x * p + y * q + z * r),
        start=lambda rng: {
            x: sp.Rational(1, 3), y: sp.Rational(2, 3), z: sp.Rational(2, 3),
            p: (first := number(rng)), q: (second := number(rng)), r: -(first + 2 * second) / 2,
        },
    ),
    "motion in a potential": Mechanism(
        {x: p, p: -sp.diff(U(x), x)}, (p**2 / 2 + U(x),)
    ),
    "motion in a plane potential": Mechanism(
        {x: p, y: q, p: -sp.diff(U(x, y), x), q: -sp.diff(U(x, y), y)},
        ((p**2 + q**2) / 2 + U(x, y),),
    ),
    "central force": Mechanism(
        {x: p, y: q, p: -x * V(x**2 + y**2), q: -y * V(x**2 + y**2)}, (x * q - y * p,)
    ),
    "Suslov problem": Mechanism(
        {p: -(c * p + s * q) * q / a, q: (c * p + s * q) * p / b},
        (a * p**2 + b * q**2,),
        _positive(a, b, c, s),
    ),
    "charged particle": Mechanism(
        {x: p, y: q, p: a * q, q: -a * p}, (p**2 + q**2, p - a * y, q + a * x), _positive(a)
    ),
}  # fmt: skip


def _slips(rng: random.Random, formula: sp.Expr, names: list[sp.Symbol]) -> sp.Expr:
    """A formula with one slip."""
    terms = list(sp.Add.make_args(sp.expand(formula)))
    place = rng.randrange(len(terms))
    stray = sp.Mul(*(rng.choice(names) for _ in range(rng.randint(1, 3))))
    slip = rng.choice(["sign", "factor", "exponent", "index", "stray", "tiny"])
    if slip == "sign" and len(terms) > 1:
        terms[place] = -terms[place]
    elif slip == "factor" and len(terms) > 1:
        terms[place] *= rng.choice([2, sp.Rational(1, 2), sp.Rational(999999, 1000000), 10**9])
    elif slip == "exponent":
        terms[place] = terms[place].xreplace({(n := rng.choice(names)): n**3})
    elif slip == "index":
        terms[place] = terms[place].xreplace(dict([rng.sample(names, 2)]))
    elif slip == "tiny":
        terms.append(stray * sp.Integer(10) ** -rng.randint(6, 30))
    else:
        terms.append(number(rng) * stray)
    return sp.Add(*terms)


def _combined(rng: random.Random, integrals: tuple[sp.Expr, ...]) -> sp.Expr:
    """A function of integrals."""
    one, other = rng.choice(integrals), rng.choice(integrals)
    k = number(rng)
    return rng.choice(
        [one, one, k * one, one + k * other, one * other, one**2 - k * other, sp.sqrt(1 + one**2),
         sp.exp(one), sp.log(2 + one**2), one / (1 + other**2), sp.Function("F")(one)]
    )  # fmt: skip


def _mechanical(name: str) -> Family:
    mechanism = MECHANISMS[name]

    def made(rng: random.Random) -> Case:
        return _planted(rng, name, mechanism)

    return made


def _planted(rng: random.Random, name: str, mechanism: Mechanism) -> Case:
    """A right integral, or one with a slip and a point that shows it."""
    unspecified = any(sp.sympify(v).atoms(AppliedUndef) for v in mechanism.field.values())
    if rng.random() < 0.25 and not unspecified and not mechanism.on:
        mechanism = mechanism.scaled(rng)
    kind: Callable[..., Law] = rng.choice([_as_integral, _as_integral, _as_rate])
    found = system(mechanism.field, parameters=mechanism.parameters, relations=mechanism.relations)
    if rng.random() < 0.5:
        right = kind(_combined(rng, mechanism.integrals), mechanism.on)
        return Case(name, lambda: (found, right), "true", "a function of known integrals")
    if mechanism.on and rng.random() < 0.3:
        loose = Mechanism(mechanism.field, mechanism.integrals, start=_unit)
        shown = _shown(rng, loose, mechanism.integrals[-1])
        wrong = kind(mechanism.integrals[-1], ())
        assert shown is not None
        return Case(name, lambda: (found, wrong), "false", "it holds on a level only", shown)
    while True:
        formula = _slips(rng, rng.choice(mechanism.integrals), list(mechanism.field))
        at = _shown(rng, mechanism, formula)
        if at is not None:
            break
    law = kind(formula, mechanism.on)
    return Case(name, lambda: (found, law), "false", "its rate is not zero at a point", at)


def _as_integral(formula: sp.Expr, on: tuple[sp.Expr, ...]) -> Law:
    return Integral("law", formula, level=on)


def _as_rate(formula: sp.Expr, on: tuple[sp.Expr, ...]) -> Law:
    return Identity("law", Rate(formula), level=on)


def _shown(
    rng: random.Random, mechanism: Mechanism, formula: sp.Expr
) -> dict[sp.Symbol, Any] | None:
    """A point at which the rate of a formula is exactly another number than zero.

    Values and slopes of an unspecified function are numbers of one's choice.
    """
    rate = mechanism.rate(formula)
    for _ in range(4):
        point = mechanism.point(rng)
        unknown = sorted(rate.atoms(sp.Derivative, AppliedUndef), key=str)
        slopes = [n for n in unknown if isinstance(n, sp.Derivative)]
        free = {n: number(rng) for n in (*slopes, *(n for n in unknown if n not in slopes))}
        value = rate.xreplace(free).xreplace(point)
        if value.is_Rational and value != 0:
            return point
    return None


MECHANICAL: dict[str, Family] = {name: _mechanical(name) for name in MECHANISMS}
