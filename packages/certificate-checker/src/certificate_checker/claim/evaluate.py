"""Evaluation of formulas: names through a table and definitions, rates along a vector field."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from fractions import Fraction

from .errors import CheckError
from .formulas import CONSTANTS, Formula, names_in
from .functions import HALF, Functions
from .jets import Jet, Number, add, integer_power, inverse, multiply, slopes_of


class Point:
    """Point at which formulas are evaluated, possibly with derivatives.

    Parameters
    ----------
    values : mapping of name to number
        Values of symbols.
    definitions : mapping of name to formula
        Formulas of symbols in terms of known symbols and earlier definitions.
    rates : mapping of name to formula
        Time derivatives of the symbols that depend on time.
    functions : Functions
        Functions for one kind of numbers.
    parameter_formulas : mapping of name to formula
        Formulas of parameters in terms of others; with them an exponent may be a number.
    level : int
        Highest level of derivatives in the values.
    """

    def __init__(
        self,
        values: Mapping[str, Number],
        definitions: Mapping[str, Formula],
        rates: Mapping[str, Formula],
        functions: Functions,
        parameter_formulas: Mapping[str, Formula] | None = None,
        level: int = 0,
    ) -> None:
        self.values = dict(values)
        self.definitions = dict(definitions)
        self.rates = dict(rates)
        self.functions = functions
        self.parameter_formulas = dict(parameter_formulas or {})
        self.level = level
        self._memo: dict[Formula, Number] = {}
        self._moving: Point | None = None

    def with_definitions(self, more: Mapping[str, Formula]) -> Point:
        """Copy of the point with further definitions."""
        return Point(
            self.values,
            {**self.definitions, **more},
            self.rates,
            self.functions,
            self.parameter_formulas,
            self.level,
        )

    def moving(self) -> Point:
        """Point with the derivative of every value along the vector field, in direction 0."""
        if self._moving is None:
            values = dict(self.values)
            for word, rate in self.rates.items():
                values[word] = Jet(self.level + 1, values[word], {0: self(rate)})
            self._moving = self._above(values)
        return self._moving

    def partial(self, words: Iterable[str]) -> Point:
        """Point with partial derivatives with respect to the symbols, numbered in their order."""
        values = dict(self.values)
        for i, word in enumerate(words):
            values[word] = Jet(
                self.level + 1, values[word], {i: self.functions.number(Fraction(1))}
            )
        return self._above(values)

    def _above(self, values: Mapping[str, Number]) -> Point:
        return Point(
            values,
            self.definitions,
            self.rates,
            self.functions,
            self.parameter_formulas,
            self.level + 1,
        )

    def slopes(self, formula: Formula) -> Mapping[int, Number]:
        """Derivatives of a formula at the highest level."""
        return slopes_of(self(formula), self.level)

    def __call__(self, formula: Formula) -> Number:
        """Value of a formula."""
        value = self._memo.get(formula)
        if value is None:
            self._prepare(formula)
            value = self._memo[formula] = self._fresh_value(formula)
        return value

    def _prepare(self, formula: Formula) -> None:
        """Evaluate definitions from the first to the last, which avoids deep recursion."""
        if formula.kind != "name" or not self._waits(formula.word):
            return
        needed: set[str] = set()
        waiting: list[str] = [formula.word]
        while waiting:
            word = waiting.pop()
            if word not in needed and self._waits(word):
                needed.add(word)
                waiting.extend(names_in([self.definitions[word]]))
        for word, definition in self.definitions.items():
            if word in needed and word != formula.word:
                self._memo[definition] = self._fresh_value(definition)

    def _waits(self, word: str) -> bool:
        """True if a symbol has a definition that has not been evaluated."""
        definition = None if word in self.values else self.definitions.get(word)
        return definition is not None and definition not in self._memo

    def _fresh_value(self, formula: Formula) -> Number:
        kind, parts = formula.kind, formula.parts
        if kind == "number":
            return self.functions.number(formula.word)
        if kind == "name":
            return self._symbol_value(formula.word)
        if kind == "sum":
            result = self(parts[0])
            for part in parts[1:]:
                result = add(result, self(part))
            return result
        if kind == "product":
            result = self(parts[0])
            for part in parts[1:]:
                result = multiply(result, self(part))
            return result
        if kind == "power":
            return self._power(*parts)
        if kind == "function":
            word, orders = formula.word
            return self.functions.unspecified(word, orders, [self(part) for part in parts])
        return self._known_function(formula.word, parts)

    def _symbol_value(self, word: str) -> Number:
        if word in self.values:
            return self.values[word]
        if word in self.definitions:
            return self(self.definitions[word])
        if word in CONSTANTS:
            return self.functions.constant(word)
        raise CheckError(f"the symbol {word} is unknown")

    def exact(self, formula: Formula) -> Fraction | None:
        """Rational value of a formula by definitions and parameter formulas, or None."""
        return exact_value(formula, {**self.definitions, **self.parameter_formulas})

    def _power(self, base: Formula, exponent: Formula) -> Number:
        value = self.exact(exponent)
        if value is None:
            return self.functions.general_power(self(base), self(exponent))
        if value.denominator == 1:
            if abs(value) > 10_000:
                raise CheckError(f"the exponent {value} is too large")
            return integer_power(self(base), int(value))
        return self.functions.rational_power(self(base), value)

    def _known_function(self, word: str, parts: tuple[Formula, ...]) -> Number:
        functions = self.functions
        if word == "Rate":
            there = self.moving()
            return slopes_of(there(parts[0]), there.level).get(0, functions.number(Fraction(0)))
        if word == "sqrt":
            return functions.rational_power(self(parts[0]), HALF)
        if word == "atan2":
            return functions.arctangent(self(parts[0]), self(parts[1]))
        inner = self(parts[0])
        if word in _RATIOS:
            above, below = _RATIOS[word]
            lower = inverse(functions.value(below, inner))
            return lower if above is None else multiply(functions.value(above, inner), lower)
        return functions.value(word, inner)


_RATIOS: dict[str, tuple[str | None, str]] = {
    "tan": ("sin", "cos"),
    "cot": ("cos", "sin"),
    "sec": (None, "cos"),
    "csc": (None, "sin"),
    "tanh": ("sinh", "cosh"),
}


def exact_value(formula: Formula, definitions: Mapping[str, Formula]) -> Fraction | None:
    """Rational number that equals a formula whose symbols are numbers by definition, or None."""
    kind, parts = formula.kind, formula.parts
    if kind == "number":
        return Fraction(formula.word)
    if kind == "name":
        inner = definitions.get(formula.word)
        return None if inner is None else exact_value(inner, definitions)
    if kind not in ("sum", "product", "power"):
        return None
    values = [exact_value(part, definitions) for part in parts]
    known = [value for value in values if value is not None]
    if len(known) < len(values):
        return None
    if kind == "sum":
        return sum(known, Fraction(0))
    if kind == "product":
        result = Fraction(1)
        for value in known:
            result *= value
        return result
    base, exponent = known
    if exponent.denominator != 1 or abs(exponent) > 1000 or (base == 0 and exponent < 0):
        return None
    return base ** int(exponent)
