"""Experiment files, formulas, data and Python files with random damage: an answer or a sentence.

Some twenty-one thousand damaged texts and files in the slow tests, some hundreds in the others.
"""

from __future__ import annotations

import shutil
import warnings
from pathlib import Path
from random import Random

import pytest
import sympy as sp
import xarray as xr

from chaplygin.experiment.dataset import open_dataset, write_dataset
from chaplygin.experiment.models.experiment import load_experiment, parse_experiment
from chaplygin.experiment.python_file import load_python
from chaplygin.experiment.study import Study, dataset_of
from counted import task
from flowlanes.errors import LONGEST, InputError, RunError, readable
from flowlanes.flow.ensembles import zarr_store as store
from flowlanes.flow.ensembles.computation import compute
from flowlanes.parsing import parse, parse_formula
from flowlanes.system.vectors import Vector
from mutations import EXAMPLES, VALUES, check_message, damaged, mutated, within

TEXTS = [path.read_text() for path in sorted(EXAMPLES.glob("*.toml"))]
TEXTS += [parse_experiment(text).toml() for text in TEXTS[::4]]
TEXTS += [
    f'[system]\nname = "{name}"\n[run]\nuntil = 2.0\n{start}'
    for name, start in (
        ("chaplygin-ball", "[system.parameters]\nm = 2.0\n[start]\ngamma = [0.0, 0.6, 0.8]\n"),
        ("trailers", "[start]\nx = 1.0\n"),
        ("suslov", "[start]\nomega = [0.1, 0.2, 0.0]\n"),
    )
]
#: Seconds that no damaged file may take, on a busy machine.
PATIENCE = 60


def read_experiment(text: str, further: bool = False) -> None:
    """An experiment that its own text gives again, or one that is made ready; or a sentence."""
    try:
        with within(PATIENCE):
            experiment = parse_experiment(text, "body.toml")
            again = experiment.toml()
            assert parse_experiment(again) == experiment
            assert parse_experiment(again).toml() == again
            if further:
                study = Study.from_experiment(experiment)
                assert len(study.start) >= len(study.system.symbols)
                assert study.remarks is not None
                parse_experiment(study.complete_toml())
    except InputError as error:
        check_message(str(error))


def read_experiments(seed: int, count: int, further: bool = False) -> None:
    random = Random(seed)
    for _ in range(count):
        read_experiment(mutated(random.choice(TEXTS), random), further)


def test_damaged_experiments() -> None:
    read_experiments(0, 300)


def test_damaged_experiments_made_ready() -> None:
    read_experiments(3, 25, further=True)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(1, 14))
def test_many_damaged_experiments(seed: int) -> None:
    read_experiments(seed, 1000)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(100, 130))
def test_many_damaged_experiments_made_ready(seed: int) -> None:
    read_experiments(seed, 60, further=True)


@pytest.mark.slow
@pytest.mark.parametrize("value", VALUES)
def test_every_key_with_a_strange_value(value: str) -> None:
    for text in TEXTS[::5]:
        lines = text.splitlines(keepends=True)
        for place, line in enumerate(lines):
            key, equals, _ = line.partition("=")
            if equals and not line.startswith("#"):
                changed = [*lines[:place], f"{key}= {value}\n", *lines[place + 1 :]]
                read_experiment("".join(changed))


# --- what damaged files have shown -----------------------------------------------------------


@pytest.mark.parametrize("value", ["1e308", "-1e308", "1e200", "9" * 300])
def test_a_start_too_large_for_doubles_is_refused(value: str) -> None:
    """It was a traceback: the slopes of the relation are infinite, and have no inverse."""
    with pytest.raises(InputError, match="is missed by") as caught:
        _ = Study.from_experiment(
            load_experiment(EXAMPLES / "driven_pendulum.toml", [f"start.x={value}"])
        ).start
    assert "inf" not in str(caught.value)


