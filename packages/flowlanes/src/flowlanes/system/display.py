"""Display of systems and formulas by printers that are registered from outside."""

from __future__ import annotations

from typing import Protocol, cast

import sympy as sp

from ..displays import printers


class _Printer(Protocol):
    def system_line(self, system: Displayed) -> str: ...

    def system_text(self, system: Displayed) -> str: ...

    def system_latex(self, system: Displayed) -> str: ...

    def system_html(self, system: Displayed) -> str: ...


class _FormulaPrinter(Protocol):
    def latex(self, formula: sp.Basic) -> str: ...


class _Printers(Protocol):
    @property
    def system(self) -> _Printer: ...

    @property
    def formula(self) -> _FormulaPrinter: ...


def _printers() -> _Printers:
    return cast(_Printers, printers())


def formula_latex(formula: sp.Basic) -> str:
    """LaTeX of a formula, called by SymPy's own printer in notebooks."""
    return _printers().formula.latex(formula)


class Displayed:
    """Mixin with text, LaTeX and HTML representations."""

    def latex(self) -> str:
        """The equations of motion as a LaTeX ``aligned`` environment."""
        return _printers().system.system_latex(self)

    def __repr__(self) -> str:
        return _printers().system.system_line(self)

    def __str__(self) -> str:
        return _printers().system.system_text(self)

    def _repr_latex_(self) -> str:
        return f"$\\displaystyle {self.latex()}$"

    def _repr_html_(self) -> str:
        return _printers().system.system_html(self)
