"""The names that a user's file declares, and the formulas written in them."""

from __future__ import annotations

import keyword
import re
from collections.abc import Iterable
from dataclasses import dataclass, field

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from ...core.vectors import Vector, real_symbol
from ...errors import InputError
from ...mechanics.lagrangian.mechanism import TIME
from ...parsing import PRODUCTS, RESERVED, Formula, Named, nearest, parse_formula
from .described_models import OwnExperiment

_NAME = re.compile(r"[A-Za-z_]\w*", re.ASCII)
_SIZED = re.compile(r"(.*?)(?:\[([234])\])?", re.DOTALL)


def components(named: Named) -> tuple[sp.Symbol, ...]:
    """A named quantity by its scalars."""
    return (named,) if isinstance(named, sp.Symbol) else tuple(named.symbols)


@dataclass(frozen=True)
class Names:
    """The names that a file has declared so far; formulas know these, and ``t``.

    Parameters
    ----------
    experiment : OwnExperiment
        Whose file it is, for the places of mistakes.
    """

    experiment: OwnExperiment
    known: dict[str, Named] = field(default_factory=lambda: {str(TIME): TIME})

    def declare(self, text: str, *key: str) -> Named:
        """A new name: ``x`` for a number, ``gamma[3]`` for a vector.

        Raises
        ------
        InputError
            If it is no name, has a meaning already, or stands for something else too.
        """
        match = _SIZED.fullmatch(text)
        name, size = match.groups() if match else (text, None)
        return self.add(Vector(name, int(size)) if size else real_symbol(name), *key)

    def add(self, named: Named, *key: str) -> Named:
        """A new quantity under its own name."""
        name = str(named)
        if _NAME.fullmatch(name) is None:
            raise self.error(
                f"'{name}' is no name; a name has letters, digits and _, and a vector its size "
                "in brackets, as in gamma[3]",
                *key,
            )
        words = {*self.known, *(str(s) for n in self.known.values() for s in components(n))}
        if name in RESERVED | PRODUCTS | {str(TIME)} or keyword.iskeyword(name):
            raise self.error(f"the name '{name}' has a meaning already; choose another", *key)
        for word in (name, *map(str, components(named))):
            if word in words:
                raise self.error(f"'{word}' stands for two things; rename one of them", *key)
        self.known[name] = named
        return named

    def get(self, name: str, among: Iterable[Named], *key: str) -> Named:
        """The quantity of that name, one of these or a component of one."""
        quantities: dict[str, Named] = {}
        for named in among:
            quantities[str(named)] = named
            quantities |= {str(s): s for s in components(named)}
        if name not in quantities:
            raise self.error(f"unknown name '{name}'{nearest(name, quantities)}", *key)
        return quantities[name]

    def formula(self, text: str, *key: str) -> Formula:
        """A formula that stands at that place, scalar or vector."""
        return parse_formula(text, self.known, self.experiment.where(*key))

    def scalar(self, text: str, *key: str) -> sp.Expr:
        """A formula that must be a number."""
        value = self.formula(text, *key)
        if _size(value):
            raise self.error(f"must be a number, and '{text}' is a vector", *key)
        return value

    def like(self, named: Named, text: str, *key: str) -> Formula:
        """A formula of the size of a named quantity."""
        value = self.formula(text, *key)
        wanted = len(named.symbols) if isinstance(named, Vector) else 0
        if _size(value) != wanted:
            kind = f"a vector of {wanted}, as {named} is" if wanted else f"a number, as {named} is"
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
