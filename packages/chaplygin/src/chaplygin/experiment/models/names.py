"""The names that a user's file declares, and the formulas written in them."""

from __future__ import annotations

import keyword
import re
from collections.abc import Iterable
from dataclasses import dataclass, field

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.errors import InputError
from flowlanes.parsing import (
    PRODUCTS,
    RESERVED_WORDS,
    Formula,
    NamedQuantity,
    nearest,
    parse_formula,
)
from flowlanes.system.system import flat
from flowlanes.system.vectors import Vector, real_symbol
from nonholonomic.mechanics.lagrangian.mechanism import TIME

from .described_models import OwnExperiment

_NAME = re.compile(r"[A-Za-z_]\w*", re.ASCII)
_SIZE = re.compile(r"(.*?)(?:\[([234])\])?", re.DOTALL)


@dataclass(frozen=True)
class Names:
    """The names that a file has declared so far; formulas know these, and ``t``.

    Parameters
    ----------
    experiment : OwnExperiment
        Whose file it is, for the places of mistakes.
    """

    experiment: OwnExperiment
    by_name: dict[str, NamedQuantity] = field(default_factory=lambda: {str(TIME): TIME})

    def declare(self, text: str, *key: str) -> NamedQuantity:
        """A new name: ``x`` for a number, ``gamma[3]`` for a vector.

        Raises
        ------
        InputError
            If it is no name, has a meaning already, or stands for something else too.
        """
        match = _SIZE.fullmatch(text)
        name, size = match.groups() if match else (text, None)
        return self.add(Vector(name, int(size)) if size else real_symbol(name), *key)

    def add(self, quantity: NamedQuantity, *key: str) -> NamedQuantity:
        """A new quantity under its own name."""
        name = str(quantity)
        if _NAME.fullmatch(name) is None:
            raise self.error(
                f"'{name}' is no name; a name has Latin letters, digits and _, and a vector its "
                "size in brackets, as in gamma[3]",
                *key,
            )
        words = {*self.by_name, *map(str, flat(self.by_name.values()))}
        if name in RESERVED_WORDS | PRODUCTS | {str(TIME)} or keyword.iskeyword(name):
            raise self.error(f"the name '{name}' has a meaning already; choose another", *key)
        for word in (name, *map(str, flat([quantity]))):
            if word in words:
                raise self.error(f"'{word}' stands for two things; rename one of them", *key)
        self.by_name[name] = quantity
        return quantity

    def get(self, name: str, among: Iterable[NamedQuantity], *key: str) -> NamedQuantity:
        """The quantity of that name, one of these or a component of one."""
        quantities: dict[str, NamedQuantity] = {}
        for named in among:
            quantities[str(named)] = named
            quantities |= {str(s): s for s in flat([named])}
        if name not in quantities:
            raise self.error(f"unknown name '{name}'{nearest(name, quantities)}", *key)
        return quantities[name]

    def formula(self, text: str, *key: str) -> Formula:
        """A formula that stands at that place, scalar or vector."""
        where = self.experiment.where(*key)
        return parse_formula(text, self.by_name, where, "[parameters]")

    def scalar(self, text: str, *key: str) -> sp.Expr:
        """A formula that must be a number."""
        value = self.formula(text, *key)
        if _size(value):
            raise self.error(f"must be a number, and '{text}' is a vector", *key)
        return value

    def like(self, quantity: NamedQuantity, text: str, *key: str) -> Formula:
        """A formula of the size of a named quantity."""
        value = self.formula(text, *key)
        wanted = len(quantity.symbols) if isinstance(quantity, Vector) else 0
        if _size(value) != wanted:
            kind = (
                f"a vector of {wanted}, as {quantity} is"
                if wanted
                else f"a number, as {quantity} is"
            )
            raise self.error(f"must be {kind}", *key)
        return value

    def formulas(self, texts: Iterable[str], *key: str) -> tuple[Formula, ...]:
        """The formulas of an array."""
        return tuple(self.formula(text, *key) for text in texts)

    def error(self, message: str, *key: str) -> InputError:
        """A mistake at a place of the file."""
        return InputError(message, self.experiment.where(*key))


def _size(value: Formula) -> int:
    """Number of components; 0 for a scalar."""
    return int(value.shape[0]) if isinstance(value, MatrixExpr | sp.MatrixBase) else 0
