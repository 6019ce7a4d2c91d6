"""Mistakes in Python: wrong types, names and shapes are each one clear sentence."""

# ruff: noqa: PLW0108 (what a call needs is made when it is called)

from __future__ import annotations

import inspect
import pkgutil
import re
from collections.abc import Callable, Iterator
from importlib import import_module
from math import inf, nan
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy as sp

import borisov_mamaev_2008.audit
import chaplygin as c
import chaplygin.report
import flowlanes
import lawproof
import nonholonomic
from chaplygin.experiment import write_dataset
from flowlanes.errors import InputError, RunError
from flowlanes.system.vectors import real_symbol
from nonholonomic.contact import ContensouErismann, FrictionalContact
from nonholonomic.control import figure_of_eight

BALL = """\
[body]
mass = 1.0
inertia = [1.0, 1.2, 1.5]
[body.shape]
kind = "ball"
radius = 1.0
[start]
gamma = [0, 0, 1]
omega = [1, 0, 0]
"""
S = c.from_catalogue("chaplygin-ball")
B = c.Body(1.0, (1.0, 1.2, 1.5), c.Ball(1.0))
X = c.initial_state(S, (1, 0, 0), (0, 0, 1))
x, y, xd, yd = map(real_symbol, ["x", "y", "xdot", "ydot"])
F = nonholonomic.coordinates(x, y)
M = c.Mechanism("knife", F, (xd**2 + yd**2) / 2, (yd - x * xd,))
EXP = c.parse_experiment(BALL)
T = c.integrate(S, X, [0, 1.0])
DS = T.to_dataset()
sec = flowlanes.poincare_section(S, "gamma_3", 0.0)
AXES = [flowlanes.scans.Axis(name, 1.0, 2.0, 3) for name in ("I_1", "I_2")]
GRID = flowlanes.scans.scan_grid(S, *AXES, {"M": (1, 0, 0), "gamma": (0, 0, 1)})
RETURNS = flowlanes.orbits.ReturnMap(c.PoincareMap(S, sec))

