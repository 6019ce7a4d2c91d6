"""Write the tables of an experiment file that describe a given System."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import fields

import sympy as sp

from flowlanes.errors import InputError
from flowlanes.parsing import FUNCTIONS, Formula, NamedQuantity
from flowlanes.parsing.exact_decimals import with_exact_decimals
from flowlanes.system.laws import Integral, Measure, Symmetry
from flowlanes.system.system import System
from flowlanes.system.vectors import Vector, to_components
from nonholonomic.mechanics.lagrangian.plan import Plan

from .file.toml import Tables

_WRITABLE = (
    *(sp.Symbol, sp.Add, sp.Mul, sp.Pow, sp.Rational, sp.Float),
    *(function for function in FUNCTIONS.values() if isinstance(function, type)),
)
_CONSTANTS = (sp.pi,)


def tables_of(system: System) -> Tables:
    """The tables of a file with the same equations, lifted to space.

    Integrals, measures and symmetries are included; other laws have no form in a file.

    Raises
    ------
    InputError
        If a formula uses what no file can say, such as a function that it does not know.
    """
    whole = system.lifted() if system.reconstruction else system
    tables: Tables = {"title": whole.title, "summary": whole.summary}
    tables["parameters"] = {
        str(p.symbol): {"value": float(p.default), "unit": p.unit, "meaning": p.meaning}
        for p in whole.parameters
    }
    tables["equations"] = {
        "state": [_declaration(name) for name in whole.state],
        "rates": {str(name): _formula_text(rate) for name, rate in whole.field},
        "relations": _all(whole.relations),
    }
    tables["definitions"] = {
        str(symbol): _formula_text(value) for symbol, value in whole.scalar_definitions
    }
    tables["laws"] = _laws(whole)
    tables["observables"] = {
        item.name: {"value": _formula_text(item.value), "meaning": item.meaning, "unit": item.unit}
        for item in whole.observables
        if item.name not in map(str, whole.state)
    }
    tables["guards"] = {
        guard.name: {"value": _formula_text(guard.value), "message": guard.message}
        for guard in whole.guards
    }
    return tables


def plan_table_of(plan: Plan) -> Tables:
    """The table [plan] of a file with the same drawing."""
    tables = {
        field.name: [_all(part) for part in getattr(plan, field.name)]
        for field in fields(plan)
        if field.name != "path"
    }
    return {"path": _all(plan.path), **tables}


def _laws(system: System) -> Tables:
    integrals, measures, symmetries = {}, {}, {}
    for law in system.laws:
        on = _all(law.on)
        if isinstance(law, Integral):
            notes = {"meaning": law.meaning, "unit": law.unit, "on": on}
            integrals[law.name] = {"value": _formula_text(law.value), **notes}
        elif isinstance(law, Measure):
            measures[law.name] = {
                "value": _formula_text(law.value),
                "meaning": law.meaning,
                "on": on,
            }
        elif isinstance(law, Symmetry) and not on:
            symmetries[law.name] = {str(name): _formula_text(value) for name, value in law.field}
    return {"integrals": integrals, "measures": measures, "symmetries": symmetries}


def _declaration(name: NamedQuantity) -> str:
    return f"{name}[{len(name.symbols)}]" if isinstance(name, Vector) else str(name)


def _all(formulas: Iterable[Formula]) -> list[str]:
    return [_formula_text(formula) for formula in formulas]


def _formula_text(formula: Formula) -> str:
    """A formula as a user would type it, with exact numbers."""
    value = to_components(sp.sympify(formula))
    if isinstance(value, sp.MatrixBase):
        return f"[{', '.join(map(_formula_text, value))}]"
    for part in sp.preorder_traversal(value):
        if not isinstance(part, _WRITABLE) and part not in _CONSTANTS:
            raise InputError(f"{type(part).__name__} in {formula} cannot be written to a file")
    words = str(sp.sstr(with_exact_decimals(value)))
    # Some SymPy names differ in a file.
    return re.sub(r"\b(Abs|Max|Min)\(", lambda match: match.group().lower(), words)
