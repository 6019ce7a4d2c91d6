"""Restrict the moments of inertia of a system to those of a body (triangle inequalities)."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from flowlanes.system.system import System


def with_tensor_of_a_body(system: System, moments: tuple[sp.Symbol, ...]) -> System:
    """The system with its moments of inertia restricted to those that a body can have.

    Parameters
    ----------
    system : System
    moments : 3 Symbols
        Parameters, of which two may be the same; for a ball also I + mR², as these have the
        property if the moments I have it.
    """
    conditions = {
        own: own <= sp.Add(*moments[:i], *moments[i + 1 :]) for i, own in enumerate(moments)
    }
    parameters = tuple(
        replace(p, admissible=(*p.admissible, conditions[p.symbol]))
        if p.symbol in conditions
        else p
        for p in system.parameters
    )
    return replace(system, parameters=parameters)
