"""Proof and refutation of laws.

A law is tried at points first: where a residual is not zero, exactly or as a ball that does not
contain zero, the law is refuted there.  A law that survives is computed symbolically; when every
residual vanishes modulo the relations and the level it is proven, since no denominator vanished
at the points.  Otherwise it is undecided, and the verdict says why.
"""

from __future__ import annotations

import random
import time
from collections.abc import Iterator
from dataclasses import replace
from typing import Any, overload

from sympy.functions.elementary.trigonometric import TrigonometricFunction

from ..errors import InputError
from ..statements import Identity, Isomorphism, Law, PoissonStructure
from ..system import System
from .angles import without_angles
from .budget import Budget
from .errors import NotExactError, OutOfReachError, SpareNeededError, UnknownSymbolError
from .functions import Fractions
from .graphs import graph
from .ground import Ground
from .memory import fingerprint, recall, remember
from .numbers import Balls, Rationals, precise
from .rank import shortfall
from .residuals import preserved, residuals
from .verdict import Verdict

__all__ = ["everything", "prove", "standing", "tried"]

POINTS = 2
MORE_POINTS = 12
"""Tried where a remainder is left, before a law is called undecided."""
ATTEMPTS = 2000
"""Points tried; the first half of them must lie in the domain that the guards tell."""
SEED = 20080830


@overload
def prove(system: System, law: None = None, *, seconds: float = ...) -> tuple[Verdict, ...]: ...
@overload
def prove(system: System, law: Law | str, *, seconds: float = ...) -> Verdict: ...
def prove(
    system: System, law: Law | str | None = None, *, seconds: float = 120.0
) -> Verdict | tuple[Verdict, ...]:
    """Prove or refute a law of a system, or all of its laws.

    Parameters
    ----------
    system : System
    law : Law or str, optional
        One law, or the name of one of the system's; by default all of them.
    seconds : float
        Time after which a law is left undecided.

    Returns
    -------
    Verdict or tuple of Verdict

    Raises
    ------
    InputError
        If a law uses an unknown symbol, or its level is empty or annuls a denominator.
    """
    if not seconds > 0:
        raise InputError(f"seconds = {seconds:g}: it must be positive")
    if law is None:
        return tuple(prove(system, each, seconds=seconds) for each in system.laws)
    if isinstance(law, str):
        law = _by_name(system, law)
    name = fingerprint(system, law)
    kept = recall(name)
    if kept is not None:
        return kept
    started = time.monotonic()
    budget = Budget(deadline=started + seconds)
    try:
        with precise():
            verdict = _decided(system, law, budget)
    except UnknownSymbolError as symbol:
        raise InputError(
            f"{system.name}: the law {law.name!r} uses {symbol}, which is neither a state variable "
            "nor a definition nor a parameter of the system"
        ) from None
    except OutOfReachError as reason:
        verdict = Verdict(law.name, "undecided", reason=str(reason))
    verdict = replace(verdict, terms=budget.largest, seconds=time.monotonic() - started)
    if verdict.decision != "undecided":
        remember(name, verdict)
    return verdict


def _by_name(system: System, name: str) -> Law:
    for law in system.laws:
        if law.name == name:
            return law
    names = ", ".join(law.name for law in system.laws) or "none"
    raise InputError(f"{system.name} has no law {name!r}; its laws are {names}")


def everything(law: Law, ground: Ground, field: Any) -> Iterator[tuple[str, Any]]:
    """All residuals: of the law, and of the level being invariant."""
    yield from preserved(ground, field)
    yield from residuals(law, ground, field)


def standing(system: System, law: Law) -> tuple[tuple[System, Law], ...]:
    """What has to be proved of a law, on phase spaces whose conditions are polynomial.

    Raises
    ------
    OutOfReachError
        If there is no such phase space.
    """
    # conditions with sines and cosines go best with circles, others with graphs
    made = graph(system, law, tame=(TrigonometricFunction,))
    try:
        base = without_angles(*((system, law) if made is None else (made.system, made.law)))
    except OutOfReachError:
        made = graph(system, law)
        if made is None:
            raise
        base = made.system, made.law
    if made is None:
        return (base,)
    return (without_angles(made.system, made.consistency), base)


def _decided(system: System, law: Law, budget: Budget) -> Verdict:
    for base, claim in standing(system, law):
        verdict = _on_ground(base, claim, budget)
        if verdict.decision != "proven":
            break
    return replace(verdict, law=law.name)


