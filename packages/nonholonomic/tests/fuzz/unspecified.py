"""Unspecified functions, and names that collide with what a program may call things itself."""

from __future__ import annotations

import random
from typing import Any

import sympy as sp

from fuzz.case import parameter, real
from fuzz.levels import number, polynomial
from fuzz.setting import Setting, SettingFamily, no, yes

__all__ = ["UNSPECIFIED"]

x, y, z = real("x y z")


def _function(rng: random.Random) -> Any:
    return sp.Function(rng.choice(["f", "U", "V", "F_1", "log", "exp", "sin", "phi", "x", "aux0"]))


def substitution(rng: random.Random) -> Setting:
    """f(x) = 0 and x = y."""
    f = _function(rng)
    form = rng.choice(["linear", "square", "cube"])
    tie = {"linear": x - y, "square": x**2 - y**2, "cube": x**3 - y**3}[form]
    equal = form != "square"
    claims = [
        yes(f(x) * (1 + y), "a condition"),
        yes(f(x**2) * z - f(y**2) * z, "x² = y²"),
        no(sp.diff(f(x), x), "a zero of f need not be double"),
        no(f(x + 1), "another place"),
        no(f(z), "another place"),
        no(x, "f may vanish elsewhere"),
    ]
    if equal:
        claims += [
            yes(f(y), "y = x"),
            yes(f(x + z) - f(y + z), "y = x"),
            yes(sp.diff(f(x), x) - sp.diff(f(y), y), "y = x"),
            yes(f(f(x)) - f(f(y)), "y = x"),
            yes(f(f(y)) - f(sp.S.Zero) if rng.random() < 0.5 else f(x) + f(y), "f(y) = 0"),
        ]
    else:
        claims += [
            no(f(y), "y may be −x"),
            no(x - y, "y may be −x"),
            no(f(x + z) - f(y + z), "y may be −x"),
        ]
    return Setting((x, y, z), tuple(claims), (f(x), tie), regular=False)


def values(rng: random.Random) -> Setting:
    """Equal values do not mean equal places, equal places mean equal values."""
    f, g = sp.Function("f"), sp.Function("g")
    form = rng.choice(["values", "places", "fixed", "inverse", "product", "sum"])
    if form == "values":
        level: tuple[Any, ...] = (f(x) - f(y),)
        claims = [
            no(x - y, "f may be constant"),
            no(sp.diff(f(x), x) - sp.diff(f(y), y), "slopes may differ"),
            no(f(2 * x) - f(2 * y), "only the values at x and y are equal"),
            yes(f(x) ** 2 - f(y) ** 2, "squares of equal values"),
            yes(g(f(x)) - g(f(y)), "equal places"),
            yes(f(f(x)) - f(f(y)), "equal places"),
        ]
    elif form == "places":
        p = polynomial(rng, y, z)
        level = (x - p,)
        claims = [
            yes(f(x) - f(p), "equal places"),
            yes(f(x, z) - f(p, z), "equal places"),
            no(f(x) - f(p + 1), "other places"),
            no(f(x, z) - f(x, z + 1), "other places"),
        ]
    elif form == "fixed":
        level = (f(x) - x,)
        claims = [
            yes(f(f(x)) - x, "a fixed point"),
            yes(f(f(f(x))) - f(x), "a fixed point"),
            no(sp.diff(f(x), x) - 1, "a single fixed point"),
            no(f(y) - y, "another place"),
        ]
    elif form == "inverse":
        level = (f(x) - y, f(y) - x)
        claims = [
            yes(f(f(x)) - x, "y = f(x)"),
            yes(f(f(f(x))) - y, "y = f(x)"),
            no(x - y, "f may exchange them"),
            no(f(z) - z, "another place"),
        ]
    elif form == "product":
        level = (f(x) * g(y),)
        claims = [
            no(f(x), "g(y) may be zero"),
            no(g(y) * z, "f(x) may be zero"),
            yes(f(x) * g(y) * z, "a multiple"),
            yes(f(x) ** 2 * g(y) + g(y) ** 3 * f(x), "a multiple"),
        ]
    else:
        level = (f(x) ** 2 + g(y) ** 2,)
        claims = [
            yes(f(x), "both squares are zero"),
            yes(z * f(x) + g(y), "both squares are zero"),
            no(f(y), "another place"),
            no(x, "the place is free"),
        ]
    return Setting((x, y, z), tuple(claims), level, regular=False)


