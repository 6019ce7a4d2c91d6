"""Parser of formulas and conditions in Python syntax; no text is executed."""

from __future__ import annotations

import re
from collections.abc import Iterator
from fractions import Fraction

from .errors import CheckError
from .formulas import (
    FUNCTIONS,
    Formula,
    call,
    function,
    name,
    number,
    power,
    product,
    substitution,
    total,
)

#: Maximum nesting depth of brackets.
DEPTH = 120
LENGTH = 5_000_000
DIGITS = 5_000

_TOKEN = re.compile(
    r"\s*(?:(?P<number>\d+(?:\.\d*)?(?:[eE][+-]?\d{1,4})?|\.\d+(?:[eE][+-]?\d{1,4})?)"
    r"|(?P<name>[^\W\d]\w*)"
    r"|(?P<sign>\*\*|<=|>=|==|!=|[-+*/(),<>&|]))"
)


def parse(text: object, what: str) -> Formula:
    """Formula from text.

    Raises
    ------
    CheckError
        If the text is not a formula.
    """
    return _Reader(text, what).whole()


def parse_condition(text: object, what: str) -> list[tuple[Formula, str]]:
    """Formulas of a condition on parameters, with ``>``, ``>=``, ``=`` or ``!=`` (to zero)."""
    return _Reader(text, what).condition()


def parse_alternatives(text: object, what: str) -> list[list[tuple[Formula, str]]]:
    """Alternatives, joined by ``|``; each as in :func:`parse_condition`."""
    return _Reader(text, what).alternatives()


