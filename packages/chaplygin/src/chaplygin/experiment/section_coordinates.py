"""Default coordinates in which a section is drawn."""

from __future__ import annotations

import numpy as np
import sympy as sp

from flowlanes.errors import InputError
from flowlanes.flow.sections.poincare_dataset import Quantity
from flowlanes.formulas.array_evaluation import values
from flowlanes.scans.state_coordinates import chart
from flowlanes.system.named_formulas import scalars
from flowlanes.system.system import System
from flowlanes.system.vectors import Vector

#: Number of states at which a variable is tested for being an angle.
_TRIALS = 5
_ROUNDING = 1e-9


def usual(system: System, condition: str = "") -> str:
    """Two or three coordinates in the syntax of ``--coordinates``.

    Andoyer's variables l and L/G for a momentum and γ; otherwise the longitude of γ and the third
    component of the other vector; otherwise the first variables of the state. There are three if
    the points of one level fill a volume.

    Parameters
    ----------
    system : System
    condition : str
        The quantity that defines the section, which is not used as a coordinate.
    """
    conditions = len(system.relations) + sum(not law.level for law in system.integrals)
    spatial = len(system.symbols) - conditions - 1 > 2
    if _has_andoyer(system):
        first = (
            "l, g"
            if condition.endswith("_3") and not condition.startswith(("g", "G"))
            else "l, L/G"
        )
        return f"andoyer-ratio: {first}{', H' if spatial else ''}"
    vectors = [name for name in system.state if isinstance(name, Vector)]
    gamma = next((v for v in vectors if v.name in ("gamma", "Gamma") and len(v.symbols) == 3), None)
    others = [str(v.symbols[2]) for v in vectors if v is not gamma and len(v.symbols) == 3]
    if gamma is not None and others:
        one, two, three = gamma.symbols
        heights = [name for name in (*others, str(three)) if name != condition]
        listed = [f"phi = atan2({two}, {one})", *heights]
        return ", ".join(listed[: 3 if spatial else 2])
    listed = [str(symbol) for symbol in system.symbols if str(symbol) != condition]
    return ", ".join(listed[: 3 if spatial else 2])


def _has_andoyer(system: System) -> bool:
    try:
        chart(system, "andoyer-ratio")
    except InputError:
        return False
    return True


def is_angle(system: System, symbol: sp.Symbol) -> bool:
    """Whether a variable enters the equations of motion only as an angle."""
    rates = [entry for _, rate in system.field for entry in scalars(rate)]
    place = system.symbols.index(symbol)
    states = np.random.default_rng(0).uniform(0.2, 1.1, (_TRIALS, len(system.symbols)))

    def shifted_by(by: float) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
        there = states.copy()
        there[:, place] += by
        return np.asarray(values(system, rates, there), dtype=np.float64)

    here, turned, elsewhere = shifted_by(0.0), shifted_by(2 * np.pi), shifted_by(1.0)
    near = _ROUNDING * (1.0 + np.abs(here))
    same = np.isfinite(here).all() and np.all(np.abs(turned - here) < near)
    return bool(same and np.any(np.abs(elsewhere - here) > near))


def within_a_turn(symbol: sp.Symbol, description: tuple[str, str] | None = None) -> Quantity:
    """An angle of the state between −π and π."""
    meaning = description[0] if description and description[0] else str(symbol)
    value = sp.atan2(sp.sin(symbol), sp.cos(symbol))
    return Quantity(f"{symbol}_in_turn", value, f"{meaning}, within a turn", "rad", str(symbol))
