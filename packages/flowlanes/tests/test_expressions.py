"""What the formula language accepts, what it refuses, and what it says then."""

import string
from fractions import Fraction

import pytest
import sympy
from hypothesis import example, given, settings, strategies as st

from flowlanes.errors import InputError, RunError
from flowlanes.parsing import FUNCTIONS, MAX_LENGTH, nearest, parse
from flowlanes.parsing.grammar import OF_TWO

NAMES = {name: sympy.Symbol(name, real=True) for name in ("x", "y", "z", "gamma_3", "a")}
X, Y, Z = NAMES["x"], NAMES["y"], NAMES["z"]


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("0.3", sympy.Rational(3, 10)),
        ("0.1 + 0.2", sympy.Rational(3, 10)),
        ("1e-3", sympy.Rational(1, 1000)),
        (".5", sympy.Rational(1, 2)),
        ("2.", sympy.Integer(2)),
        ("-x**2", -(X**2)),
        ("2**-1", sympy.Rational(1, 2)),
        ("2**3**2", sympy.Integer(512)),
        ("x - y - z", X - Y - Z),
        ("x - (y - z)", X - Y + Z),
        ("x/y/z*2", 2 * X / (Y * Z)),
        ("x/(y*z)", X / (Y * Z)),
        ("+x - -y", X + Y),
        ("pi/2", sympy.pi / 2),
        ("atan2(y, x)", sympy.atan2(Y, X)),
        ("x**4 + y**4 + z**4 - 1", X**4 + Y**4 + Z**4 - 1),
        ("  x\n\t + y ", X + Y),
        ("(8)**(1/3)", sympy.Integer(2)),
        ("sqrt (x)", sympy.sqrt(X)),
        ("+".join(["x*y"] * 2500), 2500 * X * Y),
    ],
)
def test_reads_formulas_exactly(text: str, value: sympy.Expr) -> None:
    assert parse(text, NAMES) == value


@pytest.mark.parametrize("name", sorted(set(FUNCTIONS) - OF_TWO))
def test_every_function_of_one_argument(name: str) -> None:
    value = parse(f"{name}(x/3)", NAMES)
    assert value == FUNCTIONS[name](X / 3)
    assert value.free_symbols == {X}


@pytest.mark.parametrize("name", sorted(OF_TWO))
def test_every_function_of_two_arguments(name: str) -> None:
    assert parse(f"{name}(x/3, y)", NAMES) == FUNCTIONS[name](X / 3, Y)


@pytest.mark.parametrize(
    ("text", "message", "caret"),
    [
        ("gama_3**2 + 1", "unknown name 'gama_3', did you mean 'gamma_3'?", 0),
        ("x + open", "unknown name 'open'; allowed: x, y, z, gamma_3, a, abs, acos", 4),
        ("__import__(1)", "unknown name '__import__'", 0),
        ("x^2", "a power is written **", 1),
        ("x = 1", "write a formula, not an equation", 2),
        ("x.real", "the character '.' has no meaning here", 1),
        ("[x]", "the character '[' has no meaning here", 0),
        ("x @ y", "the character '@' has no meaning here", 2),
        ("'x'", "has no meaning here", 0),
        ("\u0416", "the character '\u0416' has no meaning here", 0),
        ("x; y", "has no meaning here", 1),
        ("2x", "an operator is missing here; multiplication is written *", 1),
        ("2 (x)", "an operator is missing", 2),
        ("x(y)", "an operator is missing", 1),
        ("(x)(y)", "an operator is missing", 3),
        ("sin x", "an operator is missing", 4),
        ("x + sin", "'sin' is a function; write sin(...)", 4),
        ("x // y", "division is written /", 0),
        ("x +", "cannot be read from here on", 3),
        ("* x", "cannot be read from here on", 0),
        ("1 + (x", "this parenthesis is never closed", 4),
        ("x) + (y", "this parenthesis closes none", 1),
        ("x, y", "not part of a formula", 0),
        ("()", "not part of a formula", 0),
        ("sin(*x)", "not part of a formula", 4),
        ("sin(**x)", "sin takes 1 argument", 0),
        ("1 + sin(x, y)", "sin takes 1 argument", 4),
        ("atan2(x)", "atan2 takes 2 arguments", 0),
        ("x + 1/0", "division by zero", 6),
        ("x/(y - y)", "division by zero", 3),
        ("0**-1", "no finite value", 0),
        ("log(0)", "no finite value", 0),
        ("tan(pi/2)", "no finite value", 0),
        ("x + sqrt(-1)", "not a real number", 4),
        ("(-8)**(1/3)", "not a real number", 0),
        ("acos(2)", "not a real number", 0),
        ("x**101", "up to 100 is allowed", 3),
        ("x**-101", "up to 100 is allowed", 3),
        ("(x**50)**50", "up to 100 is allowed", 9),
        ("2**2**2**2**2", "up to 100 is allowed", 3),
        ("2**1e-30", "this exponent has more than 6 decimals", 3),
        ("exp(log(7)*1e60)", "this exponent is too large", 0),
        ("1e5000", "the power of ten of this number is too large", 0),
        ("x + (9**100)**100", "this number is too large", 4),
        ("1/(sin(1)**2 + cos(1)**2 - 1)", "division by zero", 3),
        ("x/(sqrt(2)*sqrt(3) - sqrt(6))", "division by zero", 3),
        ("sin(exp(exp(100)))", "this number is larger than 1e+100", 4),
        ("", "the formula is empty", 0),
        (" \n", "the formula is empty", 0),
    ],
)
def test_points_at_the_mistake(text: str, message: str, caret: int) -> None:
    with pytest.raises(InputError) as caught:
        parse(text, NAMES, "body.toml, line 3")
    sentence, excerpt, pointer = str(caught.value).split("\n")
    assert sentence.startswith("body.toml, line 3: ")
    assert message in sentence
    assert excerpt == "    " + text.replace("\n", " ")
    assert pointer.index("^") - 4 == caret
    assert caught.value.where == "body.toml, line 3"


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("x" * (MAX_LENGTH + 1), "at most 10000 are allowed"),
        ("(" * 300 + "x" + ")" * 300, "nested too deeply"),
        ("-" * 9000 + "x", "nested too deeply"),
        ("-" * 100 + "x", "nested too deeply"),
        ("x" + "**x" * 3000, "nested too deeply"),
        ("1" * 2000, "more than 300 digits"),
    ],
)
def test_size_is_bounded(text: str, message: str) -> None:
    with pytest.raises(InputError, match=message):
        parse(text, NAMES)