#: A call with one argument left out, and values of it that are mistakes.
MISTAKES: tuple[tuple[Any, ...], ...] = (
    (EXP.path, object()),
    (lambda v: EXP.where("body", v), 1),
    (lambda v: c.invariant_measure(source=v), "ball"),
    (flowlanes.system.unit_vector, 4),
    (c.Ball, "1", None, -1, nan, [1.0], np.array([1.0, 2.0]), 1j),
    (lambda v: c.Ball(1.0, centre=v), (0, 0), "up"),
    (lambda v: c.Ball(1.0, v), "yes"),
    (c.Disk, [1], 0),
    (c.Ellipsoid, (1, 2), 3.0, ("a", "b", "c")),
    (lambda v: c.Ellipsoid((1, 2, 3), v), "north"),
    (lambda v: c.Torus(1.0, v), None),
    (lambda v: c.Torus({}, v), 1),
    (c.ShapeOfRevolution, "1 + gamma_3**2", None),
    (lambda v: c.ShapeOfRevolution(sp.Symbol("gamma_3", real=True), v), 3),
    (
        lambda v: c.ShapeOfRevolution(sp.Symbol("a") + sp.Symbol("gamma_3", real=True) ** 2, v),
        {"a": "x"},
    ),
    (lambda v: c.ShapeOfRevolution.from_profile(None, v), None),
    (
        lambda v: c.ShapeOfRevolution.from_profile(
            sp.Integer(1), sp.Symbol("gamma_3", real=True), v
        ),
        "a=1",
    ),
    (c.ImplicitShape, "x**2+y**2+z**2-1", sp.Integer(3), [x]),
    (c.Sphere, "2", 0, -2.0, None),
    (lambda v: c.Body(1.0, (1, 1, 1), v), "ball", c.Ball),
    (lambda v: c.Body(v, (1, 1, 1), c.Ball(1.0)), "1", None),
    (lambda v: c.Body(1.0, v, c.Ball(1.0)), (1, 1), 1.0, None, ((1, 0), (0, 1, 0), (0, 0, 1))),
    (lambda v: c.Body(1.0, v, c.Ball(1.0)), "1,1,1", (1, nan, 1), (10**400, 1, 1)),
    (lambda v: c.Body(1.0, (1, 1, 1), c.Ball(1.0), v), (1, 2), "k"),
    (c.Forces, "9.81", (0, 0, -9.81)),
    (lambda v: c.Forces(9.81, v), "gamma_3"),
    (lambda v: c.rolling_system(B, field=v), c.Forces(9.81, sp.Symbol("k")), 9.81),
    (lambda v: c.Forces(9.81, 0, v), "k"),
    (c.rolling_system, "ball", None, c.Ball(1.0)),
    (lambda v: c.rolling_system(B, v), "plane", c.Plane),
    (lambda v: c.rolling_system(B, c.Plane(), v), "sliding", None),
    (lambda v: c.rolling_system(B, name=v), 3),
    (lambda v: c.rolling_system(c.Plane(), v), B),
    (c.RollingBody, "ball"),
    (lambda v: nonholonomic.RollingBall(mass=1, inertia=0.4, radius=1, surface=v), "plane"),
    (lambda v: nonholonomic.RollingBall(mass="1", inertia=0.4, radius=1, surface=v), c.Plane()),
    (nonholonomic.rolling_mechanism, S, None),
    (c.from_catalogue, "chaplygin-bal", None, 3, S),
    (lambda v: c.from_catalogue("chaplygin-ball", I_1=v), "2", -2, None, [1, 2, 3], nan),
    (lambda v: c.from_catalogue("chaplygin-ball", J=v), 2),
    (lambda v: c.integrate(v, X, [0, 1]), "chaplygin-ball", None, B, EXP),
    (lambda v: c.integrate(M, [0, 0, 1], v), [0, 1]),
    (lambda v: c.integrate(S, v, [0, 1]), None, 3.0, [1, 2], "here", ["a"] * len(X), {"q": 1}),
    (lambda v: c.integrate(S, v, [0, 1]), {"M": (1, 0, 0)}, {"M": (1, 0), "gamma": (0, 0, 1)}),
    (lambda v: c.integrate(S, v, [0, 1]), {"M": "up", "gamma": (0, 0, 1)}),
    (lambda v: c.integrate(S, v, [0, 1]), {"M": None, "gamma": (0, 0, 1)}, np.ones((2, 6))),
    (lambda v: c.integrate(S, v, [0, 1]), [nan] * len(X), [1j] * len(X), {1: 2}),
    (lambda v: c.integrate(S, X, v), 10, None, [], [0, 2, 1], "0,1", [0, nan], [[0, 1], [2, 3]]),
    (lambda v: c.integrate(S, X, [0, 1], parameters=v), [1, 2], {"q": 1}, {"m": "1 kg"}),
    (lambda v: c.integrate(S, X, [0, 1], parameters=v), {"m": None}, {3: 1.0}),
    (lambda v: c.integrate(S, X, [0, 1], tolerance=v), "small", -1, 10),
    (lambda v: c.integrate(S, X, [0, 1], precision=v), "triple", 34),
    (lambda v: c.integrate(S, X, [0, 1], method=v), "rk4", ["taylor"]),
    (lambda v: c.integrate(S, X, [0, 1], on_liftoff=v), "fly"),
    (lambda v: c.integrate(S, X, [0, 1], time_limit=v), "1 min", -1),
    (lambda v: c.integrate(S, X, [0, 1], progress=v), "yes"),
    (lambda v: c.integrate(S, X, [0, 1], keep_integrals=v), "yes"),
    (lambda v: c.initial_state(v, (1, 0, 0), (0, 0, 1)), "chaplygin-ball"),
    (lambda v: c.initial_state(v, (1, 0, 0), (0, 0, 1)), c.from_catalogue("chaplygin-sleigh")),
    (lambda v: c.initial_state(v, (1, 0, 0), (0, 0, 1)), c.from_catalogue("chaplygin-ball-nd")),
    (lambda v: c.initial_state(S, v, (0, 0, 1)), (1, 0), 1),
    (lambda v: c.initial_state(S, None, v), None),
    (lambda v: c.initial_state(S, (1, 0, 0), v), (0, 0, 0)),
    (lambda v: c.initial_state(S, (1, 0, 0), (0, 0, 1), heading=v), "north", nan),
    (lambda v: c.initial_state(S, (1, 0, 0), (0, 0, 1), parameters=v), {"zz": 1}),
    (lambda v: c.initial_state(S, (1, 0, 0), (0, 0, 1), normal=v), (0, 1)),
    (lambda v: c.lyapunov_spectrum("chaplygin-ball", X, t_end=v), 10),
    (lambda v: c.lyapunov_spectrum(S, X, t_end=v), "10", -10),
    (lambda v: c.lyapunov_spectrum(S, X, t_end=10, intervals=v), 0, 1.5),
    (lambda v: c.lyapunov_spectrum(S, [1, 2], t_end=v), 10),
    (lambda v: c.lyapunov_spectrum(S, X, v, t_end=10), {"q": 1}, [1, 2]),
    (lambda v: c.lyapunov_spectrum(S, X, t_end=10, tolerance=v), "x"),
    (lawproof.prove_all, "chaplygin-ball", None),
    (lambda v: S.with_laws(c.Integral("e", v)), sp.Symbol("q")),
    (lambda v: c.prove(S, v), "enrgy", 3),
    (lambda v: c.prove(S, "energy", effort=v), "much", -1),
    (c.invariant_measure, "chaplygin-ball", None, S),
    (c.classify, "chaplygin-ball", None),
    (lambda v: c.classify(S, v), "all"),
    (flowlanes.reversing_symmetries, "chaplygin-ball", M),
    (flowlanes.rotation_number, 3, np.ones(10), lambda n: None, lambda n: np.ones(3)),
    (lambda v: flowlanes.rotation_number(lambda n: np.arange(n) * 0.1, tolerance=v), "x"),
    (lambda v: c.linear_stability("x", v), X),
    (lambda v: c.linear_stability(S, v), [1]),
    (lambda v: c.linear_stability(S, X[:6], digits=v), "many"),
    (lambda v: c.linear_stability(S, X[:6], along=v), 3),
    (flowlanes.batch_integrator, "S", []),
    (lambda v: flowlanes.batch_integrator(S, deviations=v), "x"),
    (lambda v: flowlanes.batch_integrator(S, tolerance=v), "x"),
    (lambda v: flowlanes.batch_integrator(S, precision=v), "half"),
    (lambda v: flowlanes.batch_integrator(S, section=v), "gamma_3"),
    (lambda v: flowlanes.poincare_section(S, v), "delta", None),
    (lambda v: flowlanes.poincare_section(S, "gamma_3", v), "0", nan, inf),
    (lambda v: flowlanes.poincare_section(S, "gamma_3", 0, v), "rising", 5),
    (lambda v: flowlanes.poincare_section("S", v), "gamma_3"),
    (lambda v: c.PoincareMap(S, v), "gamma_3"),
    (lambda v: c.PoincareMap("S", v), sec),
    (lambda v: c.PoincareMap(S, sec, v), {"q": 1}, [1]),
    (lambda v: c.PoincareMap(S, sec).crossings(v, 3), [1, 2], "x"),
    (lambda v: c.PoincareMap(S, sec).crossings([X[:6]], v), "x", -1),
    (lambda v: c.PoincareMap(S, sec).within("q", v), 1),
    (lambda v: c.PoincareMap(S, sec).within("gamma_1", v), "x"),
    (lambda v: c.ensemble("S", [X[:6]], v), [0, 1]),
    (lambda v: c.ensemble(S, v, [0, 1]), None, [[1, 2]], "x"),
    (lambda v: c.ensemble(S, [X[:6]], v), "x", 3),
    (lambda v: c.ensemble(S, [X[:6]], [0, 1], record=v), ["zz"], "energy"),
    (lambda v: c.ensemble(S, [X[:6]], [0, 1], v), [1]),
    (lambda v: c.ensemble(S, [X[:6]], [0, 1], block=v), 0, "x"),
    (lambda v: c.ensemble(S, [X[:6]], [0, 1], store=v), 3),
    (lambda v: c.ensemble(S, [X[:6]], [0, 1], client=v), "here"),
    (lambda v: flowlanes.sample_level("S", 3, v), {}),
    (lambda v: flowlanes.sample_level(S, "3", v), {}),
    (lambda v: flowlanes.sample_level(S, -3, v), {"energy": 1.0}),
    (lambda v: flowlanes.sample_level(S, 3, v), {"enrgy": 1.0}, {"energy": "1"}, None, ["energy"]),
    (lambda v: flowlanes.sample_level(S, 3, v), {"energy": -1.0}),
    (lambda v: flowlanes.sample_level(S, 3, {"energy": 1.0}, seed=v), "x"),
    (lambda v: c.solve("S", v), X),
    (lambda v: c.solve(S, v), "x", None),
    (lambda v: c.solve(S, X).states(v), "x", [nan]),
    (lambda v: c.solve(S, X).rigorous(v), "x"),
    (lambda v: c.solve(S, X).rigorous(1, v), "x"),
    (lambda v: flowlanes.gauss_integrator("S", v), X),
    (lambda v: flowlanes.gauss_integrator(S, v), [1], [nan] * 6),
    (lambda v: flowlanes.gauss_integrator(S, X, precision=v), "half"),
    (c.load_experiment, None, 3, {"body": 1}),
    (lambda v: c.parse_experiment(BALL, overrides=v), "run.until=3", 3, [3], {"run.until": 3}),
    (c.parse_experiment, None, b"x", Path("x")),
    (lambda v: c.parse_experiment("x", v), 3),
    (c.Study.from_experiment, "ball.toml", None, S),
    (lambda v: c.Study.from_experiment(EXP).trajectory(pieces=v), 0),
    (c.open_dataset, "none.nc", None, "bad.nc", "bad.zarr", "dir.nc"),
    (lambda v: write_dataset(v, "a.nc"), None, T),
    (lambda v: write_dataset(DS, v), "a.txt", "/none/a.nc", None, "dir.nc"),
    (lambda v: T.to_dataset(v), "x"),
    (borisov_mamaev_2008.audit.audit, 99, "two"),
    (lambda v: borisov_mamaev_2008.audit.audit(2, workers=v), "x"),
    (nonholonomic.coordinates, 3, None),
    (lambda _: nonholonomic.coordinates(), None),
    (lambda v: nonholonomic.coordinates(x, v), x),
    (lambda v: nonholonomic.coordinates(x, dot=v), 3),
    (lambda v: c.Frame((), v), ()),
    (lambda v: c.Frame(None, v), None),
    (lambda v: c.Frame("x", v), "y"),
    (F.field, 7, "x"),
    (lambda v: c.Mechanism("a", "frame", v), xd**2),
    (
        lambda v: c.equations_of_motion(c.Mechanism("a", F, v)),
        None,
        "xdot**2",
        sp.Symbol("m") * xd**2,
    ),
    (
        lambda v: c.equations_of_motion(c.Mechanism("a", F, xd**2 + yd**2, v)),
        yd - x * xd,
        ("xdot",),
    ),
    (c.equations_of_motion, "x", S),
    (lambda v: c.Mechanism("a", F, xd**2 + yd**2, parameters=v), ("m",)),
    (lambda v: c.Mechanism(3, F, v), xd**2 + yd**2),
    (nonholonomic.nonholonomy, "x", S),
    (nonholonomic.chaplygin_form, "x"),
    (lambda v: nonholonomic.chaplygin_form(M, v), 3),
    (c.from_sympy, "x", None),
    (nonholonomic.mechanism_from_sympy, 3),
    (lambda v: c.Parameter(v, "mass", 1.0), "m", None),
    (lambda v: c.Parameter(sp.Symbol("m", real=True), "mass", v), "1"),
    (lambda v: c.System("a", "A", v), None, "x", {"x": "x"}, {x: sp.Symbol("q") * x}),
    (lambda v: c.System("a", "A", {x: x}, laws=v), ("energy",)),
    (lambda v: c.System("a", "A", {x: x}, parameters=v), ({"m": 1},)),
    (lambda v: c.System(None, "A", v), {x: x}),
    (S.with_laws, "energy"),
    (lambda v: c.source_code(S, v), "fortran", None),
    (lambda v: flowlanes.lambdify(S, v), "torch"),
    (S.required_definitions, "x"),
    (lambda v: c.Integral("e", v), "x", None),
    (lambda v: c.Integral(3, v), x),
    (lambda v: c.Measure("m", v), "1"),
    (lambda v: c.Symmetry("s", v), None, [x]),
    (lambda v: flowlanes.Identity("i", v), None),
    (flowlanes.Rate, "x"),
    (lambda v: flowlanes.PoissonStructure("p", v), "x", sp.zeros(2, 3), 3, [[1, 2], [3]]),
    (lambda v: flowlanes.ConformallyHamiltonian("h", 1, "x", v), 2),
    (lambda v: flowlanes.Isomorphism("i", "chaplygin-ball", v), {}),
    (lambda v: flowlanes.Reduction("r", "x", v), "y"),
    (lambda v: flowlanes.Separation("r", None, v), None),
    (T.subsample, "x", 0),
    (lambda v: c.from_catalogue("chaplygin-ball-nd", dimension=v), nan, inf, 3.5),
    (lambda v: c.solve(S, X)(v), "now", [nan]),
    (lambda v: figure_of_eight(nan, 1.0, v), 1.0),
    (lambda v: figure_of_eight(1.0, inf, v), 1.0),
    (lambda v: figure_of_eight(1.0, 1.0, v), nan, 0.0),
    (lambda v: flowlanes.batch_integrator(S).propagate([X[:6]], [0, 1.0], v), 3),
    (lambda v: flowlanes.batch_integrator(S).require_reach(X[:6], v), None),
    (lambda v: c.PoincareMap(S, sec, tolerance=v), -1.0),
    (lambda v: c.PoincareMap(S, sec, t_end=v), nan),
    (lambda v: c.PoincareMap(S, sec)(v), "x"),
    (lambda v: c.PoincareMap(S, sec).dimension(v), [None] * 6),
    (lambda v: flowlanes.formulas.Formulas(S, [S.integrals[0].value])(v), 3),
    (flowlanes.system.constant, -1.5),
    (lambda _: nonholonomic.control.ControlledSystem(*["x"] * 7), None),
    (flowlanes.lyapunov.kaplan_yorke, "x"),
    (lambda v: flowlanes.lyapunov.megno(None, v), 10.0),
    (lambda v: flowlanes.lyapunov.megno(S, v), -10.0),
    (lambda v: flowlanes.orbits.find_periodic(None, v), X[:6]),
    (flowlanes.scans.axis, b"x"),
    (lambda v: flowlanes.scans.Axis("a", 0.0, nan, v), 3),
    (lambda v: flowlanes.scans.scan_grid(S, None, None, v), {}),
    (lambda v: lawproof.search.search_space(S, degree=v), "two"),
    (lambda v: lawproof.search.search_space(S, momenta=v), b"x"),
    (lambda v: flowlanes.flow.level_sampler(S, {"energy": 1.0}, v), 3),
    (lambda v: flowlanes.flow.relative_equilibrium(S, X[:6], digits=v), "x"),
    (lambda v: flowlanes.formulas.ball_values([x], v), {}),
    (nonholonomic.closed_form.bifurcation_diagram, None),
    (lambda v: chaplygin.report.figures.state(DS, v), 3),
    (chaplygin.report.figures.drift, "x"),
    (lambda v: chaplygin.report.figures.relative_drift(DS, v), "enrgy"),
    (lambda v: flowlanes.system.cross(3, v), 4),
    (flowlanes.system.to_components, None),
    (lambda v: flowlanes.system.Vector("a", v), None),
    (nonholonomic.catalogue.entry, None),
    (lambda v: nonholonomic.catalogue.entry("chaplygin-ball").settings(v), 3),
    (lambda v: figure_of_eight(1.0, 1.0, 1.0).places(v), "x"),
    (lambda v: c.System("a", "A", {x: x}, relations=v), (None,)),
    (lambda v: flowlanes.parsing.nearest(None, v), ["a"]),
    (lambda v: flowlanes.parsing.nearest("a", v), None, [b"x"]),
    (flowlanes.formulas.ball, None, "x", 1j),
    (lambda v: flowlanes.formulas.ball_function(None, v), (x,)),
    (lambda v: flowlanes.formulas.ball_function((x,), v), "x"),
    (lambda v: flowlanes.formulas.ball_function((x,), (x,), steps=v), "x"),
    (lambda v: flowlanes.orbits.multipliers(RETURNS, v, np.eye(6)), np.ones(2)),
    (lambda v: flowlanes.orbits.multipliers(RETURNS, v, np.eye(6)), np.full(6, np.nan)),
    (lambda v: flowlanes.orbits.multipliers(RETURNS, np.array(X[:6]), v), np.eye(2)),
    (RETURNS.sizes, np.ones((2, 2)), np.ones((0, 6)), np.ones(6)),
    (lambda _: nonholonomic.CATALOGUE[None], None),
    (lambda _: nonholonomic.CATALOGUE[[]], None),
    (lambda _: nonholonomic.CATALOGUE["nonsense"], None),
    (lambda v: c.PoincareMap(S, sec).derivative(v), 3),
    (lambda v: GRID.cells(v, 2), nan, 3),
    (lambda v: GRID.cells(3, v), 4),
    (chaplygin.report.figures.svg_file, None),
    (
        lambda v: FrictionalContact(c.Body(1.0, (0.3, 0.3, 0.5), c.Disk(1.0)), laws=v),
        (ContensouErismann(0.3, 1.1),),
    ),
)


