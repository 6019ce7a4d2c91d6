"""The equations of a proof: conditions, roots, circles and equal function values."""

from __future__ import annotations

from collections.abc import Sequence

from flowlanes.formulas.errors import OutOfReachError
from flowlanes.system.formula_text import short_text

from ..claim_text import Text
from ..fields.quotient_ring import Element, Poly
from ..fields.root_field import FINENESS
from ..fields.unreduced_fields import Meaning
from ..level.triangular_set import numerator
from .chains import Chains
from .proof_setting import ProofSetting
from .sign_reasons import Reasons


def equation_sources(setting: ProofSetting) -> list[tuple[Poly, Text]]:
    """The vanishing polynomials, each with the text that justifies it."""
    sources: list[tuple[Poly, Text]] = []
    for formula, value in setting.conditions:
        poly = numerator(setting.field, value)
        below = setting.powers(
            [(setting.field.factors[n], -p) for n, p in value.powers.items() if p < 0]
        )
        sources.append((poly, {"poly": setting.terms(poly), "from": formula, "denominator": below}))
    for main, poly, _ in setting.field.relations:
        kind = setting.field.record[main].kind
        source = f"root {main}"
        if kind in ("sin", "cos"):
            both = [
                n
                for n in setting.field.record
                if setting.field.generators[n] in _gens(setting, poly)
            ]
            source = f"circle {' '.join(both)}"
        sources.append((poly, {"poly": setting.terms(poly), "from": source}))
    return _with_equal_arguments(setting, _with_equal_values(setting, sources))


def signed_equations(sources: Sequence[tuple[Poly, Text]]) -> dict[int, Poly]:
    """The equations, by index, that hold on the whole domain for every choice of signs."""
    words = ("root", "one", "same", "argument")
    return {
        number: poly
        for number, (poly, text) in enumerate(sources)
        if str(text["from"]).split(" ")[0] not in words
    }


#: Known functions that are injective.
ONE_TO_ONE = ("exp", "log", "asin", "atan")


def _with_equal_arguments(
    setting: ProofSetting, equations: list[tuple[Poly, Text]]
) -> list[tuple[Poly, Text]]:
    """Add a = b for every equation f(a) = f(b) of an injective function f.

    If q · (f(a) − f(b)) vanishes, so does q · (a − b).
    """
    field = setting.field
    values = [(name, m) for name, m in field.record.items() if m.name in ONE_TO_ONE]
    pairs = [(f"argument {n}", field.generators[n] - 1, m.of[0]) for n, m in values]
    pairs = [pair for pair, (_, m) in zip(pairs, values, strict=True) if m.name == "exp"]
    for number, (name, meaning) in enumerate(values):
        for other, theirs in values[:number]:
            if meaning.agrees(theirs):
                difference = field.generators[name] - field.generators[other]
                source = f"argument {name} {other}"
                pairs.append((source, difference, meaning.of[0] - theirs.of[0]))
    sources = list(equations)
    for source, difference, argument in pairs:
        for number, (equation, _) in enumerate(equations):
            quotient, rest = divmod(equation, difference)
            if equation and not rest:
                poly = quotient * numerator(field, argument)
                text: Text = {
                    "poly": setting.terms(poly),
                    "from": source,
                    "equation": number,
                    "quotient": setting.terms(quotient),
                }
                sources.append((poly, text))
                break
    return sources


def _with_equal_values(
    setting: ProofSetting, equations: list[tuple[Poly, Text]]
) -> list[tuple[Poly, Text]]:
    """Add f(a) = f(b) for arguments a and b that the equations make equal."""
    field = setting.field
    sources = list(equations)
    record = list(field.record.items())
    for number, (name, meaning) in enumerate(record):
        value = field.generators[name]
        others = [(o, m) for o, m in record[:number] if m.kind == meaning.kind]
        candidates: list[tuple[str, Poly, list[Poly]]] = []
        if meaning.kind in ("root", "power"):
            candidates.append((f"one {name}", value - 1, [meaning.of[0].poly - 1]))
        for other, theirs in others:
            if meaning.kind != "formal root" and meaning.agrees(theirs):
                pairs = zip(meaning.of, theirs.of, strict=True)
                differences = [numerator(field, a - b) for a, b in pairs]
                equal = value - field.generators[other]
                candidates.append((f"same {name} {other}", equal, differences))
        for source, poly, differences in candidates:
            chains = Chains(field.ring, Reasons(field.ring, []), frozenset(), field.budget)
            by = [chains.quotients(d, [p for p, _ in sources]) for d in differences]
            if any(by) and None not in by:
                text: Text = {
                    "poly": setting.terms(poly),
                    "from": source,
                    "quotients": [
                        [setting.terms(part[i]) if i in part else [] for i in range(len(sources))]
                        for part in by
                        if part is not None
                    ],
                }
                sources.append((poly, text))
                break
    return sources


def _gens(setting: ProofSetting, poly: Poly) -> list[Poly]:
    return [g for g, d in zip(setting.field.ring.gens(), poly.degrees(), strict=True) if d]


def meaning_text(setting: ProofSetting, meaning: Meaning) -> Text:
    """The meaning of an auxiliary symbol in the format of a certificate."""
    of = [_fraction(setting, element) for element in meaning.of]
    if meaning.kind in ("root", "formal root"):
        text = {
            "kind": meaning.kind,
            "of": setting.terms(meaning.of[0].poly),
            "degree": meaning.number,
        }
        if meaning.kind == "formal root":
            text["whole"] = setting.powers(meaning.whole)
        return text
    if meaning.kind == "power":
        if meaning.of[0].powers:
            raise OutOfReachError("no certificate: a symbolic power of a fraction")
        return {
            "kind": "power",
            "of": setting.terms(meaning.of[0].poly),
            "exponent": short_text(meaning.exponent),
            "fineness": FINENESS,
        }
    if meaning.kind in ("sin", "cos"):
        return {"kind": meaning.kind, "of": of[0]}
    if meaning.kind == "pi":
        return {"kind": "pi"}
    text = {"kind": meaning.kind, "name": meaning.name, "of": of}
    if meaning.kind == "function":
        text["orders"] = list(meaning.orders)
    return text


def _fraction(setting: ProofSetting, element: Element) -> Text:
    poly, below = element.poly, []
    for number, power in element.powers.items():
        if power > 0:
            poly = poly * setting.field.factors[number] ** power
        else:
            below.append((setting.field.factors[number], -power))
    return {"numerator": setting.terms(poly), "denominator": setting.powers(below)}
