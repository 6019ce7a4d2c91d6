"""Branches of roots, logarithms, powers and inverse functions."""

from __future__ import annotations

import random

import sympy as sp

from fuzz.case import parameter, real
from fuzz.levels import number, polynomial
from fuzz.setting import Claim, Setting, SettingFamily, no, yes

__all__ = ["BRANCHES"]

x, y, z = real("x y z")
a, b, k = real("a b k")


def root_of_a_square(rng: random.Random) -> Setting:
    """√(P²) = |P|."""
    kind = rng.choice(["graph", "definite", "guarded", "unspecified", "unspecified square"])
    if kind == "graph":
        p = z - polynomial(rng, x, y)
        root = sp.sqrt(sp.expand(p**2))
        below = {x: sp.S.One, y: sp.S.One}
        below[z] = (z - p).xreplace(below) - number(rng, positive=True)
        above = {**below, z: (z - p).xreplace(below) + 1}
        claims = [
            no(root - p, "P < 0", below),
            no(root + p, "P > 0", above),
            yes((root - p) * (root + p), "a difference of squares"),
            yes(root**4 - p**4, "the fourth power"),
        ]
        return Setting((x, y, z), tuple(claims))
    if kind == "definite":
        p = x**2 + y**2 * number(rng, positive=True) + number(rng, positive=True)
        p = rng.choice([p, p + z**4, p + sp.exp(z), p + 1 + sp.sin(z)])
        origin = {x: sp.S.Zero, y: sp.S.Zero, z: sp.S.Zero}
        root = sp.sqrt(sp.expand(p**2))
        claims = [
            yes(root - p, "P > 0 everywhere"),
            yes(x * (root - p), "P > 0 everywhere"),
            no(root + p, "P > 0 everywhere", origin),
        ]
        return Setting((x, y, z), tuple(claims))
    if kind == "guarded":
        p = x - number(rng) * y
        root = sp.sqrt(sp.expand(p**2))
        sign = rng.choice([1, -1])
        at = {y: sp.S.One, z: sp.S.Zero}
        at[x] = (x - p).xreplace(at) + sign
        claims = [
            yes(root - sign * p, "the guard tells the sign"),
            no(root + sign * p, "the guard tells the sign", at),
        ]
        return Setting((x, y, z), tuple(claims), guards=(sign * p,))
    places = rng.choice([(x,), (x, y)])
    U = sp.Function("U")(*places)
    if kind == "unspecified":
        root = sp.sqrt(U**2)
        claims = [
            no(sp.Pow(U**2, sp.Rational(1, 2)) - U, "U may be negative"),
            no(sp.sqrt(U**2 + 2 * U + 1) - U - 1, "U may be less than −1"),
            yes(root**2 - U**2, "the square"),
            yes(sp.sqrt(U**2 + 2 * U + 1) ** 2 - (U + 1) ** 2, "the square"),
            yes(sp.sqrt(U**2 + 1) * sp.sqrt(U**2 + 1) - U**2 - 1, "the square"),
        ]
    else:
        claims = [
            yes(sp.sqrt(U**4 + 2 * U**2 + 1) - U**2 - 1, "1 + U² > 0"),
            no(sp.sqrt(U**4 - 2 * U**2 + 1) - U**2 + 1, "U² may be less than 1"),
        ]
    return Setting((x, y, z), tuple(claims))


def difference_of_parameters(rng: random.Random) -> Setting:
    """√(a² − 2ab + b²) = |a − b|."""
    r = number(rng, positive=True)
    order = rng.choice(["none", "greater", "less", "positive"])
    asked = {
        "none": (),
        "greater": (a > r * b,),
        "less": (a < r * b,),
        "positive": (a > 0, b > 0),
    }[order]
    root = sp.sqrt(sp.expand((a - r * b) ** 2))
    less, more = {a: r, b: sp.S(2), x: sp.S.One}, {a: 3 * r, b: sp.S.One, x: sp.S.One}
    default = float(r) if order == "less" else float(3 * r)
    claims: list[Claim] = [yes(x * (root**2 - (a - r * b) ** 2), "the square")]
    if order == "greater":
        claims.append(yes(root - a + r * b, "a > r b"))
        claims.append(no(root + a - r * b, "a > r b", more))
    elif order == "less":
        claims.append(yes(root + a - r * b, "a < r b"))
        claims.append(no(root - a + r * b, "a < r b", less))
    else:
        claims.append(no(root - a + r * b, "a < r b", less))
        claims.append(no(x * (root + a - r * b), "a > r b", more))
    ps = (parameter(a, default, *asked), parameter(b, 2.0 if order == "less" else 1.0))
    return Setting((x,), tuple(claims), (), ps)


