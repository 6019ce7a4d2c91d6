"""All exports give the same numbers as the formulas themselves."""

from __future__ import annotations

import ctypes
import json
import math
import re
import shutil
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import mpmath
import numpy as np
import numpy.typing as npt
import pytest
import sympy as sp

from every_system import CASES, bare, laden
from flowlanes.errors import InputError
from flowlanes.printing.code import LANGUAGES, TARGETS, lambdify, source_code
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import real_symbol
from needs import needs
from nonholonomic.catalogue import CATALOGUE

Array = npt.NDArray[np.float64]

#: The targets; those whose package is not installed are skipped.
AS_TARGETS = {name: pytest.param(name, marks=needs(name)) for name in TARGETS}
COMPILER, NODE = shutil.which("cc"), shutil.which("node")

FEW = [("ball", "sphere", "marble"), ("implicit", "plane", "rubber")]
ROUNDING = 1e-14


def states(system: System, count: int) -> Array:
    """States away from every singularity, one a column."""
    random = np.random.default_rng(7)
    return random.uniform(0.2, 0.9, size=(len(system.symbols), count))


def defaults(system: System) -> Array:
    return np.array(list(system.defaults.values()))


def exact(system: System, x: Array) -> Array:
    """The rates with 30 digits, straight from the formulas."""
    with mpmath.workdps(30):
        known = dict(zip(system.symbols, map(mpmath.mpf, x), strict=True))
        known |= {symbol: mpmath.mpf(value) for symbol, value in system.defaults.items()}
        for symbol, value in system.required_definitions(system.rates):
            known[symbol] = sp.lambdify(list(known), value, "mpmath")(*known.values())
        rates = sp.lambdify(list(known), list(system.rates), "mpmath")(*known.values())
        return np.array([float(rate) for rate in rates])


def close(found: Array, wanted: Array, factor: float = 1.0) -> bool:
    """Agreement to rounding, relative to the largest component."""
    return bool(np.max(np.abs(found - wanted)) <= factor * ROUNDING * np.max(np.abs(wanted)))


# --- functions -----------------------------------------------------------------------------


@pytest.mark.slow
@pytest.mark.parametrize("case", CASES, ids="-".join)
def test_numpy_agrees_with_many_digits(case: tuple[str, str, str]) -> None:
    system = laden(*case)
    x = states(system, 1)[:, 0]
    # a contact near the end of its domain magnifies rounding
    assert close(lambdify(system)(0.0, x), exact(system, x), 1e3)


def test_the_lifted_system_agrees_too() -> None:
    system = CATALOGUE["rattleback"].system().lifted()
    x = states(system, 1)[:, 0]
    assert close(lambdify(system)(0.0, x), exact(system, x), 1e3)


@pytest.mark.parametrize("case", FEW, ids="-".join)
def test_many_states_at_once(case: tuple[str, str, str]) -> None:
    system = laden(*case)
    f, x = lambdify(system, "numpy"), states(system, 5)
    together = f(0.0, x)
    assert together.shape == x.shape
    for column, rates in zip(x.T, together.T, strict=True):
        assert close(rates, f(0.0, column))


@pytest.mark.slow
@pytest.mark.parametrize("case", FEW, ids="-".join)
@pytest.mark.parametrize("target", AS_TARGETS.values())
def test_targets_agree(target: str, case: tuple[str, str, str]) -> None:
    system = laden(*case)
    x, p = states(system, 1)[:, 0], defaults(system)
    wanted = lambdify(system, "numpy")(0.0, x)
    f = lambdify(system, target)
    factor = 1.0
    if target == "jax":
        import jax

        factor = 1.0 if jax.config.jax_enable_x64 else 1e9
    assert close(np.asarray(f(0.0, x)), wanted, factor)
    assert close(np.asarray(f(0.0, x, p)), wanted, factor)
    changed = p * 1.01
    assert close(np.asarray(f(0.0, x, changed)), lambdify(system, "numpy")(0.0, x, changed), factor)


def decay() -> System:
    """Names that mean something to programming languages, a clock, and a rate of zero."""
    x, p, t, clock = (real_symbol(name) for name in ("x", "p", "t", "clock"))
    lam, double, e, dx = (real_symbol(name) for name in ("lambda", "double", "e", "dx"))
    return System(
        name="2-decay law",
        title="Decay \\",
        field={
            x: -lam * dx * double + sp.exp(1) * sp.Abs(p),
            clock: sp.S.One,
            t: sp.S.Zero,
            double: sp.atan2(x, e) ** 3 - sp.pi * x - sp.sqrt(x + 1) ** 3 / 3 + (x + e) ** 2,
        },
        parameters=(
            Parameter(lam, "rate\nof decay", 0.5, "1/s"),
            Parameter(e, "offset", 2.0),
            Parameter(p, "push", -0.25),
        ),
        definitions={dx: sp.cos(x) ** 2 / (1 + x**2)},
    )


