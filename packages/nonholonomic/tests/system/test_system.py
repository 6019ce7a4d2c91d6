"""A System refuses what it does not know, orders what it needs and never changes."""

from __future__ import annotations

import dataclasses
import re
from dataclasses import replace

import pytest
import sympy as sp

from every_system import CASES, bare, laden
from flowlanes.errors import InputError
from flowlanes.system.laws import Integral
from flowlanes.system.system import Observable, Parameter, Reconstruction, System
from flowlanes.system.vectors import (
    Diagonal,
    Symmetric,
    Vector,
    cross,
    dot,
    norm_squared,
    real_symbol,
)
from nonholonomic.catalogue import from_catalogue
from nonholonomic.mechanics.lagrangian.mechanism import Frame, Mechanism

M, omega, gamma = Vector("M"), Vector("omega"), Vector("gamma")
I, A = Diagonal("I"), Diagonal("A")
s, unused, height, v = (real_symbol(name) for name in ("s", "unused", "height", "v"))


def top() -> System:
    """Euler's equations, with a definition that nothing needs."""
    return System(
        name="top",
        title="Free body",
        field={M: cross(M, omega), gamma: cross(gamma, omega)},
        parameters=tuple(
            Parameter(symbol, f"moment of inertia {i}", float(i), "kg m^2", (symbol > 0,))
            for i, symbol in enumerate(I.symbols, 1)
        ),
        definitions={
            A: I**-1,
            unused: norm_squared(M),
            omega: A * M,
            s: sp.sqrt(dot(gamma, omega)),
        },
        relations=(norm_squared(gamma) - 1,),
        laws=(Integral("energy", dot(M, omega) / 2, "energy"),),
    )


def test_flat_order_is_the_order_of_declaration() -> None:
    system = top()
    assert system.state == (M, gamma)
    assert system.symbols == (*M.symbols, *gamma.symbols)
    m, w = M.symbols, omega.symbols
    assert system.rates[0] == m[1] * w[2] - m[2] * w[1]
    assert len(system.rates) == 6
    assert system.defaults == dict(zip(I.symbols, (1.0, 2.0, 3.0), strict=True))


def test_definitions_become_scalar_steps_in_order() -> None:
    assert [str(symbol) for symbol, _ in top().scalar_definitions] == [
        *("A_1", "A_2", "A_3", "unused", "omega_1", "omega_2", "omega_3", "s")
    ]
    assert dict(top().scalar_definitions)[A.symbols[1]] == 1 / I.symbols[1]


def test_a_symmetric_tensor_has_six_steps() -> None:
    G = Symmetric("G")
    system = System("six", "Six", {v: sp.S.Zero}, definitions={G: sp.eye(3) * v})
    assert [str(symbol) for symbol, _ in system.scalar_definitions] == [
        *("G_11", "G_12", "G_13", "G_22", "G_23", "G_33")
    ]


def test_needed_steps_are_those_that_are_used_in_order() -> None:
    system = top()
    names = [str(symbol) for symbol, _ in system.required_definitions(system.rates)]
    assert names == ["A_1", "A_2", "A_3", "omega_1", "omega_2", "omega_3"]
    assert [str(x) for x, _ in system.required_definitions([omega.symbols[1]])] == [
        "A_2",
        "omega_2",
    ]
    assert system.required_definitions([gamma.symbols[0]]) == ()


def test_needed_stops_at_what_is_given() -> None:
    system = top()
    assert system.required_definitions(system.rates, inputs=omega.symbols) == ()
    assert [str(x) for x, _ in system.required_definitions([s], inputs=omega.symbols)] == ["s"]


def test_vector_formulas_may_be_asked_for() -> None:
    system = top()
    assert system.required_definitions([dot(M, omega)]) == system.required_definitions(system.rates)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"field": {M: v * M, gamma: M}}, "the rate of M_1 uses v"),
        ({"definitions": {omega: A * M, A: I**-1}}, "the definition of omega_1 uses A_1"),
        ({"definitions": {s: s + 1}}, "the definition of s uses s"),
        ({"laws": (Integral("area", real_symbol("q"), "x"),)}, "the law 'area' uses q"),
        ({"relations": (real_symbol("q") - 1,)}, "the relation q - 1 uses q"),
    ],
)
def test_unknown_symbols_are_refused(change: dict[str, object], message: str) -> None:
    with pytest.raises(InputError) as error:
        replace(top(), **change)
    assert str(error.value).startswith(f"top: {message}, which is neither a state variable")