def product_of_roots(rng: random.Random) -> Setting:
    """√(ax) √(bx) = √(ab) |x|, where it is defined."""
    order = rng.choice(["none", "positive", "negative", "guard", "positive and guard"])
    asked = {
        "positive": (a > 0, b > 0),
        "positive and guard": (a > 0, b > 0),
        "negative": (a < 0, b < 0),
    }.get(order, ())
    left = sp.sqrt(a * x) * sp.sqrt(b * x)
    formula = left - sp.sqrt(a * b) * x
    minus = {a: -sp.S.One, b: -sp.S.One, x: -sp.S.One}
    plus = {a: sp.S.One, b: sp.S.One, x: sp.S.One}
    claims = [yes(left**2 - a * b * x**2, "the square")]
    if order == "none":
        claims.append(no(formula, "a, b and x may be negative", minus))
        claims.append(no(left + sp.sqrt(a * b) * x, "all may be positive", plus))
    elif order == "negative":
        claims.append(no(formula, "x is not positive where √(ax) is real", minus))
        claims.append(yes(left + sp.sqrt(a * b) * x, "x is not positive where √(ax) is real"))
    else:
        claims.append(yes(formula, "x is not negative where √(ax) is real, or by the guard"))
        claims.append(no(left + sp.sqrt(a * b) * x, "twice the root", plus))
    sign = -1.0 if order == "negative" else 1.0
    ps = (parameter(a, 1.5 * sign, *asked), parameter(b, 0.5 * sign))
    return Setting((x,), tuple(claims), (), ps, guards=(x,) if "guard" in order else ())


def split_root(rng: random.Random) -> Setting:
    """√(PQ) = √P √Q where P and Q are positive."""
    m, n = number(rng, positive=True), number(rng, positive=True)
    # factors, a point with P = 1 < Q, a point with P < 0 < Q
    p, q, inside, outside = rng.choice(
        [
            (x + m, y + n, (1 - m, 4 - n), (-m - 1, sp.S.Zero)),
            (x - y, x + y, (sp.Rational(5, 2), sp.Rational(3, 2)), (sp.S.Zero, sp.S.One)),
            (x + m, x + m + n, (1 - m, sp.S.Zero), (-m - n / 2, sp.S.Zero)),
            (x, m - y, (sp.S.One, m - 4), (-sp.S.One, m - 1)),
        ]
    )
    both = sp.sqrt(sp.expand(p * q))
    claims = [
        yes(both - sp.sqrt(p) * sp.sqrt(q), "both are positive where the right side is real"),
        yes(both**2 - p * q, "the square"),
        no(both - p, "P = 1 is less than Q", dict(zip((x, y), inside, strict=True))),
    ]
    square = sp.sqrt(sp.expand(p**2 * q))
    if rng.random() < 0.5:
        claims.append(yes(square - p * sp.sqrt(q), "P > 0"))
        return Setting((x, y), tuple(claims), guards=(p, q))
    at = dict(zip((x, y), outside, strict=True))
    claims.append(no(square - p * sp.sqrt(q), "P < 0", at))
    return Setting((x, y), tuple(claims))


