"""Generators and auxiliary symbols of a proof, from a certificate."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from ..claim.claim import Claim
from ..claim.domain import domain
from ..claim.errors import CheckError, UndefinedError
from ..claim.formulas import Formula
from ..claim.json_data import as_list, choice, field, integer, items, mapping, only, rational, text
from ..claim.parsing import parse
from ..claim.polynomials import Poly, Ring
from ..claim.quotients import quotient
from .generator_functions import Auxiliary
from .generators import Exchange, Generators

FIELDS = (
    "ring",
    "auxiliary",
    "settled",
    "exchanged",
    "inverted",
    "zeros",
    "signs",
    "equations",
    "divisors",
    "positive",
)

#: Known functions of one argument.
ONE = {"exp", "log", "asin", "acos", "atan"}


def read_generators(data: Mapping[str, object], claim: Claim, what: str) -> Generators:
    """Ring, auxiliary symbols and generators of a proof."""
    names = [text(n, f"the ring of {what}") for n in as_list(field(data, "ring", what), what)]
    if len(set(names)) < len(names):
        raise CheckError(f"the ring of {what} has a generator twice")
    ring = Ring(names)
    settled = _read_settled(data.get("settled", []), claim, what)
    exchanged = _read_exchanged(data.get("exchanged", []), claim, what)
    if set(exchanged) & set(settled):
        raise CheckError(f"{what} settles and exchanges the same parameter")
    generators = Generators(
        claim=claim,
        domain=domain(claim, settled),
        ring=ring,
        auxiliary=_auxiliaries(data.get("auxiliary", []), ring, what),
        settled_formulas=settled,
        exchanges=exchanged,
        inverses=_read_inverted(data.get("inverted", []), claim, what),
        zeros=_read_zeros(data.get("zeros", []), claim, what),
        signs=_read_signs(data.get("signs", []), ring, what),
    )
    system = claim.system
    gone = {*settled, *exchanged}
    for word in generators.plain:
        if word in gone or word not in {*system.symbols, *system.definitions}:
            raise CheckError(f"the ring of {what} has a generator {word} without a meaning")
    return generators


def _auxiliaries(data: object, ring: Ring, what: str) -> tuple[Auxiliary, ...]:
    auxiliaries: list[Auxiliary] = []
    meanings: dict[str, object] = {}
    for pair in as_list(data, f"the auxiliary symbols of {what}"):
        name, meaning = items(pair, 2, f"an auxiliary symbol of {what}")
        word = text(name, "an auxiliary symbol")
        if word not in ring.names or word in meanings:
            raise CheckError(f"the auxiliary symbol {word!r} of {what} is not in its ring, once")
        meanings[word] = meaning
    later = set(meanings)
    # An auxiliary symbol may use only earlier ones; `later` holds it and those after it.
    for word, meaning in meanings.items():
        auxiliary = _auxiliary(word, mapping(meaning, word), ring)
        for above, below in auxiliary.of:
            for poly in (above, *(factor for factor, _ in below)):
                if later & _generators(poly, ring):
                    raise CheckError(f"{word} is defined by a later symbol")
        if any(later & _generators(poly, ring) for poly, _ in auxiliary.whole):
            raise CheckError(f"{word} is defined by a later symbol")
        later.discard(word)
        auxiliaries.append(auxiliary)
    return tuple(auxiliaries)


def _generators(poly: Poly, ring: Ring) -> set[str]:
    return {n for n, d in zip(ring.names, poly.degrees(), strict=False) if d > 0}


def _auxiliary(word: str, data: Mapping[str, object], ring: Ring) -> Auxiliary:
    what = f"the meaning of {word}"
    kinds = ("root", "formal root", "power", "sin", "cos", "pi", "function", "known")
    kind = choice(field(data, "kind", what), what, *kinds)
    symbol = Auxiliary(word, kind, kind, 0, (), None, (), [])
    if kind == "pi":
        only(data, what, "kind")
        return symbol
    of = field(data, "of", what)
    if kind in ("root", "formal root"):
        only(data, what, "kind", "of", "degree", *(["whole"] if kind == "formal root" else []))
        degree = integer(field(data, "degree", what), what, 2, 1000)
        symbol = replace(symbol, number=degree, of=((ring.read(of, what), []),))
        if kind == "root":
            return symbol
        whole = ring.powers(field(data, "whole", what), what, negative=True)
        return replace(symbol, whole=whole)
    if kind == "power":
        only(data, what, "kind", "of", "exponent", "fineness")
        fineness = integer(field(data, "fineness", what), what, 1, 1000)
        exponent = parse(field(data, "exponent", what), what)
        base = ring.read(of, what)
        return replace(symbol, number=fineness, exponent=exponent, of=((base, []),))
    if kind in ("sin", "cos"):
        only(data, what, "kind", "of")
        return replace(symbol, of=(ring.fraction(of, what),))
    only(data, what, "kind", "of", "name", *(["orders"] if kind == "function" else []))
    arguments = tuple(ring.fraction(part, what) for part in as_list(of, what))
    name = text(field(data, "name", what), what)
    symbol = replace(symbol, word=name, of=arguments)
    if kind == "function":
        orders = items(field(data, "orders", what), len(arguments), what)
        return replace(symbol, orders=tuple(integer(n, what, 0, 1000) for n in orders))
    if name not in {*ONE, "atan2"} or len(arguments) != 1 + (name == "atan2"):
        raise CheckError(f"{what} is no known function of so many arguments")
    return symbol


def _read_settled(data: object, claim: Claim, what: str) -> dict[str, Formula]:
    settled: dict[str, Formula] = {}
    for pair in as_list(data, f"what is settled in {what}"):
        word, formula = (text(t, what) for t in items(pair, 2, f"what is settled in {what}"))
        if word not in claim.system.parameters or word in settled:
            raise CheckError(
                f"{what} settles {word!r}, which is not a parameter, or is settled twice"
            )
        settled[word] = parse(formula, f"what {word} is settled to in {what}")
    _check_settled(claim, settled, what)
    return settled


def _check_settled(claim: Claim, parameter_formulas: Mapping[str, Formula], what: str) -> None:
    """Check by elimination that the conditions determine the settled parameters as stated."""
    if not parameter_formulas:
        return
    system = claim.system
    ring = Ring(system.parameters)
    solution: dict[str, Poly] = {}

    def value_of(word: str) -> tuple[Poly, Poly] | None:
        if word not in ring.index:
            return None
        return solution.get(word, ring.generator(word)), ring.constant(1)

    for condition in claim.conditions:
        # A condition that is not rational in the parameters alone determines no parameter.
        try:
            poly, _ = quotient(condition, ring, value_of, system.definitions)
        except UndefinedError:
            continue
        for word in sorted(set(parameter_formulas) - set(solution)):
            value = _linear_solution(poly, word, ring)
            if value is not None:
                table = [value if n == word else ring.generator(n) for n in ring.names]
                solution = {n: p.compose(*table) for n, p in solution.items()}
                solution[word] = value
                break
    for word, formula in parameter_formulas.items():
        if word not in solution:
            raise CheckError(f"{what} settles {word}, which no condition gives")
        try:
            above, below = quotient(formula, ring, value_of, system.definitions)
        except UndefinedError:
            raise CheckError(f"{what} settles {word} by a formula that is not rational") from None
        if above != below * solution[word]:
            raise CheckError(f"{what} settles {word} otherwise than the conditions")


def _linear_solution(poly: Poly, word: str, ring: Ring) -> Poly | None:
    """Value of a symbol in which a polynomial is linear with a constant coefficient, or None."""
    slope = poly.derivative(ring.index[word])
    if slope.is_zero() or not slope.is_constant():
        return None
    factor = slope.leading_coefficient()
    return ring.generator(word) - poly / factor


def _read_exchanged(data: object, claim: Claim, what: str) -> dict[str, Exchange]:
    exchanges: dict[str, Exchange] = {}
    for four in as_list(data, f"what is exchanged in {what}"):
        word, factor, parameter, constant = items(four, 4, f"what is exchanged in {what}")
        word, parameter = (text(t, f"what is exchanged in {what}") for t in (word, parameter))
        number = rational(factor, f"a factor of what is exchanged in {what}")
        if word not in claim.system.definitions or parameter not in claim.system.parameters:
            raise CheckError(f"{what} exchanges {word!r} and {parameter!r} without a meaning")
        if parameter in exchanges or not number or word in [e.name for e in exchanges.values()]:
            raise CheckError(f"{what} exchanges {parameter} for {word} twice or by zero")
        exchange = Exchange(word, number, parse(constant, f"the rest of {word} in {what}"))
        exchanges[parameter] = exchange
    return exchanges


def _read_inverted(
    data: object, claim: Claim, what: str
) -> tuple[tuple[tuple[str, ...], tuple[str, ...]], ...]:
    inverted = []
    for pair in as_list(data, f"what is inverted in {what}"):
        names, of = (
            tuple(text(word, what) for word in items(six, 6, what))
            for six in items(pair, 2, f"what is inverted in {what}")
        )
        for word in (*names, *of):
            if word not in claim.system.definitions:
                raise CheckError(f"{what} inverts {word!r}, which is not a definition")
        inverted.append((names, of))
    return tuple(inverted)


def _read_zeros(data: object, claim: Claim, what: str) -> tuple[Formula, ...]:
    zeros = []
    for formula in as_list(data, f"the zeros of {what}"):
        zero = parse(formula, f"a zero of {what}")
        if zero.kind != "function" or zero not in claim.conditions:
            raise CheckError(f"{what} sets {formula} to zero, which is not a condition")
        zeros.append(zero)
    return tuple(zeros)


def _read_signs(data: object, ring: Ring, what: str) -> tuple[tuple[Poly, int], ...]:
    signs = []
    for pair in as_list(data, f"the signs of {what}"):
        poly, sign = items(pair, 2, f"a sign of {what}")
        factor = ring.read(poly, f"a sign of {what}")
        if factor.is_constant():
            raise CheckError(f"a sign of {what} is that of a number")
        signs.append((factor, choice(sign, f"a sign of {what}", 1, -1)))
    return tuple(signs)
