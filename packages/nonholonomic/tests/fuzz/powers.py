"""Powers with exponents that are symbols, absolute values and signs.

A power bᵃ is real where b > 0, and for whole a wherever b is not zero: (b²)ᵃ is defined for either
sign of b, and differs from b²ᵃ at a = ½ where b < 0.
"""

from __future__ import annotations

import random

import sympy as sp

from fuzz.case import parameter, real
from fuzz.levels import number, polynomial
from fuzz.setting import Claim, Setting, SettingFamily, no, yes

__all__ = ["POWERS"]

x, y, z = real("x y z")
a, b = real("a b")
HALF = sp.Rational(1, 2)


def _base(rng: random.Random) -> tuple[sp.Expr, sp.Rational]:
    """A base in x alone that is positive right of a place and negative left of it."""
    place = number(rng)
    return rng.choice([x - place, number(rng, positive=True) * (x - place)]), place


def even_powers(rng: random.Random) -> Setting:
    """(b²)ᵃ against b²ᵃ, and its relatives."""
    base, place = _base(rng)
    where = rng.choice(["anywhere", "right", "left"])
    made = rng.choice(
        [
            lambda p: sp.Pow(sp.expand(p**2), a) - p ** (2 * a),
            lambda p: sp.Pow(sp.sqrt(sp.expand(p**2)), 2 * a) - p ** (2 * a),
            lambda p: sp.Pow(sp.expand(p**4), a / 2) - p ** (2 * a),
            lambda p: sp.Pow(sp.expand(p**2), a + 1) - p ** (2 * a) * p**2,
            lambda p: sp.Pow(sp.expand(p**2), a) * sp.Pow(sp.expand(p**2), a) - p ** (4 * a),
        ]
    )
    exponent = parameter(a, 1.3, a > 0)
    always = yes(sp.Pow(sp.expand(base**2), a) ** 2 - sp.Pow(sp.expand(base**4), a), "squares")
    if where == "anywhere":
        left = {x: place - 2, a: HALF}
        formula = made(base)
        failing = no(formula, "b < 0 and 2 a = 1", left)
        # where the last form is even at a = 1/2, a quarter shows it
        if sp.sympify(formula).subs(left) == 0:
            failing = no(formula, "b < 0", {x: place - 2, a: HALF / 2})
        claims = [failing, always]
        return Setting((x,), tuple(claims), parameters=(exponent,), refusable=False)
    sign = 1 if where == "right" else -1
    right = yes(made(sign * base), "the guard tells the sign")
    wrong = no(
        sp.Pow(sp.expand(base**2), a) - sign * (sign * base) ** (2 * a + 1),
        "one power too many",
        {x: place + 2 * sign, a: sp.S.One},
    )
    return Setting((x,), (right, wrong), parameters=(exponent,), guards=(sign * base,))


def powers_of_products(rng: random.Random) -> Setting:
    """(f g)ᵃ = fᵃ gᵃ where f and g are positive."""
    c = number(rng, positive=True)
    f, g = rng.choice([(x, y), (x + c, y), (1 + x**2, y), (x, c + y**2)])
    formula = sp.Pow(sp.expand(f * g), a) - f**a * g**a
    ones = {x: sp.S(2), y: sp.S(3), a: sp.S(2)}
    claims = (
        yes(formula, "both are positive"),
        no(sp.Pow(sp.expand(f * g), a) - f**a * g ** (a + 1), "one power too many", ones),
        no(sp.Pow(sp.expand(f * g), a) + f**a * g**a, "the sign", ones),
        yes(sp.Pow(f, a) * sp.Pow(f, b) - sp.Pow(f, a + b), "exponents add"),
        no(sp.Pow(f, a) + sp.Pow(f, b) - sp.Pow(f, a + b), "they do not", {**ones, b: sp.S.One}),
    )
    exponents = (parameter(a, 1.3, a > 0), parameter(b, 0.7))
    return Setting((x, y), claims, parameters=exponents, guards=(x, y))


