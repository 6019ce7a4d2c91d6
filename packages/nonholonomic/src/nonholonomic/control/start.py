"""States of driven balls, given by their angular velocity."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
import sympy as sp

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.formulas.array_formulas import Formulas
from flowlanes.system.arrays import FloatArray
from flowlanes.system.system import System

from ..mechanics.lagrangian.mechanism import TIME
from .equations import A, M, b

ROUNDING = 1e-12

#: The definitions of A and b.
_MOMENTUM = frozenset({*b.symbols, *A.entries})


def is_driven(system: System) -> bool:
    """Whether M = Aω + b with the definitions of a driven ball."""
    return M in system.state and _MOMENTUM.issubset(dict(system.scalar_definitions))


@arguments_checked
def driven_state(
    system: System,
    omega: Sequence[float],
    gamma: Sequence[float],
    known: Mapping[str, float],
) -> dict[str, FloatArray | float]:
    """The state of a driven ball by name, M = Aω + b; see :func:`nonholonomic.initial_state`.

    Parameters
    ----------
    system : System
        A system of :func:`~nonholonomic.control.equations.driven_system`.
    omega, gamma : 3 numbers
        Angular velocity (rad/s) and vertical, body axes; γ is normalised.
    known : mapping of str to float
        Values of the joints, if there are any, and the time t at which the speeds of rotors and
        joints are taken (s), 0 unless it is given.

    Raises
    ------
    InputError
        If a vector is no vector, a joint is missing, ω has a part along γ that a rubber contact
        forbids, or the speeds of the rotors depend on M, which they would determine.
    """
    turn, up = _vector("omega", omega), _vector("gamma", gamma)
    length = float(np.linalg.norm(up))
    if not length > 0:
        raise InputError("gamma is zero: it must point along the vertical")
    up = up / length
    given = {str(TIME): 0.0, **known}
    names = [str(name) for name in system.state if isinstance(name, sp.Symbol)]
    if missing := [name for name in names if name not in given]:
        raise InputError(
            f"{system.name}: the joints {', '.join(missing)} need a value at the start"
        )
    if unknown := sorted(set(known) - {*names, str(TIME)}):
        raise InputError(f"{system.name}: there is no joint {', '.join(unknown)}")
    others = {name: float(given[name]) for name in names}
    state = np.array([0.0, 0.0, 0.0, *up, *others.values()])
    momentum = Formulas(system, b.symbols)
    if np.abs(momentum.slopes(state)[:, :3]).max() > 0:
        raise InputError(
            f"{system.name}: the speeds depend on M, so that omega alone does not give the start; "
            "give M"
        )
    entries = Formulas(system, list(A.entries))(state).reshape(3, 3)
    total = entries @ turn + momentum(state)
    if len(system.relations) > 1:  # rubber: M is the horizontal part
        spin = float(turn @ up)
        if abs(spin) > ROUNDING * max(1.0, float(np.abs(turn).max())):
            raise InputError(
                f"omega: (omega, gamma) = {spin:.6g}, and a ball on a rubber contact needs 0"
            )
        total = total - (total @ up) * up
    return {str(M): total, "gamma": up, **others}


def _vector(name: str, values: Sequence[float]) -> FloatArray:
    numbers = np.asarray(values, dtype=float)
    if numbers.shape != (3,) or not np.isfinite(numbers).all():
        raise InputError(f"{name}: three finite numbers are needed, not {values}")
    return numbers