def test_a_long_array_is_refused_at_once() -> None:
    """It took minutes: each of its elements was wrong, and the whole was written for each."""
    text = f"[frame]\ncoordinates = [{'1, ' * 20_000}]\n[lagrangian]\nL = 'x'\n"
    with within(PATIENCE / 6), pytest.raises(InputError, match=r"not \[1, 1, 1") as caught:
        parse_experiment(text, "body.toml")
    check_message(str(caught.value))


def test_an_empty_formula_is_refused() -> None:
    """It was accepted, and left out when the experiment was written."""
    text = (EXAMPLES / "volterra.toml").read_text()
    for blank in ("''", "'  '", '"\\n"'):
        with pytest.raises(InputError, match="must be a formula in quotes, not the text"):
            parse_experiment(text.replace('"1/(x*y*z)"', blank))


@pytest.mark.parametrize("character", ["\x00", "\x07", "\x1b", "\x7f", "\x9b", "\u202e", "\u200b"])
def test_control_characters_do_not_pass(character: str) -> None:
    code = f"\\u{ord(character):04x}"
    ball = (EXAMPLES / "unbalanced_ball.toml").read_text()
    changed = (
        f'title = "a{code}b"\n' + ball.replace("title", "# title"),
        ball.replace('kind = "ball"', f'kind = "ba{code}ll"'),
        ball + f'\n["ru{code}n"]\n',
        f'"bo{code}dy" = 1\n' + ball,
    )
    for text in changed:
        with pytest.raises(InputError, match="control character U") as caught:
            parse_experiment(text, "body.toml")
        check_message(str(caught.value))
    with pytest.raises(InputError) as raised:
        parse_experiment(ball, "body.toml", [f"start.{character}=1"])
    check_message(str(raised.value))


def test_messages_are_fit_for_a_terminal() -> None:
    for text in ("x" * 20_000, "line\n" * 5000, "\x1b[2J\x07\u202e\udc80\r", f"{'k' * 3000}: end"):
        check_message(str(InputError(text, text)))
        check_message(str(RunError(text, 0.0)))
    assert readable("a\x1b[31mb\r\u202e\udc80γ\n\tc") == ("a\\x1b[31mb\\r\\u202e\\udc80γ\n\\tc")
    assert readable(f"begin {'x' * 9000} end").startswith("begin xxx")
    assert readable(f"begin {'x' * 9000} end").endswith("xxx end")
    assert readable("one\n" * 3000).endswith("more lines")
    assert len(readable("one\n" * 3000)) <= LONGEST
    for text in ("", "short", "two\nlines", "x" * 500):
        assert readable(text) == text
    for text in ("x" * 20_000, "\x1b" * 3000, "line\n" * 5000):
        assert readable(readable(text)) == readable(text)


# --- formulas ----------------------------------------------------------------------------------

FORMULAS = (
    "x**4 + y**4 + z**4 - 1",
    "m*(x**2 + y**2)/2 - sqrt(z)*cos(2*pi*x)",
    "exp(-x)/(1 + y**2)**(3/2) + atan2(y, x)",
    "1.25e-3*log(x + 2) - tanh(y - 0.1)",
    "dot(u, v) - 3*x/cross(u, v)",
    "2*u + x*[1, y, 3] - cross(u, v)/m",
)
SCALARS = {name: sp.Symbol(name, real=True) for name in "xyzm"}
VECTORS = {name: Vector(name, 3) for name in "uv"}


def read_formulas(seed: int, count: int) -> None:
    random = Random(seed)
    for _ in range(count):
        text = mutated(random.choice(FORMULAS), random)
        for act in (parse, parse_formula):
            try:
                with within(PATIENCE):
                    found = act(text, SCALARS if act is parse else SCALARS | VECTORS)
                assert not found.has(sp.nan, sp.zoo, sp.oo)
            except InputError as error:
                check_message(str(error))