def nested_roots(rng: random.Random) -> Setting:
    """√(p + q ± 2√(pq)) = |√p ± √q|."""
    p, q = sorted(rng.sample([2, 3, 5, 7, 11], 2))
    plus = sp.Pow(p + q + 2 * sp.sqrt(p * q), sp.Rational(1, 2), evaluate=False)
    minus = sp.Pow(p + q - 2 * sp.sqrt(p * q), sp.Rational(1, 2), evaluate=False)
    at = {x: sp.S.One, y: sp.S.One}
    quarter = {x: sp.Rational(1, 4), y: sp.S.One}
    constants = [
        yes(x * (plus - sp.sqrt(p) - sp.sqrt(q)), "the squares are equal, both are positive"),
        yes(x * (minus - sp.sqrt(q) + sp.sqrt(p)), "the squares are equal, both are positive"),
        no(x * (minus - sp.sqrt(p) + sp.sqrt(q)), "the right side is negative", at),
        no(x * (plus - sp.sqrt(p + q)), "the squares differ", at),
    ]
    inner = sp.sqrt(x + 1 - 2 * sp.sqrt(x))
    outer = sp.sqrt(x + 1 + 2 * sp.sqrt(x))
    form = rng.choice(["constants", "free", "above", "below"])
    if form == "constants":
        return Setting((x, y), tuple(constants))
    if form == "free":
        moving = [
            no(inner - sp.sqrt(x) + 1, "x < 1", quarter),
            no(inner + sp.sqrt(x) - 1, "x > 1", {x: sp.S(4), y: sp.S.One}),
            yes(outer - sp.sqrt(x) - 1, "1 + √x > 0"),
            yes(inner**2 - (sp.sqrt(x) - 1) ** 2, "the square"),
        ]
        return Setting((x, y), tuple(moving))
    if form == "above":
        moving = [
            yes(inner - sp.sqrt(x) + 1, "x > 1"),
            no(inner + sp.sqrt(x) - 1, "x > 1", {x: sp.S(4), y: sp.S.One}),
        ]
        return Setting((x, y), tuple(moving), guards=(x - 1,))
    moving = [
        yes(inner + sp.sqrt(x) - 1, "x < 1"),
        no(inner - sp.sqrt(x) + 1, "x < 1", quarter),
    ]
    return Setting((x, y), tuple(moving), guards=(x, 1 - x))


def logarithms(rng: random.Random) -> Setting:
    """Rules of logarithms and exponentials, right and wrong."""
    one = {x: sp.S.One, y: sp.S.One}
    exp, log, sqrt = sp.exp, sp.log, sp.sqrt
    minus = {x: -sp.S.One, y: -sp.S.One}
    claims = (
        yes(log(x**2) - 2 * log(x), "x > 0 where log x is real"),
        yes(log(x * y) - log(x) - log(y), "both are positive where the logarithms are real"),
        yes(log(x**2 * y**2) - 2 * log(x * y), "x y > 0 where its logarithm is real"),
        yes(log(1 / x) + log(x), "x > 0"),
        yes(log(x / y) - log(x) + log(y), "both are positive"),
        yes(log(x**2) / 2 - log(-x), "x < 0 where log(−x) is real"),
        yes(log(1 + x**2) + log(1 + y**2) - log((1 + x**2) * (1 + y**2)), "all positive"),
        yes(exp(x + y) - exp(x) * exp(y), "the law of exponentials"),
        yes(exp(2 * x) - exp(x) ** 2, "the law of exponentials"),
        yes(exp(x - y) * exp(y) - exp(x), "the law of exponentials"),
        yes(exp(3 * x) * exp(-2 * x) - exp(x), "the law of exponentials"),
        yes(sqrt(exp(2 * x)) - exp(x), "positive"),
        yes(log(exp(x) * (1 + y**2)) - x - log(1 + y**2), "the law of logarithms"),
        no(log(x + y) - log(x) - log(y), "log 2 is not 0", one),
        no(log(x) ** 2 - log(x**2), "log² e is not 2", {x: sp.E, y: sp.S.One}),
        no(log(x * y) - log(-x) - log(-y) + x + y, "it is x + y", minus),
        no(exp(x * y) - exp(x) * exp(y), "e is not e²", one),
        no(exp(x**2) - exp(x) ** 2, "e is not e²", one),
        no(sp.sqrt(log(x) ** 2) - log(x), "x < 1", {x: 1 / sp.E, y: sp.S.One}),
        no(log(x) - log(y), "x and y are free", {x: sp.S(2), y: sp.S.One}),
        no(log(x**2) / 2 - log(x**4) / 2, "log 2 is not 0", {x: sp.S(2), y: sp.S.One}),
    )
    return Setting((x, y), claims)


