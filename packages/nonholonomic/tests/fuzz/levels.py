"""Levels that fall into parts: products of factors, extensions, empty and excluded parts."""

from __future__ import annotations

import random
from collections.abc import Callable
from dataclasses import dataclass
from itertools import combinations
from typing import Any

import sympy as sp
from sympy.core.function import AppliedUndef

from fuzz.case import parameter, real
from fuzz.setting import Claim, Setting, SettingFamily, no, yes

__all__ = ["LEVELS"]

x, y, z, u, v, w = real("x y z u v w")
a, b, c = real("a b c")
HALF = sp.Rational(1, 2)


def number(rng: random.Random, *, positive: bool = False) -> sp.Rational:
    """A small rational number that is not zero."""
    above = rng.randint(1, 7)
    return sp.Rational(above if positive or rng.random() < 0.6 else -above, rng.randint(1, 4))


def polynomial(rng: random.Random, *names: sp.Symbol) -> sp.Expr:
    """A polynomial with two or three terms."""
    terms = [sp.Mul(*(s ** rng.randint(0, 2) for s in names)) for _ in range(rng.randint(1, 2))]
    return sp.Add(*(number(rng) * term for term in terms)) + rng.randint(-2, 2)


# --- products of factors -----------------------------------------------------------------------


@dataclass(frozen=True)
class Factor:
    """A factor of a level.

    Parameters
    ----------
    formula : sympy.Expr
    put : callable, optional
        Moves a point to where the factor vanishes; None where it does so nowhere.
    consequence : sympy.Expr
        What vanishes where the factor does.
    condition, guard : optional
        A condition on parameters, or a guard, without which it may vanish.
    thin : bool
        Whether it is a sum of squares.
    """

    formula: sp.Expr
    put: Callable[[dict[Any, Any]], dict[Any, Any]] | None
    consequence: sp.Expr
    condition: Any = None
    guard: Any = None
    thin: bool = False

    @property
    def simple(self) -> bool:
        """Whether its differential by the state is not zero almost everywhere on it."""
        moving = bool(self.formula.free_symbols & {x, y, z})
        return moving and not self.thin and not _has_unspecified(self.formula)


def _graph(rng: random.Random) -> Factor:
    target, one, two = rng.sample([x, y, z], 3)
    made = polynomial(rng, one, two)
    factor = target - made
    return Factor(factor, lambda p: {**p, target: made.xreplace(p)}, factor)


def _variable(rng: random.Random) -> Factor:
    s = rng.choice([x, y, z])
    return Factor(s, lambda p: {**p, s: sp.S.Zero}, s)


def _constant(rng: random.Random) -> Factor:
    s, value = rng.choice([a, b]), number(rng, positive=True)
    return Factor(s - value, lambda p: {**p, s: value}, s - value)


def _parameters(rng: random.Random) -> Factor:
    value = number(rng, positive=True)
    return Factor(a - value * b, lambda p: {**p, a: value * p[b]}, a - value * b)


def _mixed(rng: random.Random) -> Factor:
    s, other = rng.sample([x, y, z], 2)
    factor = a * s - b * other
    return Factor(factor, lambda p: {**p, s: p[b] * p[other] / p[a]}, factor)


def _thin(rng: random.Random) -> Factor:
    """A sum of squares: a line, or a plane of codimension two."""
    s, other = rng.sample([x, y, z], 2)
    value = rng.randint(-1, 1)
    factor = (s - value) ** 2 + rng.choice([1, 2, 5]) * other**2
    consequence = rng.choice([s - value, other, factor, s - value + 3 * other])
    return Factor(
        factor,
        lambda p: {**p, s: sp.Integer(value), other: sp.S.Zero},
        consequence,
        thin=True,
    )


def _sine(rng: random.Random) -> Factor:
    s = rng.choice([x, y, z])
    where = rng.choice([sp.S.Zero, sp.pi])
    return Factor(sp.sin(s), lambda p: {**p, s: where}, rng.choice([sp.sin(s), sp.sin(2 * s)]))


def _exponential(rng: random.Random) -> Factor:
    s, other = rng.sample([x, y, z], 2)
    factor = s - sp.exp(other)
    return Factor(factor, lambda p: {**p, s: sp.S.One, other: sp.S.Zero}, factor)


def _unspecified(rng: random.Random) -> Factor:
    factor = sp.Function(rng.choice(["f", "U", "g", "log", "U_1"]))(rng.choice([x, y, z]))
    return Factor(factor, lambda p: p, factor)


