"""Rolling bodies: whether a measure exists, decided on the sphere of normals.

The body's place and heading are of no account: where a density e^σ on the whole configuration
space gives an invariant measure, σ does not change under the motions of the plane or the rotations
of the sphere (docs/measures.md), so that nothing is lost by looking for σ(γ).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from ...mechanics.rolling import Rolling
from ...mechanics.shapes import Disk, Implicit, Torus
from ...statements import Measure
from ..prove import prove
from ..verdict import Verdict
from .closed_form import closed_form, density
from .families import Level, criterion, levels
from .form import OneForm, one_form
from .quadrature import log_density
from .value import Existence

__all__ = ["decide_body"]

PATIENCE = 12.0
"""Seconds for a proof with free parameters, where one with numbers remains."""


def decide_body(rolling: Rolling, name: str, seconds: float) -> Existence:
    """Decide for a body with its numbers.

    Parameters
    ----------
    rolling : Rolling
    name : str
        Of the system, for the reader.
    seconds : float
        Time after which a proof is given up.
    """
    form = one_form(rolling)
    theorem = criterion(rolling)
    tried = tuple(levels(rolling, form.system.parameters))
    # the last level fixes all numbers: what fails there fails for this body
    numbers = tried[-1]
    here = tuple(_proofs(form, numbers, seconds))
    if here[-1].decision == "refuted":
        return Existence(
            name,
            "none",
            obstruction=_obstruction(here[-1], form),
            criterion=theorem,
            verdicts=here,
        )
    for level in tried[:-1]:
        found = tuple(_proofs(form, level, min(seconds, PATIENCE)))
        if all(found):
            return _existing(rolling, form, name, level, numbers, found, theorem, seconds)
    if all(here):
        return _existing(rolling, form, name, numbers, numbers, here, theorem, seconds)
    return Existence(name, "undecided", criterion=theorem, reason=here[-1].reason, verdicts=here)


def _proofs(form: OneForm, level: Level, seconds: float) -> Iterator[Verdict]:
    """Verdicts on the conditions, up to the first that is not proven."""
    for law in form.conditions:
        verdict = prove(form.system, replace(law, on=level), seconds=seconds)
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
    return {"what": what, "point": witness["point"], "residual": witness["residual"]}


def _existing(
    rolling: Rolling,
    form: OneForm,
    name: str,
    level: Level,
    numbers: Level,
    verdicts: tuple[Verdict, ...],
    theorem: str,
    seconds: float,
) -> Existence:
    """The measure that exists on a level, in closed form if possible."""
    made = Existence(name, "exists", criterion=theorem, verdicts=verdicts)
    powers = closed_form(rolling, form, numbers)
    if powers is not None:
        system = rolling.system(name)
        law = Measure(
            "configuration_measure",
            density(rolling, powers),
            meaning="density that depends on the configuration alone",
        )
        for where, time in ((level, min(seconds, PATIENCE)), (numbers, seconds)):
            verdict = prove(system, replace(law, on=where), seconds=time)
            if verdict:
                return replace(
                    made,
                    density=replace(law, on=where),
                    system=system,
                    verdicts=(*verdicts, verdict),
                )
    if isinstance(rolling.body.shape, (Disk, Torus)):
        # lying flat is outside their domain, a sphere without its poles
        turned = prove(form.system, replace(form.period, on=level), seconds=seconds)
        if not turned:
            return replace(
                made,
                decision="undecided",
                reason="the 1-form is closed; its period about body axis 3 is not known to vanish",
                verdicts=(*verdicts, turned),
            )
        verdicts = (*verdicts, turned)
    reason = "the 1-form is closed, and so exact on the sphere of normals"
    sigma = None if isinstance(rolling.body.shape, Implicit) else log_density(form)
    return replace(
        made,
        reason=reason,
        verdicts=verdicts,
        log_density=sigma,
    )