def _on_ground(system: System, law: Law, budget: Budget) -> Verdict:
    ground = Ground(system, law.on)
    generator = random.Random(SEED)
    sample: dict[str, float] = {}
    for _ in range(POINTS):
        field, witness = tried(law, ground, generator)
        sample = sample or {name: float(value) for name, value in field.values.items()}
        if witness is not None:
            return _refuted(law, ground, field, witness)
    verdict = _symbolic(law, ground, sample, budget)
    if verdict.decision == "undecided":
        for _ in range(MORE_POINTS):
            field, witness = tried(law, ground, generator)
            if witness is not None:
                return _refuted(law, ground, field, witness)
    return verdict


def _symbolic(law: Law, ground: Ground, sample: dict[str, float], budget: Budget) -> Verdict:
    """The residuals over fractions, with as many auxiliary symbols as they need."""
    spare = 8
    while True:
        try:
            return _computed(law, ground, ground.fractions(Fractions, spare, sample, budget))
        except SpareNeededError:
            spare *= 2


def _refuted(
    law: Law, ground: Ground, field: Rationals | Balls, witness: tuple[str, Any]
) -> Verdict:
    what, residual = witness
    return Verdict(
        law.name,
        "refuted",
        shown=f"{what} fails at a point",
        witness={"point": ground.point_shown(field), "what": what, "residual": str(residual)},
    )


def tried(
    law: Law, ground: Ground, generator: random.Random
) -> tuple[Rationals | Balls, tuple[str, Any] | None]:
    """A point of the level, and the first residual that is not zero there."""
    for attempt in range(ATTEMPTS):
        values, exact = ground.point(generator)
        if attempt < ATTEMPTS // 2 and not ground.inside(values, exact):
            continue
        for rational in (True, False) if exact else (False,):
            field = ground.numbers(values, rational)
            try:
                for what, residual in everything(law, ground, field):
                    if not field.vanishes(residual):
                        return field, (what, residual)
                missing = shortfall(law, ground, field)
            except NotExactError:
                continue
            except ZeroDivisionError:
                break
            return field, missing
    raise InputError(
        f"{ground.system.name}: the law {law.name!r} divides by zero, or takes a root of a "
        "negative quantity, at every point tried on its level"
    )


def _computed(law: Law, ground: Ground, field: Fractions) -> Verdict:
    """The residuals, symbolically; that the level is invariant is shown once for all its laws."""
    invariance = Identity("invariance of the level", (), on=law.on)
    name = fingerprint(ground.system, invariance)
    if recall(name) is None:
        verdict = _vanishing(invariance, preserved(ground, field), field)
        if verdict.decision != "proven":
            return replace(verdict, law=law.name)
        remember(name, verdict)
    verdict = _vanishing(law, residuals(law, ground, field), field)
    domain = _domain(ground, field)
    if verdict.decision == "proven" and domain:
        return replace(verdict, shown=f"{verdict.shown}, where {domain}")
    return verdict


def _domain(ground: Ground, field: Fractions) -> str:
    """Where roots have the sign they have at the points: what they were split into stays positive.

    A single moving factor to the first power is positive wherever the root is real.
    """
    state = {str(s) for s in ground.system.symbols}
    kept: dict[str, None] = {}
    for factors in field.radicands:
        moving = [
            (poly, power)
            for poly, power in factors
            if state & {n for n, d in zip(field.names, poly.degrees(), strict=True) if d}
        ]
        if len(moving) > 1 or any(abs(power) > 1 for _, power in moving):
            kept.update({str(poly): None for poly, _ in moving})
    if not kept:
        return ""
    if max(map(len, kept)) > 60 or len(kept) > 4:
        return f"what stands under roots keeps the signs of its {len(kept)} factors"
    return ", ".join(f"{text} > 0" for text in kept)


def _vanishing(law: Law, pairs: Iterator[tuple[str, Any]], field: Fractions) -> Verdict:
    count = 0
    for what, residual in pairs:
        count += 1
        if not field.vanishes(residual):
            return Verdict(
                law.name,
                "undecided",
                reason=f"{what} vanishes at the points tried, but does not reduce to zero: a "
                f"polynomial of {len(residual.poly):,} terms remains",
            )
    return Verdict(law.name, "proven", shown=_words(law, count))


def _words(law: Law, count: int) -> str:
    kind = {Isomorphism: "carried onto the target", PoissonStructure: "Jacobi identity"}
    extra = next((words for cls, words in kind.items() if isinstance(law, cls)), "")
    many = "1 residual is" if count == 1 else f"{count} residuals are"
    return f"{many} zero modulo the relations" + (f" ({extra})" if extra else "")
