"""Syntax of formulas: tokens, precedence, and positions of errors."""

from __future__ import annotations

import ast
import re
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from types import MappingProxyType

from ..errors import InputError, nearest
from .grammar import FUNCTIONS, MAX_DEPTH, MAX_DIGITS, MAX_LENGTH, PRODUCTS

_TOKEN = re.compile(
    r"(?P<space>\s+)"
    r"|(?P<number>(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)"
    r"|(?P<name>[A-Za-z_]\w*)"
    r"|(?P<operator>\*\*|[-+*/(),])"
    r"|(?P<bracket>[\[\]])",
    re.ASCII,
)
_HINTS = MappingProxyType({"^": "a power is written **", "=": "write a formula, not an equation"})
_CORRECTIONS = MappingProxyType(
    {
        **dict.fromkeys(("E", "e"), "; Euler's number is written exp(1)"),
        **dict.fromkeys(("Pi", "PI", "π"), "; the half turn is written pi"),
        **dict.fromkeys(("oo", "inf", "nan", "zoo"), "; only finite numbers stand in formulas"),
    }
)
"""Hints for names used in other languages, as ends of sentences."""
_CLOSING = MappingProxyType({")": "(", "]": "["})
_SHAPE = MappingProxyType({"(": "parenthesis", "[": "bracket"})
_EXCERPT = 72

TOO_DEEP = "the formula is nested too deeply"
LONG_SUM = 500
"""Number of terms below which Python's parser accepts a sum in any context."""


