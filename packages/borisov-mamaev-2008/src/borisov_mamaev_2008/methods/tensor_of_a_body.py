"""Restriction of the moments of inertia of a system to those of a body."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from flowlanes.system.system import System


def with_tensor_of_a_body(system: System, moments: tuple[sp.Symbol, ...]) -> System:
    """The system with the triangle inequalities for its moments of inertia.

    Parameters
    ----------
    system : System
    moments : 3 Symbols
        Three parameters, of which two may coincide; for a ball also I + mR², which satisfies the
        inequalities if I does.
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