def _empty(rng: random.Random) -> Factor:
    s, other = rng.sample([x, y, z], 2)
    made = rng.choice(
        [
            s**2 + number(rng, positive=True),
            s**2 + other**2 + number(rng, positive=True),
            s**2 + s * other + other**2 + 1,
            s**4 - s**2 + 1,
            a**2 + b**2 + 1,
            a**2 + s**2 + HALF,
            sp.exp(s),
            sp.exp(s) + 2,
            2 + sp.sin(s),
            1 + sp.Function("f")(s) ** 2,
            sp.cosh(s),
            1 + sp.sqrt(1 + s**2),
        ]
    )
    return Factor(made, None, sp.S.One)


def _excluded(rng: random.Random) -> Factor:
    """Never zero with admissible parameters, or inside the guards."""
    s = rng.choice([x, y, z])
    value = number(rng, positive=True)
    made, condition, guard = rng.choice(
        [
            (a + value, a > 0, None),
            (a * b, a * b > 0, None),
            (a - b, a > b, None),
            (a, sp.Ne(a, 0), None),
            (s + value, None, s),
            (s, None, s),
            (s - value, None, value - s),
            (a * s + b**2, a > 0, s),
        ]
    )
    return Factor(made, None, sp.S.One, condition, guard)


_FACTORS = (
    _graph, _graph, _variable, _variable, _constant, _parameters, _mixed, _thin, _sine,
    _exponential, _unspecified, _empty, _empty, _excluded, _excluded,
)  # fmt: skip


def _nonzero(value: sp.Expr) -> bool:
    """Whether a number is certainly not zero."""
    value = sp.sympify(value)
    if value.is_Rational:
        return bool(value != 0)
    return value.is_zero is False


def _inside(point: dict[Any, Any], conditions: list[Any], guards: list[Any]) -> bool:
    asked = [*conditions, *(g > 0 for g in guards)]
    return all(sp.sympify(q).xreplace(point) == sp.true for q in asked)


def _witness(
    rng: random.Random,
    at: Factor,
    formulas: list[sp.Expr],
    asked: tuple[list[Any], list[Any]],
) -> dict[Any, Any] | None:
    """A point where one factor vanishes and formulas do not."""
    assert at.put is not None
    if any(map(_has_unspecified, formulas)):
        return None
    for _ in range(30):
        point = at.put({s: number(rng) for s in (x, y, z, a, b)})
        if _inside(point, *asked) and all(_nonzero(f.xreplace(point)) for f in formulas):
            return point
    return None


def _has_unspecified(formula: sp.Expr) -> bool:
    return bool(formula.atoms(AppliedUndef))


def product_of_factors(rng: random.Random) -> Setting:
    """One condition, a product of factors that may be zero, or may not."""
    while True:
        factors = [rng.choice(_FACTORS)(rng) for _ in range(rng.randint(2, 4))]
        distinct = len({sp.expand(f.formula) for f in factors}) == len(factors)
        made = _product_setting(rng, factors) if distinct else None
        if made is not None:
            return made


def _product_setting(rng: random.Random, factors: list[Factor]) -> Setting | None:
    there = [f for f in factors if f.put is not None]
    asked = [f.condition for f in factors if f.condition is not None]
    inside = [f.guard for f in factors if f.guard is not None]
    powers = [rng.choice([1, 1, 1, 2]) for _ in factors]
    level = sp.Mul(*(f.formula**n for f, n in zip(factors, powers, strict=True)))
    cofactor = rng.choice([sp.S.One, 1 + x, y - 2 * z, 3 + x * y])
    parts = ", ".join(f"{f.formula} = 0" for f in there)
    whole = sp.Mul(*(f.consequence for f in there))
    claims: list[Claim] = [
        yes(whole * cofactor, f"it vanishes on each of the parts that have points: {parts}")
    ]
    for left_out in there:
        rest = sp.Mul(*(f.consequence for f in there if f is not left_out))
        if _has_unspecified(left_out.formula):
            if not inside:
                claims.append(no(rest, f"{left_out.formula} may be zero where this is not"))
            continue
        others = [part for f in factors if f is not left_out for part in (f.consequence, f.formula)]
        point = _witness(rng, left_out, others, (asked, inside))
        if point is not None:
            claims.append(no(rest, f"it does not vanish where {left_out.formula} = 0", point))
    if len(claims) < 2:
        return None
    first, second = (1.9, 0.7) if (a > b) in asked or rng.random() < 0.5 else (0.7, 1.3)
    used = level.free_symbols
    simple = all(f.simple for f in there) and max(powers) == 1
    return Setting(
        (x, y, z),
        tuple(claims),
        (level,),
        tuple(p for p in (parameter(a, first, *asked), parameter(b, second)) if p.symbol in used),
        tuple(inside),
        regular=simple,
    )