def derivatives(rng: random.Random) -> Setting:
    """The chain rule, mixed derivatives, and functions named as derivatives might be."""
    U = sp.Function("U")
    slope = sp.diff(U(x), x)
    both = U(x, y)
    symmetric = x + y
    claims = (
        yes(sp.diff(both, x, y) - sp.diff(sp.diff(both, y), x), "mixed derivatives are equal"),
        yes(sp.diff(U(x) ** 2, x) - 2 * U(x) * slope, "the chain rule"),
        yes(z * sp.diff(U(x) * sp.exp(x), x) - z * (slope + U(x)) * sp.exp(x), "Leibniz"),
        yes(sp.diff(sp.sin(U(x)), x) - sp.cos(U(x)) * slope, "the chain rule"),
        no(slope - sp.Function("U_1")(x), "U_1 is another function"),
        no(slope - sp.Function("U'")(x), "U' is another function"),
        no(sp.diff(both, x) - sp.Function("U_10")(x, y), "U_10 is another function"),
        no(sp.diff(both, y) - sp.Function("U_01")(x, y), "U_01 is another function"),
        no(sp.diff(U(x), x, 2) - sp.Function("U_2")(x), "U_2 is another function"),
        no(sp.diff(both, x) - sp.diff(both, y), "U need not depend on x + y"),
        no(slope - U(x), "U is no exponential"),
        no(slope - sp.diff(U(y), y), "other places"),
        no(U(x) + U(y) - U(symmetric), "U need not be linear"),
        no(U(x) - U(-x), "U need not be even"),
        no(U(x) - sp.Function("V")(x), "other functions"),
    )
    return Setting((x, y, z), claims)


def named_as_known(rng: random.Random) -> Setting:
    """Unspecified functions named as well-known ones, whose rules do not hold for them."""
    log, exp, sin, cos, sqrt = (sp.Function(n) for n in ("log", "exp", "sin", "cos", "sqrt"))
    atan, tan = sp.Function("atan"), sp.Function("tan")
    claims = (
        no(log(x) - sp.log(x), "a function of the user's own"),
        no(exp(x) - sp.exp(x), "a function of the user's own"),
        no(sin(x) - sp.sin(x), "a function of the user's own"),
        no(atan(x) - sp.atan(x), "a function of the user's own"),
        no(tan(x) - sp.tan(x), "a function of the user's own"),
        no(exp(x + y) - exp(x) * exp(y), "no exponential"),
        no(sin(x) ** 2 + cos(x) ** 2 - 1, "no sine"),
        no(sqrt(x) ** 2 - x, "no root"),
        no(sp.diff(log(x), x) - 1 / x, "no logarithm"),
        no(sp.diff(exp(x), x) - exp(x), "no exponential"),
        no(sp.diff(sin(x), x) - cos(x), "no sine"),
        yes(sp.diff(exp(x) ** 2, x) - 2 * exp(x) * sp.diff(exp(x), x), "the chain rule"),
        yes(exp(x) * sp.exp(x) * sp.exp(-x) - exp(x), "the law of exponentials"),
        yes((log(x) - sin(y)) * (log(x) + sin(y)) - log(x) ** 2 + sin(y) ** 2, "squares"),
        yes(sin(x + y) - sin(y + x), "the same place"),
    )
    return Setting((x, y, z), claims)


