"""Display of systems and formulas.

The printers import this folder.  They are looked up by name at the first display, so that no import
leads back to them.
"""

from __future__ import annotations

from importlib import import_module
from typing import Protocol, cast

import sympy as sp


class _Printer(Protocol):
    def system_line(self, system: Displayed) -> str: ...

    def system_text(self, system: Displayed) -> str: ...

    def system_latex(self, system: Displayed) -> str: ...

    def system_html(self, system: Displayed) -> str: ...


class _FormulaPrinter(Protocol):
    def latex(self, formula: sp.Basic) -> str: ...


def _printer() -> _Printer:
    return cast(_Printer, import_module("chaplygin.printing.system"))


def formula_latex(formula: sp.Basic) -> str:
    """LaTeX of a formula, for SymPy's own printer, which notebooks call."""
    return cast(_FormulaPrinter, import_module("chaplygin.printing.formula")).latex(formula)


class Displayed:
    """A value with text, LaTeX and HTML."""

    def latex(self) -> str:
        """The equations of motion as a LaTeX ``aligned`` environment."""
        return _printer().system_latex(self)

    def __repr__(self) -> str:
        return _printer().system_line(self)

    def __str__(self) -> str:
        return _printer().system_text(self)

    def _repr_latex_(self) -> str:
        return f"$\\displaystyle {self.latex()}$"

    def _repr_html_(self) -> str:
        return _printer().system_html(self)