def shared_factor(rng: random.Random) -> Setting:
    """f g = 0 and f h = 0: either f = 0, or g = h = 0."""
    f = rng.choice([z - polynomial(rng, x, y), x - 1, a - 2, x * a - y, x**2 + y**2 - 25])
    g, h = u - polynomial(rng, x), v - polynomial(rng, y)
    point = None
    while point is None:
        values = {s: number(rng) for s in (x, y, z, a)}
        values |= {u: (u - g).xreplace(values), v: (v - h).xreplace(values)}
        if _nonzero(f.xreplace(values)):
            point = values
    on_f = {s: number(rng) for s in (x, y, z, a, u, v)}
    claims = [
        yes(f * g, "a condition"),
        yes(f * (g + 3 * h), "a sum of the conditions"),
        yes(f**2 * g * h + f * h, "in the ideal of the conditions"),
        no(f, "where g = h = 0 it is free", point),
    ]
    if f == x - 1:
        at = {**on_f, x: sp.S.One}
        if _nonzero((g * h).xreplace(at)):
            claims += [no(g, "where f = 0 it is free", at), no(h, "where f = 0 it is free", at)]
    return Setting((x, y, z, u, v), tuple(claims), (f * g, f * h), (parameter(a, 1.7),),
                   regular=False)  # fmt: skip


# --- levels that fall apart over an extension only ---------------------------------------------


def two_roots(rng: random.Random) -> Setting:
    """x² = c and y² = c r²: the level is four points (or lines), y = ± r x."""
    value, ratio = sp.Integer(rng.choice([2, 3, 5, 6, 7, 4])), number(rng, positive=True)
    form = rng.choice(["number", "parameter", "moving"])
    size = {"number": value, "parameter": a, "moving": 1 + z**2}[form]
    parameters = (parameter(a, 2.0, a > 0),) if form == "parameter" else ()
    root = {"number": sp.sqrt(value), "parameter": sp.S(2), "moving": sp.S.One}[form]
    at = {x: root, y: -ratio * root, z: sp.S.Zero, a: sp.S(4)}
    return Setting(
        (x, y, z),
        (
            yes(y**2 - ratio**2 * x**2, "y² = r² x²"),
            yes(x * y * (y**2 - ratio**2 * x**2) + x**2 - size, "a sum of what vanishes"),
            yes(x**4 * y**2 - ratio**2 * size**3, "x⁴ y² = c² r² c"),
            no(y - ratio * x, "y = −r x is another part", at),
            no(x * y - ratio * size, "x y = −r c on another part", at),
            no(y + ratio * x, "y = r x is another part", {**at, y: ratio * root}),
        ),
        (x**2 - size, y**2 - ratio**2 * size),
        parameters,
    )


def three_roots(rng: random.Random) -> Setting:
    """x² = p, y² = q, z² = p q: z = ± x y."""
    p, q = rng.sample([2, 3, 5, 7, 10], 2)
    at = {x: sp.sqrt(p), y: sp.sqrt(q), z: -sp.sqrt(p * q)}
    sum_square = sp.expand(((x + y) ** 2 - p - q) ** 2 - 4 * p * q)
    return Setting(
        (x, y, z),
        (
            yes(z**2 - x**2 * y**2, "z² = p q = x² y²"),
            yes(sum_square, "(x + y)² = p + q + 2 x y and (2 x y)² = 4 p q"),
            no(z - x * y, "z = −x y is another part", at),
            no(q * x - y * z, "y z = −q x on another part", at),
        ),
        (x**2 - p, y**2 - q, z**2 - p * q),
    )


def odd_roots(rng: random.Random) -> Setting:
    """An odd power is one-to-one over the reals, where the level has more parts over ℂ."""
    n = rng.choice([3, 5])
    same = [
        yes(x - y, "odd powers are one-to-one over the reals"),
        yes(x**2 - y**2, "odd powers are one-to-one over the reals"),
        yes(x**n - y**n, "both are the same"),
    ]
    if rng.random() < 0.3:
        free = {x: sp.S.One, y: sp.S.One, z: sp.S.Zero}
        claims = (*same, no(x, "x = y is free", free), no(x + y, "x = y is free", free))
        return Setting((x, y, z), claims, (x**n - y**n,))
    size, at = rng.choice([(sp.S(2), sp.root(2, n)), (a, sp.S.One), (1 + z**2, sp.S.One)])
    point = {x: at, y: at, z: sp.S.Zero, a: sp.S.One}
    claims = (*same, no(x + y, "x = y is not zero", point), no(x, "it is not zero", point))
    return Setting(
        (x, y, z), claims, (x**n - size, y**n - size), (parameter(a, 1.5),) if size == a else ()
    )


