"""Formulas with vectors: what they mean, and what is said of numbers and vectors mixed up."""

import pytest
import sympy

from flowlanes.errors import InputError
from flowlanes.parsing import parse_formula
from flowlanes.system.vectors import Diagonal, Vector, cross, dot, real_symbol, to_components

GAMMA, OMEGA, Q = Vector("gamma"), Vector("omega"), Vector("q", 4)
TENSOR, M = Diagonal("I"), real_symbol("m")
NAMES = {"gamma": GAMMA, "omega": OMEGA, "I": TENSOR, "m": M, "q": Q}
ENERGY = dot(OMEGA, TENSOR * OMEGA) / 2


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("gamma", GAMMA),
        ("cross(gamma, omega)", cross(GAMMA, OMEGA)),
        ("dot(omega, I*omega)/2 + m*gamma_3", ENERGY + M * real_symbol("gamma_3")),
        ("-m*cross(gamma, cross(omega, gamma))", -M * cross(GAMMA, cross(OMEGA, GAMMA))),
        ("2*gamma/m - (omega + gamma)", (2 / M) * GAMMA - (OMEGA + GAMMA)),
        ("I*I*omega", TENSOR * (TENSOR * OMEGA)),
        ("-I*omega", -TENSOR * OMEGA),
        ("sqrt(dot(q, q))", sympy.sqrt(dot(Q, Q))),
        ("I_1 - q_w", real_symbol("I_1") - real_symbol("q_w")),
        ("pi*m", sympy.pi * M),
    ],
)
def test_reads_formulas_as_written(text: str, value: object) -> None:
    assert parse_formula(text, NAMES) == value


def test_vectors_by_their_components() -> None:
    value = to_components(parse_formula("[m, 0, 1] + cross(gamma, [0, 0, 2])", NAMES))
    assert list(value) == [M + 2 * real_symbol("gamma_2"), -2 * real_symbol("gamma_1"), 1]


@pytest.mark.parametrize(
    ("text", "message", "caret"),
    [
        ("gama", "unknown name 'gama', did you mean 'gamma'?", 0),
        ("1 + gamma", "a number cannot be added to a vector", 0),
        ("gamma + 1", "a number cannot be added to a vector", 8),
        ("gamma + q", "vectors of different sizes cannot be added", 8),
        ("2*gamma*omega", "two vectors are multiplied by dot or cross", 8),
        ("m/gamma", "nothing can be divided by a vector or a tensor", 2),
        ("gamma/0", "division by zero", 6),
        ("gamma**2", "a number is wanted here, and 'gamma' is none", 0),
        ("sin(gamma)", "a number is wanted here, and 'gamma' is none", 4),
        ("omega*I", "a tensor stands before the vector it multiplies", 6),
        ("cross(gamma)", "cross takes 2 vectors", 0),
        ("cross(q, q)", "only vectors of 3 components have a vector product", 0),
        ("dot(gamma, q)", "vectors of different sizes cannot be multiplied", 0),
        ("1 + dot(gamma, 2)", "dot multiplies vectors, and this is none", 15),
        ("[1]", "a vector has 2, 3 or 4 components", 0),
        ("[1, 2] + gamma", "vectors of different sizes cannot be added", 9),
        ("[1, 2, gamma]", "a number is wanted here", 7),
        ("m*[1, 2, 3", "this bracket is never closed", 2),
        ("(m*[1, 2, 3)]", "this parenthesis closes none", 11),
        ("gamma[1]", "an operator is missing here", 5),
        ("sin([1, 2, 3])", "this is not part of a formula", 4),
        ("dot", "'dot' is a function; write dot(...)", 0),
        ("dot(gamma, omega).x", "the character '.' has no meaning here", 17),
    ],
)
def test_points_at_the_mistake(text: str, message: str, caret: int) -> None:
    with pytest.raises(InputError) as caught:
        parse_formula(text, NAMES, "body.toml, line 3")
    sentence, excerpt, pointer = str(caught.value).split("\n")
    assert sentence.startswith("body.toml, line 3: ")
    assert message in sentence
    assert excerpt == "    " + text
    assert pointer.index("^") - 4 == caret


@pytest.mark.parametrize("text", ["-" * 100 + "gamma", "cross(gamma, " * 70 + "omega" + ")" * 70])
def test_depth_is_bounded(text: str) -> None:
    with pytest.raises(InputError, match="nested too deeply"):
        parse_formula(text, NAMES)
