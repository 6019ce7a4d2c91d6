"""A verdict held against the truth."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

import sympy as sp

from flowlanes.errors import InputError
from flowlanes.system.laws import Law
from flowlanes.system.system import System
from fuzz.case import Case
from lawproof.proof.verdict import Verdict

__all__ = ["GRAVE", "OUTCOMES", "admits", "judged"]

#: What may come of a case: (outcome, what it means).
OUTCOMES = {
    "right": "true and proven, false and refuted, malformed and refused",
    "false proof": "false, but proven",
    "false proof where": "false at a point that meets the conditions",
    "false refutation": "true, but refuted",
    "bad witness": "false and refuted, but at a point outside of what is allowed",
    "proven where, true": "true, proven under conditions",
    "proven where, false": "false, proven under conditions; no known point meets them",
    "undecided, true": "",
    "undecided, false": "",
    "refused": "an InputError, though nothing is malformed",
    "not refused": "malformed, but refuted or undecided",
    "proven, malformed": "malformed, but proven",
    "crash": "an exception that is no InputError",
    "too long": "no answer within the limit",
}
#: Never to happen.
GRAVE = (
    "false proof",
    "false proof where",
    "false refutation",
    "bad witness",
    "proven, malformed",
    "crash",
)


def judged(case: Case, verdict: Verdict | Exception, made: tuple[System, Law] | None) -> str:
    """The outcome of a case.

    Parameters
    ----------
    case : Case
    verdict : Verdict or Exception
        What the prover said, or raised.
    made : tuple of System and Law, optional
        What was judged; None where it could not be made.
    """
    if isinstance(verdict, Exception):
        if not isinstance(verdict, InputError):
            return "crash"
        return "right" if case.truth == "malformed" or case.refusable else "refused"
    decision = verdict.decision
    if case.truth == "malformed":
        proven = decision.startswith("proven")
        return "proven, malformed" if proven else "not refused"
    if decision == "undecided":
        return f"undecided, {case.truth}"
    if decision == "refuted":
        if case.truth == "true":
            return "false refutation"
        assert made is not None
        return "right" if _allowed(made, verdict.witness) else "bad witness"
    if decision == "proven":
        return "right" if case.truth == "true" else "false proof"
    if case.truth == "true":
        return "proven where, true"
    if case.fails_at is not None and admits(verdict.conditions, case.fails_at):
        return "false proof where"
    return "proven where, false"


def admits(conditions: tuple[str, ...], point: Mapping[sp.Symbol, Any]) -> bool | None:
    """Whether a point meets all conditions of a proof; None where one of them cannot be read."""
    met = [_met(text, point) for text in conditions]
    if False in met:
        return False
    return None if None in met else True


def _met(text: str, point: Mapping[sp.Symbol, Any]) -> bool | None:
    text = text.strip()
    if text.startswith("not "):
        inner = _met(text[4:], point)
        return None if inner is None else not inner
    for word, combine in ((" or ", any), (" and ", all)):
        if word in text:
            parts = [_met(part.strip("() "), point) for part in text.split(word)]
            return None if None in parts else combine(parts)
    sides = re.split(r"(<=|>=|!=|≠|≤|≥|=|<|>)", text)
    if len(sides) != 3:
        return None
    names = {str(s): s for s in point}
    # a name may be a word of Python
    safe = {name: f"name{i}_" for i, name in enumerate(names)}
    meant = {safe[name]: s for name, s in names.items()}

    def read(side: str) -> sp.Expr:
        told = re.sub(r"[^\W\d]\w*", lambda m: safe.get(m.group(), m.group()), side)
        made = sp.sympify(told.replace("^", "**"), locals=meant)
        return made.subs(dict(point), simultaneous=True)

    try:
        left, right = read(sides[0]), read(sides[2])
        difference = sp.N(left - right, 40, chop=True)
    except Exception:
        return None
    if difference.free_symbols or not difference.is_real:
        return None
    relation = {"≠": "!=", "≤": "<=", "≥": ">=", "=": "=="}.get(sides[1], sides[1])
    number = float(difference)
    return {
        "<": number < 0, ">": number > 0, "<=": number <= 0, ">=": number >= 0,
        "==": number == 0, "!=": number != 0,
    }[relation]  # fmt: skip


def _allowed(made: tuple[System, Law], witness: Mapping[str, Any] | None) -> bool:
    """Whether a witness meets the conditions on parameters, the guards and, if exact, the level.

    What cannot be read is let pass.
    """
    system, law = made
    if witness is None or "point" not in witness:
        return True
    names = [*system.symbols, *(p.symbol for p in system.parameters)]
    point = {s: _number(witness["point"].get(str(s))) for s in names}
    if None in point.values() or len({str(s) for s in names}) < len(names):
        return True
    steps = dict(system.scalar_definitions)
    asked = [sp.sympify(c) for p in system.parameters for c in p.admissible]
    asked += [_written(guard.value, steps) > 0 for guard in system.guards]
    if any(condition.subs(point, simultaneous=True) == sp.false for condition in asked):
        return False
    level = [_written(c, steps) for c in (*system.relations, *law.level)]
    values = [c.subs(point, simultaneous=True) for c in level]
    return not any(v.is_Rational and v != 0 for v in values) or not _exact(witness["point"])


def _written(formula: Any, steps: Mapping[sp.Symbol, sp.Expr]) -> Any:
    while formula.free_symbols & set(steps):
        formula = formula.xreplace(dict(steps))
    return formula


def _exact(point: Mapping[str, str]) -> bool:
    return all(re.fullmatch(r"-?\d+(/\d+)?", text) for text in point.values())


def _number(text: str | None) -> sp.Rational | None:
    """An exact number, or the middle of a ball."""
    found = re.match(r"\[?(-?\d+(?:\.\d*)?(?:/\d+)?(?:e[+-]?\d+)?)", text or "")
    return sp.Rational(found.group(1)) if found else None