def test_damaged_formulas() -> None:
    read_formulas(0, 200)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(1, 5))
def test_many_damaged_formulas(seed: int) -> None:
    read_formulas(seed, 1000)


# --- data --------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def trajectory(tmp_path_factory: pytest.TempPathFactory) -> Path:
    study = Study.from_experiment(
        parse_experiment('[system]\nname = "chaplygin-ball"\n[run]\nuntil = 1.0\nsamples = 11\n')
    )
    return write_dataset(
        dataset_of(study, study.trajectory()), tmp_path_factory.mktemp("d") / "whole.nc"
    )


def read_trajectories(whole: Path, seed: int, count: int) -> None:
    """What can be read still has the same numbers: all of them have a checksum."""
    random, content = Random(seed), whole.read_bytes()
    expected = open_dataset(whole)
    path = whole.with_name(f"damaged{seed}.nc")
    refused = 0
    for _ in range(count):
        path.write_bytes(damaged(content, random))
        try:
            with within(PATIENCE):
                found = open_dataset(path)
        except InputError as error:
            check_message(str(error))
            refused += 1
        else:
            for name in found.variables.keys() & expected.variables.keys():
                if found[name].dtype.kind == "f" and found[name].shape:
                    assert found[name].values.tobytes() == expected[name].values.tobytes()
    assert refused > count / 3


@pytest.mark.slow
def test_damaged_trajectories(trajectory: Path) -> None:
    read_trajectories(trajectory, 0, 60)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(1, 5))
def test_many_damaged_trajectories(trajectory: Path, seed: int) -> None:
    read_trajectories(trajectory, seed, 150)