def decay_by_hand(x: float, double: float) -> list[float]:
    first = -0.5 * math.cos(x) ** 2 / (1 + x * x) * double + math.e * 0.25
    last = math.atan2(x, 2.0) ** 3 - math.pi * x - (x + 1) ** 1.5 / 3 + (x + 2) ** 2
    return [first, 1.0, 0.0, last]


DECAY = np.array([0.3, 5.0, 6.0, 0.7])


@pytest.mark.parametrize("target", [AS_TARGETS["numpy"], AS_TARGETS["numba"]])
def test_clashing_names_and_constant_rates(target: str) -> None:
    found = lambdify(decay(), target)(0.0, DECAY)
    assert found.dtype == np.float64
    assert close(found, np.array(decay_by_hand(0.3, 0.7)))


def test_numpy_keeps_the_shape_of_constant_rates() -> None:
    many = np.repeat(DECAY[:, None], 3, axis=1)
    assert lambdify(decay())(0.0, many).shape == (4, 3)


def test_wrong_lengths_are_refused() -> None:
    f = lambdify(decay())
    with pytest.raises(InputError, match=r"x has 3 entries; it needs 4, in the order of"):
        f(0.0, DECAY[:3])
    with pytest.raises(InputError, match=r"p has 2 entries; it needs 3"):
        f(0.0, DECAY, [1.0, 2.0])


def test_unknown_target_and_language_are_refused() -> None:
    with pytest.raises(InputError) as target:
        lambdify(decay(), "torch")
    assert str(target.value) == "target 'torch': it must be one of 'numpy', 'jax', 'numba'"
    with pytest.raises(InputError) as language:
        source_code(decay(), "fortran")
    assert str(language.value) == "language 'fortran': it must be one of 'c', 'javascript', 'julia'"


@pytest.mark.parametrize("target", ["jax", "numba"])
def test_missing_package_is_named(target: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, target, None)
    with pytest.raises(InputError) as error:
        lambdify(decay(), target)
    assert str(error.value) == (
        f"the target {target!r} needs the package {target}: pip install {target}"
    )


# --- source text ---------------------------------------------------------------------------


def by_julia(system: System, x: Array) -> Array:
    """Carry out Julia text line by line; the assignments are Python but for a few signs."""
    lines = source_code(system, "julia").splitlines()
    start = next(i for i, line in enumerate(lines) if line.startswith("function "))
    assert lines[-2:] == ["    return nothing", "end"]
    # arrays counted from 1
    known: dict[str, object] = {
        "x": [None, *x],
        "p": [None, *defaults(system)],
        "dx": [None, *x],
        "pi": math.pi,
        "atan": lambda y, x=1.0: math.atan2(y, x),
        "MathConstants": math,
        **{name: getattr(math, name) for name in ("sin", "cos", "tan", "sqrt", "exp", "log")},
    }
    for line in lines[start + 1 : -2]:
        python = re.sub(r"\blambda\b", "lam", line.strip()).replace("^", "**").replace("//", "/")
        exec(python, known)
    found = known["dx"]
    assert isinstance(found, list)
    return np.array(found[1:])


@pytest.mark.slow
@pytest.mark.parametrize("case", CASES, ids="-".join)
def test_julia_text_computes_the_same(case: tuple[str, str, str]) -> None:
    system = laden(*case)
    x = states(system, 1)[:, 0]
    assert close(by_julia(system, x), lambdify(system)(0.0, x))


def test_julia_text_of_clashing_names() -> None:
    assert close(by_julia(decay(), DECAY), np.array(decay_by_hand(0.3, 0.7)))


def by_c(system: System, x: Array, folder: Path) -> Array:
    """Compile C text without a warning and call it."""
    code, library = folder / "system.c", folder / "system.so"
    code.write_text(source_code(system, "c"), encoding="utf-8")
    strict = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic", "-shared", "-fPIC"]
    assert COMPILER is not None
    subprocess.run([COMPILER, *strict, "-o", library, code, "-lm"], check=True)
    name = re.search(r"^void (\w+)\(", code.read_text(encoding="utf-8"), re.MULTILINE)
    assert name is not None
    compiled = ctypes.CDLL(str(library))[name[1]]
    array = np.ctypeslib.ndpointer(dtype=np.float64, flags="C_CONTIGUOUS")
    compiled.argtypes, compiled.restype = [ctypes.c_double, array, array, array], None
    dx = np.empty_like(x)
    compiled(0.0, x, defaults(system), dx)
    return dx


@pytest.mark.parametrize("case", FEW, ids="-".join)
def test_c_text_computes_the_same(case: tuple[str, str, str], tmp_path: Path) -> None:
    system = laden(*case)
    x = states(system, 1)[:, 0]
    if COMPILER:
        assert close(by_c(system, x, tmp_path), lambdify(system)(0.0, x))
    assert_c_is_complete(system)


