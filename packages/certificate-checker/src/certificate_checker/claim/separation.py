"""Check that the equations of a separation are separated.

Every equation states that one quantity is constant, or gives its rate r or r².  Then, in lowest
terms, numerator and denominator of r_i²/r_k² must be products of polynomials, each of which
contains only u_i or only u_k apart from parameters and constants.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import combinations

from flint import fmpq

from .claim import Claim
from .errors import CheckError, UndefinedError
from .formulas import Formula, name, power, product, total, walk
from .polynomials import Poly, Ring
from .quotients import Quotient, quotient


@dataclass(frozen=True)
class Parts:
    """Quantities and constants of a separation.

    Attributes
    ----------
    quantities : mapping of name to equation
        Separated quantities, each with its equation and rate.
    """

    quantities: Mapping[str, tuple[Formula, Formula]]
    constants: tuple[str, ...]


def parts(claim: Claim) -> Parts:
    """Quantities with their equations and rates, and constants of a separation.

    Raises
    ------
    CheckError
        If an equation contains no rate, several rates, or the rate of an expression without a
        name.
    """
    squares: dict[str, tuple[Formula, Formula]] = {}
    constants: list[str] = []
    for number, equation in enumerate(claim.law.several["equations"], 1):
        rates = {node for node in walk([equation]) if node.kind == "call" and node.word == "Rate"}
        if len(rates) != 1 or next(iter(rates)).parts[0].kind != "name":
            raise CheckError(
                f"equation {number} of the separation does not contain exactly one rate"
            )
        (rate,) = rates
        word = rate.parts[0].word
        if equation is rate:
            constants.append(word)
        elif word in squares:
            raise CheckError(f"{word} has two equations in the separation")
        else:
            squares[word] = equation, rate
    if len(squares) < 2:
        raise CheckError("a separation has two quantities or more")
    return Parts(squares, tuple(constants))


def check_separation(claim: Claim) -> None:
    """Check that the quantities of a separation are separated."""
    stated = parts(claim)
    own = claim.law.quantities
    words = [*claim.system.symbols, *own]
    # The name is reserved, so no symbol has it.
    speed = "Rate"
    ring = Ring([*words, speed])

    def value_of(word: str) -> Quotient | None:
        return (ring.generator(word), ring.constant(1)) if word in ring.index else None

    squares: dict[str, Quotient] = {}
    for word, (equation, rate) in stated.quantities.items():
        try:
            above, _ = quotient(
                _with_rate_symbol(name(speed), rate, equation),
                ring,
                value_of,
                claim.system.definitions,
            )
        except UndefinedError:
            raise CheckError(f"the equation of {word} is not rational") from None
        squares[word] = _square(ring, above, speed, word)
    still = {*claim.system.parameters, *stated.constants}
    for first, second in combinations(squares, 2):
        (p, q), (r, s) = squares[first], squares[second]
        above, below = p * s, q * r
        # In lowest terms every factor of a product f(u_i) g(u_k) belongs to one variable.
        common = above.gcd(below)
        for poly in (above / common, below / common):
            for factor, _ in poly.factor()[1]:
                if {*_variables_of(ring, factor)} - still not in ({first}, {second}, set()):
                    raise CheckError(f"the rates of {first} and {second} do not separate")


def _with_rate_symbol(symbol: Formula, rate: Formula, formula: Formula) -> Formula:
    """Formula with a symbol instead of the rate; UndefinedError if it is not rational."""
    if formula is rate:
        return symbol
    inner = [_with_rate_symbol(symbol, rate, part) for part in formula.parts]
    if formula.kind in ("number", "name"):
        return formula
    if formula.kind == "sum":
        return total(inner)
    if formula.kind == "product":
        return product(inner)
    if formula.kind == "power":
        return power(*inner)
    raise UndefinedError("the formula is not rational")


def _square(ring: Ring, above: Poly, speed: str, word: str) -> Quotient:
    """Square of the rate, from A r + C = 0 or A r² + C = 0."""
    position = ring.index[speed]
    terms: dict[int, dict[tuple[int, ...], fmpq]] = {}
    for exponents, coefficient in above.to_dict().items():
        powers = list(map(int, exponents))
        degree, powers[position] = powers[position], 0
        terms.setdefault(degree, {})[tuple(powers)] = coefficient
    if set(terms) - {0} not in ({1}, {2}):
        raise CheckError(f"the equation of {word} gives neither its rate nor the square of it")
    (degree,) = set(terms) - {0}
    lead = ring.context.from_dict(terms[degree])
    constant = ring.context.from_dict(terms.get(0, {}))
    if constant.is_zero():
        raise CheckError(f"the equation of {word} says that it is constant")
    return (-constant, lead) if degree == 2 else (constant * constant, lead * lead)


def _variables_of(ring: Ring, poly: Poly) -> list[str]:
    return [word for word, degree in zip(ring.names, poly.degrees(), strict=True) if degree]
