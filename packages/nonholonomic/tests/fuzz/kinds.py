"""Laws of every kind that are right by construction, and the same with one thing wrong."""

from __future__ import annotations

import random
from collections.abc import Callable
from typing import Any

import sympy as sp

from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import (
    ConformallyHamiltonian,
    Identity,
    Integral,
    Law,
    Measure,
    PoissonStructure,
    Rate,
    Reduction,
    Separation,
    Symmetry,
)
from flowlanes.system.system import System
from fuzz.case import Case, Family, Truth, parameter, real, system
from fuzz.levels import number

__all__ = ["KINDS"]

x, y, z, u, v, w = real("x y z u v w")
p, q, s = real("p q s")
a, b, c = real("a b c")
SPACE = (x, y, z)


def _case(
    name: str,
    made: System,
    law: Law | Callable[[], Law],
    truth: Truth | bool,
    why: str,
    refusable: bool = False,
) -> Case:
    """A case; a law that may be refused when it is made comes as a function that makes it."""
    told: Truth = ("true" if truth else "false") if isinstance(truth, bool) else truth
    return Case(
        name,
        lambda: (made, law if isinstance(law, Law) else law()),
        told,
        why,
        refusable=refusable,
    )


def _polynomial(rng: random.Random, names: tuple[sp.Symbol, ...] = SPACE) -> sp.Expr:
    """A polynomial of degree two or three in which every variable occurs."""
    squares = sum(number(rng) * n ** rng.choice([2, 2, 3]) for n in names)
    return squares + number(rng) * sp.Mul(*rng.sample(names, 2)) + number(rng) * rng.choice(names)


def _gradient(formula: sp.Expr) -> sp.Matrix:
    return sp.Matrix([sp.diff(formula, n) for n in SPACE])


def _crossed(rng: random.Random) -> tuple[sp.Expr, sp.Expr, list[sp.Expr]]:
    """Two integrals, and the field ∇P × ∇Q without divergence that keeps them; no rate is zero."""
    while True:
        first, second = _polynomial(rng), _polynomial(rng)
        rates = [sp.expand(r) for r in _gradient(first).cross(_gradient(second))]
        if all(rates):
            return first, second, rates


def integrals(rng: random.Random) -> Case:
    """P and Q are integrals of ∇P × ∇Q; a variable whose rate is not zero is none."""
    first, second, rates = _crossed(rng)
    factor = rng.choice(
        [sp.S.One, 1 + x**2, sp.exp(y), 1 / (2 + sp.sin(z)), sp.Function("g")(x, y)]
    )
    made = system(dict(zip(SPACE, [factor * r for r in rates], strict=True)))
    right = rng.choice(
        [first, second, first * second, first**2 - 3 * second, sp.sqrt(1 + first**2),
         sp.exp(second), sp.log(1 + first**2), sp.sin(first) * second, sp.Function("f")(first)]
    )  # fmt: skip
    if rng.random() < 0.5:
        return _case("integrals", made, Integral("law", right), True, "a function of P and Q")
    stray = number(rng) * rng.choice(SPACE) * sp.Integer(10) ** rng.randint(-9, 3)
    wrong = Integral("law", right + stray)
    return _case("integrals", made, wrong, False, f"the rate of {stray} is not zero")


def measures(rng: random.Random) -> Case:
    """A field ∇P × ∇Q divided by ρ has the density ρ."""
    _, _, rates = _crossed(rng)
    base = rng.choice([1 + x**2, 2 + x**2 + y**2, 1 + x**4])
    power = rng.choice([sp.S.One, sp.S(2), sp.Rational(1, 2), -sp.S.One, sp.Rational(-3, 2), a])
    made = system(
        dict(zip(SPACE, [r * base**-power for r in rates], strict=True)),
        parameters=(parameter(a, 1.3, a > 1),),
    )
    if rng.random() < 0.5:
        law = Measure("law", {base: power, sp.S(3): rng.choice([0, 1])})
        return _case("measures", made, law, True, "ρ v has no divergence")
    form = rng.choice(["power", "base", "none"])
    if form == "none":
        law = Measure("law", {sp.S.One: 1})
        why = "v(base) is not zero, and the power is none"
    elif form == "power":
        law = Measure("law", {base: power + rng.choice([1, -1, sp.Rational(1, 1000)])})
        why = "the density by the right one is a power of the base, which is no integral"
    else:
        law = Measure("law", {base: power, 2 + z**2: 1})
        why = "2 + z² is no integral"
    # v(base) and v(2 + z²) would have to vanish
    moved = base if form != "base" else 2 + z**2
    flow = sum(sp.diff(moved, n) * r for n, r in zip(SPACE, rates, strict=True))
    if sp.expand(flow) == 0:
        return measures(rng)
    return _case("measures", made, law, False, why)


