"""Compiled code on disk: found again, never trusted when others could have written it."""

from __future__ import annotations

import errno
import os
import pickle
import subprocess
import sys
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import platformdirs
import pytest
import sympy as sp

from flowlanes.files import cache as core_cache, private_files
from flowlanes.flow.integrator import integrate
from flowlanes.flow.machine_code import code_cache as cache
from flowlanes.flow.taylor.compiled_system import compile_system
from flowlanes.system.laws import Integral
from flowlanes.system.system import Guard, Observable, Parameter, System
from needs import needs

x, y, p, q = sp.symbols("x y p q", real=True)

OSCILLATOR = System(
    name="oscillator",
    title="Oscillator",
    parameters=(Parameter(p, "square of the frequency", 1.0),),
    field={x: y, y: -p * x},
    laws=(Integral("energy", y**2 + p * x**2, "energy"),),
    observables=(Observable("place", x, "place"),),
    guards=(Guard("near", 100 - x, "it went too far"),),
)


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """An empty cache of the test's own."""
    chosen = tmp_path / "code"
    monkeypatch.setenv("FLOWLANES_CACHE", str(chosen))
    return chosen


@pytest.fixture
def place(folder, monkeypatch):
    """The same without what this process has at hand, so that files alone count."""
    monkeypatch.setattr(cache, "_file_version", lambda path: object())
    return folder


def entries(folder: Path) -> list[Path]:
    return sorted(folder.iterdir())


def remember(name: str = "name", value: object = (1, 2)) -> tuple[object, bool]:
    return cache.cached_entry(name, lambda: value)


def test_the_variable_chooses_the_folder(place):
    assert core_cache.folder() == place
    remember()
    assert entries(place) == [place / "name.code"]


@pytest.mark.parametrize("value", [None, ""])
def test_without_the_variable_it_is_the_users_own(monkeypatch, value):
    if value is None:
        monkeypatch.delenv("FLOWLANES_CACHE", raising=False)
    else:
        monkeypatch.setenv("FLOWLANES_CACHE", value)
    assert core_cache.folder() == Path(platformdirs.user_cache_dir("flowlanes"))


def test_an_entry_is_made_once(place):
    assert remember() == ((1, 2), False)
    assert remember(value="not made") == ((1, 2), True)
    assert remember("another", 3) == (3, False)


def test_only_the_user_may_look_into_the_folder(place):
    remember()
    assert place.stat().st_mode & 0o777 == 0o700
    assert (place / "name.code").stat().st_mode & 0o077 == 0


@pytest.mark.slow
def test_a_second_process_finds_the_code(place):
    program = (
        "import sympy as sp\n"
        "from flowlanes.flow.taylor.compiled_system import compile_system\n"
        "from flowlanes.system.system import System\n"
        "x, y = sp.symbols('x y', real=True)\n"
        "print(compile_system(System('pendulum', 'P', {x: y, y: -sp.sin(x)})).from_cache)\n"
    )
    found = [
        subprocess.run(
            [sys.executable, "-c", program], check=True, capture_output=True, text=True
        ).stdout
        for _ in range(2)
    ]
    assert found == ["False\n", "True\n"]


def test_an_entry_appears_complete_or_not_at_all(place, monkeypatch):
    remember("reference")
    size = (place / "reference.code").stat().st_size
    seen = []

    def watch(source: Path, target: Path) -> None:
        seen.append((source.parent, source.stat().st_size, target.exists()))
        os.replace(source, target)  # noqa: PTH105

    monkeypatch.setattr(Path, "replace", watch)
    remember()
    assert seen == [(place, size, False)]
    assert entries(place) == [place / "name.code", place / "reference.code"]


def test_nothing_is_left_when_the_disk_is_full(place, monkeypatch):
    place.mkdir(mode=0o700)

    def refuse(source: Path, target: Path) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(Path, "replace", refuse)
    assert remember() == ((1, 2), False)
    assert entries(place) == []