def named_symbols(rng: random.Random) -> Setting:
    """Variables named as a program may name its own."""
    phi, s, c, aux0, aux1 = real("phi sin_phi cos_phi aux0 aux1")
    at = {phi: sp.S.Zero, s: sp.S(2), c: sp.S(3), aux0: sp.S(5), aux1: sp.S(7), x: sp.S.Zero}
    everything = (phi, s, c, aux0, aux1, x)
    form = rng.choice(["free", "angle", "root"])
    if form == "free":
        claims = (
            no(sp.sin(phi) - s, "a variable of its own", at),
            no(sp.cos(phi) - c, "a variable of its own", at),
            no(s**2 + c**2 - 1, "variables of their own", at),
            no(sp.sqrt(1 + x**2) - aux0, "a variable of its own", at),
            no(sp.sqrt(2 + x**2) ** 2 - aux0 * aux1, "variables of their own", at),
            no(sp.exp(x) - aux0, "a variable of its own", at),
            no(sp.Function("f")(x) - aux0, "a variable of its own"),
            yes(aux0 * (sp.sqrt(1 + x**2) ** 2 - 1 - x**2), "the square of a root"),
            yes(s * (sp.sin(phi) ** 2 + sp.cos(phi) ** 2 - 1), "Pythagoras"),
            yes((sp.sin(phi) + s) * (sp.sin(phi) - s) - sp.sin(phi) ** 2 + s**2, "squares"),
        )
        return Setting(everything, claims)
    if form == "angle":
        claims = (
            yes(sp.cos(phi) ** 2 + x**2 - 1, "x = sin φ"),
            yes(c * (sp.cos(phi) ** 2 + x**2 - 1), "x = sin φ"),
            no(c**2 + x**2 - 1, "a variable of its own", at),
            no(s - x, "a variable of its own", at),
            no(sp.cos(phi) - sp.sqrt(1 - x**2), "cos φ < 0", {**at, phi: sp.pi}),
        )
        return Setting(everything, claims, (x - sp.sin(phi),))
    claims = (
        yes(x**2 - 1 - s**2, "squares"),
        no(x - aux0, "a variable of its own", {**at, x: sp.sqrt(5)}),
        no(x**2 - 1 - aux0**2, "a variable of its own", {**at, x: sp.sqrt(5)}),
    )
    return Setting(everything, claims, (x - sp.sqrt(1 + s**2),))


def same_print(rng: random.Random) -> Setting:
    """Different things that print alike."""
    real_x, plain, one, other = x, sp.Symbol("x"), sp.Dummy("x"), sp.Dummy("x")
    first, second = rng.choice([(real_x, plain), (one, other), (plain, one), (real_x, one)])
    at = {first: sp.S.One, second: sp.S(2)}
    form = rng.choice(["state", "parameter"])
    claims = (
        no(first - second, "two things that print alike", at),
        no(first**2 - first * second, "two things that print alike", at),
        yes((first - second) * (first + second) - first**2 + second**2, "squares"),
        yes(first * second - second * first, "products commute"),
    )
    if form == "state":
        return Setting((first, second), claims, refusable=True)
    return Setting((first,), claims, (), (parameter(second, 1.5),), refusable=True)


def conjugates(rng: random.Random) -> Setting:
    """Polynomial identities in values of an unspecified function and its slopes."""
    f = sp.Function("f")
    r = number(rng)
    p, q = f(x), sp.diff(f(x), x)
    m = rng.randint(2, 4)
    claims = (
        yes(sp.expand((p + r * q) ** m) - (p + r * q) ** m, "expanded"),
        yes((p - q) * sum(p**i * q ** (m - 1 - i) for i in range(m)) - p**m + q**m, "a known sum"),
        no(sp.expand((p + r * q) ** m) - p**m - (r * q) ** m, "mixed terms are missing"),
        no(sp.diff(p**m, x) - m * p**m * q, "an exponent is wrong"),
        yes(sp.diff(p**m, x) - m * p ** (m - 1) * q, "the chain rule"),
    )
    return Setting((x, y, z), claims)


UNSPECIFIED: dict[str, SettingFamily] = {
    "substitution into a function": substitution,
    "values of functions": values,
    "derivatives of functions": derivatives,
    "functions named as known ones": named_as_known,
    "symbols named as a program's own": named_symbols,
    "symbols that print alike": same_print,
    "identities in functions": conjugates,
}
