"""SciPy: DOP853 and LSODA, one trajectory after another."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp

from .bodies import Body
from .generated import defined, field_text
from .programs import Program, Run

__all__ = ["scipy_method"]


def scipy_method(body: Body, until: float, method: str) -> Program:
    """Method of `solve_ivp`; the rates are computed in Python with floats, its fastest form."""
    field: Callable[..., Any] = defined(
        field_text(body), {"sqrt": math.sqrt, "sin": math.sin, "cos": math.cos}
    )["field"]

    def rates(_: float, state: np.ndarray) -> Any:
        return field(*state.tolist())

    def build(tolerance: float) -> Run:
        exactness = {"rtol": max(tolerance, 2.3e-14), "atol": tolerance}

        def run(starts: np.ndarray) -> np.ndarray:
            found = [
                solve_ivp(rates, (0.0, until), start, method=method, **exactness).y[:, -1]
                for start in starts
            ]
            return np.array(found)

        return run

    return Program(f"SciPy {method}", build, share=0.01)