def test_a_file_in_which_hdf5_comes_to_no_end_is_refused(
    trajectory: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The heap of texts has an object of size zero, at which HDF5 stays for ever."""
    content = bytearray(trajectory.read_bytes())
    content[content.index(b"GCOL") + 24] = 0
    path = tmp_path / "circle.nc"
    path.write_bytes(content)
    monkeypatch.setattr("chaplygin.experiment.dataset._READ_TIMEOUT", 5.0)
    with pytest.raises(InputError, match=r"circle\.nc: not a readable NetCDF file"):
        open_dataset(path)
    assert open_dataset(trajectory).sizes["time"] == 11


@pytest.mark.parametrize(
    "content", [b"", b"CDF\x01" + b"\0" * 100, b"\x89HDF\r\n\x1a\n", b"x" * 99]
)
def test_foreign_files_are_no_trajectories(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "foreign.nc"
    path.write_bytes(content)
    with pytest.raises(InputError, match="not a readable NetCDF file"):
        open_dataset(path)


@pytest.fixture(scope="module")
def blocks(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("z") / "whole.zarr"
    compute(task(), folder)
    return folder


def read_stores(whole: Path, seed: int, count: int) -> None:
    """A damaged store is refused, or mended by the same computation; never read otherwise."""
    random, expected = Random(seed), store.read_store(whole).load()
    folder = whole.with_name(f"damaged{seed}.zarr")
    files = sorted(p.relative_to(whole) for p in whole.rglob("*") if p.is_file())
    refused = 0
    for _ in range(count):
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(whole, folder)
        path = folder / random.choice(files)
        if path.name == "zarr.json" and random.random() < 0.5:
            path.write_text(mutated(path.read_text(), random))
        else:
            path.write_bytes(damaged(path.read_bytes(), random))
        for act in (lambda: store.read_store(folder), lambda: compute(task(), folder)):
            try:
                with within(PATIENCE), warnings.catch_warnings():
                    warnings.simplefilter("ignore")
                    found = act().load()
            except (InputError, RunError) as error:
                check_message(str(error))
                refused += 1
            else:
                for name in expected.variables:
                    xr.testing.assert_equal(found[name], expected[name])
    assert refused > count / 4


@pytest.mark.slow
def test_damaged_stores(blocks: Path) -> None:
    read_stores(blocks, 0, 15)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(1, 6))
def test_many_damaged_stores(blocks: Path, seed: int) -> None:
    read_stores(blocks, seed, 40)


def test_a_damaged_block_is_computed_again(blocks: Path, tmp_path: Path) -> None:
    folder = tmp_path / "a.zarr"
    shutil.copytree(blocks, folder)
    chunk = folder / "orbit" / "c" / "1" / "0" / "0"
    content = bytearray(chunk.read_bytes())
    content[len(content) // 2] ^= 1
    chunk.write_bytes(content)
    with pytest.raises(InputError, match="1 have lost a part, the first is 1; run the same"):
        store.read_store(folder)
    xr.testing.assert_identical(compute(task(), folder).load(), store.read_store(blocks).load())


# --- Python files that misbehave ---------------------------------------------------------------

GOOD = (
    "import sympy as sp\nfrom flowlanes.system.system import System\n"
    "x, y = sp.symbols('x y', real=True)\n"
    "system = System(name='o', title='O', field={x: y, y: -x})\nstart = {'x': 1.0, 'y': 0.0}\n"
)
MISBEHAVING = {
    "ends the program": "raise SystemExit(3)",
    "exits in silence": "import sys; sys.exit()",
    "no Python": "system = = 3",
    "a null byte": "x = '\x00'",
    "bad indentation": "if True:\nx = 1",
    "too deep": "f = lambda n: f(n)\nf(1)",
    "divides by zero": "1/0",
    "a strange message": "raise ValueError('\\x1b[2J\\x07' + 'x'*20000)",
    "a message that fails": "class E(Exception):\n def __str__(self): return 1/0\nraise E",
    "no system": "a = 1",
    "another kind": "system = 3",
    "a class": "from flowlanes.system.system import System as system",
    "a start that is a list": GOOD + "start = [1, 2]",
    "a start of texts": GOOD + "start = {'x': 'a', 'y': 0.0}",
    "a start of infinities": GOOD + "start = {'x': float('inf'), 'y': 0.0}",
    "a huge start": GOOD + "start = {'x': 10**400, 'y': 0.0}",
    "a start of complex numbers": GOOD + "start = {'x': 1j, 'y': 0.0}",
    "a start that is unknown": GOOD + "start = {'q': 1, 'y': 0.0}",
    "a start without end": GOOD
    + "class N:\n def __iter__(self):\n  while True: yield 1.0\nstart = {'x': N(), 'y': 0.0}",
    "a start that contains itself": GOOD + "l = []\nl.append(l)\nstart = {'x': l, 'y': 0.0}",
    "numbers that fail": GOOD
    + "class N:\n def __float__(self): raise KeyError('n')\nstart = {'x': N(), 'y': 0.0}",
    "a run that is unknown": GOOD + "run = {'untill': 3}",
    "a run of None": GOOD + "run = None",
    "a field that fails": GOOD + "system = System(name='o', title='O', field={x: 1/sp.S(0), y: x})",
    "a field of floats": GOOD + "system = System(name='o', title='O', field={x: sp.nan, y: x})",
    "a missing module": "import no_module_of_this_name",
}


@pytest.mark.parametrize("how", MISBEHAVING)
def test_python_files_that_misbehave(tmp_path: Path, how: str) -> None:
    path = tmp_path / "file.py"
    path.write_text(MISBEHAVING[how])
    with within(PATIENCE), pytest.raises(InputError) as caught:
        _ = load_python(path).start
    check_message(str(caught.value))
    assert str(path) in str(caught.value) or "start" in str(caught.value)


def test_a_python_file_that_is_no_text(tmp_path: Path) -> None:
    path = tmp_path / "file.py"
    for seed in range(20):
        path.write_bytes(Random(seed).randbytes(300))
        with pytest.raises(InputError) as caught:
            load_python(path)
        check_message(str(caught.value))