def even_powers(rng: random.Random) -> Setting:
    """x⁴ = c² means x² = c: the other part, x² = −c, has no real points."""
    value = rng.choice([2, 3, 4, 9, 10])
    root = sp.sqrt(value)
    return Setting(
        (x, y),
        (
            yes(x**2 - value, "x² = −c has no real point"),
            yes(y * (x**2 - value), "x² = −c has no real point"),
            no(x**2 + value, "it is 2 c", {x: root, y: sp.S.Zero}),
            no(x - root, "x = −√c is another point", {x: -root, y: sp.S.Zero}),
        ),
        (x**4 - value**2,),
    )


def near_roots(rng: random.Random) -> Setting:
    """A root, and a rational number very close to it."""
    value, digits = rng.choice([2, 3, 5, 7]), rng.choice([8, 15, 30, 60])
    close = sp.Integer(sp.floor(sp.sqrt(value) * 10**digits)) / 10**digits
    at = {x: sp.sqrt(value)}
    return Setting(
        (x,),
        (
            no(x - close, "√c is not rational", at),
            no(10**digits * x**2 - 10**digits * value + x - close, "√c is not rational", at),
            yes(x - sp.sqrt(value), "x = √c"),
            yes(x**2 - value, "a condition"),
            yes(1 / x - x / value, "x² = c"),
        ),
        (x**2 - value,),
        guards=(x,),
    )


# --- empty and excluded parts ------------------------------------------------------------------


def equal_powers(rng: random.Random) -> Setting:
    """aⁿ = bⁿ with signs known, or not."""
    n = rng.choice([2, 2, 4, 6])
    r = number(rng, positive=True)
    condition = a**n - (r * b) ** n
    form = rng.choice(["both", "one", "order", "none", "guards", "guard"])
    if form in ("guards", "guard"):
        return Setting(
            (x, y),
            (
                yes(x - r * y, "the guards leave out the other part"),
                yes(x**3 - (r * y) ** 3, "the guards leave out the other part"),
                no(x + r * y, "it is 2 x", {x: r, y: sp.S.One}),
                no(x * y - r, "x is free", {x: 2 * r, y: sp.S(2)}),
            ),
            (x**n - (r * y) ** n,),
            guards=(x, y) if form == "guards" else (x + r * y,),
        )
    signs = {"both": (a > 0, b > 0), "one": (a > 0,), "order": (a + r * b > 0,), "none": ()}[form]
    at = {a: r, b: -sp.S.One, x: sp.S.One}
    known = form in ("both", "order")
    first = yes(a - r * b, "the signs leave one part") if known else no(a - r * b, "a = −r b", at)
    return Setting(
        (x,),
        (
            first,
            yes(x * (a**2 - r**2 * b**2), "the other factors have no real zeros but a = b = 0"),
            no(x * (a + r * b), "a = r b", {a: r, b: sp.S.One, x: sp.S.One}),
        ),
        (condition,),
        (parameter(a, float(r), *signs), parameter(b, 1.0)),
    )


def chosen_roots(rng: random.Random) -> Setting:
    """A polynomial in one variable with guards that leave one of its roots."""
    roots = sorted(rng.sample([-3, -2, -1, 0, 1, 2, 3, 5], 3))
    place = rng.randrange(3)
    low = roots[place] - HALF
    high = roots[place] + HALF
    chosen = sp.Integer(roots[place])
    powers = [rng.choice([1, 1, 2]) for _ in roots]
    level = sp.Mul(*((x - r) ** n for r, n in zip(roots, powers, strict=True)))
    return Setting(
        (x, y),
        (
            yes(x - chosen, "the other roots are outside the guards"),
            yes(y * (x**2 - chosen**2), "the other roots are outside the guards"),
            no(x - chosen - 1, "x is one less", {x: chosen, y: sp.S.One}),
            no(y * (x + 1 - chosen), "y is free", {x: chosen, y: sp.S.One}),
        ),
        (sp.expand(level),),
        guards=(x - low, high - x),
        regular=max(powers) == 1,
    )