def imaginary_densities(rng: random.Random) -> Case:
    """A density that is nowhere real, or nowhere different from zero."""
    _, _, rates = _crossed(rng)
    made = system(dict(zip(SPACE, rates, strict=True)))
    inside = rng.choice([-1 - x**2 - y**2, -2 - x**4, -sp.exp(x) - 1])
    form = rng.choice(["root", "half", "zero", "log"])
    if form == "root":
        law = Measure("law", {sp.sqrt(inside): rng.choice([1, 2, -1])})
    elif form == "half":
        law = Measure("law", {inside: rng.choice([sp.Rational(1, 2), sp.Rational(3, 2)])})
    elif form == "zero":
        law = Measure("law", {(x + 1) ** 2 - x**2 - 2 * x - 1: 1})
    else:
        law = Measure("law", {sp.log(inside): 1})
    return _case("imaginary densities", made, law, "malformed", "the density is nowhere defined")


def symmetries(rng: random.Random) -> Case:
    """Linear fields commute as their matrices do; the Euler field with what has degree one."""
    if rng.random() < 0.5:
        A = sp.Matrix(3, 3, lambda i, j: rng.randint(-3, 3))
        B = number(rng) * A**2 + number(rng) * A + number(rng) * sp.eye(3)
        right = rng.random() < 0.5
        if not right:
            i, j = rng.sample(range(3), 2)
            B[i, j] += number(rng) / 1000
        commutator = A * B - B * A
        made = system(dict(zip(SPACE, A * sp.Matrix(SPACE), strict=True)))
        law = Symmetry("law", dict(zip(SPACE, B * sp.Matrix(SPACE), strict=True)))
        holds = commutator == sp.zeros(3, 3)
        why = "the matrices commute" if holds else "the matrices do not commute"
        return _case("symmetries", made, law, holds, why)
    degree = rng.randint(1, 3)
    rates = []
    for _ in SPACE:
        terms = [sp.Mul(*(rng.choice(SPACE) for _ in range(degree))) for _ in range(2)]
        rates.append(sp.expand(number(rng) * terms[0] + number(rng, positive=True) * terms[1]))
    if not any(rates):
        return symmetries(rng)
    made = system(dict(zip(SPACE, rates, strict=True)))
    law = Symmetry("law", dict(zip(SPACE, SPACE, strict=True)))
    why = f"the field is homogeneous of degree {degree}: [E, v] = {degree - 1} v"
    return _case("symmetries", made, law, degree == 1, why)


def _skew(vector: list[sp.Expr]) -> sp.Matrix:
    return sp.Matrix(
        [[0, -vector[2], vector[1]], [vector[2], 0, -vector[0]], [-vector[1], vector[0], 0]]
    )


def brackets(rng: random.Random) -> Case:
    """In three dimensions {·, ·} is a vector J with (J, rot J) = 0, such as g ∇C."""
    while True:
        casimir = _polynomial(rng)
        normal = list(_gradient(casimir))
        if all(normal):
            break
    g = rng.choice([sp.S.One, 1 + x**2, y, sp.exp(z), sp.Function("g")(x, y, z)])
    matrix = _skew([g * n for n in normal])
    made = system(dict.fromkeys(SPACE, sp.S.Zero))
    form = rng.choice(["right", "right", "right", "rank", "odd", "casimir", "skew", "jacobi"])
    name = "brackets"
    if form == "right":
        law = PoissonStructure("law", matrix, rng.choice([(), (casimir,), (casimir**2,)]),
                               rank=rng.choice([None, 2]))  # fmt: skip
        return _case(name, made, law, True, "g ∇C is a Poisson structure of rank 2")
    if form == "rank":
        even = rng.choice([0, 4])
        return _case(
            name,
            made,
            lambda: PoissonStructure("law", matrix, rank=even),
            False,
            "the rank is 2",
            True,
        )
    if form == "odd":
        odd = rng.choice([1, 3, -2])
        return _case(
            name,
            made,
            lambda: PoissonStructure("law", matrix, rank=odd),
            False,
            "no rank is odd",
            True,
        )
    if form == "casimir":
        law = PoissonStructure("law", matrix, (casimir + number(rng) * rng.choice(SPACE),))
        return _case(name, made, law, False, "a variable is no Casimir function")
    if form == "skew":
        i, j = rng.choice([(0, 0), (1, 1), (0, 1), (2, 1)])
        wrong = matrix.copy()
        wrong[i, j] += number(rng)
        return _case(name, made, PoissonStructure("law", wrong), False, "it is not skew")
    size = number(rng)
    wrong = _skew(rng.choice([[sp.S.Zero, size * x, sp.S.One], [size * y, sp.S.Zero, sp.S.One],
                              [y, z, size * x]]))  # fmt: skip
    return _case(name, made, PoissonStructure("law", wrong), False, "(J, rot J) is not zero")


