"""Proof and refutation of laws, with checked arguments and cached verdicts."""

from __future__ import annotations

import contextlib
import math
import time
from dataclasses import fields, replace
from typing import Protocol

import sympy as sp

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.formulas.errors import OutOfReachError, UnknownSymbolError
from flowlanes.formulas.number_fields import ball_precision
from flowlanes.system.laws import Law
from flowlanes.system.parameters import condition_words, conditions, satisfies
from flowlanes.system.system import System, Theorem

from .decision import verdict_of
from .fields.budget import EFFORT, Budget, checked_effort
from .theorems import identities_of, theorem_of
from .verdict import Verdict
from .verdict_cache import fingerprint, load_verdict, store_verdict

POINTS_ALONE = 1
"""An effort too small for a proof, so that a law is only evaluated at points."""


@arguments_checked
def prove(system: System, law: Law | str, *, effort: int = EFFORT) -> Verdict:
    """Prove or refute a law of a system.

    Parameters
    ----------
    system : System
    law : Law or str
        A law, or the name of a law of the system.
    effort : int
        Term operations after which a law is left undecided; independent of the machine.

    Returns
    -------
    Verdict

    Raises
    ------
    InputError
        If the law uses an unknown symbol, its level is empty, or it is nowhere defined on it.

    Examples
    --------
    >>> import flowlanes
    >>> import lawproof
    >>> import sympy as sp
    >>> a, b, c = sp.symbols("a b c", real=True)
    >>> top = flowlanes.System("top", "Euler's top", {a: -b * c, b: 4 * a * c, c: -3 * a * b})
    >>> lawproof.prove(top, flowlanes.Integral("square", a**2 + b**2 + c**2)).decision
    'proven'
    >>> lawproof.prove(top, flowlanes.Integral("a", a)).decision
    'refuted'
    """
    checked_effort(effort)
    if isinstance(law, str):
        law = _by_name(system, law)
    _check_defaults(system)
    _check_formulas(system, law)
    theorem = theorem_of(system, law)
    law = law.basic(system)
    name = fingerprint(system, law, theorem)
    stored = load_verdict(name, effort)
    if stored is not None:
        return stored
    started = time.monotonic()
    budget = Budget(effort=effort)
    try:
        with ball_precision():
            if theorem is None:
                verdict = verdict_of(system, law, budget)
            else:
                verdict = _by_theorem(system, law, theorem, budget)
            verdict = replace(verdict, terms=budget.largest)
    except UnknownSymbolError as symbol:
        raise InputError(
            f"{system.name}: the law {law.name!r} uses {symbol}, which is neither a state variable "
            "nor a definition nor a parameter of the system"
        ) from None
    except OutOfReachError as reason:
        verdict = Verdict(law.name, "undecided", reason=str(reason))
    verdict = replace(verdict, effort=budget.used, seconds=time.monotonic() - started)
    store_verdict(name, verdict, effort)
    return verdict


@arguments_checked
def prove_all(system: System, *, effort: int = EFFORT) -> tuple[Verdict, ...]:
    """Prove or refute all laws of a system.

    Parameters
    ----------
    system : System
    effort : int
        Term operations after which a law is left undecided; independent of the machine.

    Returns
    -------
    tuple of Verdict
        In the order of ``system.laws``. A law for which `prove` would raise InputError is
        "refused".

    Raises
    ------
    InputError
        If an argument has the wrong type.

    Examples
    --------
    >>> import flowlanes
    >>> import lawproof
    >>> import sympy as sp
    >>> x, v = sp.symbols("x v", real=True)
    >>> energy = flowlanes.Integral("energy", v**2 / 2 - sp.cos(x))
    >>> pendulum = flowlanes.System("pendulum", "Pendulum", {x: v, v: -sp.sin(x)}, laws=(energy,))
    >>> [verdict.decision for verdict in lawproof.prove_all(pendulum)]
    ['proven']
    """
    checked_effort(effort)
    return tuple(judgement_of(prove, system, each, effort) for each in system.laws)


class Prover(Protocol):
    """A function that decides a law: `prove` or `prove_with_certificate`."""

    def __call__(self, system: System, law: Law, *, effort: int) -> Verdict:
        """The verdict on a law of a system."""
        ...


def judgement_of(prover: Prover, system: System, law: Law, effort: int) -> Verdict:
    """The verdict on one law of several; "refused" in place of an InputError."""
    try:
        return prover(system, law, effort=effort)
    except InputError as problem:
        return Verdict(law.name, "refused", reason=str(problem))


def _by_theorem(system: System, law: Law, theorem: Theorem, budget: Budget) -> Verdict:
    """The verdict on a law by a theorem: points are tried, then its identities are proven."""
    with contextlib.suppress(OutOfReachError):
        verdict = verdict_of(system, law, Budget(effort=POINTS_ALONE))
        if verdict.decision != "undecided":
            return verdict
    wholes = identities_of(theorem, system, law)
    parts = [v for whole in wholes for v in prove_all(whole, effort=budget.effort)]
    budget.charge(sum(v.effort for v in parts))
    if not parts or any(not part for part in parts):
        return verdict_of(system, law, budget)
    count = f"{len(parts)} identities are" if len(parts) > 1 else "1 identity is"
    return Verdict(law.name, "proven", finding=f"{theorem.words}; {count} certified")


def _check_defaults(system: System) -> None:
    """Check that the defaults of the parameters, near which points are drawn, are admissible."""
    for parameter in system.parameters:
        if not math.isfinite(parameter.default):
            raise InputError(
                f"{system.name}: the default {parameter.default} of {parameter.symbol} is no number"
            )
    for parameter, condition in conditions(system.parameters):
        if condition.free_symbols <= set(system.defaults) and not satisfies(
            condition, system.defaults
        ):
            raise InputError(
                f"{system.name}: the default {parameter.symbol} = {parameter.default:g} is not "
                f"admissible; {condition_words(condition)} must hold"
            )


def _check_formulas(system: System, law: Law) -> None:
    """Check that a law consists of formulas."""
    if not isinstance(law.level, tuple | list):
        raise InputError(
            f"{system.name}: the level of the law {law.name!r} is {law.level}; it must be a tuple "
            "of formulas that vanish, such as (x,)"
        )
    waiting = [
        (f.name, getattr(law, f.name)) for f in fields(law) if f.name in ("value", "level", "time")
    ]
    while waiting:
        name, value = waiting.pop()
        if isinstance(value, tuple | list):
            waiting += [(name, part) for part in value]
        elif not isinstance(value, int | float | sp.Basic | sp.MatrixBase):
            raise InputError(
                f"{system.name}: the law {law.name!r} has {value!r} in its {name!r}, which is no "
                "formula of SymPy"
            )


def _by_name(system: System, name: str) -> Law:
    for law in system.laws:
        if law.name == name:
            return law
    names = ", ".join(law.name for law in system.laws) or "none"
    raise InputError(f"{system.name} has no law {name!r}; its laws are {names}")