class _Reader:
    """Recursive-descent parser of one text."""

    def __init__(self, text: object, what: str) -> None:
        if not isinstance(text, str) or len(text) > LENGTH:
            raise CheckError(f"{what} is not the text of a formula")
        self.text, self.what = text, what
        self.tokens = list(self._tokens())
        self.at = 0
        self.depth = 0

    def _wrong(self, why: str) -> CheckError:
        shown = self.text if len(self.text) < 80 else self.text[:77] + "..."
        return CheckError(f"{self.what}: the formula {shown!r} {why}")

    def _tokens(self) -> Iterator[tuple[str, str]]:
        at, end = 0, len(self.text.rstrip())
        while at < end:
            match = _TOKEN.match(self.text, at)
            if match is None:
                raise self._wrong(f"has an unexpected {self.text[at:].lstrip()[0]!r}")
            yield str(match.lastgroup), match.group(match.lastgroup or 0)
            at = match.end()

    def _peek(self) -> str:
        return self.tokens[self.at][1] if self.at < len(self.tokens) else ""

    def _take(self, *signs: str) -> str | None:
        if self.at < len(self.tokens) and self.tokens[self.at] in [("sign", s) for s in signs]:
            self.at += 1
            return self.tokens[self.at - 1][1]
        return None

    def _expect(self, sign: str) -> None:
        if self._take(sign) is None:
            raise self._wrong(f"has no {sign!r} where one is required")

    def _end(self) -> None:
        if self.at < len(self.tokens):
            raise self._wrong(f"has an unexpected {self._peek()!r}")

    def whole(self) -> Formula:
        formula = self.sum()
        self._end()
        return formula

    # --- conditions ----------------------------------------------------------------------------

    def condition(self) -> list[tuple[Formula, str]]:
        relations = self._conjunction()
        self._end()
        return relations

    def alternatives(self) -> list[list[tuple[Formula, str]]]:
        found = [self._conjunction()]
        while self._take("|"):
            found.append(self._conjunction())
        self._end()
        return found

    def _conjunction(self) -> list[tuple[Formula, str]]:
        relations = self._one()
        while self._take("&"):
            relations += self._one()
        return relations

    def _one(self) -> list[tuple[Formula, str]]:
        for word, sign in (("Ne", "!="), ("Eq", "=")):
            if self.tokens[self.at : self.at + 2] == [("name", word), ("sign", "(")]:
                self.at += 2
                first = self.sum()
                self._expect(",")
                second = self.sum()
                self._expect(")")
                return [(_difference(first, second), sign)]
        start = self.at
        try:
            return [self._comparison()]
        except CheckError:
            # The bracket may begin a formula or a condition; only the attempt shows which.
            self.at = start
            if self._take("(") is None:
                raise
            relations = self._conjunction()
            self._expect(")")
            return relations

    def _comparison(self) -> tuple[Formula, str]:
        first = self.sum()
        sign = self._take(">", ">=", "<", "<=", "==", "!=")
        if sign is None:
            raise self._wrong("contains no comparison")
        second = self.sum()
        if sign in ("<", "<="):
            first, second, sign = second, first, sign.replace("<", ">")
        return _difference(first, second), sign.replace("==", "=")

    # --- sums, products, powers ------------------------------------------------------------------

    def sum(self) -> Formula:
        self.depth += 1
        if self.depth > DEPTH:
            raise self._wrong("is nested too deep")
        parts = [self._product()]
        while (sign := self._take("+", "-")) is not None:
            part = self._product()
            parts.append(part if sign == "+" else _negative(part))
        self.depth -= 1
        return total(parts)

    def _product(self) -> Formula:
        parts = [self._unary()]
        while (sign := self._take("*", "/")) is not None:
            part = self._unary()
            parts.append(part if sign == "*" else _inverse(part))
        # A quotient of numbers becomes one number, so that 2/3 is recognized as an exponent.
        numbers = [part for part in parts if part.kind == "number"]
        if len(numbers) == len(parts):
            value = Fraction(1)
            for part in numbers:
                value *= part.word
            return number(value)
        return product(parts)

    def _unary(self) -> Formula:
        negative = False
        while (sign := self._take("+", "-")) is not None:
            negative ^= sign == "-"
        formula = self._power()
        return _negative(formula) if negative else formula

    def _power(self) -> Formula:
        base = self._atom()
        if self._take("**") is None:
            return base
        self.depth += 1
        if self.depth > DEPTH:
            raise self._wrong("is nested too deep")
        exponent = self._unary()
        self.depth -= 1
        return power(base, exponent)

    def _atom(self) -> Formula:
        if self._take("("):
            inner = self.sum()
            self._expect(")")
            return inner
        if self.at >= len(self.tokens):
            raise self._wrong("ends too early")
        kind, word = self.tokens[self.at]
        if kind == "sign":
            raise self._wrong(f"has an unexpected {word!r}")
        self.at += 1
        if kind == "number":
            if len(word) > DIGITS:
                raise self._wrong("has a number that is too long")
            return number(Fraction(word))
        if self._take("(") is None:
            return name(word)
        return self._call(word)

    # --- calls -----------------------------------------------------------------------------------

    def _call(self, word: str) -> Formula:
        if word == "Derivative":
            return self._derivative()
        if word == "Subs":
            return self._substitution()
        arguments = [self.sum()]
        while self._take(","):
            arguments.append(self.sum())
        self._expect(")")
        if word in ("Max", "Min"):
            return _extreme(word, arguments)
        if word not in FUNCTIONS:
            return function(word, [0] * len(arguments), arguments)
        if len(arguments) != FUNCTIONS[word]:
            raise self._wrong(f"gives {word} {len(arguments)} arguments")
        return call(word, arguments)

    def _derivative(self) -> Formula:
        inner = self.sum()
        if inner.kind != "function":
            raise self._wrong("has a derivative that is not of one unspecified function")
        word, orders = inner.word
        counts = list(orders)
        while self._take(","):
            bracket = self._take("(")
            variable, count = self.sum(), 1
            if bracket:
                if self._take(","):
                    times = self.sum()
                    if times.kind != "number" or times.word.denominator != 1 or times.word < 1:
                        raise self._wrong("has a derivative of an order that is not a number")
                    count = int(times.word)
                    self._take(",")
                self._expect(")")
            if variable.kind != "name" or inner.parts.count(variable) != 1:
                raise self._wrong(
                    "has a derivative that is not with respect to one argument of its function"
                )
            counts[inner.parts.index(variable)] += count
        self._expect(")")
        return function(word, counts, inner.parts)

    def _list(self) -> list[Formula]:
        if self._take("(") is None:
            return [self.sum()]
        formulas = [self.sum()]
        while self._take(","):
            if self._peek() != ")":
                formulas.append(self.sum())
        self._expect(")")
        return formulas

    def _substitution(self) -> Formula:
        inner = self.sum()
        self._expect(",")
        start = self.at
        variables = self._list()
        self._expect(",")
        points = self._points(start, len(variables))
        self._take(",")
        self._expect(")")
        if any(v.kind != "name" for v in variables) or len(points) != len(variables):
            raise self._wrong("substitutes for something that is not a name")
        return substitution(inner, {v.word: p for v, p in zip(variables, points, strict=True)})

    def _points(self, start: int, count: int) -> list[Formula]:
        """Arguments after the variables; a bracketed list if the variables are in brackets."""
        if self.tokens[start] == ("sign", "("):
            return self._list()
        return [self.sum()]


def _extreme(word: str, parts: list[Formula]) -> Formula:
    """Maximum or minimum through absolute values: max(a, b) = (a + b + |a - b|)/2."""
    result, sign = parts[0], Fraction(1 if word == "Max" else -1)
    for part in parts[1:]:
        size = call("Abs", [_difference(result, part)])
        whole = total((result, part, product((number(sign), size))))
        result = product((number(Fraction(1, 2)), whole))
    return result


def _negative(part: Formula) -> Formula:
    if part.kind == "number":
        return number(-part.word)
    return product((number(-1), part))


def _inverse(part: Formula) -> Formula:
    if part.kind == "number" and part.word:
        return number(1 / part.word)
    return power(part, number(-1))


def _difference(first: Formula, second: Formula) -> Formula:
    if second.kind == "number" and not second.word:
        return first
    return total((first, _negative(second)))
