"""Mistakes in Python: wrong types, names and shapes are each one clear sentence."""

from __future__ import annotations

import inspect
import pkgutil
import re
from collections.abc import Callable, Iterator
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy as sp

import chaplygin
from flowlanes.errors import InputError, RunError
from flowlanes.system.vectors import real_symbol
from nonholonomic.contact import ContensouErismann, FrictionalContact
from nonholonomic.control import figure_of_eight

c: Any = chaplygin
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
F = c.coordinates(x, y)
M = c.Mechanism("knife", F, (xd**2 + yd**2) / 2, (yd - x * xd,))
EXP = c.loads(BALL)
T = c.integrate(S, X, [0, 1.0])
DS = c.to_dataset(T)
sec = c.poincare_section(S, "gamma_3", 0.0)
AXES = [c.analysis.scans.Axis(name, 1.0, 2.0, 3) for name in ("I_1", "I_2")]
GRID = c.analysis.scans.scan_grid(S, *AXES, {"M": (1, 0, 0), "gamma": (0, 0, 1)})
RETURNS = c.analysis.orbits.ReturnMap(c.PoincareMap(S, sec))

MISTAKES: dict[str, Callable[[], Any]] = {
    "Experiment.path object": lambda: EXP.path(object()),
    "Experiment.where number": lambda: EXP.where("body", 1),
    "measure_exists by keyword": lambda: c.measure_exists(source="ball"),
    "unit_vector 4": lambda: c.core.unit_vector(4),
    "Ball str": lambda: c.Ball("1"),
    "Ball None": lambda: c.Ball(None),
    "Ball neg": lambda: c.Ball(-1),
    "Ball nan": lambda: c.Ball(float("nan")),
    "Ball centre 2": lambda: c.Ball(1.0, centre=(0, 0)),
    "Ball centre str": lambda: c.Ball(1.0, centre="up"),
    "Ball hollow str": lambda: c.Ball(1.0, "yes"),
    "Ball list": lambda: c.Ball([1.0]),
    "Ball array": lambda: c.Ball(np.array([1.0, 2.0])),
    "Ball complex": lambda: c.Ball(1j),
    "Disk list": lambda: c.Disk([1]),
    "Disk zero": lambda: c.Disk(0),
    "Ellipsoid 2": lambda: c.Ellipsoid((1, 2)),
    "Ellipsoid number": lambda: c.Ellipsoid(3.0),
    "Ellipsoid str": lambda: c.Ellipsoid(("a", "b", "c")),
    "Ellipsoid turn": lambda: c.Ellipsoid((1, 2, 3), "north"),
    "Torus None": lambda: c.Torus(1.0, None),
    "Torus dict": lambda: c.Torus({}, 1),
    "Revolution str": lambda: c.Revolution("1 + gamma_3**2"),
    "Revolution None": lambda: c.Revolution(None),
    "Revolution number values": lambda: c.Revolution(sp.Symbol("gamma_3", real=True), 3),
    "Revolution values dict": lambda: c.Revolution(
        sp.Symbol("a") + sp.Symbol("gamma_3", real=True) ** 2, {"a": "x"}
    ),
    "from_profile None": lambda: c.Revolution.from_profile(None, None),
    "from_profile values": lambda: c.Revolution.from_profile(
        sp.Integer(1), sp.Symbol("gamma_3", real=True), "a=1"
    ),
    "Implicit str": lambda: c.Implicit("x**2+y**2+z**2-1"),
    "Implicit no xyz": lambda: c.Implicit(sp.Integer(3)),
    "Implicit list": lambda: c.Implicit([x]),
    "Sphere str": lambda: c.Sphere("2"),
    "Sphere zero": lambda: c.Sphere(0),
    "Sphere negative": lambda: c.Sphere(-2.0),
    "Sphere None": lambda: c.Sphere(None),
    "Body shape str": lambda: c.Body(1.0, (1, 1, 1), "ball"),
    "Body shape class": lambda: c.Body(1.0, (1, 1, 1), c.Ball),
    "Body mass str": lambda: c.Body("1", (1, 1, 1), c.Ball(1.0)),
    "Body mass None": lambda: c.Body(None, (1, 1, 1), c.Ball(1.0)),
    "Body inertia 2": lambda: c.Body(1.0, (1, 1), c.Ball(1.0)),
    "Body inertia number": lambda: c.Body(1.0, 1.0, c.Ball(1.0)),
    "Body inertia None": lambda: c.Body(1.0, None, c.Ball(1.0)),
    "Body inertia ragged": lambda: c.Body(1.0, ((1, 0), (0, 1, 0), (0, 0, 1)), c.Ball(1.0)),
    "Body inertia str": lambda: c.Body(1.0, "1,1,1", c.Ball(1.0)),
    "Body inertia nan": lambda: c.Body(1.0, (1, float("nan"), 1), c.Ball(1.0)),
    "Body gyrostat 2": lambda: c.Body(1.0, (1, 1, 1), c.Ball(1.0), (1, 2)),
    "Body gyrostat str": lambda: c.Body(1.0, (1, 1, 1), c.Ball(1.0), "k"),
    "Forces gravity str": lambda: c.Forces("9.81"),
    "Forces gravity vec": lambda: c.Forces((0, 0, -9.81)),
    "Forces potential str": lambda: c.Forces(9.81, "gamma_3"),
    "Forces potential unknown": lambda: c.roll(B, field=c.Forces(9.81, sp.Symbol("k"))),
    "Forces values": lambda: c.Forces(9.81, 0, "k"),
    "roll body str": lambda: c.roll("ball"),
    "roll body None": lambda: c.roll(None),
    "roll shape": lambda: c.roll(c.Ball(1.0)),
    "roll surface str": lambda: c.roll(B, "plane"),
    "roll surface class": lambda: c.roll(B, c.Plane),
    "roll contact": lambda: c.roll(B, c.Plane(), "sliding"),
    "roll contact None": lambda: c.roll(B, c.Plane(), None),
    "roll field number": lambda: c.roll(B, field=9.81),
    "roll name number": lambda: c.roll(B, name=3),
    "roll swapped": lambda: c.roll(c.Plane(), B),
    "Rolling str": lambda: c.Rolling("ball"),
    "RollingBall surface str": lambda: c.RollingBall(
        mass=1, inertia=0.4, radius=1, surface="plane"
    ),
    "RollingBall mass": lambda: c.RollingBall(mass="1", inertia=0.4, radius=1, surface=c.Plane()),
    "rolling_mechanism system": lambda: c.rolling_mechanism(S),
    "rolling_mechanism None": lambda: c.rolling_mechanism(None),
    "from_catalogue unknown": lambda: c.from_catalogue("chaplygin-bal"),
    "from_catalogue None": lambda: c.from_catalogue(None),
    "from_catalogue number": lambda: c.from_catalogue(3),
    "from_catalogue system": lambda: c.from_catalogue(S),
    "from_catalogue param str": lambda: c.from_catalogue("chaplygin-ball", I_1="2"),
    "from_catalogue param unknown": lambda: c.from_catalogue("chaplygin-ball", J=2),
    "from_catalogue param neg": lambda: c.from_catalogue("chaplygin-ball", I_1=-2),
    "from_catalogue param None": lambda: c.from_catalogue("chaplygin-ball", I_1=None),
    "from_catalogue param list": lambda: c.from_catalogue("chaplygin-ball", I_1=[1, 2, 3]),
    "from_catalogue param nan": lambda: c.from_catalogue("chaplygin-ball", I_1=float("nan")),
    "integrate name": lambda: c.integrate("chaplygin-ball", X, [0, 1]),
    "integrate None": lambda: c.integrate(None, X, [0, 1]),
    "integrate mechanism": lambda: c.integrate(M, [0, 0, 1], [0, 1]),
    "integrate body": lambda: c.integrate(B, X, [0, 1]),
    "integrate experiment": lambda: c.integrate(EXP, X, [0, 1]),
    "integrate start None": lambda: c.integrate(S, None, [0, 1]),
    "integrate start number": lambda: c.integrate(S, 3.0, [0, 1]),
    "integrate start short": lambda: c.integrate(S, [1, 2], [0, 1]),
    "integrate start str": lambda: c.integrate(S, "here", [0, 1]),
    "integrate start strs": lambda: c.integrate(S, ["a"] * len(X), [0, 1]),
    "integrate start dict wrong": lambda: c.integrate(S, {"q": 1}, [0, 1]),
    "integrate start dict part": lambda: c.integrate(S, {"M": (1, 0, 0)}, [0, 1]),
    "integrate start dict len": lambda: c.integrate(S, {"M": (1, 0), "gamma": (0, 0, 1)}, [0, 1]),
    "integrate start dict str": lambda: c.integrate(S, {"M": "up", "gamma": (0, 0, 1)}, [0, 1]),
    "integrate start dict None": lambda: c.integrate(S, {"M": None, "gamma": (0, 0, 1)}, [0, 1]),
    "integrate start 2d": lambda: c.integrate(S, np.ones((2, 6)), [0, 1]),
    "integrate start nan": lambda: c.integrate(S, [float("nan")] * len(X), [0, 1]),
    "integrate start complex": lambda: c.integrate(S, [1j] * len(X), [0, 1]),
    "integrate start dict int keys": lambda: c.integrate(S, {1: 2}, [0, 1]),
    "integrate times number": lambda: c.integrate(S, X, 10),
    "integrate times None": lambda: c.integrate(S, X, None),
    "integrate times empty": lambda: c.integrate(S, X, []),
    "integrate times unsorted": lambda: c.integrate(S, X, [0, 2, 1]),
    "integrate times str": lambda: c.integrate(S, X, "0,1"),
    "integrate times nan": lambda: c.integrate(S, X, [0, float("nan")]),
    "integrate times 2d": lambda: c.integrate(S, X, [[0, 1], [2, 3]]),
    "integrate parameters list": lambda: c.integrate(S, X, [0, 1], parameters=[1, 2]),
    "integrate parameters unknown": lambda: c.integrate(S, X, [0, 1], parameters={"q": 1}),
    "integrate parameters str": lambda: c.integrate(S, X, [0, 1], parameters={"m": "1 kg"}),
    "integrate parameters None": lambda: c.integrate(S, X, [0, 1], parameters={"m": None}),
    "integrate parameters int key": lambda: c.integrate(S, X, [0, 1], parameters={3: 1.0}),
    "integrate tolerance str": lambda: c.integrate(S, X, [0, 1], tolerance="small"),
    "integrate tolerance neg": lambda: c.integrate(S, X, [0, 1], tolerance=-1),
    "integrate tolerance big": lambda: c.integrate(S, X, [0, 1], tolerance=10),
    "integrate precision": lambda: c.integrate(S, X, [0, 1], precision="triple"),
    "integrate precision num": lambda: c.integrate(S, X, [0, 1], precision=34),
    "integrate method": lambda: c.integrate(S, X, [0, 1], method="rk4"),
    "integrate method list": lambda: c.integrate(S, X, [0, 1], method=["taylor"]),
    "integrate liftoff": lambda: c.integrate(S, X, [0, 1], on_liftoff="fly"),
    "integrate time_limit": lambda: c.integrate(S, X, [0, 1], time_limit="1 min"),
    "integrate time_limit neg": lambda: c.integrate(S, X, [0, 1], time_limit=-1),
    "integrate progress": lambda: c.integrate(S, X, [0, 1], progress="yes"),
    "integrate dense gauss": lambda: c.integrate(S, X, [0, 1], keep_integrals="yes"),
    "initial_state name": lambda: c.initial_state("chaplygin-ball", (1, 0, 0), (0, 0, 1)),
    "initial_state len": lambda: c.initial_state(S, (1, 0), (0, 0, 1)),
    "initial_state number": lambda: c.initial_state(S, 1, (0, 0, 1)),
    "initial_state None": lambda: c.initial_state(S, None, None),
    "initial_state zero": lambda: c.initial_state(S, (1, 0, 0), (0, 0, 0)),
    "initial_state heading": lambda: c.initial_state(S, (1, 0, 0), (0, 0, 1), heading="north"),
    "initial_state params": lambda: c.initial_state(S, (1, 0, 0), (0, 0, 1), parameters={"zz": 1}),
    "initial_state normal": lambda: c.initial_state(S, (1, 0, 0), (0, 0, 1), normal=(0, 1)),
    "initial_state of sleigh": lambda: c.initial_state(
        c.from_catalogue("chaplygin-sleigh"), (1, 0, 0), (0, 0, 1)
    ),
    "lyapunov_spectrum name": lambda: c.lyapunov_spectrum("chaplygin-ball", X, until=10),
    "lyapunov_spectrum until str": lambda: c.lyapunov_spectrum(S, X, until="10"),
    "lyapunov_spectrum until neg": lambda: c.lyapunov_spectrum(S, X, until=-10),
    "lyapunov_spectrum intervals": lambda: c.lyapunov_spectrum(S, X, until=10, intervals=0),
    "lyapunov_spectrum intervals float": lambda: c.lyapunov_spectrum(S, X, until=10, intervals=1.5),
    "lyapunov_spectrum start short": lambda: c.lyapunov_spectrum(S, [1, 2], until=10),
    "lyapunov_spectrum params": lambda: c.lyapunov_spectrum(S, X, {"q": 1}, until=10),
    "lyapunov_spectrum params list": lambda: c.lyapunov_spectrum(S, X, [1, 2], until=10),
    "lyapunov_spectrum tol": lambda: c.lyapunov_spectrum(S, X, until=10, tolerance="x"),
    "prove name": lambda: c.prove("chaplygin-ball"),
    "prove law unknown": lambda: c.prove(S, "enrgy"),
    "prove law number": lambda: c.prove(S, 3),
    "prove effort": lambda: c.prove(S, "energy", effort="much"),
    "prove effort neg": lambda: c.prove(S, "energy", effort=-1),
    "prove None": lambda: c.prove(None),
    "measure_exists str": lambda: c.measure_exists("chaplygin-ball"),
    "measure_exists None": lambda: c.measure_exists(None),
    "measure_exists system": lambda: c.measure_exists(S),
    "classify str": lambda: c.classify("chaplygin-ball"),
    "classify None": lambda: c.classify(None),
    "classify verdicts": lambda: c.classify(S, "all"),
    "reversors str": lambda: c.reversors("chaplygin-ball"),
    "reversors mech": lambda: c.reversors(M),
    "rotation_number number": lambda: c.rotation_number(3),
    "rotation_number array": lambda: c.rotation_number(np.ones(10)),
    "rotation_number target": lambda: c.rotation_number(lambda n: np.arange(n) * 0.1, target="x"),
    "rotation_number bad callable": lambda: c.rotation_number(lambda n: None),
    "rotation_number wrong len": lambda: c.rotation_number(lambda n: np.ones(3)),
    "linear_stability str": lambda: c.linear_stability("x", X),
    "linear_stability short": lambda: c.linear_stability(S, [1]),
    "linear_stability digits": lambda: c.linear_stability(S, X[:6], digits="many"),
    "linear_stability along": lambda: c.linear_stability(S, X[:6], along=3),
    "batch_integrator str": lambda: c.batch_integrator("S"),
    "batch_integrator deviations": lambda: c.batch_integrator(S, deviations="x"),
    "batch_integrator tolerance": lambda: c.batch_integrator(S, tolerance="x"),
    "batch_integrator digits": lambda: c.batch_integrator(S, digits=20),
    "batch_integrator section str": lambda: c.batch_integrator(S, section="gamma_3"),
    "poincare_section unknown": lambda: c.poincare_section(S, "delta"),
    "poincare_section None": lambda: c.poincare_section(S, None),
    "poincare_section value": lambda: c.poincare_section(S, "gamma_3", "0"),
    "poincare_section direction": lambda: c.poincare_section(S, "gamma_3", 0, "rising"),
    "poincare_section direction 5": lambda: c.poincare_section(S, "gamma_3", 0, 5),
    "poincare_section system": lambda: c.poincare_section("S", "gamma_3"),
    "PoincareMap str": lambda: c.PoincareMap(S, "gamma_3"),
    "PoincareMap name": lambda: c.PoincareMap("S", sec),
    "PoincareMap params": lambda: c.PoincareMap(S, sec, {"q": 1}),
    "PoincareMap params list": lambda: c.PoincareMap(S, sec, [1]),
    "PoincareMap crossings": lambda: c.PoincareMap(S, sec).crossings([1, 2], 3),
    "PoincareMap crossings str": lambda: c.PoincareMap(S, sec).crossings("x", 3),
    "PoincareMap crossings count": lambda: c.PoincareMap(S, sec).crossings([X[:6]], "x"),
    "PoincareMap crossings count neg": lambda: c.PoincareMap(S, sec).crossings([X[:6]], -1),
    "PoincareMap within": lambda: c.PoincareMap(S, sec).within("q", 1),
    "PoincareMap within width": lambda: c.PoincareMap(S, sec).within("gamma_1", "x"),
    "ensemble str": lambda: c.ensemble("S", [X[:6]], [0, 1]),
    "ensemble members None": lambda: c.ensemble(S, None, [0, 1]),
    "ensemble members short": lambda: c.ensemble(S, [[1, 2]], [0, 1]),
    "ensemble members str": lambda: c.ensemble(S, "x", [0, 1]),
    "ensemble times": lambda: c.ensemble(S, [X[:6]], "x"),
    "ensemble times num": lambda: c.ensemble(S, [X[:6]], 3),
    "ensemble record": lambda: c.ensemble(S, [X[:6]], [0, 1], record=["zz"]),
    "ensemble record str": lambda: c.ensemble(S, [X[:6]], [0, 1], record="energy"),
    "ensemble params": lambda: c.ensemble(S, [X[:6]], [0, 1], [1]),
    "ensemble block": lambda: c.ensemble(S, [X[:6]], [0, 1], block=0),
    "ensemble block str": lambda: c.ensemble(S, [X[:6]], [0, 1], block="x"),
    "ensemble where num": lambda: c.ensemble(S, [X[:6]], [0, 1], where=3),
    "ensemble client": lambda: c.ensemble(S, [X[:6]], [0, 1], client="here"),
    "sample_level str": lambda: c.sample_level("S", 3, {}),
    "sample_level count": lambda: c.sample_level(S, "3", {}),
    "sample_level count neg": lambda: c.sample_level(S, -3, {"energy": 1.0}),
    "sample_level level unknown": lambda: c.sample_level(S, 3, {"enrgy": 1.0}),
    "sample_level level str": lambda: c.sample_level(S, 3, {"energy": "1"}),
    "sample_level level None": lambda: c.sample_level(S, 3, None),
    "sample_level level list": lambda: c.sample_level(S, 3, ["energy"]),
    "sample_level seed": lambda: c.sample_level(S, 3, {"energy": 1.0}, seed="x"),
    "sample_level level impossible": lambda: c.sample_level(S, 3, {"energy": -1.0}),
    "solve str": lambda: c.solve("S", X),
    "solve start": lambda: c.solve(S, "x"),
    "solve start None": lambda: c.solve(S, None),
    "solve states": lambda: c.solve(S, X).states("x"),
    "solve rigorous": lambda: c.solve(S, X).rigorous("x"),
    "solve rigorous digits": lambda: c.solve(S, X).rigorous(1, "x"),
    "gauss_integrator str": lambda: c.gauss_integrator("S", X),
    "gauss_integrator start": lambda: c.gauss_integrator(S, [1]),
    "gauss_integrator digits": lambda: c.gauss_integrator(S, X, digits=12),
    "load None": lambda: c.load(None),
    "load number": lambda: c.load(3),
    "load dict": lambda: c.load({"body": 1}),
    "load overrides str": lambda: c.loads(BALL, overrides="run.until=3"),
    "load overrides num": lambda: c.loads(BALL, overrides=3),
    "load overrides nums": lambda: c.loads(BALL, overrides=[3]),
    "load overrides dict": lambda: c.loads(BALL, overrides={"run.until": 3}),
    "loads None": lambda: c.loads(None),
    "loads bytes": lambda: c.loads(b"x"),
    "loads path": lambda: c.loads(Path("x")),
    "loads name": lambda: c.loads("x", 3),
    "prepare str": lambda: c.prepare("ball.toml"),
    "prepare None": lambda: c.prepare(None),
    "prepare system": lambda: c.prepare(S),
    "study pieces": lambda: c.prepare(EXP).trajectory(pieces=0),
    "read missing": lambda: c.read("none.nc"),
    "read None": lambda: c.read(None),
    "read bad": lambda: c.read("bad.nc"),
    "read bad zarr": lambda: c.read("bad.zarr"),
    "read dir": lambda: c.read("dir.nc"),
    "write None": lambda: c.write(None, "a.nc"),
    "write trajectory": lambda: c.write(T, "a.nc"),
    "write suffix": lambda: c.write(DS, "a.txt"),
    "write nowhere": lambda: c.write(DS, "/none/a.nc"),
    "write None path": lambda: c.write(DS, None),
    "write dir": lambda: c.write(DS, "dir.nc"),
    "to_dataset None": lambda: c.to_dataset(None),
    "to_dataset str": lambda: c.to_dataset("x"),
    "to_dataset attributes": lambda: c.to_dataset(T, "x"),
    "audit section": lambda: c.audit(99),
    "audit section str": lambda: c.audit("two"),
    "audit workers": lambda: c.audit(2, workers="x"),
    "coordinates str num": lambda: c.coordinates(3),
    "coordinates none": c.coordinates,
    "coordinates twice": lambda: c.coordinates(x, x),
    "coordinates None": lambda: c.coordinates(None),
    "coordinates dot": lambda: c.coordinates(x, dot=3),
    "Frame nothing": lambda: c.Frame((), ()),
    "Frame None": lambda: c.Frame(None, None),
    "Frame str": lambda: c.Frame("x", "y"),
    "Frame field": lambda: F.field(7),
    "Frame field str": lambda: F.field("x"),
    "Mechanism frame": lambda: c.Mechanism("a", "frame", xd**2),
    "Mechanism lagrangian None": lambda: c.equations(c.Mechanism("a", F, None)),
    "Mechanism lagrangian str": lambda: c.equations(c.Mechanism("a", F, "xdot**2")),
    "Mechanism constraint bare": lambda: c.equations(
        c.Mechanism("a", F, xd**2 + yd**2, yd - x * xd)
    ),
    "Mechanism constraint strs": lambda: c.equations(c.Mechanism("a", F, xd**2 + yd**2, ("xdot",))),
    "Mechanism undeclared": lambda: c.equations(
        c.Mechanism("a", F, sp.Symbol("m") * (xd**2 + yd**2))
    ),
    "Mechanism parameters": lambda: c.Mechanism("a", F, xd**2 + yd**2, parameters=("m",)),
    "Mechanism name": lambda: c.Mechanism(3, F, xd**2 + yd**2),
    "equations str": lambda: c.equations("x"),
    "equations system": lambda: c.equations(S),
    "nonholonomy str": lambda: c.nonholonomy("x"),
    "nonholonomy system": lambda: c.nonholonomy(S),
    "chaplygin_form str": lambda: c.chaplygin_form("x"),
    "chaplygin_form levels": lambda: c.chaplygin_form(M, 3),
    "from_sympy str": lambda: c.from_sympy("x"),
    "from_sympy None": lambda: c.from_sympy(None),
    "mechanism_from_sympy": lambda: c.mechanism_from_sympy(3),
    "Parameter str": lambda: c.Parameter("m", "mass", 1.0),
    "Parameter default str": lambda: c.Parameter(sp.Symbol("m", real=True), "mass", "1"),
    "Parameter None": lambda: c.Parameter(None, "mass", 1.0),
    "System field None": lambda: c.System("a", "A", None),
    "System field str": lambda: c.System("a", "A", "x"),
    "System field dict strs": lambda: c.System("a", "A", {"x": "x"}),
    "System field undeclared": lambda: c.System("a", "A", {x: sp.Symbol("q") * x}),
    "System laws str": lambda: c.System("a", "A", {x: x}, laws=("energy",)),
    "System parameters": lambda: c.System("a", "A", {x: x}, parameters=({"m": 1},)),
    "System name": lambda: c.System(None, "A", {x: x}),
    "System with_laws": lambda: S.with_laws("energy"),
    "source_code": lambda: c.source_code(S, "fortran"),
    "source_code None": lambda: c.source_code(S, None),
    "lambdify": lambda: c.lambdify(S, "torch"),
    "System required_definitions": lambda: S.required_definitions("x"),
    "Integral str": lambda: c.Integral("e", "x"),
    "Integral None": lambda: c.Integral("e", None),
    "Integral name": lambda: c.Integral(3, x),
    "Integral unknown": lambda: c.prove(S.with_laws(c.Integral("e", sp.Symbol("q")))),
    "Measure str": lambda: c.Measure("m", "1"),
    "Symmetry None": lambda: c.Symmetry("s", None),
    "Symmetry list": lambda: c.Symmetry("s", [x]),
    "Identity None": lambda: c.Identity("i", None),
    "Rate": lambda: c.Rate("x"),
    "PoissonStructure": lambda: c.PoissonStructure("p", "x"),
    "PoissonStructure matrix 2x3": lambda: c.PoissonStructure("p", sp.zeros(2, 3)),
    "ConformallyHamiltonian": lambda: c.ConformallyHamiltonian("h", 1, "x", 2),
    "Isomorphism": lambda: c.Isomorphism("i", "chaplygin-ball", {}),
    "Reduction": lambda: c.Reduction("r", "x", "y"),
    "Separation": lambda: c.Separation("r", None, None),
    "subsample": lambda: T.subsample("x"),
    "subsample 0": lambda: T.subsample(0),
    "dimension nan": lambda: c.from_catalogue("chaplygin-ball-nd", dimension=float("nan")),
    "dimension inf": lambda: c.from_catalogue("chaplygin-ball-nd", dimension=float("inf")),
    "dimension 3.5": lambda: c.from_catalogue("chaplygin-ball-nd", dimension=3.5),
    "gauss start nan": lambda: c.gauss_integrator(S, [float("nan")] * 6),
    "closed form at a word": lambda: c.solve(S, X)("now"),
    "closed form at nan": lambda: c.solve(S, X)([float("nan")]),
    "section value nan": lambda: c.poincare_section(S, "gamma_3", float("nan")),
    "section value inf": lambda: c.poincare_section(S, "gamma_3", float("inf")),
    "figure_of_eight nan": lambda: figure_of_eight(float("nan"), 1.0, 1.0),
    "figure_of_eight inf": lambda: figure_of_eight(1.0, float("inf"), 1.0),
    "figure_of_eight period nan": lambda: figure_of_eight(1.0, 1.0, float("nan")),
    "figure_of_eight period zero": lambda: figure_of_eight(1.0, 1.0, 0.0),
    "initial_state of n dimensions": lambda: c.initial_state(
        c.from_catalogue("chaplygin-ball-nd"), (1, 0, 0), (0, 0, 1)
    ),
    "initial_state heading nan": lambda: c.initial_state(
        S, (1, 0, 0), (0, 0, 1), heading=float("nan")
    ),
    "batch_integrator list": lambda: c.batch_integrator([]),
    "batch parameters number": lambda: c.batch_integrator(S).propagate([X[:6]], [0, 1.0], 3),
    "batch reach of nothing": lambda: c.batch_integrator(S).require_reach(X[:6], None),
    "inertia too large for a float": lambda: c.Body(1.0, (10**400, 1, 1), c.Ball(1.0)),
    "PoissonStructure of a number": lambda: c.PoissonStructure("p", 3),
    "PoissonStructure ragged": lambda: c.PoissonStructure("p", [[1, 2], [3]]),
    "PoincareMap tolerance": lambda: c.PoincareMap(S, sec, tolerance=-1.0),
    "PoincareMap until": lambda: c.PoincareMap(S, sec, until=float("nan")),
    "PoincareMap point is a word": lambda: c.PoincareMap(S, sec)("x"),
    "PoincareMap dimension of nothing": lambda: c.PoincareMap(S, sec).dimension([None] * 6),
    "states of one number": lambda: c.formulas.Formulas(S, [S.integrals[0].value])(3),
    "closed form at nan in rows": lambda: c.solve(S, X).states([float("nan")]),
    "constant of one number": lambda: c.core.constant(-1.5),
    "controlled system of a word": lambda: c.control.ControlledSystem(*["x"] * 7),
    "kaplan_yorke of a word": lambda: c.analysis.lyapunov.kaplan_yorke("x"),
    "megno of nothing": lambda: c.analysis.lyapunov.Megno(None, 10.0),
    "megno backwards": lambda: c.analysis.lyapunov.Megno(S, -10.0),
    "find_periodic of nothing": lambda: c.analysis.orbits.find_periodic(None, X[:6]),
    "axis of bytes": lambda: c.analysis.scans.axis(b"x"),
    "axis to nowhere": lambda: c.analysis.scans.Axis("a", 0.0, float("nan"), 3),
    "scan_grid of nothing": lambda: c.analysis.scans.scan_grid(S, None, None, {}),
    "search degree": lambda: c.search.search_request(S, degree="two"),
    "search momenta": lambda: c.search.search_request(S, momenta=b"x"),
    "level_sampler parameters": lambda: c.flow.level_sampler(S, {"energy": 1.0}, 3),
    "relative_equilibrium digits": lambda: c.flow.relative_equilibrium(S, X[:6], digits="x"),
    "ball_values without a value": lambda: c.formulas.ball_values([x], {}),
    "bifurcation_diagram of nothing": lambda: c.explicit.bifurcation_diagram(None),
    "figure of a number": lambda: c.report.figures.state(DS, 3),
    "figure of a word": lambda: c.report.figures.drift("x"),
    "drift of an unknown name": lambda: c.report.figures.relative_drift(DS, "enrgy"),
    "cross of a number": lambda: c.core.cross(3, 4),
    "components of nothing": lambda: c.core.to_components(None),
    "vector of no size": lambda: c.core.Vector("a", None),
    "entry of nothing": lambda: c.catalogue.entry(None),
    "entry settings number": lambda: c.catalogue.entry("chaplygin-ball").settings(3),
    "path at a word": lambda: figure_of_eight(1.0, 1.0, 1.0).places("x"),
    "relations that are numbers": lambda: c.System("a", "A", {x: x}, relations=(None,)),
    "nearest of nothing": lambda: c.parsing.nearest(None, ["a"]),
    "nearest among nothing": lambda: c.parsing.nearest("a", None),
    "nearest among bytes": lambda: c.parsing.nearest("a", [b"x"]),
    "ball of nothing": lambda: c.formulas.ball(None),
    "ball of a word": lambda: c.formulas.ball("x"),
    "ball of a complex number": lambda: c.formulas.ball(1j),
    "ball_function of nothing": lambda: c.formulas.ball_function(None, (x,)),
    "ball_function of a word": lambda: c.formulas.ball_function((x,), "x"),
    "ball_function steps": lambda: c.formulas.ball_function((x,), (x,), steps="x"),
    "multipliers of a short point": lambda: c.analysis.orbits.multipliers(
        RETURNS, np.ones(2), np.eye(6)
    ),
    "multipliers of a small slope": lambda: c.analysis.orbits.multipliers(
        RETURNS, np.array(X[:6]), np.eye(2)
    ),
    "multipliers of nan": lambda: c.analysis.orbits.multipliers(
        RETURNS, np.full(6, np.nan), np.eye(6)
    ),
    "sizes of short points": lambda: RETURNS.sizes(np.ones((2, 2))),
    "sizes of no points": lambda: RETURNS.sizes(np.ones((0, 6))),
    "sizes of one point": lambda: RETURNS.sizes(np.ones(6)),
    "CATALOGUE of nothing": lambda: c.CATALOGUE[None],
    "CATALOGUE of a list": lambda: c.CATALOGUE[[]],
    "CATALOGUE of an unknown name": lambda: c.CATALOGUE["nonsense"],
    "derivative at a number": lambda: c.PoincareMap(S, sec).derivative(3),
    "cells of row nan": lambda: GRID.cells(float("nan"), 2),
    "cells of no row": lambda: GRID.cells(3, 2),
    "cells past the last row": lambda: GRID.cells(3, 4),
    "svg_file of nothing": lambda: c.report.figures.svg_file(None),
    "patch larger than the disk": lambda: FrictionalContact(
        c.Body(1.0, (0.3, 0.3, 0.5), c.Disk(1.0)), laws=(ContensouErismann(0.3, 1.1),)
    ),
}