@pytest.mark.parametrize("other", [sp.Symbol("s"), sp.Symbol("s", positive=True)])
@pytest.mark.parametrize("role", ["field", "definitions", "parameters", "reconstruction"])
def test_names_that_are_written_alike_are_refused(other: sp.Symbol, role: str) -> None:
    """`s` of the system is a real symbol; the other one is another symbol for SymPy."""
    system = top()
    more = {
        "field": (*system.field, (other, sp.S.Zero)),
        "definitions": (*system.definitions, (other, sp.S.One)),
        "parameters": (*system.parameters, Parameter(other, "other", 1.0)),
        "reconstruction": Reconstruction({other: sp.S.One}, (), ()),
    }
    with pytest.raises(InputError, match="top: s stands for two things; each state variable"):
        replace(system, **{role: more[role]})


@pytest.mark.parametrize("name", ["2", "x y", "f(x)", "x_{1}", "a,b", ""])
def test_a_name_that_is_no_word_is_refused(name: str) -> None:
    system = top()
    message = f"top: {re.escape(repr(name))} is no name for a state variable, a definition or a p"
    with pytest.raises(InputError, match=message):
        replace(system, field=(*system.field, (sp.Symbol(name, real=True), sp.S.Zero)))


@pytest.mark.parametrize("name", ["pi", "sin", "sqrt", "atan2"])
@pytest.mark.parametrize("role", ["state", "parameter", "definition"])
def test_a_name_that_means_a_number_or_a_function_is_refused(name: str, role: str) -> None:
    symbol, x = real_symbol(name), real_symbol("x")
    more: dict[str, object] = {}
    field = {x: sp.Integer(0)}
    if role == "state":
        field[symbol] = sp.Integer(0)
    elif role == "parameter":
        more["parameters"] = (Parameter(symbol, "a number", 3.0),)
    else:
        more["definitions"] = {symbol: sp.Integer(3)}
    with pytest.raises(InputError, match=f"{name} is a number or a function in every formula"):
        System("o", "O", field, **more)


def test_a_vector_has_a_name_of_its_own() -> None:
    with pytest.raises(InputError, match="top: s stands for two things"):
        replace(top(), field={M: cross(M, omega), gamma: cross(gamma, omega), Vector("s"): M})


def test_a_formula_with_a_symbol_that_is_only_written_alike_is_told() -> None:
    field = {M: cross(M, omega), gamma: sp.Symbol("gamma_1") * gamma}
    with pytest.raises(InputError) as error:
        replace(top(), field=field)
    assert str(error.value) == (
        "top: the rate of gamma_1 uses gamma_1 (no assumptions; the known gamma_1 has real=True), "
        "which is neither a state variable, an earlier definition nor a parameter"
    )


@pytest.mark.parametrize("other", [sp.Symbol("q"), sp.Symbol("q", positive=True)])
def test_names_of_a_mechanism_that_are_written_alike_are_refused(other: sp.Symbol) -> None:
    q, w = real_symbol("q"), real_symbol("w")
    with pytest.raises(InputError, match="frame: q stands for two things"):
        Frame({q: w, other: w}, (w,))
    parameters = (Parameter(other, "other", 1.0),)
    with pytest.raises(InputError, match="point: q stands for two things"):
        Mechanism("point", Frame({q: w}, (w,)), w**2 / 2, parameters=parameters)
    with pytest.raises(InputError, match=r"the Lagrangian uses q \("):
        Mechanism("point", Frame({q: w}, (w,)), w**2 / 2 + other)


def test_a_system_cannot_be_changed() -> None:
    system = top()
    with pytest.raises(dataclasses.FrozenInstanceError):
        system.name = "other"  # a mistake on purpose
    mapping = {M: cross(M, omega)}
    definitions = {A: I**-1, omega: A * M}
    other = System("top", "Top", mapping, system.parameters, definitions)
    mapping[gamma] = cross(gamma, omega)
    definitions.clear()
    assert other.state == (M,)
    assert len(other.scalar_definitions) == 6


def test_with_laws_leaves_the_first_system_alone() -> None:
    system = top()
    longer = system.with_laws(Integral("momentum", norm_squared(M), "square of the momentum"))
    assert [law.name for law in longer.laws] == ["energy", "momentum"]
    assert [law.name for law in system.laws] == ["energy"]
    with pytest.raises(InputError, match="the law 'spin' uses q"):
        system.with_laws(Integral("spin", real_symbol("q"), "spin"))


def test_lifted_joins_system_and_motion() -> None:
    motion = Reconstruction(
        field={height: v},
        relations=(height - v,),
        observables=(Observable("height", height, "height", "m"),),
    )
    falling = System("fall", "Fall", {v: sp.Integer(-1)}, reconstruction=motion)
    lifted = falling.lifted()
    assert lifted.symbols == (v, height)
    assert lifted.rates == (-1, v)
    assert lifted.relations == (height - v,)
    assert [o.name for o in lifted.observables] == ["height"]
    assert lifted.reconstruction is None
    with pytest.raises(InputError, match="fall: this system has no motion in space"):
        lifted.lifted()