def ranks(rng: random.Random) -> Case:
    """Constant and linear brackets in four and five dimensions, of known rank."""
    names = (x, y, z, u, w)[: rng.choice([4, 5])]
    size = len(names)
    pairs = rng.choice([1, 2])
    matrix = sp.zeros(size, size)
    for k in range(pairs):
        value = rng.choice([number(rng), names[2 * k], 1 + names[2 * k] ** 2])
        matrix[2 * k, 2 * k + 1], matrix[2 * k + 1, 2 * k] = value, -value
    order = list(range(size))
    rng.shuffle(order)
    matrix = matrix.extract(order, order)
    names = tuple(names[i] for i in order)
    said = rng.choice([2 * pairs, 2 * pairs, 2 * pairs, 0, 2, 4, 3, 6])
    made = system(dict.fromkeys(names, sp.S.Zero))
    why = f"it is a sum of {pairs} brackets in a plane each"
    holds = said == 2 * pairs
    return _case(
        "ranks", made, lambda: PoissonStructure("law", matrix, rank=said), holds, why, not holds
    )


def hamiltonian_forms(rng: random.Random) -> Case:
    """v = N J dH by construction."""
    casimir, energy = _polynomial(rng), _polynomial(rng)
    matrix = _skew(list(_gradient(casimir)))
    factor = rng.choice([sp.S.One, 1 + x**2, sp.exp(y), 1 / (1 + z**2), a])
    rates = [sp.expand(r) for r in matrix * _gradient(energy)]
    if not all(rates):
        return hamiltonian_forms(rng)
    made = system(
        dict(zip(SPACE, [factor * r for r in rates], strict=True)),
        parameters=(parameter(a, 1.7, a > 0),),
    )
    structure = PoissonStructure("bracket", matrix, rank=2)
    form = rng.choice(["right", "right", "right", "factor", "energy", "multiplier", "scaled"])
    name = "hamiltonian forms"
    if form == "right":
        told = rng.choice([energy, energy + 3, energy + casimir, energy - casimir**2])
        law = ConformallyHamiltonian("law", factor, structure, told)
        return _case(name, made, law, True, "v = N J dH, up to Casimir functions")
    if form == "scaled":
        law = ConformallyHamiltonian("law", factor / (2 * energy + 200), structure,
                                     (energy + 100) ** 2)  # fmt: skip
        return _case(name, made, law, True, "dH² = 2 H dH")
    if form == "factor":
        law = ConformallyHamiltonian("law", 2 * factor, structure, energy)
        return _case(name, made, law, False, "twice the field, which is not zero")
    if form == "multiplier":
        law = ConformallyHamiltonian("law", factor + sp.Rational(1, 10**6), structure, energy)
        return _case(name, made, law, False, "another multiple of the field, which is not zero")
    law = ConformallyHamiltonian("law", factor, structure, energy + x)
    if not any(matrix * _gradient(x)):
        return hamiltonian_forms(rng)
    return _case(name, made, law, False, "x is no Casimir function")