def test_one_sentence(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("bad.nc").write_bytes(b"CDF\x01garbage")
    Path("bad.zarr").mkdir()
    Path("dir.nc").mkdir()
    wrong = [
        f"{inspect.getsource(call).splitlines()[0].strip()} of {value!r}: {fault}"
        for call, *values in MISTAKES
        for value in values
        if (fault := _fault(call, value))
    ]
    assert not wrong, "\n".join(wrong)


def _fault(call: Callable[[Any], Any], value: Any) -> str:
    """What is wrong with the answer to a mistake; empty if it is one clear sentence."""
    try:
        call(value)
    except (InputError, RunError) as refused:
        first, *excerpt = str(refused).splitlines()
        clear = len(first) < 600 and all(line.startswith("    ") for line in excerpt)
        technical = re.search(r"has no attribute|object is not|could not convert", first)
        return "" if clear and not technical else str(refused)
    except Exception as error:
        return f"a {type(error).__name__}: {error}"
    return "it is accepted"


def test_several_of_a_word_in_y() -> None:
    with pytest.raises(InputError, match="must be a Cavity or a sequence of Cavities, not"):
        c.Body(1.0, (0.4, 0.5, 0.6), c.Ball(1.0), cavity="x")  # type: ignore[arg-type]


def _public_functions() -> Iterator[tuple[str, Callable[..., Any]]]:
    """Every function with arguments of the public namespaces, by its full name."""
    packages = (flowlanes, lawproof, nonholonomic, c)
    found = [m for p in packages for m in pkgutil.walk_packages(p.__path__, f"{p.__name__}.")]
    # the command line and the checker of certificates refuse in ways of their own
    apart = re.compile(r"\.cli\b")
    folders = (m.name for m in found if m.ispkg and not apart.search(m.name))
    for module in (*(p.__name__ for p in packages), *folders):
        space = import_module(module)
        for name in getattr(space, "__all__", ()):
            thing = getattr(space, name)
            if inspect.isfunction(thing) and inspect.signature(thing).parameters:
                yield f"{module}.{name}", thing


def test_a_mere_object_is_refused() -> None:
    public = dict(_public_functions())
    assert {"chaplygin.integrate", "flowlanes.parsing.nearest"} < public.keys()
    assert len(public) > 100
    wrong = [fault for name, function in public.items() if (fault := _accepts(name, function))]
    assert not wrong, "\n".join(wrong)


def _accepts(name: str, function: Callable[..., Any]) -> str:
    """How a function answers objects of no type that it knows; empty if it refuses the first."""
    first, *others = inspect.signature(function).parameters.values()
    needed = [p for p in others if p.default is p.empty and p.kind is not p.VAR_KEYWORD]
    named = first.kind in (first.KEYWORD_ONLY, first.VAR_KEYWORD)
    try:
        if named:
            function(**{first.name: object()})
        else:
            function(object(), **{p.name: object() for p in needed})
    except InputError as refused:
        known = re.search(rf"\b({first.name}|object)\b", str(refused))
        return "" if known else f"{name}: {refused}"
    except Exception as error:
        return f"{name}: {type(error).__name__} {error}"
    return f"{name} takes it"


def test_an_unknown_quantity_is_a_missing_key_too() -> None:
    motion = c.integrate(S, X, [0.0, 0.1])
    with pytest.raises(KeyError, match="no quantity 'omga', did you mean 'omega'"):
        motion["omga"]
    with pytest.raises(KeyError, match="by its name in quotes, not by 3"):
        motion[3]  # type: ignore[index]
    with pytest.raises(KeyError, match=r"by its name in quotes, not by \{\}"):
        motion[{}]  # type: ignore[index]


def test_members_are_refused_by_the_function_that_was_called() -> None:
    for members in ("x", None, {"M": "x"}, object()):
        with pytest.raises(InputError, match=r"^ensemble: members must be"):
            c.ensemble(S, members, [0.0, 1.0])


def test_an_unknown_system_is_a_missing_key_too() -> None:
    with pytest.raises(KeyError) as refused:
        nonholonomic.CATALOGUE["chaplygin-bal"]
    assert "did you mean 'chaplygin-ball'?" in str(refused.value)
    assert nonholonomic.CATALOGUE.get("nonsense") is None
    assert "nonsense" not in nonholonomic.CATALOGUE
