"""What a System says in many states, compiled once, and how it changes along the motion."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import sympy as sp
from hypothesis import strategies as st

from flowlanes.system.system import System
from flowlanes.system.vectors import Vector, to_components

GIVEN = ("omega", "gamma", "zeta", "r")

coordinates = st.tuples(*[st.floats(-1.0, 1.0, width=32)] * 3).map(np.array)
directions = coordinates.filter(lambda v: v @ v > 0.04).map(lambda v: v / np.linalg.norm(v))


class Portrait:
    """The rates, relations, definitions, observables and laws of a system, by name.

    Parameters
    ----------
    system : System
    further : mapping of str to formula, optional
        To be told as well.
    """

    def __init__(self, system: System, further: Mapping[str, Any] | None = None) -> None:
        self.system = system
        told = {f"rate of {name}": rate for name, rate in system.field}
        told |= {f"relation {i}": relation for i, relation in enumerate(system.relations)}
        told |= {str(name): name for name in system.state}
        told |= {str(name): name for name, _ in system.definitions}
        told |= {item.name: item.value for item in system.observables}
        told |= {law.name: law.value for law in system.laws}
        told |= further or {}
        self.parts = {name: _entries(value) for name, value in told.items()}
        self.told = self._compile(
            system.symbols, [entry for part in self.parts.values() for entry in part]
        )
        self.spins = [s for name in GIVEN for s in Vector(name).symbols if self._is_given(name)]
        self.momenta = self._compile(
            self.spins,
            [e for _, formula in system.conventions.start_formulas for e in to_components(formula)],
        )

    def _is_given(self, name: str) -> bool:
        """Whether a start may name it: omega always, the rest unless it follows from the state."""
        return name == "omega" or all(name != str(known) for known, _ in self.system.definitions)

    def _compile(self, symbols: Sequence[sp.Symbol], formulas: list[sp.Expr]) -> Any:
        names = [*self.system.defaults, *symbols]
        steps = list(self.system.required_definitions(formulas, inputs=names))
        return sp.lambdify(names, formulas, "numpy", cse=lambda e: (steps, e))

    def _constants(self, parameters: Mapping[str, float]) -> list[float]:
        return [parameters.get(str(s), value) for s, value in self.system.defaults.items()]

    def state(self, parameters: Mapping[str, float] | None = None, **given: Any) -> np.ndarray:
        """The state with given ``omega``, ``gamma`` or ``r``, and ``zeta``."""
        values = {
            symbol: x
            for name in GIVEN
            for symbol, x in zip(Vector(name).symbols, given.get(name, np.zeros(3)), strict=True)
        }
        constants = self._constants(parameters or {})
        momenta = self.momenta(*constants, *(values[s] for s in self.spins))
        names = [s for name, _ in self.system.conventions.start_formulas for s in name.symbols]
        values |= dict(zip(names, momenta, strict=True))
        return np.array([values[s] for s in self.system.symbols])

    def at(
        self, state: np.ndarray, parameters: Mapping[str, float] | None = None
    ) -> dict[str, np.ndarray]:
        """Everything in one state; an array for each name."""
        numbers = iter(self.told(*self._constants(parameters or {}), *state))
        return {name: np.array([next(numbers) for _ in part]) for name, part in self.parts.items()}

    def along(self, state: np.ndarray) -> dict[str, np.ndarray]:
        """Rates of change of everything along the motion, by an imaginary step."""
        here = self.at(state)
        velocity = np.concatenate([here[f"rate of {name}"] for name in self.system.state])
        step = 1e-30
        return {k: v.imag / step for k, v in self.at(state + 1j * step * velocity).items()}


def _entries(value: Any) -> list[sp.Expr]:
    parts = to_components(value)
    return list(parts) if isinstance(parts, sp.MatrixBase) else [parts]
