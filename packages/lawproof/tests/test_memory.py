"""Functions that remember their results, and proofs of systems that cannot be hashed."""

from __future__ import annotations

import sympy as sp

import flowlanes
import lawproof
from flowlanes.memory import memory


def test_errors_are_not_kept() -> None:
    calls = []

    @memory(2)
    def inverse(number: int) -> float:
        calls.append(number)
        return 1 / number

    for _ in range(2):
        try:
            inverse(0)
        except ZeroDivisionError:
            continue
    assert calls == [0, 0]
    assert inverse(2) == inverse(2) == 0.5
    assert calls == [0, 0, 2]


def test_a_system_with_lists_is_proved_and_refuted() -> None:
    x, y = sp.symbols("x y", real=True)
    laws = [
        flowlanes.Integral("energy", x**2 + y**2),
        flowlanes.Integral("wrong", x),
        flowlanes.Integral("half", y),
    ]
    system = flowlanes.System("wheel", "Wheel", {x: y, y: -x}, relations=[], laws=laws)
    decisions = [verdict.decision for verdict in lawproof.prove_all(system)]
    assert decisions == ["proven", "refuted", "refuted"]