def powers(rng: random.Random) -> Setting:
    """Symbolic powers of positive variables."""
    at = {x: sp.S(2), y: sp.S(3), a: sp.S.One, b: sp.S(2), k: sp.S(2)}
    claims = (
        yes(x**a * x**b - x ** (a + b), "the law of powers"),
        yes((x**a) ** b - x ** (a * b), "the law of powers"),
        yes(x**a * y**a - (x * y) ** a, "the law of powers"),
        yes((x**2) ** (a / 2) - x**a, "x > 0"),
        yes(x**a * x ** (-a) - 1, "the law of powers"),
        yes(sp.log(x**a) - a * sp.log(x), "the law of logarithms"),
        yes(sp.exp(a * sp.log(x)) - x**a, "the definition of powers"),
        yes(sp.sqrt(x ** (2 * a)) - x**a, "positive"),
        no(x**a - x**b, "2 is not 4", at),
        no(x**a * y**b - (x * y) ** (a + b), "18 is not 216", at),
        no((x**a) ** b - x ** (a + b), "4 is not 8", at),
        no(x**a + y**a - (x + y) ** a, "13 is not 25", {**at, a: sp.S(2)}),
        no(x**a - 1, "2 is not 1", at),
    )
    return Setting((x, y), claims, (), (parameter(a, 1.3), parameter(b, 2.1)), guards=(x, y))


def circles(rng: random.Random) -> Setting:
    """Sines, their inverses, and signs."""
    sin, cos, pi = sp.sin, sp.cos, sp.pi
    zero = {x: sp.S.Zero, y: sp.S.Zero}
    quarter = {x: pi / 2, y: pi / 2}
    claims = (
        yes(sin(x) ** 2 + cos(x) ** 2 - 1, "Pythagoras"),
        yes(sin(2 * x) - 2 * sin(x) * cos(x), "double angle"),
        yes(sin(x + y) - sin(x) * cos(y) - cos(x) * sin(y), "sum of angles"),
        yes(cos(3 * x) - 4 * cos(x) ** 3 + 3 * cos(x), "triple angle"),
        yes(sp.tan(x) * cos(x) - sin(x), "where the tangent is defined"),
        yes(cos(x) - 1 + 2 * sin(x / 2) ** 2, "half angle"),
        yes(sp.tan(x / 2) * (1 + cos(x)) - sin(x), "half angle"),
        yes(sp.cosh(x) ** 2 - sp.sinh(x) ** 2 - 1, "hyperbola"),
        yes(sp.tanh(x) * sp.cosh(x) - sp.sinh(x), "quotient"),
        yes(sin(sp.asin(x)) - x, "the inverse"),
        yes(sp.tan(sp.atan(x)) - x, "the inverse"),
        yes(cos(sp.asin(x)) ** 2 + x**2 - 1, "the inverse"),
        yes(cos(sp.atan(x)) - 1 / sp.sqrt(1 + x**2), "−π/2 < atan x < π/2"),
        yes(sin(x) ** 2 - sp.sqrt(1 - cos(x) ** 2) ** 2, "squares"),
        no(sin(x) - sp.sqrt(1 - cos(x) ** 2), "−1 is not 1", {**zero, x: -pi / 2}),
        no(cos(x) - sp.sqrt(1 - sin(x) ** 2), "−1 is not 1", {**zero, x: pi}),
        no(sin(2 * x) - 2 * sin(x), "0 is not 2", quarter),
        no(sin(x + y) - sin(x) - sin(y), "0 is not 2", quarter),
        no(cos(x) ** 2 - sin(x) ** 2 - 1, "−1 is not 1", quarter),
        no(cos(x / 2) ** 2 - cos(x), "1/2 is not 0", quarter),
        no(sp.asin(sin(x)) - x, "0 is not π", {**zero, x: pi}),
        no(sp.acos(cos(x)) - x, "0 is not 2π", {**zero, x: 2 * pi}),
        no(sp.atan(x) + sp.atan(1 / x) - pi / 2, "x < 0", {**zero, x: -sp.S.One}),
        no(sp.atan2(y, x) - sp.atan(y / x), "x < 0", {x: -sp.S.One, y: sp.S.One}),
        no(sp.atan(sp.tan(x)) - x, "0 is not π", {**zero, x: pi}),
        no(
            sp.atan(x) + sp.atan(y) - sp.atan((x + y) / (1 - x * y)),
            "x y > 1",
            {x: sp.sqrt(3), y: sp.sqrt(3)},
        ),
    )
    return Setting((x, y), claims)


