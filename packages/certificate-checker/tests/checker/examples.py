"""Valid certificates, one for each thing that a certificate can do."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from checker.made import (
    divisor,
    equation,
    identity,
    law,
    poly,
    powers,
    proof,
    proven,
    refuted,
    residual,
    system,
    zero,
)

Certificate = dict[str, Any]


def oscillator() -> Certificate:
    """The energy of an oscillator: everything cancels."""
    ring = ["x", "v", "k"]
    claim = {
        "system": system({"x": "v", "v": "-k*x"}, parameters=["k"]),
        "law": law("Integral", value="v**2/2 + k*x**2/2"),
    }
    made = proof(ring, residuals=[residual("0", [], ring)], tree=zero(identity(0, [], ring)))
    return proven(claim, made, sample={"x": "1", "v": "1/2", "k": "3"})


def area() -> Certificate:
    """A free body with (M, γ) = 0, on which x does not move."""
    state = {
        "M_1": "(J_2 - J_3)*M_2*M_3",
        "M_2": "(J_3 - J_1)*M_3*M_1",
        "M_3": "(J_1 - J_2)*M_1*M_2",
        "g_1": "J_3*M_3*g_2 - J_2*M_2*g_3",
        "g_2": "J_1*M_1*g_3 - J_3*M_3*g_1",
        "g_3": "J_2*M_2*g_1 - J_1*M_1*g_2",
        "x": "area/(1 + m)",
    }
    level = "M_1*g_1 + M_2*g_2 + M_3*g_3"
    # M' = M × ω with ω = −J M here, so that signs agree
    state["M_1"], state["M_2"], state["M_3"] = (
        "J_3*M_2*M_3 - J_2*M_3*M_2",
        "J_1*M_3*M_1 - J_3*M_1*M_3",
        "J_2*M_1*M_2 - J_1*M_2*M_1",
    )
    ring = [*state, "J_1", "J_2", "J_3", "m"]
    claim = {
        "system": system(
            state, parameters=["J_1", "J_2", "J_3", "m"], definitions=[["area", level]]
        ),
        "law": law("Integral", ["area"], value="3*x"),
    }
    made = proof(
        ring,
        equations=[equation(level, ring, "area")],
        divisors=[divisor("1 + m", [("1 + m", 1)], ring)],
        residuals=[residual("0", [], ring), residual(f"3*({level})", [("m + 1", 1)], ring)],
        tree=zero(identity(0, ["0"], ring), identity(1, ["6"], ring, [], "2")),
    )
    return proven(claim, made, sample={**dict.fromkeys(ring, "1"), "g_3": "-2"})


def product_of_two() -> Certificate:
    """x² y² = 0 with x' = y' = 0: then x y = 0, by cases."""
    ring = ["x", "y"]
    claim = {
        "system": system({"x": "0", "y": "0"}, relations=["x**2*y**2"]),
        "law": law("Identity", value=["x*y"]),
    }
    made = proof(
        ring,
        equations=[equation("x**2*y**2", ring)],
        residuals=[residual("0", [], ring), residual("x*y", [], ring)],
        tree={
            "case": "split",
            "polynomial": poly("x**2*y**2", ring),
            "factors": powers([("x", 2), ("y", 2)], ring),
            "constant": "1",
            "by": [],
            "quotients": [poly("1", ring)],
            "children": [
                zero(identity(0, ["0", "0"], ring), identity(1, ["0", "y"], ring)),
                zero(identity(0, ["0", "0"], ring), identity(1, ["0", "x"], ring)),
            ],
        },
    )
    return proven(claim, made, sample={"x": "0", "y": "2"})


def root() -> Certificate:
    """√(x²(1 + y²))/x stays constant: for x > 0 and for x < 0."""
    ring = ["aux0", "x", "y"]
    claim = {
        "system": system({"x": "x", "y": "0"}),
        "law": law("Integral", value="sqrt(x**2*(y**2 + 1))/x"),
    }
    proofs = [
        proof(
            ring,
            signs=[[poly("x", ring), sign]],
            auxiliary=[["aux0", {"kind": "root", "of": poly("y**2 + 1", ring), "degree": 2}]],
            equations=[equation("aux0**2 - y**2 - 1", ring, "root aux0")],
            divisors=[
                divisor("x", [("x", 1)], ring),
                divisor("x**2*(y**2 + 1)", [("x", 2), ("y**2 + 1", 1)], ring),
            ],
            residuals=[residual(f"{sign}*(aux0**2 - y**2 - 1)", [("aux0", 1)], ring)],
            tree=zero(identity(0, [str(sign)], ring)),
        )
        for sign in (1, -1)
    ]
    return proven(claim, *proofs, sample={"x": "-1", "y": "0"})


def squares() -> Certificate:
    """a x² + 2 y² = 0 with a > 0: then x = 0."""
    ring = ["x", "y", "a"]
    claim = {
        "system": system(
            {"x": "0", "y": "0"},
            parameters=["a"],
            relations=["a*x**2 + 2*y**2"],
            admissible=["a > 0"],
        ),
        "law": law("Identity", value=["x"]),
    }
    made = proof(
        ring,
        equations=[equation("a*x**2 + 2*y**2", ring)],
        positive=[{"poly": poly("a", ring), "strict": True, "from": "a > 0"}],
        residuals=[residual("0", [], ring), residual("x", [], ring)],
        tree={
            "case": "squares",
            "polynomial": poly("a*x**2 + 2*y**2", ring),
            "by": [],
            "quotients": [poly("1", ring)],
            "terms": [
                [powers([("a", 1)], ring), "1", [poly("x", ring)]],
                [[], "2", [poly("y", ring)]],
            ],
            "child": zero(identity(0, ["0"] * 3, ring), identity(1, ["0", "1", "0"], ring)),
        },
    )
    return proven(claim, made, sample={"x": "0", "y": "0", "a": "1"})


def vanishing() -> Certificate:
    """a x = 0: then a² x (x + 1) = 0, whether a vanishes or not."""
    ring = ["x", "a"]
    claim = {
        "system": system({"x": "0"}, parameters=["a"], relations=["a*x"]),
        "law": law("Identity", value=["a**2*x*(x + 1)"]),
    }
    made = proof(
        ring,
        equations=[equation("a*x", ring)],
        residuals=[residual("0", [], ring), residual("a**2*x*(x + 1)", [], ring)],
        tree={
            "case": "vanishing",
            "polynomial": poly("a", ring),
            "nonzero": zero(
                identity(0, ["0"], ring), identity(1, ["a**2*(x + 1)"], ring, [("a", 1)])
            ),
            "zero": {
                "case": "vanishing",
                "polynomial": poly("x", ring),
                "nonzero": zero(
                    identity(0, ["0", "0"], ring), identity(1, ["0", "a*x*(x + 1)"], ring)
                ),
                "zero": zero(
                    identity(0, ["0"] * 3, ring), identity(1, ["a*(x + 1)", "0", "0"], ring)
                ),
            },
        },
    )
    return proven(claim, made, sample={"x": "0", "a": "2"})


def empty() -> Certificate:
    """x/y with x y = 1 and x = 0: nothing is left to be shown."""
    ring = ["x", "y"]
    claim = {
        "system": system({"x": "0", "y": "0"}, relations=["x*y"]),
        "law": law("Identity", value=["x + 1/y - 1/y"]),
    }
    made = proof(
        ring,
        equations=[equation("x*y", ring)],
        divisors=[divisor("y", [("y", 1)], ring)],
        residuals=[residual("0", [], ring), residual("x", [], ring)],
        tree={
            "case": "vanishing",
            "polynomial": poly("x", ring),
            "nonzero": {
                "case": "empty",
                "factors": powers([("x", 1), ("y", 1)], ring),
                "constant": "3",
                "quotients": [poly("3", ring)],
            },
            "zero": zero(identity(0, ["0", "0"], ring), identity(1, ["0", "1"], ring)),
        },
    )
    return proven(claim, made, sample={"x": "0", "y": "1"})


def somewhere() -> Certificate:
    """x y = 0: then x = 0 where y does not vanish."""
    ring = ["x", "y"]
    claim = {
        "system": system({"x": "0", "y": "0"}, relations=["x*y"]),
        "law": law("Identity", value=["x"]),
    }
    made = proof(
        ring,
        equations=[equation("x*y", ring)],
        residuals=[residual("0", [], ring), residual("x", [], ring)],
        tree={
            "case": "split",
            "polynomial": poly("x*y", ring),
            "factors": powers([("x", 1), ("y", 1)], ring),
            "constant": "1",
            "by": [],
            "quotients": [poly("1", ring)],
            "children": [
                zero(identity(0, ["0", "0"], ring), identity(1, ["0", "1"], ring)),
                {"case": "unproven", "condition": "not y = 0"},
            ],
        },
    )
    return {
        **proven(claim, made, sample={"x": "0", "y": "1"}),
        "verdict": "proven where",
        "conditions": ["not y = 0"],
    }


def inertia() -> Certificate:
    """A parameter exchanged for J = I + m r², another settled to −1, a function that vanishes."""
    ring = ["w", "J", "m", "r"]
    claim = {
        "system": system(
            {"w": "(k + 1)*w/J + U(r)"},
            parameters=["I", "m", "r", "k"],
            definitions=[["J", "I + m*r**2"]],
        ),
        "law": law("Integral", ["k + 1", "U(r)"], value="J*w + Subs(Derivative(U(x), x), x, r)"),
    }
    made = proof(
        ring,
        settled=[["k", "-1"]],
        exchanged=[["J", "1", "I", "m*r**2"]],
        zeros=["U(r)"],
        divisors=[divisor("J", [("J", 1)], ring)],
        residuals=[residual("0", [], ring)],
        tree=zero(identity(0, [], ring)),
    )
    return proven(claim, made, sample={"w": "2", "I": "1", "m": "3", "r": "1/2", "k": "-1"})


def inverse() -> Certificate:
    """The inverse A of a full tensor J as generators: A J = 1."""
    six = ["11", "12", "13", "22", "23", "33"]
    minors = {
        "11": "J_22*J_33 - J_23**2",
        "12": "J_13*J_23 - J_12*J_33",
        "13": "J_12*J_23 - J_13*J_22",
        "22": "J_11*J_33 - J_13**2",
        "23": "J_12*J_13 - J_11*J_23",
        "33": "J_11*J_22 - J_12**2",
    }
    determinant = f"(J_11*({minors['11']}) + J_12*({minors['12']}) + J_13*({minors['13']}))"
    names = [f"A_{n}" for n in six]
    ring = ["x", *names]
    claim = {
        "system": system(
            {"x": "0"},
            parameters=[f"I_{n}" for n in six],
            definitions=[
                *([f"J_{n}", f"I_{n} + {int(n[0] == n[1])}*2"] for n in six),
                *([f"A_{n}", f"({minors[n]})/{determinant}"] for n in six),
            ],
        ),
        "law": law("Identity", value=["A_11*J_11 + A_12*J_12 + A_13*J_13 - 1"]),
    }
    made = proof(
        ring,
        exchanged=[[f"J_{n}", "1", f"I_{n}", str(int(n[0] == n[1]) * 2)] for n in six],
        inverted=[[names, [f"J_{n}" for n in six]]],
        residuals=[residual("0", [], ring)],
        tree=zero(identity(0, [], ring)),
    )
    return proven(claim, made, sample={"x": "0", **{f"I_{n}": str(int(n[0] == n[1])) for n in six}})


def circle() -> Certificate:
    """sin² + cos² = 1 along a pendulum, with its equation."""
    ring = ["aux0", "aux1", "q", "p"]
    angle = {"numerator": poly("q", ring), "denominator": []}
    claim = {
        "system": system({"q": "p", "p": "-sin(q)"}),
        "law": law("Identity", value=["sin(q)**2 + cos(q)**2 - 1", "Rate(p**2/2 - cos(q))"]),
    }
    made = proof(
        ring,
        auxiliary=[["aux0", {"kind": "sin", "of": angle}], ["aux1", {"kind": "cos", "of": angle}]],
        equations=[equation("aux0**2 + aux1**2 - 1", ring, "circle aux0 aux1")],
        residuals=[residual("aux0**2 + aux1**2 - 1", [], ring), residual("0", [], ring)],
        tree=zero(identity(0, ["1"], ring), identity(1, ["0"], ring)),
    )
    return proven(claim, made, sample={"q": "1", "p": "2"})


def potential() -> Certificate:
    """Energy with an unspecified potential, whose derivatives are symbols."""
    ring = ["aux0", "aux1", "aux2", "q", "p"]

    def value(orders: list[int], of: str) -> dict[str, object]:
        place = {"numerator": poly(of, ring), "denominator": []}
        return {"kind": "function", "name": "U", "orders": orders, "of": [place]}

    claim = {
        "system": system({"q": "p*q", "p": "-Derivative(U(q), q)*q"}),
        "law": law("Identity", ["q"], value=["Rate(p**2/2 + U(q)) + q*U(2*q)*exp(q)"]),
    }
    made = proof(
        ring,
        auxiliary=[
            ["aux0", value([0], "2*q")],
            ["aux1", {"kind": "known", "name": "exp", "of": [_place("q", ring)]}],
            ["aux2", value([1], "q")],
        ],
        equations=[equation("q", ring)],
        residuals=[
            residual("p*q", [], ring),
            residual("q*aux0*aux1 + aux2*q - aux2*q", [], ring),
        ],
        tree=zero(identity(0, ["p"], ring), identity(1, ["aux0*aux1"], ring)),
    )
    return proven(claim, made, sample={"q": "0", "p": "2"})


def _place(text: str, ring: list[str]) -> dict[str, object]:
    return {"numerator": poly(text, ring), "denominator": []}


def power() -> Certificate:
    """A density with a symbolic exponent, and a power with the same, of what is positive."""
    ring = ["aux0", "x", "n"]
    claim = {
        "system": system({"x": "x**(n + 1)"}, parameters=["n"], guards=["x"]),
        "law": law("Measure", density=[["x", "-n - 1"]]),
    }
    made = proof(
        ring,
        auxiliary=[
            ["aux0", {"kind": "power", "of": poly("x", ring), "exponent": "n", "fineness": 4}]
        ],
        divisors=[divisor("x", [("x", 1)], ring)],
        positive=[{"poly": poly("x", ring), "strict": True, "from": "x"}],
        residuals=[residual("0", [], ring)],
        tree=zero(identity(0, [], ring)),
    )
    return proven(claim, made, sample={"x": "2", "n": "1/3"})


def sphere() -> Certificate:
    """The area of a sphere is kept by rotations; its relation is."""
    ring = ["x", "y", "z"]
    claim = {
        "system": system(
            {"x": "-y*x**2 - y", "y": "x**3 + x", "z": "0"}, relations=["x**2 + y**2 + z**2 - 1"]
        ),
        "law": law("Measure", density=[["1 + x**2", "-1"]]),
    }
    made = proof(
        ring,
        equations=[equation("x**2 + y**2 + z**2 - 1", ring)],
        divisors=[
            divisor("1 + x**2", [("x**2 + 1", 1)], ring),
            divisor("the volume of the conditions", [("x**2 + y**2 + z**2", 1)], ring, content="4"),
        ],
        residuals=[residual("0", [], ring)] * 2,
        tree=zero(identity(0, ["0"], ring), identity(1, ["0"], ring)),
    )
    return proven(claim, made, sample={"x": "0", "y": "3/5", "z": "-4/5"})


def bracket() -> Certificate:
    """The rotation of a free body is Hamiltonian on so(3)."""
    ring = ["x", "y", "z", "a", "b", "c"]
    matrix = [["0", "-z", "y"], ["z", "0", "-x"], ["-y", "x", "0"]]
    claim = {
        "system": system(
            {"x": "-z*b*y*2 + y*c*z*2", "y": "z*a*x*2 - x*c*z*2", "z": "-y*a*x*2 + x*b*y*2"},
            parameters=["a", "b", "c"],
        ),
        "law": law(
            "ConformallyHamiltonian",
            multiplier="2",
            hamiltonian="(a*x**2 + b*y**2 + c*z**2)/2",
            structure={"matrix": matrix, "casimirs": ["x**2 + y**2 + z**2"], "rank": 2},
        ),
    }
    count = 6 + 1 + 3 + 3
    made = proof(
        ring,
        residuals=[residual("0", [], ring)] * count,
        tree=zero(*(identity(i, [], ring) for i in range(count))),
    )
    point = dict.fromkeys(ring, "1/2")
    return proven(claim, made, sample=point)


def carried() -> Certificate:
    """An oscillator with frequency ω carried to the one with frequency 1, in its own time."""
    ring = ["x", "v", "w"]
    claim = {
        "system": system({"x": "v", "v": "-w**2*x"}, parameters=["w"], admissible=["w > 0"]),
        "law": law(
            "Isomorphism",
            target=system({"X": "V/s", "V": "-X/s"}, parameters=["s"]),
            map=[["X", "w*x"], ["V", "v"]],
            time="3*w",
            constants=[["s", "3"]],
        ),
    }
    made = proof(
        ring,
        residuals=[residual("0", [], ring)] * 3,
        tree=zero(*(identity(i, [], ring) for i in range(3))),
    )
    return proven(claim, made, sample={"x": "1", "v": "2", "w": "3"})


def reduced() -> Certificate:
    """q = x² obeys an equation of its own; second rates as well."""
    ring = ["x", "c"]
    claim = {
        "system": system({"x": "c*x"}, parameters=["c"]),
        "law": law(
            "Reduction",
            quantities=[["q", "x**2"], ["u", "log(q)"]],
            equations=["Rate(q)**2 - 4*c**2*q**2", "Rate(Rate(q)) - 4*c**2*q", "Rate(u) - 2*c"],
        ),
    }
    made = proof(
        ring,
        divisors=[divisor("x**2", [("x", 2)], ring)],
        residuals=[residual("0", [], ring)] * 3,
        tree=zero(*(identity(i, [], ring) for i in range(3))),
    )
    return proven(claim, made, sample={"x": "-1", "c": "2"})


def symmetry() -> Certificate:
    """Rotations commute with a central field and keep the circle."""
    ring = ["x", "y"]
    claim = {
        "system": system({"x": "-y*(x**2 + y**2)", "y": "x*(x**2 + y**2)"}),
        "law": law("Symmetry", ["x**2 + y**2 - 2"], field=[["x", "-y"], ["y", "x"]]),
    }
    made = proof(
        ring,
        equations=[equation("x**2 + y**2 - 2", ring)],
        residuals=[residual("0", [], ring)] * 4,
        tree=zero(*(identity(i, ["0"], ring) for i in range(4))),
    )
    return proven(claim, made, sample={"x": "1", "y": "-1"})


def rational_witness() -> Certificate:
    """x²/y is no integral."""
    x, y, a = Fraction(1, 2), Fraction(-3), Fraction(5, 7)
    claim = {
        "system": system({"x": "1", "y": "a"}, parameters=["a"], guards=["x"]),
        "law": law("Integral", value="x**2/y"),
    }
    return refuted(
        claim,
        point={"x": str(x), "y": str(y), "a": str(a)},
        what="v(F)",
        index=0,
        residual=str(2 * x / y - x * x * a / y**2),
    )


def algebraic_witness() -> Certificate:
    """y = √2 on a circle, and x from it by a quadratic."""
    claim = {
        "system": system(
            {"x": "y", "y": "-x", "z": "0"}, relations=["x**2 + y**2 - 3", "z - sin(x)"]
        ),
        "law": law("Integral", value="x + z"),
    }
    claim["system"]["rates"][2] = "y*cos(x)"
    return refuted(
        claim,
        point={
            "y": _root([["1", [0, 2]], ["-2", []]], ["y"], "1.41421356", "1e-8"),
            "x": _root([["1", [0, 2]], ["1", [1, 2]], ["-3", []]], ["x", "y"], "-1", "0.25"),
            "z": {"formula": "sin(x)"},
        },
        what="v(F)",
        index=2,
        residual="[2.1783 +/- 1e-4]",
    )


def _root(terms: Any, ring: list[str], near: str, radius: str) -> Any:
    return {"root": {"poly": {"ring": ring, "terms": terms}, "near": near, "radius": radius}}


ALL = [
    oscillator,
    area,
    product_of_two,
    root,
    squares,
    vanishing,
    empty,
    somewhere,
    inertia,
    inverse,
    circle,
    potential,
    power,
    sphere,
    bracket,
    carried,
    reduced,
    symmetry,
    rational_witness,
    algebraic_witness,
]
