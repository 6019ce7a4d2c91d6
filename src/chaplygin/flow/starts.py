"""Many starts at once, from what is said of them by name."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import lru_cache
from typing import Any

import numpy as np
import sympy as sp

from ..errors import InputError
from ..system import System, flat
from ..vectors import Vector
from .values import values

__all__ = ["flat_starts"]

omega, gamma = Vector("omega"), Vector("gamma")


def flat_starts(
    system: System, given: Mapping[str, Any], parameters: Mapping[str, Any] | None = None
) -> Any:
    """States in flat order.

    Parameters
    ----------
    system : System
    given : mapping of str to array
        ``state`` (n, size), the whole state; or variables of the state, (n, components) for
        vectors and (n,) for scalars, or single components; or ``omega`` and ``gamma``, (n, 3) in
        body axes, from which the system says how the state follows (γ is normalised then).
    parameters : mapping of str to number or array (n,), optional
        Values that replace the defaults.

    Returns
    -------
    array (n, size)

    Raises
    ------
    InputError
        If a name is unknown, a shape is wrong, or something of the state is not given.
    """
    if set(given) == {"state"}:
        return _shaped(system, "state", given["state"], len(system.symbols))
    if "omega" in given and ("gamma" in given or omega not in system.state):
        return _placed(system, _of_spin(system, given, parameters))
    return _placed(system, given)


def _placed(system: System, given: Mapping[str, Any]) -> Any:
    """The columns of the state, from variables and components by name."""
    columns: dict[str, Any] = {}
    variables = {str(v): v for v in system.state}
    components = {str(s): s for s in system.symbols}
    for name, array in given.items():
        if name in variables:
            symbols = flat([variables[name]])
            block = _shaped(system, name, array, len(symbols))
            columns |= {str(s): block[:, i] for i, s in enumerate(symbols)}
        elif name in components:
            columns[name] = _shaped(system, name, array, 1)[:, 0]
        else:
            known = ", ".join([*variables, *(str(p.symbol) for p in system.parameters)])
            raise InputError(f"{system.name}: there is no {name}; it has {known}")
    missing = [name for name in components if name not in columns]
    if missing:
        raise InputError(f"{system.name}: the start does not tell {', '.join(missing)}")
    return np.column_stack([columns[name] for name in components])


def _shaped(system: System, name: str, array: Any, size: int) -> Any:
    """An array (n, size); scalars may be (n,)."""
    block = np.asarray(array, dtype=float)
    if size == 1 and block.ndim == 1:
        return block[:, np.newaxis]
    if block.ndim != 2 or block.shape[1] != size:
        raise InputError(
            f"{system.name}: each row of {name} has the shape {block.shape[1:]}; "
            f"({size},) is needed"
        )
    return block


def _of_spin(
    system: System, given: Mapping[str, Any], parameters: Mapping[str, Any] | None
) -> dict[str, Any]:
    """The variables of the state that follow from ω and γ, and those that are given besides."""
    if not system.start and omega not in system.state:
        raise InputError(f"{system.name}: its state does not follow from omega; give the state")
    if "gamma" not in given:
        raise InputError(f"{system.name}: omega is given, but gamma is not")
    turning = _shaped(system, "omega", given["omega"], 3)
    normal = _shaped(system, "gamma", given["gamma"], 3)
    lengths = np.linalg.norm(normal, axis=1, keepdims=True)
    if not np.all(lengths > 0):
        raise InputError(f"{system.name}: gamma is zero: it must point along the normal")
    points = np.column_stack([turning, normal / lengths])
    auxiliary, symbols = _spinning(system)
    found = values(auxiliary, symbols, points, parameters)
    following = {str(s): found[:, i] for i, s in enumerate(symbols)}
    others = {name: array for name, array in given.items() if name not in ("omega", "gamma")}
    kept = {
        str(name): block
        for name, block in ((omega, points[:, :3]), (gamma, points[:, 3:]))
        if name in system.state
    }
    return {**following, **kept, **others}


@lru_cache(maxsize=16)
def _spinning(system: System) -> tuple[System, tuple[sp.Symbol, ...]]:
    """ω and γ as a state of their own, in which the variables that follow are definitions."""
    state: Sequence[Any] = (omega, gamma)
    still = {name: sp.ImmutableMatrix([0, 0, 0]) for name in state}
    known = flat(state)
    formulas = [formula for _, formula in system.start]
    before = system.needed(formulas, known)
    auxiliary = System(
        system.name,
        system.title,
        still,
        system.parameters,
        definitions=(*before, *system.start),
    )
    return auxiliary, flat([name for name, _ in system.start])
