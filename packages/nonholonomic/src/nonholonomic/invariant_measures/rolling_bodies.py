"""Existence of a measure for rolling bodies, decided on the sphere of normals.

Position and heading of the body can be ignored: if a density e^σ on the whole configuration space
gives an invariant measure, σ is invariant under the motions of the plane or the rotations of the
sphere (docs/measures.md), so nothing is lost by searching for σ(γ).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from flowlanes.system.laws import Measure
from lawproof.proof.prover import POINTS_ALONE, prove
from lawproof.proof.verdict import Verdict

from ..mechanics.rolling.equations import RollingBody
from .closed_form import closed_form, density
from .fluid_theorem import THEOREM, lemma
from .implicit_shapes import log_density_on_surface
from .known_families import Level, criterion, levels
from .one_form import OneForm, Powers, one_form
from .quadrature import log_density
from .result import MeasureExistence

SHARE = 10
"""Divisor of the effort for the proof of a density as a law of the equations of motion, which is
attempted after the density is already proven by other means."""


def decide_body(rolling: RollingBody, name: str, effort: int) -> MeasureExistence:
    """Decide for a body with given parameters.

    Parameters
    ----------
    name : str
        Name of the system in the result.
    effort : int
        Largest number of term operations of a proof.
    """
    if rolling.body.fluids:
        return _with_fluid(rolling, name, effort)
    form = one_form(rolling)
    theorem = criterion(rolling)
    levels_tried = tuple(levels(rolling, form.system.parameters))
    # the last level fixes all parameters, so that a condition refuted there fails for this body
    numbers = levels_tried[-1]
    for law in form.conditions:
        # evaluation at points may refute a condition before any proof is tried
        verdict = prove(form.system, replace(law, level=numbers), effort=POINTS_ALONE)
        if verdict.decision == "refuted":
            return MeasureExistence(
                name,
                "none",
                obstruction=_obstruction(verdict, form),
                criterion=theorem,
                verdicts=(verdict,),
            )
    existence = MeasureExistence(name, "exists", criterion=theorem)
    powers = closed_form(rolling, form, numbers)
    if powers is not None:
        proofs = tuple(_proofs_by_quadrature(form, powers, numbers, effort))
        if all(proofs):
            existence = replace(existence, verdicts=proofs)
            return _with_density(existence, rolling, powers, levels_tried, effort)
    for level in (numbers, *levels_tried[:-1]):
        proofs = tuple(_proofs(form, level, effort))
        if all(proofs):
            return _with_quadrature(
                replace(existence, verdicts=proofs), rolling, form, level, effort
            )
    return replace(existence, decision="undecided", reason=proofs[-1].words, verdicts=proofs)


def _with_fluid(rolling: RollingBody, name: str, effort: int) -> MeasureExistence:
    """The decision for the equivalent rigid body, and the lemma that transfers it to the body."""
    rigid = decide_body(rolling.equivalent, name, effort)
    verdict = lemma()
    decision = rigid.decision if verdict else "undecided"
    return replace(
        rigid,
        decision=decision,
        system=rigid.system and rolling.system(name),
        criterion=f"{THEOREM}; {rigid.criterion}",
        verdicts=(verdict, *rigid.verdicts),
    )


def _proofs(form: OneForm, level: Level, effort: int) -> Iterator[Verdict]:
    """Verdicts on the conditions, up to the first that is not proven."""
    for law in form.conditions:
        verdict = prove(form.system, replace(law, level=level), effort=effort)
        yield verdict
        if not verdict:
            return


def _obstruction(verdict: Verdict, form: OneForm) -> dict[str, object]:
    what = (
        "the 1-form is not closed"
        if verdict.law == form.closed.name
        else ("spinning about the normal changes the volume")
    )
    witness = verdict.witness or {}
    own = {str(s) for s in form.system.symbols}
    point = {name: value for name, value in witness["point"].items() if name in own}
    return {"what": what, "point": point, "residual": witness["residual"]}


def _proofs_by_quadrature(
    form: OneForm, powers: Powers, level: Level, effort: int
) -> Iterator[Verdict]:
    """Verdicts on the spin and on dσ = θ, up to the first that is not proven."""
    laws = [(form.system, form.spin)] if form.spin is not None else []
    for system, law in (*laws, form.density_law(powers)):
        verdict = prove(system, replace(law, level=level), effort=effort)
        yield verdict
        if not verdict:
            return


def _with_density(
    existence: MeasureExistence,
    rolling: RollingBody,
    powers: Powers,
    levels_tried: tuple[Level, ...],
    effort: int,
) -> MeasureExistence:
    """The measure as a law of the equations of motion, on the most general level proven.

    It is already proven that dσ = θ for the parameters of the body, and the law follows.
    """
    system = rolling.system(existence.name)
    law = Measure(
        "configuration_measure",
        density(rolling, powers),
        meaning="density that depends on the configuration alone",
    )
    for level in levels_tried:
        again = replace(law, level=level)
        verdict = prove(system, again, effort=max(effort // SHARE, 1))
        if verdict:
            return replace(
                existence, density=again, system=system, verdicts=(*existence.verdicts, verdict)
            )
    return replace(existence, density=replace(law, level=levels_tried[-1]), system=system)


def _with_quadrature(
    existence: MeasureExistence, rolling: RollingBody, form: OneForm, level: Level, effort: int
) -> MeasureExistence:
    """The measure with a closed 1-form whose density has no closed form."""
    if rolling.body.shape.has_flat_face:
        # a body lying flat is outside the domain, which is the sphere without its poles
        turned = prove(form.system, replace(form.period, level=level), effort=effort)
        existence = replace(existence, verdicts=(*existence.verdicts, turned))
        if not turned:
            return replace(
                existence,
                decision="undecided",
                reason="the 1-form is closed; its period about body axis 3 is not known to vanish",
            )
    return replace(
        existence,
        reason="the 1-form is closed, and so exact on the sphere of normals",
        log_density=log_density_on_surface(form)
        if rolling.body.shape.by_equation
        else log_density(form),
    )