# Operations in the field and the definitions it needs, with a fifth to spare.
CEILINGS = {
    ("ball", "plane", "marble"): (137, 412),
    ("ball", "plane", "rubber"): (443, 848),
    ("ball", "sphere", "marble"): (143, 458),
    ("ball", "sphere", "rubber"): (472, 916),
    ("unbalanced ball", "plane", "marble"): (288, 707),
    ("unbalanced ball", "plane", "rubber"): (908, 1593),
    ("unbalanced ball", "sphere", "marble"): (298, 756),
    ("unbalanced ball", "sphere", "rubber"): (940, 1665),
    ("hollow ball", "sphere", "marble"): (143, 458),
    ("hollow ball", "sphere", "rubber"): (472, 916),
    ("ellipsoid", "plane", "marble"): (300, 597),
    ("ellipsoid", "plane", "rubber"): (498, 939),
    ("ellipsoid", "sphere", "marble"): (444, 858),
    ("ellipsoid", "sphere", "rubber"): (650, 1208),
    ("rattleback", "plane", "marble"): (455, 752),
    ("rattleback", "plane", "rubber"): (653, 1094),
    ("rattleback", "sphere", "marble"): (693, 1191),
    ("rattleback", "sphere", "rubber"): (898, 1540),
    ("disk", "plane", "marble"): (299, 596),
    ("disk", "plane", "rubber"): (497, 938),
    ("disk", "sphere", "marble"): (426, 840),
    ("disk", "sphere", "rubber"): (632, 1190),
    ("torus", "plane", "marble"): (324, 621),
    ("torus", "plane", "rubber"): (522, 963),
    ("torus", "sphere", "marble"): (489, 914),
    ("torus", "sphere", "rubber"): (694, 1263),
    ("revolution", "plane", "marble"): (318, 615),
    ("revolution", "plane", "rubber"): (516, 957),
    ("revolution", "sphere", "marble"): (441, 813),
    ("revolution", "sphere", "rubber"): (646, 1162),
    ("implicit", "plane", "marble"): (532, 828),
    ("implicit", "plane", "rubber"): (730, 1170),
    ("implicit", "sphere", "marble"): (549, 1090),
    ("implicit", "sphere", "rubber"): (772, 1457),
}


def operations(system: System) -> int:
    steps = [value for _, value in system.required_definitions(system.rates)]
    return int(sp.count_ops([*steps, *system.rates]))


def test_every_case_has_a_ceiling() -> None:
    assert set(CEILINGS) == set(CASES)


@pytest.mark.slow
@pytest.mark.parametrize("case", CASES, ids="-".join)
def test_equations_do_not_swell(case: tuple[str, str, str]) -> None:
    plain, full = CEILINGS[case]
    assert operations(bare(*case)) <= plain
    assert operations(laden(*case)) <= full


def test_formulas_expand_to_state_and_parameters():
    x, v, k, energy, half = (real_symbol(name) for name in ("x", "v", "k", "E", "half"))
    definitions = {half: v**2 / 2, energy: half + k * x**2 / 2}
    parameters = (Parameter(k, "stiffness", 2.0),)
    system = System("spring", "Spring", {x: v, v: -k * x}, parameters, definitions)
    assert system.expand(energy) == v**2 / 2 + k * x**2 / 2
    assert system.expand(x + 1) == x + 1
    assert system.expand(2) == 2
    ball = from_catalogue("chaplygin-ball")
    expanded = ball.expand(Vector("omega"))
    assert expanded.shape == (3, 1)
    assert expanded.free_symbols <= {*ball.symbols, *ball.defaults}


@pytest.mark.parametrize("words", [{"name": " "}, {"title": "a\u202eb"}, {"summary": "a\u200bb"}])
def test_labels_are_there_and_can_be_seen(words: dict[str, str]) -> None:
    x = sp.Symbol("x", real=True)
    with pytest.raises(InputError, match=r"name of a system is empty|cannot be seen"):
        System(**({"name": "line", "title": "Line"} | words), field={x: sp.S.One})


def test_meanings_can_be_seen() -> None:
    x, a = sp.symbols("x a", real=True)
    for part in (
        {"parameters": (Parameter(a, "a\u202eb", 1.0),)},
        {"laws": (Integral("x", x, meaning="a\u202eb"),)},
    ):
        with pytest.raises(InputError, match=r"U\+202E, which cannot be seen"):
            System("line", "Line", {x: sp.S.Zero}, **part)
