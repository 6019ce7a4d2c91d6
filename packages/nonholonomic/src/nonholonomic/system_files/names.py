"""The names that a file declares, and the formulas written in them."""

from __future__ import annotations

import keyword
import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field, replace

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
from flowlanes.system.laws import Rate
from flowlanes.system.named_formulas import flat
from flowlanes.system.vectors import Diagonal, Symmetric, Vector, real_symbol, to_components

from ..mechanics.lagrangian.mechanism import TIME
from .tables import ComponentsTable

_NAME = re.compile(r"[A-Za-z_]\w*", re.ASCII)
#: A vector of the plane has 2 components, a quaternion 4.
_SIZE = re.compile(r"(.*?)(?:\[([234])\])?", re.DOTALL)
_KINDS: dict[str, type[Vector] | type[Diagonal] | type[Symmetric]] = {
    "vector": Vector,
    "diagonal": Diagonal,
    "symmetric": Symmetric,
}


@dataclass(frozen=True)
class Names:
    """The names that a file has declared so far; formulas know these, and ``t``.

    Parameters
    ----------
    where : callable
        The place of a key in the file, for the places of mistakes.
    """

    where: Callable[..., str]
    by_name: dict[str, NamedQuantity] = field(default_factory=lambda: {str(TIME): TIME})
    whole: dict[str, NamedQuantity] = field(default_factory=dict)
    """Vectors and tensors whose components are declared by themselves."""
    definitions: dict[str, sp.Basic] = field(default_factory=dict)
    """Formulas that have a name: definitions, and shorthand."""

    def copy(self) -> Names:
        """The same names, to which others may be added."""
        parts = {"by_name": dict(self.by_name), "whole": dict(self.whole)}
        return replace(self, **parts, definitions=dict(self.definitions))  # type: ignore[arg-type]

    def below(self, *key: str) -> Names:
        """An empty set of names for the tables below a key."""
        return Names(lambda *further: self.where(*key, *further))

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

    def define(self, name: str, value: Formula, *key: str) -> NamedQuantity:
        """A new name for a formula, of the kind that the formula is."""
        if not isinstance(value, MatrixExpr | sp.MatrixBase):
            quantity: NamedQuantity = real_symbol(name)
        elif value.shape[1] == 1:
            quantity = Vector(name, int(value.shape[0]))
        elif value.shape != (3, 3) or to_components(value) != to_components(value).T:
            raise self.error("must be a number, a vector or a symmetric tensor", *key)
        else:
            kind = Diagonal if to_components(value).is_diagonal() else Symmetric
            quantity = kind(name)
        self.definitions[name] = value
        return self.add(quantity, *key)

    def abbreviate(self, name: str, value: Formula, *key: str) -> None:
        """Add a name that abbreviates a formula."""
        self._check(name, *key)
        if name in {*self.by_name, *self.whole, *map(str, flat(self.by_name.values()))}:
            raise self.error(f"'{name}' stands for two things; rename one of them", *key)
        self.definitions[name] = value

    def add(self, quantity: NamedQuantity, *key: str) -> NamedQuantity:
        """A new quantity under its own name."""
        name = str(quantity)
        self._check(name, *key)
        # a definition is noted before its quantity is added, and may have its own name
        short = self.definitions.keys() - {name}
        words = {*self.by_name, *self.whole, *short, *map(str, flat(self.by_name.values()))}
        for word in (name, *map(str, flat([quantity]))):
            if word in words:
                raise self.error(f"'{word}' stands for two things; rename one of them", *key)
        self.by_name[name] = quantity
        return quantity

    def group(self, components: ComponentsTable) -> None:
        """Vectors and tensors whose components are declared by themselves, before or after."""
        # whether the components are declared is seen at the end (`require_components`)
        for name, kind in components.items():
            self._check(name, "components", name)
            if name in self.by_name:
                raise self.error(
                    f"'{name}' stands for two things; rename one of them", "components", name
                )
            self.whole[name] = _KINDS[kind](name)

    def require_components(self) -> None:
        """Refuse a vector or tensor without one of its components."""
        known = set(flat(self.by_name.values()))
        for name, quantity in self.whole.items():
            missing = [str(s) for s in quantity.symbols if s not in known]
            if missing:
                raise self.error(
                    f"its component {missing[0]} is no parameter, variable or definition",
                    *("components", name),
                )

    def get(self, name: str, among: Iterable[NamedQuantity], *key: str) -> NamedQuantity:
        """The quantity of that name, one of these or a component of one."""
        # a component may be named by itself, such as the velocity omega_3 in a commutator
        quantities: dict[str, NamedQuantity] = {}
        for named in among:
            quantities[str(named)] = named
            quantities |= {str(s): s for s in flat([named])}
        if name not in quantities:
            raise self.error(f"unknown name '{name}'{nearest(name, quantities)}", *key)
        return quantities[name]

    def law_formula(self, text: str, *key: str) -> Formula:
        """A formula of a law, in which rates may occur."""
        names = self.by_name | self.whole
        return parse_formula(text, names, self.where(*key), "[parameters]", self.definitions)

    def formula(self, text: str, *key: str) -> Formula:
        """The formula of a text, scalar or vector."""
        value = self.law_formula(text, *key)
        if value.has(Rate):
            raise self.error("Rate(...) stands in laws alone; write the rate itself", *key)
        return value

    def scalar(self, text: str, *key: str) -> sp.Expr:
        """A formula that must be a number."""
        value = self.formula(text, *key)
        if kind := _kind(value):
            raise self.error(f"must be a number, and '{text}' is a {kind}", *key)
        return value

    def like(self, quantity: NamedQuantity, text: str, *key: str) -> Formula:
        """A formula of the size of a named quantity."""
        value = self.formula(text, *key)
        wanted = (len(quantity.symbols), 1) if isinstance(quantity, Vector) else ()
        if (tuple(value.shape) if _kind(value) else ()) != wanted:
            kind = f"a vector of {wanted[0]}" if wanted else "a number"
            raise self.error(f"must be {kind}, as {quantity} is", *key)
        return value

    def formulas(self, texts: Iterable[str], *key: str) -> tuple[Formula, ...]:
        """The formulas of an array."""
        return tuple(self.formula(text, *key) for text in texts)

    def error(self, message: str, *key: str) -> InputError:
        """A mistake at a place of the file."""
        return InputError(message, self.where(*key))

    def _check(self, name: str, *key: str) -> None:
        if _NAME.fullmatch(name) is None:
            raise self.error(
                f"'{name}' is no name; a name has Latin letters, digits and _, and a vector its "
                "size in brackets, as in gamma[3]",
                *key,
            )
        if name in RESERVED_WORDS | PRODUCTS | {str(TIME)} or keyword.iskeyword(name):
            raise self.error(f"the name '{name}' has a meaning already; choose another", *key)


def _kind(value: Formula) -> str:
    """Whether a formula is a vector or a tensor; empty for a number."""
    if not isinstance(value, MatrixExpr | sp.MatrixBase):
        return ""
    return "vector" if value.shape[1] == 1 else "tensor"
