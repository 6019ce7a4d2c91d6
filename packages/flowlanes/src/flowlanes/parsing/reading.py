"""Parsing of scalar and vector formulas."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping

import sympy

from ..arguments import arguments_checked
from ..errors import nearest as _nearest
from .grammar import CONSTANTS, PRODUCTS, RESERVED_WORDS
from .paper_notation import code_spelling
from .scalar import Scalars
from .syntax import Source, syntax_tree
from .vector import Formula, NamedQuantity, Vectors

nearest = arguments_checked(_nearest)


@arguments_checked
def parse(
    text: str, names: Mapping[str, sympy.Symbol], where: str = "", further: str = ""
) -> sympy.Expr:
    """Parse a scalar formula.

    Parameters
    ----------
    text
        The formula, such as ``"x**4 + y**4 + z**4 - 1"``; line breaks count as spaces.
    names
        The symbols that it may contain, by name.
    where
        Location of the formula (file, line, key), used as prefix of error messages.
    further
        Where names can be declared, such as ``"[parameters]"``; mentioned in the message for an
        unknown name.

    Returns
    -------
    sympy.Expr
        A real, finite expression in those symbols whose numbers are exact.

    Raises
    ------
    InputError
        If the text is not a formula of this language, contains an unknown name, has no real value
        (``1/0``, ``sqrt(-1)``) or is too large. The message is one sentence, followed by the
        formula and a caret under the offending character.

    Examples
    --------
    >>> import flowlanes
    >>> flowlanes.parsing.parse("x**2/2 + 0.1", {"x": flowlanes.system.real_symbol("x")})
    x**2/2 + 1/10
    """
    words = _in_order(names, RESERVED_WORDS)
    source = Source(code_spelling(text), where, words, further=further)
    return Scalars(source, {**CONSTANTS, **names}).read(syntax_tree(source), 0)


def _in_order(names: Iterable[str], reserved_words: Collection[str]) -> Collection[str]:
    """The names in the given order, then functions and constants."""
    return dict.fromkeys([*names, *sorted(reserved_words)])


@arguments_checked
def parse_formula(
    text: str,
    names: Mapping[str, NamedQuantity],
    where: str = "",
    further: str = "",
    definitions: Mapping[str, sympy.Basic] | None = None,
) -> Formula:
    """Parse a formula that may contain vectors.

    Parameters
    ----------
    text
        The formula, such as ``"cross(u, v)"`` or ``"dot(v, I*v)/2"``.
    names
        Scalars, vectors and diagonal tensors by name; the components of a vector, such as
        ``u_1``, are known with it.
    where
        Location of the formula, used as prefix of error messages.
    further
        Where names can be declared.
    definitions
        Named formulas, of which ``gradient(H, M)`` may be taken; a name that is not in `names`
        stands for its formula.

    Returns
    -------
    sympy.Expr or MatrixExpr
        The formula as written: vector products are not expanded.

    Raises
    ------
    InputError
        As for `parse`, or if numbers and vectors are mixed up.

    Examples
    --------
    >>> import flowlanes
    >>> u, v = flowlanes.system.Vector("u"), flowlanes.system.Vector("v")
    >>> flowlanes.parsing.parse_formula("dot(u, v)/2", {"u": u, "v": v})
    Dot(u, v)/2
    """
    scalars = {s.name: s for name in names.values() for s in _components(name)}
    short = {n: v for n, v in (definitions or {}).items() if n not in {*names, *scalars}}
    words = _in_order([*names, *scalars, *short], RESERVED_WORDS | PRODUCTS)
    source = Source(code_spelling(text), where, words, brackets=True, further=further)
    return Vectors(source, {**CONSTANTS, **short, **scalars}, names, definitions or {}).read(
        syntax_tree(source), 0
    )


def _components(quantity: NamedQuantity) -> tuple[sympy.Symbol, ...]:
    return (quantity,) if isinstance(quantity, sympy.Symbol) else tuple(quantity.symbols)
