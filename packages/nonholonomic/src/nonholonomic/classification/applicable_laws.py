"""Sort the proven laws of a system by domain: everywhere, on a level, or nowhere."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import sympy as sp

from flowlanes.printing.formula import text
from flowlanes.printing.laws import condition_text
from flowlanes.system.laws import Law
from flowlanes.system.named_formulas import scalars
from lawproof.proof.verdict import Verdict

from .ranks import RankSample
from .statements import IgnoredLaw


@dataclass(frozen=True)
class ApplicableLaws:
    """The laws of a system sorted by where they apply.

    Attributes
    ----------
    general : tuple of Law
        Proven, and valid on the whole phase space at the present parameters.
    levels : dict
        Conditions on the state ↦ the laws that are proven under them.
    ignored_laws : tuple of IgnoredLaw
    """

    general: tuple[Law, ...]
    levels: dict[tuple[sp.Expr, ...], tuple[Law, ...]]
    ignored_laws: tuple[IgnoredLaw, ...]


def sorted_laws(whole: RankSample, verdicts: Mapping[str, Verdict]) -> ApplicableLaws:
    """Sort the laws of a system by where they apply.

    Parameters
    ----------
    whole : RankSample
        The system on its whole phase space.
    verdicts : mapping of str to Verdict
        Verdicts on its laws, by name.
    """
    system = whole.system
    state = set(system.symbols)
    general: list[Law] = []
    levels: dict[tuple[sp.Expr, ...], tuple[Law, ...]] = {}
    uncounted = []
    for law in system.laws:
        verdict = verdicts.get(law.name)
        if not verdict:
            uncounted.append(IgnoredLaw(law.name, _why(verdict)))
            continue
        moving = tuple(c for c in law.level if whole.expand(*scalars(c)).free_symbols & state)
        fixed = tuple(c for c in law.level if c not in moving)
        if not all(map(whole.vanishes, fixed)):
            where = condition_text(replace(law, level=fixed), system, text)
            uncounted.append(IgnoredLaw(law.name, f"proven {where}, not at the present parameters"))
        elif moving:
            levels[moving] = (*levels.get(moving, ()), law)
        else:
            general.append(law)
    return ApplicableLaws(tuple(general), levels, tuple(uncounted))


def _why(verdict: Verdict | None) -> str:
    if verdict is None:
        return "without a verdict"
    return verdict.words