def flip(position: float):
    def damage(content: bytes) -> bytes:
        index = int(position * (len(content) - 1))
        return content[:index] + bytes([content[index] ^ 0x10]) + content[index + 1 :]

    return damage


DAMAGE = {
    "empty": lambda content: b"",
    "cut to one byte": lambda content: content[:1],
    "cut in its seal": lambda content: content[:20],
    "cut after its seal": lambda content: content[:32],
    "cut in half": lambda content: content[: len(content) // 2],
    "cut by one byte": lambda content: content[:-1],
    "longer": lambda content: content + b"\0",
    "something else": lambda content: b"not code" * 100,
    "a bare pickle": lambda content: pickle.dumps((1, 2)),
    **{f"bit flipped at {at:g}": flip(at) for at in (0.0, 0.3, 0.5, 0.7, 0.9, 1.0)},
}


@pytest.mark.parametrize("name", DAMAGE)
def test_a_damaged_entry_is_compiled_again(place, name):
    before = integrate(OSCILLATOR, [1, 0], [0, 1])
    (path,) = entries(place)
    content = path.read_bytes()
    path.write_bytes(DAMAGE[name](content))
    assert path.read_bytes() != content
    again = integrate(OSCILLATOR, [1, 0], [0, 1])
    assert not again.statistics.from_cache
    assert again.states.tolist() == before.states.tolist()
    assert integrate(OSCILLATOR, [1, 0], [0, 1]).statistics.from_cache


@pytest.mark.parametrize("mode", [0o770, 0o720, 0o702, 0o777])
def test_a_folder_that_others_can_write_is_not_used(place, mode):
    remember()
    place.chmod(mode)
    assert remember(value="made anew") == ("made anew", False)
    assert remember("another") == ((1, 2), False)
    assert entries(place) == [place / "name.code"]


@pytest.mark.parametrize("mode", [0o620, 0o602])
def test_an_entry_that_others_can_write_is_not_used(place, mode):
    remember()
    (place / "name.code").chmod(mode)
    assert remember(value="made anew") == ("made anew", False)
    # it was replaced by one that can be trusted
    assert remember() == ("made anew", True)


def test_a_folder_of_somebody_else_is_not_used(place, monkeypatch):
    remember()
    owner = os.geteuid()
    monkeypatch.setattr(os, "geteuid", lambda: owner + 1)
    assert remember(value="made anew") == ("made anew", False)
    assert remember("another") == ((1, 2), False)
    assert entries(place) == [place / "name.code"]


def test_a_folder_that_cannot_be_made_is_no_error(tmp_path, monkeypatch):
    obstacle = tmp_path / "file"
    obstacle.write_text("")
    monkeypatch.setenv("FLOWLANES_CACHE", str(obstacle / "code"))
    assert remember() == ((1, 2), False)
    # what is at hand serves without a file
    assert remember() == ((1, 2), True)


def test_a_folder_that_cannot_be_written_is_no_error(place, monkeypatch):
    place.mkdir(mode=0o700)

    def refuse(*_: object) -> None:
        raise PermissionError(errno.EACCES, "Permission denied")

    monkeypatch.setattr(private_files, "partial_file", refuse)
    assert remember() == ((1, 2), False)
    assert entries(place) == []


def test_the_oldest_entries_go(place, monkeypatch):
    monkeypatch.setattr(cache, "_STORED", 3)
    now = time.time()
    for age, name in ((40, "a"), (30, "b"), (20, "c")):
        remember(name)
        os.utime(place / f"{name}.code", (now - age, now - age))
    remember("a")  # used again, and so the youngest
    remember("d")
    assert [path.stem for path in entries(place)] == ["a", "c", "d"]


def observed_and_guarded(system: System) -> System:
    """The same formulas in the same order, a law and a guard turned into observables."""
    law, guard = system.laws[0], system.guards[0]
    return replace(
        system,
        laws=(),
        observables=(
            Observable("law", law.value, ""),
            *system.observables,
            Observable("guard", guard.value, ""),
        ),
        guards=(),
    )


OTHERS = {
    "another rate": replace(OSCILLATOR, field={x: y, y: -p * x * 2}),
    "a sign": replace(OSCILLATOR, field={x: y, y: p * x}),
    "another law": replace(OSCILLATOR, laws=(Integral("energy", y**2, ""),)),
    "another observable": replace(OSCILLATOR, observables=(Observable("place", 2 * x, ""),)),
    "another guard": replace(OSCILLATOR, guards=(Guard("near", 50 - x, ""),)),
    "another parameter": replace(
        OSCILLATOR,
        parameters=(Parameter(q, "", 1.0), *OSCILLATOR.parameters),
    ),
    "a relation": replace(OSCILLATOR, relations=(x**2 + y**2 - 1,)),
    "a definition": replace(OSCILLATOR, definitions={q: x}),
    "law and guard only observed": observed_and_guarded(OSCILLATOR),
}


@pytest.mark.parametrize("name", OTHERS)
def test_other_formulas_are_other_code(place, name):
    assert not compile_system(OSCILLATOR).from_cache
    assert compile_system(OSCILLATOR).from_cache
    assert not compile_system(OTHERS[name]).from_cache


def test_the_last_digit_of_a_decimal_counts(place):
    def system(decimal: float) -> System:
        return System(name="linear", title="", field={x: sp.Float(decimal) * x})

    assert not compile_system(system(0.3)).from_cache
    assert not compile_system(system(0.1 + 0.2)).from_cache
    assert compile_system(system(0.3)).from_cache


@needs("heyoka")
def test_tolerance_precision_and_direction_are_other_code(place):
    assert not compile_system(OSCILLATOR, 1e-15).from_cache
    assert not compile_system(OSCILLATOR, 1e-12).from_cache
    assert not compile_system(OSCILLATOR, 1e-15, "quad").from_cache
    assert not compile_system(OSCILLATOR, 1e-15, "double", "backward").from_cache
    assert len(entries(place)) == 4
    assert compile_system(OSCILLATOR, 1e-12).from_cache


def test_words_do_not_count(place):
    assert not compile_system(OSCILLATOR).from_cache
    assert compile_system(replace(OSCILLATOR, name="other", title="Other", source="(1)")).from_cache


def test_parameters_share_the_code(place):
    assert not compile_system(OSCILLATOR).from_cache
    other = replace(OSCILLATOR, parameters=(Parameter(p, "square of the frequency", 4.0),))
    times = np.linspace(0, 1, 5)
    for motion, frequency in (
        (integrate(OSCILLATOR, [1, 0], times), 1),
        (integrate(other, [1, 0], times), 2),
        (integrate(OSCILLATOR, [1, 0], times, parameters={p: 9.0}), 3),
    ):
        assert motion.statistics.from_cache
        assert motion["x"] == pytest.approx(np.cos(frequency * times), abs=2e-15)
    assert len(entries(place)) == 1


def test_an_entry_at_hand_is_not_read_again(folder, monkeypatch):
    made, found = remember()
    assert not found
    monkeypatch.setattr(private_files, "read_private", lambda path: pytest.fail("it was read"))
    again, found = remember(value=(3, 4))
    assert found
    assert again is made


def test_an_entry_at_hand_yields_to_a_newer_file(folder):
    remember()
    assert remember(value=(3, 4)) == ((1, 2), True)
    (folder / "name.code").unlink()
    assert remember(value=(5, 6)) == ((5, 6), False)


def test_few_entries_are_at_hand(folder):
    for number in range(3 * cache._IN_MEMORY):
        remember(f"name{number}", number)
    assert len(cache._in_memory) <= cache._IN_MEMORY
