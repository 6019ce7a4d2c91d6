"""Formulas typed by the user, read into SymPy without running any code of theirs.

The language is small: decimal numbers, the names that the caller knows, ``pi``, the operators
``+ - * / **``, parentheses and the functions of `FUNCTIONS`. Decimal numbers become exact
rationals (``0.3`` is 3/10), so that what is proved of a formula later is proved exactly.
"""

import ast
import difflib
import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from types import MappingProxyType

import sympy

from .errors import InputError

FUNCTIONS: Mapping[str, Callable[..., sympy.Expr]] = MappingProxyType(
    {
        "sqrt": sympy.sqrt,
        "sin": sympy.sin,
        "cos": sympy.cos,
        "tan": sympy.tan,
        "asin": sympy.asin,
        "acos": sympy.acos,
        "atan": sympy.atan,
        "atan2": sympy.atan2,
        "sinh": sympy.sinh,
        "cosh": sympy.cosh,
        "tanh": sympy.tanh,
        "exp": sympy.exp,
        "log": sympy.log,
    }
)
"""Functions that a formula may call; each takes one argument, ``atan2`` takes two."""

CONSTANTS: Mapping[str, sympy.Expr] = MappingProxyType({"pi": sympy.pi})
"""Names that mean a number in every formula."""

RESERVED = frozenset(FUNCTIONS) | frozenset(CONSTANTS)
"""Names that no symbol of a formula can bear."""

_DECIMALS = 6
MAX_LENGTH = 10_000
MAX_EXPONENT = 100
MAX_DEPTH = 60
MAX_ROOT = 10**_DECIMALS
MAX_DIGITS = 300
MAX_BITS = 1024
MAX_CONSTANT = sympy.Float("1e100")

_TOKEN = re.compile(
    r"(?P<space>\s+)"
    r"|(?P<number>(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)"
    r"|(?P<name>[A-Za-z_]\w*)"
    r"|(?P<operator>\*\*|[-+*/(),])",
    re.ASCII,
)
_HINTS = MappingProxyType({"^": "a power is written **", "=": "write a formula, not an equation"})
_TOO_DEEP = "the formula is nested too deeply"
_EXCERPT = 72
# SymPy computes constants while it builds an expression, and where that is beyond its means it
# fails in these ways (among them PrecisionExhausted, an ArithmeticError).
_SYMPY_FAILURES = (ArithmeticError, AttributeError, RecursionError, TypeError, ValueError)


def parse(text: str, names: Mapping[str, sympy.Symbol], where: str = "") -> sympy.Expr:
    """Read a formula.

    Parameters
    ----------
    text
        The formula, such as ``"x**4 + y**4 + z**4 - 1"``; line breaks count as spaces.
    names
        The symbols that it may contain, by the name under which they are written.
    where
        Where the formula stands (file, line, key), put before the message of an error.

    Returns
    -------
    sympy.Expr
        A real, finite expression in those symbols whose numbers are exact.

    Raises
    ------
    InputError
        When the text is no formula of this language, contains an unknown name, has no real value
        (``1/0``, ``sqrt(-1)``) or is absurdly large. The message is one sentence, followed by
        the formula and a caret under the offending character.
    """
    if len(text) > MAX_LENGTH:
        raise InputError(
            f"the formula has {len(text)} characters; at most {MAX_LENGTH} are allowed", where
        )
    source = _Source(text, where)
    tokens = _tokens(source)
    _check_words(source, tokens, names)
    _check_parentheses(source, tokens)
    return _Reader(source, {**CONSTANTS, **names}).read(_syntax_tree(source), 0)


def nearest(name: str, known: Iterable[str]) -> str:
    """End a sentence about an unknown name: the likeliest intention, and all that is allowed.

    Parameters
    ----------
    name
        The unknown name.
    known
        The names that would have been accepted.
    """
    allowed = list(known)
    close = difflib.get_close_matches(name, allowed, n=1)
    guess = f", did you mean '{close[0]}'?" if close else ";"
    return f"{guess} allowed: {', '.join(allowed) or 'none'}"