def forbidden_value(rng: random.Random) -> Setting:
    """(a − c) x = 0 where a may, or may not, be c."""
    value = sp.Integer(rng.randint(1, 3))
    form = rng.choice([a > value, a >= value, sp.Ne(a, value), a < value, a <= value])
    allowed = isinstance(form, sp.Ge | sp.Le)
    default = float(value + (2 if isinstance(form, sp.Gt | sp.Ge | sp.Ne) else -2))
    at = {a: value, x: sp.S.One, y: sp.S.One}
    first = no(x, "a may be c", at) if allowed else yes(x, "a is not c, so that x is zero")
    still = {a: value + (1 if isinstance(form, sp.Gt | sp.Ge | sp.Ne) else -1)}
    return Setting(
        (x, y),
        (
            first,
            yes((a - value) * x * y, "a multiple of the condition"),
            no((a - value) * y, "x = 0 and y free", {**still, x: sp.S.Zero, y: sp.S.One}),
        ),
        ((a - value) * x,),
        (parameter(a, default, form),),
    )


def moments(rng: random.Random) -> Setting:
    """Moments of inertia: none exceeds the sum of the others."""
    A, B, C = real("I_1 I_2 I_3")
    known = rng.random() < 0.6
    asked = (A > 0, B > 0, C > 0, *((A + B >= C, B + C >= A, C + A >= B) if known else ()))
    ps = (parameter(A, 1.0, *asked), parameter(B, 1.3), parameter(C, 1.7))
    root = sp.sqrt(sp.expand((A + B - C) ** 2)) - (A + B - C)
    at = {A: sp.S.One, B: sp.S.One, C: sp.S(3), x: sp.S.One}
    claims = [
        yes(root, "the sum is not negative") if known else no(root, "I₁ + I₂ < I₃", at),
        yes(x * root * (root + 2 * (A + B - C)), "difference of squares"),
        no(x * (root + 2 * (A + B - C)), "twice the sum is not zero",
           {A: sp.S.One, B: sp.S.One, C: sp.S.One, x: sp.S.One}),
    ]  # fmt: skip
    return Setting((x,), tuple(claims), (), ps)


def squares(rng: random.Random) -> Setting:
    """Sums of squares and definite forms: all terms vanish."""
    p, q = x - rng.randint(-2, 2) * y, z - number(rng)
    n = rng.choice([2, 4])
    level = rng.choice(
        [p**2 + q**n, p**2 + p * q + q**2, p**4 + 3 * q**2, 2 * p**2 - 2 * p * q + q**2]
    )
    at = {y: sp.S.One, x: (x - p).xreplace({y: sp.S.One}), z: z - q}
    return Setting(
        (x, y, z),
        (
            yes(p, "all terms of a definite form vanish"),
            yes(q, "all terms of a definite form vanish"),
            yes(p * y - q * x, "all terms of a definite form vanish"),
            no(y, "y is free", at),
            no(p + y * q + y, "y is free", at),
        ),
        (sp.expand(level) if rng.random() < 0.5 else level,),
        regular=False,
    )  # fmt: skip


def power_product(rng: random.Random) -> Setting:
    """xᵐ yⁿ = 0."""
    m, n = rng.randint(1, 4), rng.randint(1, 4)
    at = {x: sp.S.One, y: sp.S.Zero, z: sp.S.One}
    return Setting(
        (x, y, z),
        (
            yes(x * y, "one of them is zero"),
            yes(x * y * z + x**5 * y, "one of them is zero"),
            no(x, "y = 0", at),
            no(x * z + y, "y = 0", at),
            no(y, "x = 0", {x: sp.S.Zero, y: sp.S.One, z: sp.S.One}),
        ),
        (x**m * y**n,),
        regular=m == n == 1,
    )


def isolated_point(rng: random.Random) -> Setting:
    """y² = x² (x − c), with c > 0: a curve and the isolated point (0, 0)."""
    value = number(rng, positive=True)
    inside = rng.random() < 0.5
    guard = value / 2 - x if inside else value - x
    at = {x: 2 * value, y: 2 * value * sp.sqrt(value)}
    level = y**2 - x**2 * (x - value)
    if rng.random() < 0.5:
        claims = (
            yes(x, "the guard leaves the isolated point"),
            yes(y, "the guard leaves the isolated point"),
            yes(x - y, "the guard leaves the isolated point"),
            no(x - 1, "x = 0", {x: sp.S.Zero, y: sp.S.Zero}),
        )
        return Setting((x, y), claims, (level,), guards=(guard,), regular=False)
    return Setting(
        (x, y),
        (
            no(x, "the curve", at),
            no(y, "the curve", at),
            yes(x * level, "a multiple"),
            no(x - value, "the isolated point", {x: sp.S.Zero, y: sp.S.Zero}),
        ),
        (level,),
        regular=False,
    )