def test_long_formula_is_shown_around_the_mistake() -> None:
    with pytest.raises(InputError) as caught:
        parse("x + " * 200 + "q + x", NAMES)
    _, excerpt, pointer = str(caught.value).split("\n")
    assert len(excerpt) < 80
    assert excerpt[pointer.index("^")] == "q"


def test_symbols_win_over_constants() -> None:
    assert parse("pi", {"pi": X}) == X


@pytest.mark.parametrize(
    ("name", "ending"),
    [
        ("radus", ", did you mean 'radius'? allowed: radius, axes"),
        ("wxyz", "; allowed: radius, axes"),
    ],
)
def test_nearest(name: str, ending: str) -> None:
    assert nearest(name, ["radius", "axes"]) == ending


@given(st.fractions(max_denominator=1000), st.decimals(allow_nan=False, allow_infinity=False))
def test_numbers_keep_every_digit(ratio: Fraction, decimal: object) -> None:
    assert parse(f"({ratio.numerator})/{ratio.denominator}", {}) == sympy.Rational(
        ratio.numerator, ratio.denominator
    )
    text = str(decimal)
    try:
        value = parse(text, {})
    except InputError as error:
        assert "power of ten" in str(error) or "too large" in str(error)
    else:
        exact = Fraction(text)
        assert (value.p, value.q) == (exact.numerator, exact.denominator)


def _formulas() -> st.SearchStrategy[str]:
    leaves = st.sampled_from(["x", "y", "0.5", "3", "pi", "1e3", "0"])

    def larger(inner: st.SearchStrategy[str]) -> st.SearchStrategy[str]:
        return st.one_of(
            st.tuples(inner, st.sampled_from(["+", "-", "*", "/", "**"]), inner).map(
                lambda parts: "({}{}{})".format(*parts)
            ),
            st.tuples(st.sampled_from(sorted(set(FUNCTIONS) - OF_TWO)), inner).map(
                lambda parts: "{}({})".format(*parts)
            ),
            inner.map(lambda part: f"-{part}"),
        )

    return st.recursive(leaves, larger, max_leaves=6)


@settings(max_examples=150)
@given(_formulas())
@example("cos(sin(exp(99)))")
def test_accepted_formulas_are_real_and_exact(text: str) -> None:
    try:
        value = parse(text, NAMES)
    except InputError:
        return
    assert not value.has(sympy.Float, sympy.zoo, sympy.nan, sympy.oo)
    assert value.free_symbols <= {X, Y}


@settings(max_examples=300)
@given(st.one_of(st.text(), st.text(alphabet="xyz019.e+-*/(), sincoqrtpi" + string.whitespace)))
def test_any_text_is_a_formula_or_an_input_error(text: str) -> None:
    try:
        value = parse(text, NAMES)
    except InputError as error:
        assert 1 <= len(str(error).split("\n")) <= 3
    else:
        assert isinstance(value, sympy.Expr)


def test_errors_say_where_and_when() -> None:
    assert str(InputError("no such file")) == "no such file"
    assert str(InputError("unknown key", "body.toml, line 2")) == "body.toml, line 2: unknown key"
    failure = RunError("the step size fell to zero", 1.5)
    assert (failure.reason, failure.time) == ("the step size fell to zero", 1.5)
    assert str(failure) == "the step size fell to zero (the last good time is 1.5)"


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("γ₃", "gamma_3"),
        ("2*γ₁² − π·γ₃", "2*gamma_1**2 - pi*gamma_3"),
        ("Ω_0", "Omega_0"),
        ("λ₀⁴", "lambda_0**4"),
    ],
)
def test_letters_as_on_paper(text: str, code: str) -> None:
    names = {n: sympy.Symbol(n) for n in ("gamma_1", "gamma_3", "Omega_0", "lambda_0")}
    assert parse(text, names) == parse(code, names)


def test_an_unknown_letter_is_told_as_it_is_written_in_code() -> None:
    with pytest.raises(InputError, match="unknown name 'gamma_4', did you mean 'gamma_3'"):
        parse("γ₄", {"gamma_3": sympy.Symbol("gamma_3")})


def test_a_sum_of_many_terms_is_read() -> None:
    assert parse("x" + "-y" * 2400 + "+x" * 2500, NAMES) == 2501 * X - 2400 * Y


def test_a_mistake_far_inside_a_long_sum_is_shown_where_it_is() -> None:
    text = "x" + "+x" * 4000 + "+sqrt(x, y)" + "+x" * 20
    with pytest.raises(InputError, match="sqrt takes 1 argument") as caught:
        parse(text, NAMES)
    _, excerpt, pointer = str(caught.value).split("\n")
    assert excerpt[pointer.index("^") :].startswith("sqrt(x, y)")
