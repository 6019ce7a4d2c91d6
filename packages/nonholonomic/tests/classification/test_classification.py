"""The place of a system in the hierarchy of dynamics, against what is known of each."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest
import sympy as sp

from flowlanes.system.laws import (
    ConformallyHamiltonian,
    Integral,
    Measure,
    PoissonStructure,
    Rate,
    Reduction,
    Symmetry,
)
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import cross, dot, norm_squared, real_symbol, vectors
from lawproof.proof.fields.budget import EFFORT
from lawproof.proof.verdict import Verdict
from nonholonomic.catalogue import entry
from nonholonomic.classification.classification import Classification
from nonholonomic.classification.classifier import classify, classify_laws
from nonholonomic.classification.conserved_covectors import sources
from nonholonomic.classification.facts import ProofBudget
from nonholonomic.classification.lie_theorem import independent_symmetries, lie_symmetries
from nonholonomic.classification.ranks import RankSample, rational_parameters
from nonholonomic.classification.sign_test import sign
from nonholonomic.classification.statements import IgnoredLaw

x, p = vectors("x p")


def found(system: System, **verdicts: Verdict) -> Classification:
    """The place, with some verdicts replaced."""
    budget = ProofBudget(EFFORT // 5)
    return classify_laws(system, budget.verdicts(system) | verdicts, ProofBudget(EFFORT // 5), None)


def of(name: str, **parameters: float) -> Classification:
    """The place of a system of the catalogue."""
    return found(entry(name).system(parameters))


def kinds(standing: Classification) -> list[str]:
    """Names of its classes."""
    return [kind.name for kind in standing.kinds]


def motions(standing: Classification) -> str:
    """Everything said of its motions."""
    return " ".join(statement.text for statement in standing.dynamics)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "dimension", "count", "classes"),
    [
        ("rattleback", 5, 1, ["none known"]),
        ("unbalanced-ball", 5, 2, ["none known"]),
        ("unbalanced-rubber-ball", 4, 2, ["none known"]),
        ("suslov", 4, 1, ["none known"]),
        ("ball-on-sphere", 5, 2, ["none known"]),
        ("veselova-spinning", 5, 3, ["euler-jacobi"]),
        ("heavy-disk", 5, 3, ["lie", "euler-jacobi"]),
        ("disk-on-ice", 6, 4, ["lie", "euler-jacobi"]),
        ("chaplygin-sleigh", 5, 1, ["lie"]),
        ("chaplygin-sleigh-reduced", 2, 1, ["curves", "conformally hamiltonian", "liouville"]),
        ("veselova", 4, 2, ["euler-jacobi", "conformally hamiltonian", "liouville"]),
        ("chaplygin-ball", 5, 3, ["euler-jacobi", "conformally hamiltonian", "liouville"]),
        ("chaplygin-ball-gyrostat-bruns", 5, 2, ["conformally hamiltonian"]),
        ("clebsch", 5, 3, ["euler-jacobi", "hamiltonian", "liouville"]),
        ("rubber-ball-on-sphere", 4, 1, ["conformally hamiltonian"]),
        ("rubber-ball-on-e3", 4, 1, ["hamiltonian"]),
        ("suslov-bracket", 5, 3, ["euler-jacobi", "hamiltonian"]),
        ("lagrange-top-angles", 6, 3, ["lie", "hamiltonian", "liouville"]),
    ],
)
def test_known_systems(name: str, dimension: int, count: int, classes: list[str]) -> None:
    standing = of(name)
    assert (standing.dimension, standing.count) == (dimension, count)
    assert kinds(standing) == classes


@pytest.mark.slow
def test_without_a_measure_attractors_are_not_excluded() -> None:
    assert "strange attractors are not excluded" in motions(of("rattleback"))
    assert "No attracting sets" not in motions(of("rattleback"))


@pytest.mark.slow
def test_surfaces_without_a_measure_have_limit_cycles_but_no_chaos() -> None:
    sentence = motions(of("unbalanced-rubber-ball"))
    assert "no chaos" in sentence
    assert "limit cycles are not excluded" in sentence


@pytest.mark.slow
def test_with_a_measure_chaos_preserves_volume() -> None:
    sentence = motions(of("ball-on-sphere"))
    assert "volume-preserving" in sentence
    assert "No attracting sets" in sentence


def test_a_density_with_zeros_excludes_no_asymptotic_motion() -> None:
    standing = of("chaplygin-sleigh")
    assert [m.sign for m in standing.measures] == ["changes"]
    assert "motions may tend to that set" in motions(standing)


@pytest.mark.slow
def test_a_density_is_shown_to_be_positive_or_to_change_sign() -> None:
    ball = entry("chaplygin-ball").system()
    (measure,) = (law for law in ball.laws if isinstance(law, Measure))
    assert sign(RankSample(ball), [base for base, _ in measure.density]) == "kept"
    assert sign(RankSample(ball), [ball.symbols[0]]) == "changes"
    # a square vanishes somewhere without changing sign
    assert sign(RankSample(ball), [ball.symbols[3] ** 2]) == "unknown"


# --- what counts ---------------------------------------------------------------------------


@pytest.mark.slow
def test_what_is_undecided_or_unknown_does_not_count() -> None:
    late = Verdict("momentum", "undecided", reason="not proven within 1 s")
    standing = found(entry("chaplygin-ball").system(), momentum=late)
    assert standing.count == 2
    assert kinds(standing) == ["conformally hamiltonian"]
    assert [(u.law, u.why) for u in standing.ignored_laws] == [
        ("momentum", "undecided: not proven within 1 s")
    ]
    assert "momentum: undecided" in str(standing)
    assert classify(entry("rattleback").system(), {}).ignored_laws[0].why == "without a verdict"


@pytest.mark.slow
def test_what_is_refuted_does_not_count() -> None:
    ball = entry("chaplygin-ball").system()
    standing = found(ball.with_laws(Integral("wrong", ball.symbols[0])))
    assert standing.count == 3
    assert [u.law for u in standing.ignored_laws] == ["wrong"]
    assert standing.ignored_laws[0].why.startswith("refuted")


@pytest.mark.slow
def test_functions_of_known_integrals_do_not_count() -> None:
    system = entry("rattleback").system()
    (energy,) = system.integrals
    standing = found(system.with_laws(Integral("square", energy.value**2)))
    assert standing.count == 1
    assert [fact.law for fact in standing.dependent] == ["square"]


@pytest.mark.slow
def test_relations_do_not_count_as_integrals() -> None:
    ball = entry("chaplygin-ball").system()
    gamma = ball.state[1]
    assert found(ball.with_laws(Integral("length", norm_squared(gamma)))).count == 3


@pytest.mark.parametrize(("a", "names"), [(0.3, ["measure"]), (0.0, ["measure", "volume"])])
def test_conditions_on_parameters_must_hold_exactly(a: float, names: list[str]) -> None:
    assert [m.law.law for m in of("chaplygin-sleigh", a=a).measures] == names


@pytest.mark.slow
def test_the_case_of_one_ratio_counts_at_this_ratio_alone() -> None:
    special = entry("rubber-ball-of-ratio").system()
    assert "euler-jacobi" in kinds(found(special))
    close = tuple(
        replace(p, default=-0.999999) if str(p.symbol) == "k" else p for p in special.parameters
    )
    general = found(replace(special, parameters=close))
    assert "euler-jacobi" not in kinds(general)
    assert "proven for k = −1, not at the present parameters" in str(general)


@pytest.mark.slow
def test_a_level_has_a_place_of_its_own() -> None:
    (level,) = of("chaplygin-ball").levels
    assert level.level == "on (M, γ) = 0"
    assert (level.dimension, level.count) == (4, 2)
    assert [b.law.law for b in level.brackets] == ["hamiltonian"]
    assert {fact.law for fact in level.reductions} >= {"clebsch_case", "fedorov"}


@pytest.mark.slow
def test_linear_equations_give_integrals() -> None:
    standing = of("heavy-disk")
    assert [(f.law, f.functions) for f in standing.integrals] == [("energy", 1), ("momenta", 2)]


def test_nonlinear_reductions_give_none() -> None:
    u, q, w = real_symbol("u"), real_symbol("q"), real_symbol("w")
    free = Reduction("free", {u: u, q: q}, (Rate(q) - q**2 * Rate(u),))
    forced = Reduction("forced", {u: u, q: q}, (Rate(q) - u * Rate(u),))
    other = Reduction("other", {u: u, q: q, w: w}, (Rate(q) - w * q * Rate(u),))
    assert sources([free, forced, other]) == []
    linear = Reduction("linear", {u: u, q: q}, (2 * Rate(q) - u * q * Rate(u),))
    assert [s.fact.law for s in sources([linear])] == ["linear"]


def test_leaves_of_many_valued_functions_are_no_tori() -> None:
    standing = of("suslov-bracket")
    assert standing.brackets[0].rank == 2
    assert not standing.brackets[0].closed
    assert "liouville" not in kinds(standing)


@pytest.mark.slow
def test_isomorphisms_carry_laws_over() -> None:
    standing = of("rubber-chaplygin-ball")
    assert [b.law.law for b in standing.brackets] == ["veselova"]
    assert standing.brackets[0].law.system == "Veselova system"
    assert "liouville" in kinds(standing)
    in_angles = of("chaplygin-ball-angles")
    assert kinds(in_angles) == ["conformally hamiltonian"]
    assert in_angles.brackets[0].rank == 4


@pytest.mark.slow
def test_volume_and_rotations_are_tried_where_nothing_is_stated() -> None:
    standing = of("marble-ball")
    assert [m.law.source for m in standing.measures] == ["found here"]
    assert [f.law for f in standing.symmetries] == ["rotation_3"]
    assert of("rattleback").symmetries == ()


# --- theorems ------------------------------------------------------------------------------


def central(*laws: Symmetry | Integral) -> System:
    """A particle in a central field, by place and momentum."""
    k = Parameter(real_symbol("k"), "stiffness", 0.7)
    energy = Integral("energy", norm_squared(p) / 2 + k.symbol * norm_squared(x) ** 2)
    field = {x: p, p: -4 * k.symbol * norm_squared(x) * x}
    return System("central", "Particle in a central field", field, (k,), laws=(energy, *laws))


def turning(i: int) -> Symmetry:
    """Rotation of space about an axis."""
    axis = sp.ImmutableMatrix([int(i == j) for j in range(3)])
    return Symmetry(f"turning_{i}", {x: cross(axis, x), p: cross(axis, p)})


def solved_by(system: System, needed: int) -> list[str]:
    """Symmetry fields by which Theorem 3 applies, if `needed` are enough."""
    standing, budget = RankSample(system), ProofBudget(EFFORT // 10)
    chosen = independent_symmetries(standing, system.laws, budget)
    own = [s for s in sources(system.laws) if len(s.functions) == 1]
    return [f.law for f in lie_symmetries(standing, needed, own, chosen, budget)]


def test_an_algebra_that_is_not_solvable_does_not_help() -> None:
    assert solved_by(central(turning(2)), 1) == ["turning_2"]
    assert solved_by(central(*map(turning, range(3))), 3) == []


def test_a_field_that_changes_an_integral_does_not_help() -> None:
    momentum = Integral("momentum", dot(cross(x, p), sp.ImmutableMatrix([1, 0, 0])))
    assert solved_by(central(turning(0), momentum), 1) == ["turning_0"]
    assert solved_by(central(turning(2), momentum), 1) == []


def test_a_solvable_algebra_need_not_be_commutative() -> None:
    (by,) = (kind.by for kind in of("chaplygin-sleigh").kinds if kind.name == "lie")
    assert {f.law for f in by} == {"energy", "shift_x", "shift_y", "turning"}


def test_integrals_must_be_in_involution() -> None:
    names = ["x_1", "x_2", "x_3", "p_1", "p_2", "p_3"]
    zero, unit = sp.zeros(3), sp.eye(3)
    canonical = PoissonStructure("canonical", sp.Matrix([[zero, unit], [-unit, zero]]), rank=6)
    system = central()
    (energy,) = system.integrals
    form = ConformallyHamiltonian("form", sp.S.One, canonical, energy.value)
    momentum = cross(x, p)
    axes = [sp.ImmutableMatrix([int(i == j) for j in range(3)]) for i in range(3)]
    components = [Integral(f"m_{i}", dot(momentum, axis)) for i, axis in enumerate(axes)]
    assert [str(s) for s in system.symbols] == names
    two = found(system.with_laws(form, *components[:2]))
    assert "liouville" not in kinds(two)
    square = Integral("square", norm_squared(momentum))
    complete = found(system.with_laws(form, components[0], square))
    assert "liouville" in kinds(complete)


# --- telling -------------------------------------------------------------------------------


@pytest.mark.slow
def test_text_names_its_laws_and_fits_a_page() -> None:
    text = str(of("chaplygin-ball"))
    assert max(map(len, text.splitlines())) <= 100
    for words in ("area (7.2)", "on (M, γ) = 0", "[energy, area, momentum, measure]"):
        assert words in text


def test_the_record_is_plain() -> None:
    record = json.loads(json.dumps(of("chaplygin-ball").record))
    assert record["dimension"] == 5
    assert record["remaining"] == 2
    assert record["levels"][0]["dimension"] == 4
    assert record["kinds"][0]["name"] == "euler-jacobi"


def test_a_fast_answer_says_what_it_leaves_out(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setenv("FLOWLANES_CACHE", str(tmp_path))
    system = entry("chaplygin-ball").system()
    budget = ProofBudget(EFFORT, 1)
    budget.effort_used = 1
    verdicts = budget.verdicts(system)
    assert {v.decision for v in verdicts.values()} == {"undecided"}
    assert all("was spent" in v.reason for v in verdicts.values())
    named = replace(system, laws=system.laws[:1])
    assert "was spent" in str(classify_laws(named, verdicts, budget, None))


@pytest.mark.slow
def test_what_is_proven_where_a_condition_holds_does_not_count() -> None:
    system = entry("heavy-disk").system()
    name = next(law.name for law in system.laws if isinstance(law, Measure))
    whole = found(system)
    assert name in {density.law.law for density in whole.measures}
    partly = Verdict(name, "proven where", conditions=("gamma_3 > 0", "not omega_1 = 0"))
    standing = found(system, **{name: partly})
    words = "proven where gamma_3 > 0, not omega_1 = 0"
    assert name not in {density.law.law for density in standing.measures}
    assert IgnoredLaw(name, words) in standing.ignored_laws


def test_a_measure_left_open_is_named_where_it_would_decide() -> None:
    oscillator = System(
        "oscillator", "oscillator", {x: p, p: -x}, laws=(Measure("volume", {sp.S.One: 1}),)
    )
    for verdict, words in (
        (Verdict("volume", "undecided", reason="too large"), "volume is undecided"),
        (Verdict("volume", "proven where", conditions=("x > 0",)), "volume is proven where x > 0"),
    ):
        sentence = classified_with(oscillator, verdict)
        assert f"No invariant measure is proven ({words})" in sentence
    refuted = classified_with(oscillator, Verdict("volume", "refuted"))
    assert "No invariant measure is proven:" in refuted


def classified_with(system: System, verdict: Verdict) -> str:
    """What is said of motions, with nothing proven besides."""
    return " ".join(
        str(classify_laws(system, {verdict.law: verdict}, ProofBudget(1, 1), None)).split()
    )


# --- measures on the configuration ---------------------------------------------------------


def with_what_moves(name: str) -> Classification:
    """The place, with the body and the surface known."""
    item, budget = entry(name), ProofBudget(EFFORT // 5)
    system = item.system()
    return classify_laws(system, budget.verdicts(system), budget, item.rolling())


@pytest.mark.slow
def test_a_question_that_was_not_tried_is_told() -> None:
    item = entry("rattleback")
    system = item.system()
    sentence = str(classify_laws(replace(system, laws=()), {}, ProofBudget(1, 0), item.rolling()))
    words = "whether one has a density that depends on the configuration alone was not tried"
    assert words in " ".join(sentence.split())
    sentence = str(
        classify_laws(replace(system, laws=()), {}, ProofBudget(EFFORT // 10), item.rolling())
    )
    assert "was not tried" not in sentence


def test_the_absence_of_a_measure_is_told_with_its_witness() -> None:
    standing = with_what_moves("rattleback")
    assert standing.measures == ()
    assert "changes the volume, as at γ₁ = " in standing.absence
    assert "none has a density that depends on the configuration alone" in motions(standing)
    assert "none whose density" in str(standing)
    assert of("rattleback").absence == ""


@pytest.mark.slow
def test_a_measure_that_exists_counts() -> None:
    standing = with_what_moves("rubber-body-of-revolution")
    assert [m.sign for m in standing.measures] == ["kept"]
    assert kinds(standing) == ["lie", "euler-jacobi"]


def test_the_question_is_not_asked_where_a_measure_is_proven() -> None:
    standing = with_what_moves("chaplygin-ball")
    assert [m.law.law for m in standing.measures] == ["measure"]


def test_a_root_by_which_the_equations_divide_is_positive() -> None:
    s, q, w = real_symbol("s"), real_symbol("q"), real_symbol("w")
    root = sp.sqrt(q**2 + w**4)
    divided = System("divided", "Divided", {q: w, w: q / s}, definitions={s: root})
    whole = System("whole", "Whole", {q: w, w: q * s}, definitions={s: root})
    assert sign(RankSample(divided), [s]) == "kept"
    assert sign(RankSample(whole), [s]) == "unknown"


@pytest.mark.parametrize(("number", "found"), [(0.0, "kept"), (0.5, "unknown")])
def test_a_variable_whose_coefficient_is_zero_is_no_variable(number: float, found: str) -> None:
    s, q, v, w, k = (real_symbol(name) for name in "sqvwk")
    system = System(
        "circle",
        "Circle",
        {q: v, v: -q, w: w * sp.S.Zero},
        parameters=(Parameter(k, "coupling", number),),
        definitions={s: 2 + q + k * w},
        relations=(q**2 + v**2 - 1,),
    )
    assert sign(RankSample(system), [s]) == found


def test_a_place_out_of_reach_says_why() -> None:
    q, w = real_symbol("q"), real_symbol("w")
    steady = Integral("steady", w)
    made = System("out", "Out", {q: w, w: 0 * w}, relations=(q - sp.exp(w),), laws=(steady,))
    standing = classify(made, {"steady": Verdict("steady", "proven")})
    assert kinds(standing) == ["none known"]
    assert standing.reason
    assert "not determined" in str(standing)
    assert "steady" in str(standing)


def test_relations_with_angles_are_read_by_sine_and_cosine() -> None:
    q, w, u = real_symbol("q"), real_symbol("w"), real_symbol("u")
    relation = u * sp.cos(q) - w * sp.sin(q)
    field = {q: sp.S.One, u: -w, w: u}
    made = found(System("turning", "Turning", field, relations=(relation,)))
    assert made.reason == ""
    assert made.dimension == 2


def test_sine_and_cosine_of_a_parameter_leave_a_phase_space() -> None:
    """Their decimals are on no circle; a rational point of it as near as rounding is taken."""
    x, y, beta = map(real_symbol, ["x", "y", "beta"])
    field = {x: y * sp.cos(beta), y: y * sp.sin(beta)}
    system = System(
        "slope",
        "Slope",
        field,
        (Parameter(beta, "angle", 0.3),),
        relations=(x * sp.sin(beta) - y * sp.cos(beta),),
    )
    assert found(system).dimension == 1
    s, c = map(real_symbol, ["s", "c"])
    pair = (Parameter(s, "sine", 0.3), Parameter(c, "cosine", 0.9539392014169456))
    values = rational_parameters(System("pair", "Pair", {x: x}, pair, relations=(s**2 + c**2 - 1,)))
    assert values[s] ** 2 + values[c] ** 2 == 1
    assert all(abs(values[p.symbol] - p.default) < 1e-15 for p in pair)


def test_decimals_that_miss_a_relation_between_parameters_are_named() -> None:
    x, a, b = map(real_symbol, ["x", "a", "b"])
    given = (Parameter(a, "number", 2.0), Parameter(b, "its root", 1.4142135623730951))
    standing = found(System("root", "Root", {x: x}, given, relations=(b**2 - a,)))
    assert "between parameters does not hold exactly at their present values" in standing.reason
    assert "empty" not in standing.reason