def unit_parameter(rng: random.Random) -> Setting:
    """a x = b and a y = b: x = y unless a = b = 0."""
    form = rng.choice(["none", "a", "b", "ge"])
    asked = {"none": (), "a": (a > 0,), "b": (b > 0,), "ge": (a >= 0,)}[form]
    at = {a: sp.S.Zero, b: sp.S.Zero, x: sp.S.One, y: sp.S(2)}
    known = form in ("a", "b")
    return Setting(
        (x, y),
        (
            yes(x - y, "a is not zero") if known else no(x - y, "a = b = 0", at),
            yes(a * (x - y), "the difference of the conditions"),
            yes(b * (x - y), "b x = a x y = b y"),
            no(x + y, "a = b", {a: sp.S(2), b: sp.S(2), x: sp.S.One, y: sp.S.One}),
        ),
        (a * x - b, a * y - b),
        (parameter(a, 1.5, *asked), parameter(b, 2.5)),
        regular=known,
    )


# --- lost parts of pseudo-division -------------------------------------------------------------


def kernel(rng: random.Random) -> Setting:
    """A (x, y) = 0 for a 2×2 matrix A: its determinant may differ from zero at x = y = 0."""
    shift = rng.choice([0, 0, 1])
    p, q = x - shift, y + shift * z
    rows = sp.Matrix([[z, -w], [u, -v]])
    if rng.random() < 0.5:
        rows = rows * sp.Matrix([[1, number(rng)], [0, number(rng)]])
    first, second = sp.expand(rows * sp.Matrix([p, q]))
    determinant = sp.expand(rows.det())
    at = {z: sp.S.One, w: sp.S(2), u: sp.S.One, v: sp.S(3), x: sp.Integer(shift)}
    at[y] = (y - q).xreplace(at)
    at = at if _nonzero(determinant.xreplace(at)) else {**at, v: sp.S(-5)}
    return Setting(
        (x, y, z, u, v, w),
        (
            no(determinant, "x = y = 0 allows any matrix", at),
            no(determinant**2 + p, "x = y = 0 allows any matrix", at),
            yes(p * determinant, "Cramer's rule"),
            yes(q * determinant, "Cramer's rule"),
            yes((p + 3 * q) * determinant, "Cramer's rule"),
        ),
        (first, second),
        regular=False,
    )


def parallel(rng: random.Random) -> Setting:
    """Two or three components of M × γ = 0."""
    M, g = real("M_1:4"), real("gamma_1:4")
    cross = list(sp.Matrix(M).cross(sp.Matrix(g)))
    left_out = rng.randrange(3)
    two = [cross[i] for i in range(3) if i != left_out]
    at = dict.fromkeys((*M, *g), sp.S.One)
    at |= {M[left_out]: sp.S.Zero, g[left_out]: sp.S.Zero}
    other = (left_out + 1) % 3
    at |= {M[other]: sp.S(2), g[other]: sp.S(3)}
    if rng.random() < 0.3:
        loose = {**dict.fromkeys(M, sp.S.Zero), **dict.fromkeys(g, sp.S.One)}
        claims = (
            yes(cross[0] * g[1], "a condition"),
            yes(sp.expand(sum(m**2 for m in M) * sum(s**2 for s in g)
                          - sum(m * s for m, s in zip(M, g, strict=True)) ** 2),
                "the square of the cross product"),
            no(M[0] - g[0], "M = 0", loose),
            no(g[1], "M = 0", loose),
        )  # fmt: skip
        return Setting((*M, *g), claims, tuple(cross), regular=False)
    return Setting(
        (*M, *g),
        (
            no(cross[left_out], "M and γ may both lie in the plane of the two", at),
            yes(cross[left_out] * g[left_out], "(M × γ, γ) = 0"),
            yes(cross[left_out] * M[left_out], "(M × γ, M) = 0"),
            no(cross[left_out] * M[other], "M and γ may both lie in the plane of the two", at),
        ),
        tuple(two),
        regular=False,
    )


def minors(rng: random.Random) -> Setting:
    """Two of the three minors of a 2×3 matrix, the first row in two named quantities."""
    p = real("p_1:7")
    rows = [p[:3], p[3:]]
    all_minors = [
        rows[0][i] * rows[1][j] - rows[0][j] * rows[1][i] for i, j in combinations(range(3), 2)
    ]
    # the minors 12 and 13 vanish where the first column does
    at = dict(zip(p, map(sp.Integer, (0, 1, 2, 0, 3, 5)), strict=True))
    return Setting(
        tuple(p),
        (
            no(all_minors[2], "the first column is zero", at),
            yes(p[0] * all_minors[2], "expansion of a determinant with two equal rows"),
            yes(p[3] * all_minors[2], "expansion of a determinant with two equal rows"),
            no(all_minors[2] * p[1], "the first column is zero", at),
        ),
        (all_minors[0], all_minors[1]),
        regular=False,
    )


