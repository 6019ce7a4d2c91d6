"""§12: enough independent integrals for the theorem of Euler and Jacobi."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp

from chaplygin.vectors import explicit
from systems import built


@pytest.mark.parametrize(
    ("name", "cyclic"), [("ball-bearing", 0), ("straight-line-ball", 1), ("disk-on-ice", 0)]
)
def test_integrals_leave_two_dimensions(name: str, cyclic: int) -> None:
    """Relations and integrals are independent; the place along the line is a cyclic variable."""
    made = built.study(name)
    system = made.system
    state = list(system.symbols)
    functions = [explicit(law.value) for law in system.integrals]
    functions += [explicit(relation) for relation in system.relations]
    if name == "ball-bearing":
        # angles between the supports are constant too
        alpha, beta, gamma = (np.array(v.symbols) for v in system.state[1:])
        functions += [u @ v for u, v in ((alpha, beta), (beta, gamma), (gamma, alpha))]
    numbers = {**system.defaults, **dict(zip(state, map(float, made.start), strict=False))}
    flat = {}
    for symbol, value in system.steps:
        flat[symbol] = value.xreplace(flat)
    slopes = [
        [float(sp.diff(f.xreplace(flat), s).xreplace(numbers)) for s in state] for f in functions
    ]
    independent = int(np.linalg.matrix_rank(np.array(slopes), tol=1e-9))
    assert independent == len(functions)
    assert len(state) - independent - cyclic == 2
