"""Classification of a system by its proven integrals, measures, Hamiltonian forms, symmetries."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Any

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.formulas.errors import OutOfReachError
from flowlanes.orbits.sign_reversal import reversal
from flowlanes.printing.formula import text
from flowlanes.printing.laws import condition_text
from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import ConformallyHamiltonian, Integral, Law, Measure, Reduction, of_kind
from flowlanes.system.system import System
from flowlanes.system.vectors import real_symbol
from lawproof.proof.fields.budget import EFFORT
from lawproof.proof.level.trigonometric import circles, without_angles
from lawproof.proof.verdict import Verdict

from ..mechanics.lagrangian.mechanism import Mechanism
from ..mechanics.rolling.equations import RollingBody
from .applicable_laws import sorted_laws
from .classes import DynamicalStructure, classes_and_dynamics
from .classification import Classification
from .configuration_measures import MeasureFacts, configuration_measure
from .conserved_covectors import sources
from .facts import Fact, ProofBudget, fact_of
from .hamiltonian_forms import Forms, hamiltonian, measures
from .ignorable import symmetries_of_ignorable_variables
from .lie_theorem import independent_symmetries, lie_symmetries
from .ranks import RankSample, rational_parameters, with_numeric_parameters
from .statements import IntegrabilityClass
from .via_isomorphism import TargetResults, through_isomorphisms

#: Term operations for the proof of one law, and for all, for an immediate classification.
EFFORT_PER_PROOF = EFFORT // 50
TOTAL_EFFORT = EFFORT // 25


def classify_laws(
    system: System,
    verdicts: Mapping[str, Verdict],
    budget: ProofBudget,
    source: RollingBody | Mechanism | None,
) -> Classification:
    """Classify a system; see :func:`classify`."""
    try:
        whole = _without_angles(system)
        place = _place_with_levels(whole, verdicts, budget, source)
    except (OutOfReachError, InputError) as reason:
        return _unknown_place(system, verdicts, str(reason))
    return _in_angles(place, len(whole.symbols) - len(system.symbols))


def _in_angles(place: Classification, more: int) -> Classification:
    """A classification in which an angle counts as one variable, not as sine and cosine."""
    return replace(
        place,
        variables=place.variables - more,
        conditions=place.conditions - more,
        levels=tuple(_in_angles(level, more) for level in place.levels),
    )


def _reversed_variables(system: System) -> tuple[str, ...]:
    """Variables that change sign under time reversal; angles instead of their sines."""
    names = reversal(system)
    return tuple(
        text(real_symbol(str(n).removeprefix("sin_")))
        if str(n).startswith("sin_") and real_symbol(f"cos_{str(n)[4:]}") not in names
        else text(n)
        for n in names
    )


def _without_angles(system: System) -> System:
    """The system with sines and cosines as variables if its relations involve angles."""
    try:
        reduced = circles(system)
    except OutOfReachError:
        system = replace(
            with_numeric_parameters(system, rational_parameters(system)), laws=system.laws
        )
        reduced = circles(system)
    if reduced is None:
        return system
    laws = []
    for law in system.laws:
        with contextlib.suppress(OutOfReachError):
            without_angles(system, law)
            laws.append(reduced.law(law))
    return replace(reduced.system, laws=tuple(laws))


def _unknown_place(system: System, verdicts: Mapping[str, Verdict], reason: str) -> Classification:
    """A classification of a system whose laws could not be counted."""
    proven = tuple(fact_of(law) for law in system.laws if verdicts.get(law.name))
    kind = IntegrabilityClass("none known", f"not determined: {reason}", proven)
    return Classification(system.title, "", len(system.symbols), 0, kinds=(kind,), reason=reason)


def _place_with_levels(
    system: System,
    verdicts: Mapping[str, Verdict],
    budget: ProofBudget,
    model: RollingBody | Mechanism | None,
) -> Classification:
    whole = RankSample(system)
    laws = sorted_laws(whole, verdicts)
    levels = []
    for on, special in laws.levels.items():
        general = [law for law in laws.general if _holds(system, law, on, budget)]
        words = condition_text(replace(special[0], level=on), system, text)
        try:
            place = _classification_of(RankSample(system, on), (*special, *general), budget)
        except (OutOfReachError, InputError) as reason:
            place = _unknown_place(replace(system, laws=special), verdicts, str(reason))
        levels.append(replace(place, level=words))
    main = _classification_of(whole, laws.general, budget, model, _open_questions(system, verdicts))
    return replace(main, ignored_laws=laws.ignored_laws, levels=tuple(levels))


def _open_questions(system: System, verdicts: Mapping[str, Verdict]) -> tuple[str, ...]:
    """Undecided laws that would give a measure, with their verdicts."""
    giving = [law for law in system.laws if isinstance(law, Measure | ConformallyHamiltonian)]
    stands = ((law.name, verdicts.get(law.name)) for law in giving)
    return tuple(
        f"{name} is {verdict.statement}"
        for name, verdict in stands
        if verdict is not None and verdict.decision in ("undecided", "proven where")
    )


def _holds(system: System, law: Law, on: tuple[Any, ...], budget: ProofBudget) -> bool:
    """Whether a law holds on a level: functions do by restriction, all else is proven."""
    if not (law.of_volume or law.by_components):
        return True
    return bool(budget.verdict(system, replace(law, level=(*law.level, *on))))


# --- one phase space -----------------------------------------------------------------------


def _classification_of(
    sample: RankSample,
    laws: Sequence[Law],
    budget: ProofBudget,
    model: RollingBody | Mechanism | None = None,
    left: tuple[str, ...] = (),
) -> Classification:
    system = sample.system
    variables = len(system.symbols)
    forms = hamiltonian(sample, laws, budget)
    there = TargetResults()
    if not forms.brackets:
        there = through_isomorphisms(sample, laws, budget)
        forms = Forms(there.brackets, there.liouville)
    own = sources(laws)
    every = [*own, *there.sources]
    independent, count = sample.independent([source.rows for source in every])
    chosen = [every[i] for i in independent]
    named = {law.name for law in of_kind(laws, Integral)}
    spare = [s.fact for i, s in enumerate(own) if i not in independent and s.fact.law in named]
    volumes = measures(sample, laws, budget) or there.measures
    existence = (
        MeasureFacts() if volumes or forms.brackets else configuration_measure(model, budget)
    )
    symmetries = independent_symmetries(sample, laws, budget)
    structure = DynamicalStructure(
        dimension=sample.dimension,
        count=count,
        integrals=tuple(source.fact for source in chosen),
        measures=volumes or existence.measures,
        absence=existence.absence,
        brackets=forms.brackets,
        symmetries=tuple(fact_of(law) for law in symmetries),
        lie=lie_symmetries(sample, sample.dimension - count - 1, chosen, symmetries, budget),
        liouville=forms.liouville,
        reversal=(),
        reductions=tuple(map(_law_fact, of_kind(laws, Reduction))),
        open=(*left, existence.open) if existence.open else left,
    )
    missing = structure.remaining - 2
    if missing > 0 and structure.measures and structure.volume and not structure.lie:
        name = structure.volume.law.law
        shifts = symmetries_of_ignorable_variables(sample, chosen, symmetries, laws, name)
        if len(shifts) == missing:
            structure = replace(structure, shifts=shifts)
    if not structure.lasting and not sample.level:
        structure = replace(structure, reversal=_reversed_variables(system))
    kinds, dynamics = classes_and_dynamics(structure)
    return Classification(
        system=system.title,
        level="",
        variables=variables,
        conditions=variables - sample.dimension,
        integrals=structure.integrals,
        count=count,
        dependent=tuple(spare),
        measures=structure.measures,
        absence=structure.absence,
        brackets=structure.brackets,
        symmetries=structure.symmetries,
        reversal=structure.reversal,
        reductions=tuple(
            _law_fact(law) for law in laws if isinstance(law, Reduction | Isomorphism)
        ),
        kinds=kinds,
        dynamics=dynamics,
    )


def _law_fact(law: Law) -> Fact:
    meaning = str(getattr(law, "meaning", ""))
    return Fact(law.name, f"{law.heading}: {meaning}" if meaning else law.heading, law.source)


@arguments_checked
def classify(
    system: System,
    verdicts: Mapping[str, Verdict] | None = None,
    *,
    source: RollingBody | Mechanism | None = None,
    effort: int = EFFORT_PER_PROOF,
    total_budget: int | None = TOTAL_EFFORT,
    progress: Callable[[str], object] | None = None,
) -> Classification:
    """Classify a system in the hierarchy of dynamics.

    Parameters
    ----------
    system : System
        Its parameters count with their present values (their defaults), taken as exact decimals.
    verdicts : mapping of str to Verdict
        Verdicts on its laws, by name; a law without a verdict does not count. By default all laws
        are tried with this effort.
    source : RollingBody or Mechanism, optional
        The mechanical model with its numbers.  If no measure of its equations is proven, it is
        decided whether there is one whose density depends on the configuration alone.
    effort : int
        Term operations for the proof of one law. Further statements are proven with it: that
        symmetries leave integrals invariant, that integrals are in involution, laws of the targets
        of isomorphisms, laws restricted to a level.
    total_budget : int, optional
        Term operations after which no further law is tried.
    progress : callable, optional
        Called with a description of the next attempt.

    Returns
    -------
    Classification
        Dimensions, integrals, measures, brackets and symmetries that are proven, and which
        motions they allow.  If the system cannot be classified, `reason` has the cause.

    Raises
    ------
    InputError
        If an argument is of another kind.

    Examples
    --------
    >>> import nonholonomic
    >>> place = nonholonomic.classify(nonholonomic.from_catalogue("suslov"))
    >>> place.dimension, place.count, place.remaining
    (4, 1, 3)
    >>> [kind.name for kind in place.kinds]
    ['none known']
    """
    budget = ProofBudget(effort, total_budget, progress or (lambda _: None))
    known = budget.verdicts(system) if verdicts is None else verdicts
    return classify_laws(system, known, budget, source)


def classify_quickly(
    system: System, source: RollingBody | Mechanism | None = None
) -> Classification:
    """Classify a system with little effort, in a few seconds."""
    return classify(system, source=source)
