"""One proof of a certificate: the residuals of a law in a ring and why they vanish."""

from __future__ import annotations

from collections.abc import Callable

from flowlanes.system.formula_text import short_text

from ..claim_text import Text
from ..fields.quotient_ring import Element, Poly
from .case_tree import Cases
from .chains import Chains
from .proof_equations import equation_sources, meaning_text, signed_equations
from .proof_setting import ProofSetting
from .proof_signs import positive_texts, sign_reasons

#: The condition of a verdict that excludes the zeros of a polynomial, or None.
ExclusionOf = Callable[[ProofSetting, Poly], str | None]


def proof_text(setting: ProofSetting, exclusion: ExclusionOf, with_decisions: bool) -> Text:
    """A proof in the format of a certificate.

    Parameters
    ----------
    with_decisions : bool
        Whether the decided signs are stated as assumptions, for one proof among several.

    Raises
    ------
    OutOfReachError
        If no complete proof was found.
    """
    field, level = setting.field, setting.level
    sources = equation_sources(setting)
    polys = [poly for poly, _ in sources]
    assumed = list(field.decisions.values()) if with_decisions else []
    reasons, entries = sign_reasons(setting, signed_equations(sources), assumed)
    numerators = [field.reduce(value.poly) for _, value in _multiplied_out(setting)]
    # Recording a denominator as non-zero may add sums to `reasons`, which must happen before the
    # positive quantities are written.
    for _, value in _multiplied_out(setting):
        for number, power in value.powers.items():
            if power < 0:
                reasons.is_nonzero(field.factors[number])
    state = {str(s) for s in level.system.symbols}
    moving = frozenset(i for i, name in enumerate(field.names) if name in state)
    cases = Cases(
        Chains(field.ring, reasons, moving, field.budget),
        numerators,
        setting.terms,
        lambda poly: exclusion(setting, poly),
    )
    tree = cases.tree(polys)
    return {
        "ring": list(setting.ring),
        "auxiliary": [[name, meaning_text(setting, m)] for name, m in field.record.items()],
        "settled": [[str(s), short_text(value)] for s, value in level.fixed_parameters.items()],
        "exchanged": [
            [str(e.name), str(e.factor), str(e.parameter), short_text(e.rest)]
            for e in level.swapped_generators
        ],
        "inverted": [
            [[str(s) for s in i.name], [str(s) for s in i.of]] for i in level.exchanged_inverses
        ],
        "zeros": [short_text(zero) for zero in level.zeros],
        "signs": [[setting.terms(poly), sign] for poly, sign in assumed],
        "equations": [text for _, text in sources],
        "divisors": [
            {
                "formula": entry.formula,
                "where": entry.where,
                "content": str(entry.content),
                "factors": setting.powers(entry.factors),
            }
            for entry in entries
        ],
        "positive": positive_texts(setting, reasons, len(sources)),
        "residuals": [_residual(setting, what, value) for what, value in _multiplied_out(setting)],
        "tree": tree,
    }


def _multiplied_out(setting: ProofSetting) -> list[tuple[str, Element]]:
    """The residuals with positive powers of named factors multiplied into the numerator."""
    residuals = []
    for what, value in setting.residuals:
        poly, below = value.poly, {}
        for number, power in value.powers.items():
            if power > 0:
                poly = poly * setting.field.factors[number] ** power
            else:
                below[number] = power
        residuals.append((what, Element(setting.field, poly, below)))
    return residuals


def _residual(setting: ProofSetting, what: str, value: Element) -> Text:
    below = [(setting.field.factors[n], -p) for n, p in value.powers.items()]
    return {
        "what": what,
        "numerator": setting.terms(setting.field.reduce(value.poly)),
        "denominator": setting.powers(below),
    }