def inverse_functions(rng: random.Random) -> Setting:
    """Arcus functions where guards choose the branch."""
    atan, pi = sp.atan, sp.pi
    one = {x: sp.S.One, y: sp.S.One}
    claims = (
        yes(atan(x) + atan(1 / x) - pi / 2, "x > 0"),
        yes(sp.atan2(y, x) - atan(y / x), "x > 0"),
        yes(sp.asin(x / sp.sqrt(1 + x**2)) - atan(x), "both in (−π/2, π/2)"),
        no(atan(x) + atan(y) - pi / 4, "π/2 is not π/4", one),
        no(sp.atan2(y, x) - atan(x / y), "atan 2 is not atan 1/2", {x: sp.S.One, y: sp.sqrt(3)}),
    )
    return Setting((x, y), claims, guards=(x, y))


def absolute_values(rng: random.Random) -> Setting:
    """|x| told by SymPy itself, for real symbols."""
    minus = {x: -sp.S.One, y: sp.S.One}
    claims = (
        yes(sp.Abs(x) ** 2 - x**2, "squares"),
        yes(sp.Abs(x * y) - sp.Abs(x) * sp.Abs(y), "absolute values multiply"),
        yes(sp.sqrt(x**2) * x**2 - sp.Abs(x**3), "absolute values multiply"),
        no(sp.Abs(x) - x, "x < 0", minus),
        no(sp.sqrt(x**2) - x, "x < 0", minus),
        no(sp.sqrt(sp.expand((x + y - 3) ** 2)) - x - y + 3, "x + y < 3", minus),
        no(sp.Abs(x + y) - sp.Abs(x) - sp.Abs(y), "opposite signs", minus),
    )
    return Setting((x, y), claims)


def cancelling_roots(rng: random.Random) -> Setting:
    """Roots that cancel in a level: √x = y, √x = −y, and squares of such."""
    r = number(rng, positive=True)
    at = {x: r**2, y: -r}
    form = rng.choice(["square", "root", "minus", "guard"])
    if form == "square":
        claims = (
            no(sp.sqrt(x) - y, "y < 0", at),
            no(sp.sqrt(x) + y, "y > 0", {**at, y: r}),
            yes(sp.sqrt(x) ** 2 - y**2, "squares"),
            yes((sp.sqrt(x) - y) * (sp.sqrt(x) + y), "squares"),
            yes(sp.sqrt(x) * y**2 - x * sp.sqrt(x), "squares"),
        )
        return Setting((x, y), claims, (y**2 - x,))
    if form == "guard":
        claims = (
            yes(sp.sqrt(x) - y, "y > 0"),
            no(sp.sqrt(x) + y, "y > 0", {**at, y: r}),
        )
        return Setting((x, y), claims, (y**2 - x,), guards=(y,))
    sign = 1 if form == "root" else -1
    claims = (
        yes(y**2 - x, "squares"),
        yes(sp.sqrt(y**2 * x + 1) - sp.sqrt(x**2 + 1), "y² = x"),
        no(sp.sqrt(x) + sign * y, "twice the root", {x: r**2, y: sign * r}),
        no(y + sign * x + sign, "both have the sign", {x: r**2, y: sign * r}),
    )
    return Setting((x, y), claims, (sp.sqrt(x) - sign * y,))


BRANCHES: dict[str, SettingFamily] = {
    "root of a square": root_of_a_square,
    "root of a difference squared": difference_of_parameters,
    "product of roots": product_of_roots,
    "split root": split_root,
    "nested roots": nested_roots,
    "logarithms": logarithms,
    "symbolic powers": powers,
    "sines": circles,
    "inverse functions": inverse_functions,
    "absolute values": absolute_values,
    "roots on levels": cancelling_roots,
}
