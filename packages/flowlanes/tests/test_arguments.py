"""What annotations allow, in words and in values, and names that only type checkers import."""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from types import ModuleType
from typing import Any, Literal

import numpy as np
import numpy.typing as npt
import pytest
import sympy as sp

from flowlanes.argument_kinds import kind_of
from flowlanes.arguments import Positive, Start, arguments_checked
from flowlanes.errors import InputError

#: An annotation, its words, values that it allows, and values that it does not.
KINDS: tuple[tuple[Any, str, list[Any], list[Any]], ...] = (
    (float, "a number", [1, 2.5, np.float32(1), sp.Rational(1, 2)], ["1", True, None, [1], 1j]),
    (int, "a whole number", [3, np.int64(3)], [3.0, True, "3"]),
    (bool, "True or False", [True, np.True_], [1, "yes"]),
    (str | None, "a text or None", ["x", None], [b"x", 1]),
    (Path, "a path", [Path()], ["x"]),
    (Literal["a", 1], "'a' or 1", ["a", 1], ["b", True, 1.0]),
    (tuple[float, float, float], "three numbers", [(1, 2, 3), [1, 2, 3], np.ones(3)], [3, "abc"]),
    (Sequence[str], "a sequence of texts", [["x"], ()], ["x", [*"xy", 1]]),
    (Mapping[str, float], "a mapping of names to numbers", [{"x": 1}], [[("x", 1)], {"x": "1"}]),
    (npt.NDArray[np.float64], "an array of numbers", [np.ones(2)], [[1.0], np.array(["x"])]),
    (
        npt.ArrayLike,
        "numbers in an array or in nested sequences",
        [1.0, [[1], [2]], np.ones((2, 2))],
        ["x", [[1], [2, 3]], None],
    ),
    (sp.Expr, "a SymPy expression", [sp.Symbol("x"), 2], ["x"]),
    (Callable[[int], int], "a function", [abs], [1]),
    (type[int], "a class", [int], [1]),
    (Positive, "a positive finite number", [1e-9], [0, -1, float("inf")]),
    (Start, "a state: numbers in order, or numbers by name in a mapping", [{"M": [1]}], [3, "x"]),
)


def test_what_annotations_allow() -> None:
    for annotation, words, allowed, others in KINDS:
        kind = kind_of(annotation)
        assert kind is not None
        assert kind.words == words
        wrong = [value for value in allowed if not kind.fits(value)]
        wrong += [value for value in others if kind.fits(value)]
        assert not wrong, f"{words}: {wrong}"


def test_every_entry_of_a_sequence_is_looked_at() -> None:
    # a checker that draws one entry at random finds this in one call of a hundred
    kind = kind_of(Sequence[float])
    assert kind is not None
    assert not any(kind.fits([1.0] * 99 + ["x"]) for _ in range(5))


def test_a_class_that_only_type_checkers_import_is_known_by_its_name() -> None:
    # a module without a source, as in a program that is frozen
    module = ModuleType("without_source")
    sys.modules[module.__name__] = module
    text = "def f(client: 'lib.Client | int | None', *, frame: 'Frame[int]'): return 'called'"
    exec(text, vars(module))
    f = arguments_checked(module.f)
    Client, Frame = type("Client", (), {}), type("Frame", (), {})
    derived = type("Derived", (Client,), {})
    assert {f(client, frame=Frame()) for client in (Client(), derived(), 1, None)} == {"called"}
    with pytest.raises(InputError, match="f: client must be a Client, a whole number or None, not"):
        f("here", frame=Frame())
    with pytest.raises(InputError, match="f: frame must be a Frame, not 1"):
        f(None, frame=1)
    del sys.modules[module.__name__]


def test_a_tool_leaves_values_as_they_are() -> None:
    numbers = [1, sp.Integer(2)]

    @arguments_checked
    def same(values: Sequence[float]) -> Any:
        return values

    assert same(numbers) is numbers
