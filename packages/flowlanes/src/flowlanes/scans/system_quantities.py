"""Named quantities of a system, and their meanings."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from ..system.system import System
from ..system.vectors import Vector


def quantities_by_name(system: System) -> dict[str, sp.Expr]:
    """Scalar integrals and observables by name; integrals take precedence."""
    values = {item.name: item.value for item in system.scalar.observables}
    values |= {item.name: item.value for item in system.scalar.integrals}
    return {name: v for name, v in values.items() if not isinstance(v, sp.MatrixBase)}


def meaning(system: System, name: str, variables: Mapping[str, tuple[str, str]]) -> tuple[str, str]:
    """Meaning and unit of a parameter, component, integral or observable.

    Parameters
    ----------
    system : System
    name : str
    variables : mapping of str to (str, str)
        Meaning and unit of vectors and scalars of the state.

    Returns
    -------
    tuple of str
        Both empty if nothing is known.
    """
    text = {str(p.symbol): (p.meaning, p.unit) for p in system.parameters}
    text |= {item.name: (item.meaning, item.unit) for item in system.observables}
    text |= {item.name: (item.meaning, item.unit) for item in system.integrals}
    for vector in (*system.state, *(n for n, _ in system.definitions)):
        if isinstance(vector, Vector) and str(vector) in variables:
            of, unit = variables[str(vector)]
            for i, component in enumerate(vector.symbols, 1):
                text[str(component)] = (f"{of}, component {i}", unit)
    return text.get(name, variables.get(name, ("", "")))