def test_c_text_of_clashing_names(tmp_path: Path) -> None:
    if COMPILER:
        assert close(by_c(decay(), DECAY, tmp_path), np.array(decay_by_hand(0.3, 0.7)))
    assert_c_is_complete(decay())


def assert_c_is_complete(system: System) -> None:
    """Every name is declared once, before its use, and every rate is stored once, in order."""
    text = source_code(system, "c")
    body = text[text.index("{") + 1 : text.rindex("}")]
    known = {"x", "p", "dx", "const", "double"}
    known |= {"sqrt", "pow", "sin", "cos", "fabs", "atan2", "exp"}
    stored = []
    for line in body.splitlines()[2:]:
        left, right = line.strip().removesuffix(";").split(" = ")
        assert set(re.findall(r"[A-Za-z_]\w*", right)) <= known
        if left.startswith("dx["):
            stored.append(left)
        else:
            name = left.removeprefix("const double ")
            assert name not in known
            known.add(name)
    assert stored == [f"dx[{i}]" for i in range(len(system.symbols))]


def by_javascript(system: System, x: Array, folder: Path) -> Array:
    """Import the module in Node and call its function."""
    module = folder / "system.mjs"
    module.write_text(source_code(system, "javascript"), encoding="utf-8")
    call = (
        f"import({json.dumps(module.as_uri())}).then((module) => {{"
        f" const [rate] = Object.values(module);"
        f" const x = {json.dumps(x.tolist())}, p = {json.dumps(defaults(system).tolist())};"
        " const dx = new Float64Array(x.length);"
        " if (rate(0, x, p, dx) !== dx) throw new Error('another array');"
        " console.log(JSON.stringify([Array.from(dx), rate(0, x, p)])); })"
    )
    assert NODE is not None
    written = subprocess.run([NODE, "-e", call], check=True, capture_output=True, text=True)
    filled, made = json.loads(written.stdout)
    assert filled == made
    return np.array(filled)


#: The functions and constants of JavaScript, for Python.
MATH = SimpleNamespace(**vars(math), abs=abs, PI=math.pi, E=math.e)


def by_reading_javascript(system: System, x: Array) -> Array:
    """Execute the lines of the function in Python, which writes these expressions alike."""
    lines = source_code(system, "javascript").splitlines()
    start = next(i for i, line in enumerate(lines) if line.startswith("export function"))
    assert lines[-2:] == ["  return dx;", "}"]
    known = {"x": list(x), "p": list(defaults(system)), "dx": {}, "Math": MATH}
    for line in lines[start + 1 : -2]:
        # Python has no const, and a word of its own may be a name here
        statement = re.sub(r"\blambda\b", "lam", line.strip().removeprefix("const "))
        assert statement.endswith(";")
        exec(statement.removesuffix(";"), known)
    stored = known["dx"]
    assert isinstance(stored, dict)
    assert list(stored) == list(range(len(x)))
    return np.array(list(stored.values()))


@pytest.mark.parametrize("case", FEW, ids="-".join)
def test_javascript_text_computes_the_same(case: tuple[str, str, str], tmp_path: Path) -> None:
    system = laden(*case)
    x = states(system, 1)[:, 0]
    wanted = lambdify(system)(0.0, x)
    assert close(by_reading_javascript(system, x), wanted)
    if NODE:
        assert close(by_javascript(system, x, tmp_path), wanted)


def test_javascript_text_of_clashing_names(tmp_path: Path) -> None:
    wanted = np.array(decay_by_hand(0.3, 0.7))
    assert close(by_reading_javascript(decay(), DECAY), wanted)
    if NODE:
        assert close(by_javascript(decay(), DECAY, tmp_path), wanted)


def test_header_says_what_a_reader_needs() -> None:
    text = source_code(bare("ball", "plane", "marble"), "c")
    assert "//     Ṁ = M × ω\n" in text
    assert "// Source: (1.17), (10.1)\n" in text
    assert "//   x[3] = gamma_1\n" in text
    assert "//   p[0] = m = 1.0 kg: mass\n" in text
    assert "\nvoid rolling_body(double t, const double *x, const double *p, double *dx)\n" in text
    text = source_code(bare("ball", "plane", "marble"), "julia")
    assert "#   x[4] = gamma_1\n" in text
    assert "\nfunction rolling_body!(dx, x, p, t)\n" in text


def test_comments_stay_comments() -> None:
    marks = {"c": ("//", "#include"), "javascript": ("//", "export"), "julia": ("#", "function")}
    assert marks.keys() == LANGUAGES.keys()
    for language, (mark, end) in marks.items():
        head = source_code(decay(), language).split(end)[0]
        assert all(line.startswith(mark) for line in head.splitlines())
        assert f"{mark} Decay\n" in head
        assert "0.5 1/s: rate of decay" in head


def test_definitions_are_computed_once() -> None:
    text = source_code(bare("ellipsoid", "plane", "marble"), "c")
    assert text.count("const double s = ") == 1
    assert "lambda_0" not in text