# --- conditions with functions -----------------------------------------------------------------

_FUNCTIONS: tuple[tuple[Any, Any, bool, Any], ...] = (
    # condition, formula, whether it follows, point where it does not
    (y * sp.sin(x), y, False, {x: 0, y: 1}),
    (y * sp.sin(x), y * sp.sin(2 * x), True, None),
    (y * sp.sin(x), y**2 * sp.tan(x), True, None),
    (sp.sin(x) * sp.cos(x), sp.sin(x), False, {x: sp.pi / 2, y: 0}),
    (sp.sin(x) * sp.cos(x), sp.sin(2 * x), True, None),
    (sp.sin(x) * sp.cos(x), sp.sin(4 * x), True, None),
    (sp.sin(x) * sp.cos(x), sp.cos(2 * x) ** 2 - 1, True, None),
    (sp.sin(x) * sp.cos(x), sp.cos(2 * x) - 1, False, {x: sp.pi / 2, y: 0}),
    (y * (x - sp.exp(z)), y, False, {x: 1, y: 1, z: 0}),
    (y * (x - sp.exp(z)), x - sp.exp(z), False, {x: 0, y: 0, z: 0}),
    (y * (x - sp.exp(z)), y * (x**2 - sp.exp(2 * z)), True, None),
    (y * sp.exp(x), y, True, None),
    (y * sp.cosh(x), y, True, None),
    (y * (2 + sp.sin(x)), y, True, None),
    (y * (1 + sp.sin(x)), y, False, {x: -sp.pi / 2, y: 1}),
    (y * (1 + sp.sin(x)), y * sp.cos(x), True, None),
    (y * sp.log(x), y, False, {x: 1, y: 1}),
    (y * sp.log(x), y * (x - 1), True, None),
    (sp.log(x), x - 1, True, None),
    (sp.exp(x) - 1, x, True, None),
    (sp.exp(x) - sp.exp(y), x - y, True, None),
    (sp.exp(x) - sp.exp(y), x + y, False, {x: 1, y: 1}),
    (sp.sin(x) - sp.sin(y), x - y, False, {x: 0, y: sp.pi}),
    (sp.sin(x) - sp.sin(y), sp.cos(x) - sp.cos(y), False, {x: 0, y: sp.pi}),
    (sp.sin(x) - sp.sin(y), sp.cos(2 * x) - sp.cos(2 * y), True, None),
    (sp.sin(x), x, False, {x: sp.pi, y: 0}),
    (sp.sin(x), sp.cos(x) ** 2 - 1, True, None),
    (sp.sin(x), sp.cos(x) - 1, False, {x: sp.pi, y: 0}),
    (sp.cos(x) - 1, sp.sin(x), True, None),
    (sp.sin(x) ** 2 + y**2, sp.sin(x), True, None),
    (sp.sin(x) ** 2 + y**2, x, False, {x: sp.pi, y: 0}),
    (sp.sinh(x), x, True, None),
    (x * sp.exp(x) - y * sp.exp(y), x - y, False, {x: -sp.log(2), y: -2 * sp.log(2)}),
    (sp.atan(x) - sp.atan(y), x - y, True, None),
    (sp.exp(2 * x) - sp.exp(x), x, True, None),
    (sp.exp(2 * x) - 3 * sp.exp(x) + 2, x, False, {x: sp.log(2), y: 0}),
    (sp.exp(2 * x) + sp.exp(x) - 2, x, True, None),
    (x * sp.sqrt(1 + y**2), x, True, None),
    (x * sp.sqrt(y), x, False, {x: 1, y: 0}),
    (sp.sqrt(x) - sp.sqrt(y), x - y, True, None),
    (sp.sqrt(x) - y, y**2 - x, True, None),
    (y**2 - x, sp.sqrt(x) - y, False, {x: 1, y: -1}),
    (x / y, x, True, None),
    (x / y, y, False, {x: 0, y: 1}),
    (1 / x - 1 / y, x - y, True, None),
    (x / y - z / x, x**2 - y * z, True, None),
    (x / y - z / x, x - y, False, {x: 2, y: 1, z: 4}),
    (sp.tan(x), sp.sin(x), True, None),
    (sp.tan(x), sp.cos(x) - 1, False, {x: sp.pi, y: 0}),
    (sp.sin(x) * sp.sin(y), sp.sin(x), False, {x: sp.pi / 2, y: 0}),
    (sp.sin(x + y) + sp.sin(x - y), sp.sin(x), False, {x: sp.pi / 6, y: sp.pi / 2}),
    (sp.sin(x + y) + sp.sin(x - y), sp.sin(2 * x) * sp.cos(y), True, None),
    (x**3 + x, x, True, None),
    (x**3 - x, x, False, {x: 1, y: 0}),
    (x**3 + x * sp.exp(y), x, True, None),
    (x**3 - x * sp.exp(y), x, False, {x: 1, y: 0}),
)  # fmt: skip