@dataclass(frozen=True)
class _Source:
    """A formula as typed, and where it stands."""

    text: str
    where: str

    def error(self, message: str, position: int) -> InputError:
        """Point at the character `position` of the formula."""
        start = max(0, position - _EXCERPT // 2)
        window = self.text[start : start + _EXCERPT]
        excerpt = "".join(char if char.isprintable() else " " for char in window)
        return InputError(f"{message}\n    {excerpt}\n    {' ' * (position - start)}^", self.where)


@dataclass(frozen=True)
class _Token:
    """A number, name or operator, and the place of its first character."""

    kind: str
    word: str
    position: int


def _tokens(source: _Source) -> list[_Token]:
    """Cut the formula into words."""
    tokens = []
    position = 0
    while position < len(source.text):
        match = _TOKEN.match(source.text, position)
        if match is None:
            char = source.text[position]
            hint = _HINTS.get(char, "allowed: names, numbers, + - * / ** ( ) and commas")
            raise source.error(f"the character {char!r} has no meaning here; {hint}", position)
        if match.lastgroup != "space":
            tokens.append(_Token(str(match.lastgroup), match.group(), position))
        position = match.end()
    if not tokens:
        raise source.error("the formula is empty", 0)
    return tokens


def _check_words(
    source: _Source, tokens: Sequence[_Token], names: Mapping[str, sympy.Symbol]
) -> None:
    """Refuse unknown names, endless numbers and values with no operator between them."""
    previous = ""
    for token in tokens:
        if _value_meets_value(previous, token.word):
            message = "an operator is missing here; multiplication is written *"
            raise source.error(message, token.position)
        if token.kind == "name" and token.word not in names and token.word not in RESERVED:
            known = nearest(token.word, [*names, *sorted(RESERVED)])
            raise source.error(f"unknown name '{token.word}'{known}", token.position)
        if token.kind == "number" and len(token.word) > MAX_DIGITS:
            raise source.error(f"this number has more than {MAX_DIGITS} digits", token.position)
        previous = token.word


def _check_parentheses(source: _Source, tokens: Sequence[_Token]) -> None:
    """Refuse parentheses that do not pair, or pair too often."""
    opened: list[_Token] = []
    for token in tokens:
        if token.word == "(":
            opened.append(token)
        elif token.word == ")":
            if not opened:
                raise source.error("this parenthesis closes none", token.position)
            opened.pop()
        if len(opened) > MAX_DEPTH:
            raise source.error(_TOO_DEEP, token.position)
    if opened:
        raise source.error("this parenthesis is never closed", opened[-1].position)


def _value_meets_value(previous: str, word: str) -> bool:
    """Whether two values follow each other without an operator: ``2x``, ``x (y + 1)``."""
    if word == "(" and previous in FUNCTIONS:
        return False
    ends_value = previous != "" and (previous[-1].isalnum() or previous[-1] in "_).")
    return ends_value and (word[0].isalnum() or word[0] in "_(.")


def _syntax_tree(source: _Source) -> ast.expr:
    """Let Python's own grammar decide what binds to what; nothing is run.

    The parentheses put around the formula make blanks before it harmless and columns in the
    tree one too large.
    """
    line = re.sub(r"\s", " ", source.text, flags=re.ASCII).rstrip()
    try:
        return ast.parse(f"({line})", mode="eval").body
    except SyntaxError as error:
        position = (error.offset or 2) - 2
        message = "the formula cannot be read from here on"
        raise source.error(message, min(max(position, 0), len(line))) from None
    except (RecursionError, MemoryError):
        raise source.error(_TOO_DEEP, 0) from None


@dataclass(frozen=True)
class _Reader:
    """Turns the syntax tree of one formula into SymPy."""

    source: _Source
    names: Mapping[str, sympy.Expr]

    def error(self, message: str, node: ast.expr) -> InputError:
        """Point at the first character of `node`."""
        return self.source.error(message, node.col_offset - 1)

    def read(self, node: ast.expr, depth: int) -> sympy.Expr:
        """The value of `node`, checked to be real, finite and of a sensible size."""
        if depth > MAX_DEPTH:
            raise self.error(_TOO_DEEP, node)
        try:
            value = self.build(node, depth)
            self.check(value, node)
        except InputError:
            raise
        except _SYMPY_FAILURES:
            raise self.error(
                "this is beyond exact computation; use simpler numbers", node
            ) from None
        return value

    def build(self, node: ast.expr, depth: int) -> sympy.Expr:
        """The value of `node`, whatever it is."""
        match node:
            case ast.Constant():
                return self.number(node)
            case ast.Name():
                return self.name(node)
            case ast.UnaryOp(op=ast.UAdd(), operand=operand):
                return self.read(operand, depth + 1)
            case ast.UnaryOp(op=ast.USub(), operand=operand):
                return -self.read(operand, depth + 1)
            case ast.BinOp(op=ast.Add() | ast.Sub()):
                return self.sum(node, depth)
            case ast.BinOp(op=ast.Mult() | ast.Div()):
                return self.product(node, depth)
            case ast.BinOp(op=ast.Pow()):
                return self.power(node, depth)
            case ast.BinOp():
                raise self.error("of two slashes one is too many; division is written /", node)
            case ast.Call():
                return self.call(node, depth)
            case _:
                raise self.error("this is not part of a formula", node)

    def number(self, node: ast.Constant) -> sympy.Expr:
        """The exact value of a decimal number."""
        text = self.source.text[node.col_offset - 1 : (node.end_col_offset or 0) - 1]
        power_of_ten = re.search(r"[eE][+-]?(\d+)$", text)
        if power_of_ten and int(power_of_ten.group(1)) > MAX_DIGITS:
            raise self.error("the power of ten of this number is too large", node)
        fraction = Fraction(text)
        return sympy.Rational(fraction.numerator, fraction.denominator)

    def name(self, node: ast.Name) -> sympy.Expr:
        """The symbol or constant that a name stands for."""
        if node.id not in self.names:
            raise self.error(f"'{node.id}' is a function; write {node.id}(...)", node)
        return self.names[node.id]

    def sum(self, node: ast.BinOp, depth: int) -> sympy.Expr:
        """A whole chain ``a + b - c`` at once: term by term SymPy would sort it anew each time."""
        terms = []
        for operator, operand in _chain(node, (ast.Add, ast.Sub)):
            value = self.read(operand, depth + 1)
            terms.append(-value if isinstance(operator, ast.Sub) else value)
        return sympy.Add(*terms)

    def product(self, node: ast.BinOp, depth: int) -> sympy.Expr:
        """A whole chain ``a * b / c`` at once."""
        factors = []
        for operator, operand in _chain(node, (ast.Mult, ast.Div)):
            value = self.read(operand, depth + 1)
            if isinstance(operator, ast.Div):
                if value.is_zero:
                    raise self.error("division by zero", operand)
                value = 1 / value
            factors.append(value)
        return sympy.Mul(*factors)

    def power(self, node: ast.BinOp, depth: int) -> sympy.Expr:
        """A power, when the numbers in its exponent keep within bounds."""
        exponent = self.read(node.right, depth + 1)
        self.check_exponent(exponent, node.right)
        value = sympy.Pow(self.read(node.left, depth + 1), exponent)
        for power in value.atoms(sympy.Pow):  # (x**100)**100 has become x**10000
            self.check_exponent(power.exp, node.right)
        return value

    def call(self, node: ast.Call, depth: int) -> sympy.Expr:
        """The value of a function."""
        name = node.func.id if isinstance(node.func, ast.Name) else ""
        if name not in FUNCTIONS or name in self.names:
            raise self.error("only functions can be called", node)
        wanted = 2 if name == "atan2" else 1
        if len(node.args) != wanted or node.keywords:
            raise self.error(f"{name} takes {wanted} argument{'s' * (wanted - 1)}", node)
        arguments = [self.read(argument, depth + 1) for argument in node.args]
        if name == "exp":
            self.check_exponent(arguments[0], node)
        return FUNCTIONS[name](*arguments)

    def check_exponent(self, exponent: sympy.Expr, node: ast.expr) -> None:
        """Refuse numbers of which SymPy, computing exactly, would make astronomic ones."""
        for number in exponent.atoms(sympy.Rational):
            if abs(number) > MAX_EXPONENT:
                message = f"this exponent is too large; up to {MAX_EXPONENT} is allowed"
                raise self.error(message, node)
            if number.q > MAX_ROOT:
                raise self.error(f"this exponent has more than {_DECIMALS} decimals", node)

    def check(self, value: sympy.Expr, node: ast.expr) -> None:
        """Refuse a constant without a real value, or one so large that SymPy might not return."""
        if value.has(sympy.zoo, sympy.nan, sympy.oo, -sympy.oo):
            raise self.error("this has no finite value", node)
        if value.is_Rational:
            if max(value.p.bit_length(), value.q.bit_length()) > MAX_BITS:
                raise self.error("this number is too large", node)
        elif not value.free_symbols:
            approximation = sympy.N(value)
            if not approximation.is_real:
                raise self.error("this is not a real number", node)
            if abs(approximation) > MAX_CONSTANT:
                raise self.error(f"this number is larger than {MAX_CONSTANT:.0e}", node)


def _chain(node: ast.BinOp, operators: tuple[type, ...]) -> list[tuple[ast.operator, ast.expr]]:
    """The operands of a left-nested chain in order, each with the operator before it."""
    links: list[tuple[ast.operator, ast.expr]] = []
    left: ast.expr = node
    while isinstance(left, ast.BinOp) and isinstance(left.op, operators):
        links.append((left.op, left.right))
        left = left.left
    first = ast.Add() if ast.Add in operators else ast.Mult()
    return [(first, left), *reversed(links)]