@dataclass(frozen=True)
class Source:
    """The text of a formula, and its location.

    Parameters
    ----------
    text, where : str
    words : collection of str
        All names that may occur, including functions.
    brackets : bool
        Whether vectors may be given by components, ``[a, b, c]``.
    further : str
        Where names can be declared; may be empty.
    """

    text: str
    where: str
    words: Collection[str]
    brackets: bool = False
    further: str = ""

    def error(self, message: str, position: int) -> InputError:
        """An error message that points at the character `position` of the formula."""
        start = max(0, position - _EXCERPT // 2)
        window = self.text[start : start + _EXCERPT]
        excerpt = "".join(char if char.isprintable() else " " for char in window)
        return InputError(f"{message}\n    {excerpt}\n    {' ' * (position - start)}^", self.where)

    def at(self, message: str, node: ast.expr) -> InputError:
        """An error message that points at the first character of `node`."""
        return self.error(message, node.col_offset - 1)


@dataclass(frozen=True)
class _Token:
    """A number, name or operator, and the position of its first character."""

    kind: str
    word: str
    position: int


def syntax_tree(source: Source) -> ast.expr:
    """Parse a formula with Python's grammar; nothing is executed.

    The formula is enclosed in parentheses, so that leading blanks are harmless; columns in the
    tree are therefore one too large.

    Raises
    ------
    InputError
        If the text is too long, contains an unknown word or is not a formula.
    """
    if len(source.text) > MAX_LENGTH:
        raise InputError(
            f"the formula has {len(source.text)} characters; at most {MAX_LENGTH} are allowed",
            source.where,
        )
    tokens = _tokens(source)
    _check_words(source, tokens)
    _check_parentheses(source, tokens)
    line = re.sub(r"\s", " ", source.text, flags=re.ASCII).rstrip()
    try:
        return ast.parse(f"({line})", mode="eval").body
    except SyntaxError as error:
        position = (error.offset or 2) - 2
        message = "the formula cannot be read from here on"
        raise source.error(message, min(max(position, 0), len(line))) from None
    except (RecursionError, MemoryError):
        return _long_sum(source, line, tokens)


def _tokens(source: Source) -> list[_Token]:
    """Split the formula into tokens."""
    tokens = []
    position = 0
    while position < len(source.text):
        match = _TOKEN.match(source.text, position)
        if match is None or (match.lastgroup == "bracket" and not source.brackets):
            char = source.text[position]
            hint = _HINTS.get(char, "allowed: names, numbers, + - * / ** ( ) and commas")
            raise source.error(f"the character {char!r} has no meaning here; {hint}", position)
        if match.lastgroup != "space":
            tokens.append(_Token(str(match.lastgroup), match.group(), position))
        position = match.end()
    if not tokens:
        raise source.error("the formula is empty", 0)
    return tokens


def _check_words(source: Source, tokens: Sequence[_Token]) -> None:
    """Reject unknown names, overlong numbers and missing operators."""
    previous = ""
    for token in tokens:
        if _value_meets_value(source, previous, token.word):
            message = "an operator is missing here; multiplication is written *"
            raise source.error(message, token.position)
        if token.kind == "name" and token.word not in source.words:
            known = _CORRECTIONS.get(token.word) or nearest(token.word, source.words)
            own = f"; {source.further} declares names of your own" if source.further else ""
            raise source.error(f"unknown name '{token.word}'{known}{own}", token.position)
        if token.kind == "number" and len(token.word) > MAX_DIGITS:
            raise source.error(f"this number has more than {MAX_DIGITS} digits", token.position)
        previous = token.word


def _check_parentheses(source: Source, tokens: Sequence[_Token]) -> None:
    """Reject unbalanced or too deeply nested parentheses."""
    opened: list[_Token] = []
    for token in tokens:
        if token.word in _SHAPE:
            opened.append(token)
        elif token.word in _CLOSING:
            partner = _CLOSING[token.word]
            if not opened or opened[-1].word != partner:
                raise source.error(f"this {_SHAPE[partner]} closes none", token.position)
            opened.pop()
        if len(opened) > MAX_DEPTH:
            raise source.error(TOO_DEEP, token.position)
    if opened:
        last = opened[-1]
        raise source.error(f"this {_SHAPE[last.word]} is never closed", last.position)


def _terms(tokens: Sequence[_Token]) -> list[tuple[str, int, int]]:
    """The terms of a sum as (preceding operator, start, end); the first operator is empty."""
    terms: list[tuple[str, int, int]] = []
    depth, operator, begin, previous = 0, "", 0, ""
    for token in tokens:
        depth += (token.word in _SHAPE) - (token.word in _CLOSING)
        if depth == 0 and token.word in ("+", "-") and _ends_value(previous):
            terms.append((operator, begin, token.position))
            operator, begin = token.word, token.position + 1
        previous = token.word
    last = tokens[-1]
    return [*terms, (operator, begin, last.position + len(last.word))]


def _long_sum(source: Source, line: str, tokens: Sequence[_Token]) -> ast.expr:
    """The tree of a sum that is too long for Python's parser; terms are parsed one by one."""
    terms = _terms(tokens)
    if len(terms) < LONG_SUM:
        raise source.error(TOO_DEEP, 0)
    whole: ast.expr | None = None
    for operator, begin, end in terms:
        try:
            term = ast.parse(f"({line[begin:end]})", mode="eval").body
        except (RecursionError, MemoryError):
            raise source.error(TOO_DEEP, begin) from None
        for node in ast.walk(term):
            if isinstance(node, ast.expr):
                node.col_offset += begin
                node.end_col_offset = (node.end_col_offset or 0) + begin
        if whole is None:
            whole = term
        else:
            sign = ast.Add() if operator == "+" else ast.Sub()
            place = {"lineno": 1, "col_offset": whole.col_offset}
            whole = ast.BinOp(whole, sign, term, **place, end_col_offset=term.end_col_offset)
    assert whole is not None
    return whole


def _ends_value(word: str) -> bool:
    return word != "" and (word[-1].isalnum() or word[-1] in "_).]")


def _value_meets_value(source: Source, previous: str, word: str) -> bool:
    """True if two values follow each other without an operator: ``2x``, ``x (y + 1)``."""
    if word == "(" and (previous in FUNCTIONS or (source.brackets and previous in PRODUCTS)):
        return False
    return _ends_value(previous) and (word[0].isalnum() or word[0] in "_(.[")


def chain(node: ast.BinOp, operators: tuple[type, ...]) -> list[tuple[ast.operator, ast.expr]]:
    """The operands of a left-nested chain in order, each with its operator."""
    links: list[tuple[ast.operator, ast.expr]] = []
    left: ast.expr = node
    while isinstance(left, ast.BinOp) and isinstance(left.op, operators):
        links.append((left.op, left.right))
        left = left.left
    first = ast.Add() if ast.Add in operators else ast.Mult()
    return [(first, left), *reversed(links)]
