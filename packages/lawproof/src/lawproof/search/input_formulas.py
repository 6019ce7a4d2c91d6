"""Parsing of formulas that a user types for a search: ``M·γ``, ``(γ, J γ) - 1``, ``k = -1``."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable, Mapping

import sympy as sp

from flowlanes.errors import InputError
from flowlanes.parsing import nearest, parse
from flowlanes.system.matrices import Skew
from flowlanes.system.system import System
from flowlanes.system.vectors import Diagonal, Symmetric, Vector, dot

_WORD = r"[A-Za-z_]\w*"
_OPERAND = rf"{_WORD}(?:(?:\s*\*?\s+|\s*\*\s*){_WORD})*"
_PRODUCT = re.compile(
    rf"(?:\bdot\s*)?\(\s*(?P<a>{_OPERAND})\s*,\s*(?P<b>{_OPERAND})\s*\)"
    rf"|(?P<c>{_WORD})\s*·\s*(?P<d>{_WORD})"
    rf"|(?P<e>{_WORD})\s*(?:\*\*\s*2|\^\s*2)(?!\d)",
    re.ASCII,
)
#: A comma outside parentheses.
_COMMA = re.compile(r",(?![^()]*\))")
_PLAIN = str.maketrans(
    {**{chr(0x2080 + i): f"_{i}" for i in range(10)}, "²": "**2", "³": "**3", "−": "-", "⋅": "·"}
)


def code_spelling(text: str) -> str:
    """The text with Greek letters, indices and powers in code spelling."""
    words = []
    for character in text.translate(_PLAIN):
        name = unicodedata.name(character, "")
        greek = re.fullmatch(r"GREEK (SMALL|CAPITAL) LETTER (\w+)", name)
        if greek is None:
            words.append(character)
        else:
            word = greek[2].lower().replace("lamda", "lambda")
            words.append(word if greek[1] == "SMALL" else word.capitalize())
    return "".join(words)


def _tensors_by_name(system: System) -> dict[str, Vector | Diagonal | Symmetric | Skew]:
    """Vectors and tensors by name."""
    tensors: dict[str, Vector | Diagonal | Symmetric | Skew] = {}
    for name, value in (*system.field, *system.definitions):
        if not isinstance(name, sp.Symbol):
            tensors[name.name] = name
        for atom in value.atoms(Vector, Diagonal, Symmetric):
            tensors.setdefault(atom.name, atom)
    return tensors


def _scalars(system: System) -> dict[str, sp.Symbol]:
    symbols = (
        *(p.symbol for p in system.parameters),
        *system.symbols,
        *(s for s, _ in system.scalar_definitions),
    )
    return {str(s): s for s in symbols}


def _operand(
    words: Iterable[str], quantities: Mapping[str, Vector | Diagonal | Symmetric], where: str
) -> sp.MatrixExpr:
    """Tensors applied to a vector, such as ``J gamma``."""
    *tensors, last = words
    for word in (*tensors, last):
        if word not in quantities:
            raise InputError(f"no vector or tensor {word!r}{nearest(word, quantities)}", where)
    result = quantities[last]
    if not isinstance(result, Vector):
        raise InputError(f"{last} is a tensor, not a vector: write ({last} u, v)", where)
    for word in reversed(tensors):
        if isinstance(quantities[word], Vector):
            raise InputError(f"{word} is a vector; only tensors multiply a vector", where)
        result = quantities[word] * result
    return result


def _read(text: str, system: System, names: Mapping[str, sp.Symbol], where: str) -> sp.Expr:
    named = _tensors_by_name(system)
    products: dict[str, sp.Expr] = {}
    prefix = "product"
    while any(name.startswith(prefix) for name in names):
        prefix += "_"

    def product_symbol(match: re.Match[str]) -> str:
        if match["e"] is not None:
            if not isinstance(named.get(match["e"]), Vector):
                return match[0]
            sides = (match["e"], match["e"])
        else:
            sides = (match["a"] or match["c"], match["b"] or match["d"])
        left, right = (_operand(re.findall(_WORD, side, re.ASCII), named, where) for side in sides)
        symbol = f"{prefix}{len(products)}"
        products[symbol] = dot(left, right)
        return f" {symbol} "

    plain = _PRODUCT.sub(product_symbol, code_spelling(text))
    left, _, right = plain.partition("=")
    known = {**names, **{name: sp.Symbol(name, real=True) for name in products}}
    expression = parse(left, known, where)
    if right.strip():
        expression = expression - parse(right, known, where)
    return expression.xreplace({known[name]: value for name, value in products.items()})


def formula(text: str, system: System, where: str = "") -> sp.Expr:
    """A scalar formula in state, definitions and parameters; ``F = G`` means F − G.

    Parameters
    ----------
    text : str
        Such as ``"M·γ"``, ``"(γ, J γ)"``, ``"M²"`` or ``"gamma_3 = 1/2"``.
    where : str
        Prefix of error messages.

    Raises
    ------
    InputError
        If the text is not a formula or contains an unknown name.
    """
    return _read(text, system, _scalars(system), where)


def condition(text: str, system: System, where: str = "") -> sp.Expr:
    """A condition on the parameters, such as ``"k = -1"`` or ``"I_1 = I_2"``.

    Raises
    ------
    InputError
        If the text is not a formula or contains a non-constant quantity.
    """
    fixed = {p.symbol for p in system.parameters}
    for symbol, value in system.scalar_definitions:
        if value.free_symbols <= fixed:
            fixed.add(symbol)
    expression = _read(text, system, {str(s): s for s in sorted(fixed, key=str)}, where)
    if not expression.free_symbols & fixed:
        raise InputError(f"{text!r} is no condition: it mentions no parameter", where)
    return expression


def quantities(names: str, system: System, where: str = "") -> tuple[sp.Expr, ...]:
    """The scalars of a comma-separated list of names (of vectors and scalars) and formulas.

    Parameters
    ----------
    names : str
        Such as ``"M, gamma_3"`` or ``"x, log(x)"``.
    where : str
        Prefix of error messages.

    Raises
    ------
    InputError
        If a name is unknown, or an entry is neither a name nor a formula.
    """
    scalars, named = _scalars(system), _tensors_by_name(system)
    vectors = {name: v for name, v in named.items() if isinstance(v, Vector | Skew)}
    scalars_asked: list[sp.Expr] = []
    for name in filter(None, (part.strip() for part in _COMMA.split(code_spelling(names)))):
        if name in vectors:
            scalars_asked += vectors[name].symbols
        elif name in scalars:
            scalars_asked.append(scalars[name])
        elif not re.fullmatch(_WORD, name, re.ASCII):
            scalars_asked.append(formula(name, system, where))
        else:
            allowed = [*vectors, *(s for s in scalars if s.rpartition("_")[0] not in named)]
            raise InputError(f"unknown variable {name!r}{nearest(name, allowed)}", where)
    return tuple(dict.fromkeys(scalars_asked))