def isomorphisms(rng: random.Random) -> Case:
    """A triangular change of variables, with the field pushed forward."""
    one, other = number(rng) * x**2 + number(rng), number(rng) * x * y
    image = (x, y + one, z + other)
    back = {x: u, y: v - one.xreplace({x: u})}
    back[z] = w - other.xreplace({x: u, y: back[y]})
    rates = [_polynomial(rng) for _ in SPACE]
    speed = rng.choice([sp.S.One, sp.S(2), 1 + x**2, a])
    name = "isomorphisms"
    pushed = [
        sp.expand(sum(sp.diff(f, n) * r for n, r in zip(SPACE, rates, strict=True))).xreplace(back)
        for f in image
    ]
    made = system(dict(zip(SPACE, [speed * r for r in rates], strict=True)),
                  parameters=(parameter(a, 1.7, a > 0),))  # fmt: skip
    target = system(dict(zip((u, v, w), pushed, strict=True)))
    told = dict(zip((u, v, w), image, strict=True))
    form = rng.choice(["right", "right", "right", "time", "map", "rest", "larger", "smaller",
                       "backwards"])  # fmt: skip
    if form == "right":
        return _case(name, made, Isomorphism("law", target, told, speed), True, "pushed forward")
    if form == "time":
        law = Isomorphism("law", target, told, speed * sp.Rational(1001, 1000))
        return _case(name, made, law, False, "another time, and the field is not zero")
    if form == "map":
        law = Isomorphism("law", system({u: rates[0].xreplace({x: u, y: v, z: w}),
                                         v: rates[1].xreplace({x: u, y: v, z: w}),
                                         w: rates[2].xreplace({x: u, y: v, z: w})}),
                          {u: x, v: y, w: z + number(rng)}, speed)  # fmt: skip
        # z occurs in a square or a cube of the first rate, so that a shift changes it
        return _case(name, made, law, False, "the rates change when z is shifted")
    if form == "rest":
        still = system(dict.fromkeys((u, v, w), sp.S.Zero))
        constant = dict.fromkeys((u, v, w), sp.Integer(rng.randint(0, 2)))
        moving = dict(zip((u, v, w), SPACE, strict=True))
        map_, time, why = rng.choice(
            [
                (constant, sp.S.One, "the map forgets everything"),
                (moving, sp.S.Zero, "the field is not zero, and no time may stand still"),
            ]
        )
        return _case(name, made, Isomorphism("law", still, map_, time), False, why, refusable=True)
    if form == "larger":
        # the plane s = 0 of a larger phase space
        field = dict(zip((u, v, w), pushed, strict=True))
        larger = system({**field, s: rng.choice([s, s * u, sp.S.Zero])})
        law = Isomorphism("law", larger, {**told, s: sp.S.Zero}, speed)
        return _case(name, made, law, False, "it is not onto", refusable=True)
    if form == "backwards":
        law = Isomorphism("law", target, told, -speed)
        reversed_ = system({n: -r for n, r in made.field}, parameters=made.parameters)
        return _case(name, reversed_, law, False, "time runs backwards", refusable=True)
    smaller = system({p: sp.S.One})
    made = system({x: sp.S.One, y: x, z: y})
    return _case(name, made, Isomorphism("law", smaller, {p: x}), False, "y and z are lost",
                 refusable=True)  # fmt: skip


def standing_time(rng: random.Random) -> Case:
    """A time that stands still carries a system at rest onto anything, and is no change of time."""
    target = system({u: number(rng) * u + 1, v: u * v})
    made = system({x: sp.S.Zero, y: sp.S.Zero})
    law = Isomorphism("law", target, {u: x, v: y}, rng.choice([sp.S.Zero, x - x]))
    return _case("standing time", made, law, False, "dτ/dt = 0", refusable=True)


def reductions(rng: random.Random) -> Case:
    """x' = k x f, so that u = xⁿ has u' = n k u f."""
    k, n = number(rng), rng.randint(2, 4)
    f, told = rng.choice([(sp.S.One, sp.S.One), (1 / (1 + x ** (2 * n)), 1 / (1 + q**2))])
    made = system({x: k * x * f, y: -y, z: x * y})
    wrong = rng.random() < 0.5
    factor = n * k + (rng.choice([1, -1, sp.Rational(1, 10**6)]) if wrong else 0)
    law = Reduction("law", {q: x**n}, (Rate(q) - factor * q * told,))
    return _case("reductions", made, law, not wrong, f"the rate is {n * k} q f")


