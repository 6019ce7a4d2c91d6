"""The reaction forces determined by auxiliary speeds of a Kane model.

An auxiliary speed is zero; its equation F + F* + Σ λ_μ ∂f_μ/∂u = 0 contains unknown forces among
the loads. The last term is the reaction of the velocity constraints f that contain the speed.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp
from sympy.core.function import AppliedUndef
from sympy.physics.mechanics import KanesMethod

from flowlanes.errors import InputError

from .names import Inputs


def auxiliary_reactions(
    name: str,
    free: KanesMethod,
    absent: Mapping[sp.Expr, int],
    work: Sequence[sp.Expr],
    moving: Sequence[sp.Expr],
    inputs: Inputs,
) -> dict[sp.Expr, sp.Expr]:
    """Unknown forces among the loads, solved from the equations of the auxiliary speeds.

    Parameters
    ----------
    work : sequence of Expr
        λ_μ ∂f_μ/∂u of each auxiliary speed u, of the velocity constraints f.

    Raises
    ------
    InputError
        If these equations do not determine them.
    """
    if not absent:
        return {}
    laws = [e.xreplace(dict(absent)) for e in free.auxiliary_eqs]
    prescribed = {str(getattr(key, "func", key)) for key in inputs}
    functions = {f for law in laws for f in law.atoms(AppliedUndef)} - set(moving)
    unknown = sorted((f for f in functions if str(f.func) not in prescribed), key=str)
    equations = [law + part.xreplace(dict(absent)) for law, part in zip(laws, work, strict=True)]
    matrix, right = sp.linear_eq_to_matrix(equations, unknown)
    if len(unknown) != len(laws) or matrix.det() == 0:
        words = ", ".join(map(str, unknown)) or "none"
        raise InputError(
            f"{name}: {len(laws)} auxiliary speed{'s' * (len(laws) > 1)} should bring out as many "
            f"unknown forces of the loads, but do not determine them: unknown are {words}; "
            "give a load for each auxiliary speed, and known functions of time in 'inputs'"
        )
    return dict(zip(unknown, matrix.LUsolve(right), strict=True))