@pytest.mark.parametrize("name", MISTAKES)
def test_one_sentence(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("bad.nc").write_bytes(b"CDF\x01garbage")
    Path("bad.zarr").mkdir()
    Path("dir.nc").mkdir()
    with pytest.raises((InputError, RunError)) as refused:
        MISTAKES[name]()
    first, *excerpt = str(refused.value).splitlines()
    assert len(first) < 600
    assert all(line.startswith("    ") for line in excerpt)
    assert not re.search(r"has no attribute|object is not|could not convert", first)


def test_several_of_a_word_in_y() -> None:
    with pytest.raises(InputError, match="must be a Cavity or a sequence of Cavities, not"):
        c.Body(1.0, (0.4, 0.5, 0.6), c.Ball(1.0), cavity="x")  # type: ignore[arg-type]


def _public_functions() -> Iterator[tuple[str, Callable[..., Any]]]:
    """Every function with arguments of the public namespaces, by its full name."""
    found = pkgutil.walk_packages(chaplygin.__path__, "chaplygin.")
    # the command line and the checker of certificates refuse in ways of their own
    apart = re.compile(r"\.(cli|check)\b|\.borisov_mamaev\.")
    for module in ("chaplygin", *(m.name for m in found if m.ispkg and not apart.search(m.name))):
        space = import_module(module)
        for name in getattr(space, "__all__", ()):
            thing = getattr(space, name)
            if inspect.isfunction(thing) and inspect.signature(thing).parameters:
                yield f"{module}.{name}", thing


PUBLIC = dict(_public_functions())


def test_public_functions_are_there() -> None:
    assert {"flowlanes.integrate", "flowlanes.parsing.nearest"} < PUBLIC.keys()
    assert len(PUBLIC) > 100


@pytest.mark.parametrize("name", PUBLIC)
def test_a_mere_object_is_refused(name: str) -> None:
    function = PUBLIC[name]
    first, *others = inspect.signature(function).parameters.values()
    needed = [p for p in others if p.default is p.empty and p.kind is not p.VAR_KEYWORD]
    named = first.kind in (first.KEYWORD_ONLY, first.VAR_KEYWORD)
    with pytest.raises(InputError, match=rf"\b({first.name}|object)\b"):
        if named:
            function(**{first.name: object()})
        else:
            function(object(), **{p.name: object() for p in needed})


def test_an_unknown_quantity_is_a_missing_key_too() -> None:
    motion = c.integrate(S, X, [0.0, 0.1])
    with pytest.raises(KeyError, match="no quantity 'omga', did you mean 'omega'"):
        motion["omga"]
    with pytest.raises(KeyError, match="by its name in quotes, not by 3"):
        motion[3]  # type: ignore[index]
    with pytest.raises(KeyError, match=r"by its name in quotes, not by \{\}"):
        motion[{}]  # type: ignore[index]


@pytest.mark.parametrize("members", ["x", None, {"M": "x"}, object()])
def test_members_are_refused_by_the_function_that_was_called(members: Any) -> None:
    with pytest.raises(InputError, match=r"^ensemble: members must be"):
        c.ensemble(S, members, [0.0, 1.0])


def test_an_unknown_system_is_a_missing_key_too() -> None:
    with pytest.raises(KeyError) as refused:
        c.CATALOGUE["chaplygin-bal"]
    assert "did you mean 'chaplygin-ball'?" in str(refused.value)
    assert c.CATALOGUE.get("nonsense") is None
    assert "nonsense" not in c.CATALOGUE
