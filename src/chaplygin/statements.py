"""Laws as plain values: what is claimed of a system, apart from any proof."""

from __future__ import annotations

from dataclasses import dataclass, field

import sympy as sp

__all__ = ["Integral"]


@dataclass(frozen=True)
class Integral:
    """A first integral: a function F of the state with v(F) = 0.

    Parameters
    ----------
    name : str
        Short name, used for the variable ``law_<name>`` of a dataset.
    value : sympy.Expr
        F, written in the state, the definitions and the parameters of its system.
    meaning : str
        A few words for a reader ("energy", "area integral").
    on : tuple of sympy.Expr
        Expressions in the parameters or the state that must vanish for the law to hold;
        empty when it holds everywhere.
    source : str
        Where it is stated, such as ``"(7.2)"``.
    unit : str
        SI unit of its value.
    """

    name: str
    value: sp.Expr
    meaning: str
    on: tuple[sp.Expr, ...] = field(default=())
    source: str = ""
    unit: str = ""