def absolute_values(rng: random.Random) -> Setting:
    """Values of |u| and sign u."""
    u = rng.choice([x, x - number(rng), x * y, x + number(rng) * y, polynomial(rng, x, y) + x])
    v = rng.choice([y, y + number(rng), z])
    plus = _point_with(u, 1)
    minus = _point_with(u, -1)
    claims: list[Claim] = [
        yes(sp.Abs(u) ** 2 - u**2, "the square"),
        yes(sp.Abs(u) * sp.sign(u) - u, "the sign"),
        yes(sp.Abs(u * v) - sp.Abs(u) * sp.Abs(v), "the value of a product"),
        yes(sp.sqrt(sp.expand(u**2)) - sp.Abs(u), "a root of a square"),
        yes(sp.Abs(u) ** 3 - u**2 * sp.Abs(u), "the cube"),
        yes((sp.Abs(u) - u) * (sp.Abs(u) + u), "a difference of squares"),
    ]
    if minus is not None:
        claims.append(no(sp.Abs(u) - u, "u < 0", minus))
        claims.append(no(sp.sqrt(sp.expand(u**2)) - u, "u < 0", minus))
        claims.append(no(sp.sign(u) - 1, "u < 0", minus))
    if plus is not None:
        claims.append(no(sp.Abs(u) + u, "u > 0", plus))
        claims.append(no(sp.sign(u) + 1, "u > 0", plus))
    return Setting((x, y, z), tuple(claims))


def absolute_values_with_signs(rng: random.Random) -> Setting:
    """|u| where a guard, a parameter or the formula itself tells the sign."""
    c = number(rng, positive=True)
    sign = rng.choice([1, -1])
    kind = rng.choice(["guard", "parameter", "bounded", "disk"])
    at = {x: sp.S(sign), y: sp.S.Zero, a: sp.S(sign) * (c + 1)}
    if kind == "guard":
        claims = (
            yes(sp.Abs(x) - sign * x, "the guard"),
            yes(y * (sp.Abs(x**3) - sign * x**3), "the guard"),
            no(sp.Abs(x) + sign * x, "the guard", at),
        )
        return Setting((x, y), claims, guards=(sign * x,))
    if kind == "parameter":
        asked = a > c if sign > 0 else a < -c
        claims = (
            yes(x * (sp.Abs(a) - sign * a), "the parameter"),
            yes(sp.sqrt(sp.expand((a - sign * c / 2) ** 2)) - sign * a + c / 2, "the parameter"),
            no(x + sp.Abs(a) + sign * a - x, "the parameter", at),
        )
        return Setting((x,), claims, parameters=(parameter(a, float(sign * (c + 1)), asked),))
    if kind == "bounded":
        claims = (
            yes(sp.Abs(2 + sp.sin(x)) - 2 - sp.sin(x), "2 + sin x > 0"),
            yes(sp.Abs(x**4 - 2 * x**2 + 2) - x**4 + 2 * x**2 - 2, "(x² − 1)² + 1 > 0"),
            yes(sp.Abs(sp.exp(x) * y) - sp.exp(x) * sp.Abs(y), "eˣ > 0"),
            no(sp.Abs(1 + 2 * sp.sin(x)) - 1 - 2 * sp.sin(x), "it changes sign", {x: -sp.pi / 2}),
            no(
                sp.Abs(x**4 - 3 * x**2 + 2) - x**4 + 3 * x**2 - 2, "it does", {x: sp.Rational(6, 5)}
            ),
        )
        return Setting((x, y), claims)
    inside = {x: HALF, y: HALF}
    claims = (
        yes(sp.Abs(2 - x) - 2 + x, "x² < 1"),
        yes(sp.sqrt(sp.expand((1 - y) ** 2)) - 1 + y, "y² < 1"),
        yes(sp.Abs(3 + x + y) - 3 - x - y, "|x + y| < 3"),
        no(sp.Abs(x) - x, "x may be negative", {x: -HALF, y: HALF}),
        no(sp.Abs(x - y) - x + y, "x may be less than y", {x: -HALF, y: HALF}),
        no(sp.Abs(2 - x) + 2 - x, "the sign", inside),
    )
    return Setting((x, y), claims, guards=(1 - x**2 - y**2,))


def _point_with(u: sp.Expr, sign: int) -> dict[sp.Symbol, sp.Expr] | None:
    """A point at which a formula has a sign; None where none of a few has it."""
    for first in (0, 1, -1, 3, -3, 8, -8):
        for second in (0, 1, -1, 5, -5):
            point = {x: sp.Integer(first), y: sp.Integer(second), z: sp.S.One}
            if sp.sign(u.subs(point)) == sign:
                return point
    return None


POWERS: dict[str, SettingFamily] = {
    "even powers": even_powers,
    "powers of products": powers_of_products,
    "absolute values": absolute_values,
    "absolute values with signs": absolute_values_with_signs,
}