def separations(rng: random.Random) -> Case:
    """x' = N f(x) and y' = N g(y), told in p = k x and q = m y."""
    k, m = number(rng), number(rng)
    f, g = rng.choice([x, 1 + x**2, 2 * x - 1]), rng.choice([y, 1 + y**4, 3 * y])
    common = rng.choice([sp.S.One, 1 + x**2 + y**2, x - y, 1 / (1 + x**2 * y**2)])
    form = rng.choice(["right", "right", "coupled", "rate", "mixed"])
    back = {x: p / k, y: q / m}
    mixed = {"mixed": y + x, "coupled": y - x + 1}.get(form, g)
    made = system({x: common * f, y: common * mixed, z: x * y})
    factor = k * rng.choice([2, -1, sp.Rational(1000001, 1000000)]) if form == "rate" else k
    equations = (
        Rate(p) - factor * (common * f).xreplace(back),
        Rate(q) - m * (common * mixed).xreplace(back),
    )
    law = Separation("law", {p: k * x, q: m * y}, equations)
    why = {
        "right": "each is a function of its own variable, but for a common factor",
        "rate": "the first rate is k N f",
    }.get(form, "the ratio of the rates is no product of functions of each")
    return _case("separations", made, law, form == "right", why, refusable=form != "right")


def open_reductions(rng: random.Random) -> Case:
    """Equations that hold and are not closed, and names that are taken."""
    made = system({x: y, y: -x, z: x * y})
    form = rng.choice(["state", "parameter", "single", "unclosed", "idle"])
    name = "open reductions"
    if form == "state":
        law: Law = Reduction("law", {y: x**2}, (Rate(y) - 2 * x * y,))
        return _case(name, made, law, "malformed", "y is a state variable already")
    if form == "parameter":
        made = system({x: a * y, y: -a * x}, parameters=(parameter(a, 1.3),))
        law = Reduction("law", {a: x**2 + y**2}, (Rate(a),))
        return _case(name, made, law, "malformed", "a is a parameter already")
    if form == "single":
        law = Separation("law", {p: x**2}, (Rate(p) - 2 * x * y,))
        return _case(name, made, law, False, "the rate is no function of p", refusable=True)
    if form == "idle":
        return _case(
            name,
            made,
            lambda: Reduction("law", {p: x**2}, (p - x**2,)),
            False,
            "nothing is said of rates",
            refusable=True,
        )
    law = Reduction("law", {p: x**2}, (Rate(p) - 2 * x * y,))
    return _case(name, made, law, False, "the rates of x and y are left open", refusable=True)


def restless_levels(rng: random.Random) -> Case:
    """A level that is not invariant: no law holds on it."""
    form = rng.choice(["square", "plane", "product", "circle", "sum", "part", "thin", "function"])
    k = number(rng)
    shift = number(rng)
    rates, on, why = {
        "square": ({x: k, y: sp.S.Zero}, (x - shift) ** 2, "x moves away"),
        "plane": ({x: k * y, y: sp.S.Zero}, x - shift, "x moves unless y = 0"),
        "product": ({x: k * y, y: -y}, x * y, "from x = 0 it moves where y is not zero"),
        "circle": ({x: y, y: -x + k * y / 1000}, x**2 + y**2 - 1, "the radius grows or shrinks"),
        "sum": ({x: k, y: sp.S.Zero}, x**2 + y**2, "x moves away from the point"),
        "part": ({x: k * y, y: sp.S.Zero}, x * (x - y), "both parts are left, one by each"),
        "thin": ({x: k * y, y: k}, (x - shift) ** 2 + y**2, "y moves away from the point"),
        "function": ({x: k, y: sp.S.Zero}, y * sp.sin(x), "it leaves x = 0 where y is not zero"),
    }[form]
    condition = rng.choice([on, number(rng) * on, on * (1 + y**2), on**2])
    made_in_relations = rng.random() < 0.5
    relations = (condition,) if made_in_relations else ()
    made = system({**rates, z: sp.S.Zero}, relations=relations)
    others: dict[str, Any] = {"level": () if made_in_relations else (condition,)}
    law = rng.choice(
        [
            Identity("law", sp.S.Zero, **others),
            Identity("law", condition, **others),
            Integral("law", z, **others),
            Integral("law", sp.Integer(3), **others),
            Symmetry("law", {z: z}, **others),
        ]
    )
    return _case("levels that move", made, law, False, why)


KINDS: dict[str, Family] = {
    "integrals": integrals,
    "measures": measures,
    "imaginary densities": imaginary_densities,
    "symmetries": symmetries,
    "brackets": brackets,
    "ranks": ranks,
    "hamiltonian forms": hamiltonian_forms,
    "isomorphisms": isomorphisms,
    "standing time": standing_time,
    "reductions": reductions,
    "separations": separations,
    "open reductions": open_reductions,
    "levels that move": restless_levels,
}