def with_functions(rng: random.Random) -> Setting:
    """Conditions with sines, exponentials, logarithms and roots."""
    condition = rng.choice(_FUNCTIONS)[0]
    one, other, third = rng.sample([x, y, z, u, v, w], 3)
    factor = rng.choice([1, 1, number(rng, positive=True)])
    change = {x: one, y: other, z: third}
    claims = []
    for level, formula, follows, at in _FUNCTIONS:
        if level == condition:
            if follows:
                claims.append(yes(factor * formula.xreplace(change), f"from {condition} = 0"))
            else:
                point = {s: sp.sympify(at.get(s, 0)) for s in (x, y, z)}
                moved = {change[s]: value for s, value in point.items()}
                claims.append(no(factor * formula.xreplace(change), "not there", moved))
    level = condition.xreplace(change)
    doubled = level.is_Pow or any(isinstance(t, sp.Pow) and t.exp == 2 for t in level.args)
    touching = {y * (1 + sp.sin(x)), sp.cos(x) - 1}
    return Setting((one, other, third), tuple(claims), (level,),
                   regular=not doubled and condition not in touching)  # fmt: skip


# --- spheres, dependent conditions -------------------------------------------------------------


def two_spheres(rng: random.Random) -> Setting:
    """Two spheres that share a variable."""
    r, s = rng.choice([1, 2, 5]), rng.choice([1, 2, 3])
    first, second = x**2 + y**2 - r**2, x**2 + z**2 - s**2
    top = {x: sp.S.Zero, y: sp.Integer(r), z: -sp.Integer(s)}
    side = {x: HALF, y: sp.sqrt(r**2 - HALF**2), z: sp.sqrt(s**2 - HALF**2)}
    claims = (
        yes(y**2 - z**2 - r**2 + s**2, "the difference"),
        yes(x * (y**2 - z**2 - r**2 + s**2) + first * z, "in the ideal"),
        no(s * y - r * z, "the other sign of z", top),
        no(y**2 + z**2 - r**2 - s**2 + 3 * x, "it is 3 x − 2 x²", side),
    )
    return Setting((x, y, z), claims, (first, second))


def repeated(rng: random.Random) -> Setting:
    """The same condition again, or one that follows."""
    p = z - polynomial(rng, x, y)
    one, other = number(rng), number(rng)
    at = {x: one, y: other, z: (z - p).xreplace({x: one, y: other})}
    again = rng.choice([2 * p, p * (1 + x**2), p * x, p * (x - y), p**2])
    claims = [yes(p, "a condition"), yes(p * w + again, "a sum of conditions")]
    claims += [no(s, "free on a graph", at) for s in (x, y)]
    return Setting((x, y, z, w), tuple(claims), (p, again), regular=False)


def coupled(rng: random.Random) -> Setting:
    """x² + y² = 2 x y and relatives: squares in disguise."""
    k = number(rng)
    level = sp.expand((x - k * y) ** 2)
    at = {x: k, y: sp.S.One, z: sp.S.Zero}
    return Setting(
        (x, y, z),
        (
            yes(x - k * y, "the square of x − k y"),
            yes(x**2 - k**2 * y**2, "the square of x − k y"),
            no(x + k * y, "2 k y", at),
            no(x * y - k, "y is free", {x: 2 * k, y: sp.S(2), z: sp.S.Zero}),
        ),
        (level,),
        regular=False,
    )


LEVELS: dict[str, SettingFamily] = {
    "product of factors": product_of_factors,
    "shared factor": shared_factor,
    "two roots": two_roots,
    "three roots": three_roots,
    "odd roots": odd_roots,
    "even powers": even_powers,
    "near a root": near_roots,
    "equal powers": equal_powers,
    "chosen roots": chosen_roots,
    "forbidden value": forbidden_value,
    "moments of inertia": moments,
    "sums of squares": squares,
    "product of powers": power_product,
    "isolated point": isolated_point,
    "a x = b": unit_parameter,
    "kernel of a matrix": kernel,
    "parallel vectors": parallel,
    "minors": minors,
    "conditions with functions": with_functions,
    "two spheres": two_spheres,
    "repeated conditions": repeated,
    "hidden squares": coupled,
}
