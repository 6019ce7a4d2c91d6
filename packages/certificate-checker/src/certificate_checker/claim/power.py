"""Theorem on energy: a proof of an integral from the linear equations of the rates.

For velocities u of the state, a certificate may state formulas A, h, C, b, λ with two claims,
which are identities in all their variables:

*power*: with free symbols a instead of the rates of u, F' = uᵀ(A a − h) for the integral F; C u =
κ f and f' = C a − b for the relations f of the system that are numbered as constraints; and the
rate of any other relation is a constraint or zero;

*solution*: for the rates of the system, A u̇ − h − Cᵀλ = 0 and C u̇ − b = 0, where names of
definitions may be treated as independent variables.

They imply Ḟ = uᵀ(A u̇ − h) = uᵀCᵀλ = Σ κ_μ λ_μ f_μ, which is zero where the relations hold, and
the relations are preserved by the motion.  This is valid where both claims are defined; so they
must not contain a divisor or a root that does not occur in the claim itself.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from .claim import Claim, read_claim
from .domain import Domain, domain
from .errors import CheckError
from .formulas import CONSTANTS, names_in
from .json_data import as_list, field, integer, items, mapping, only, text
from .parsing import parse

FIELDS = (
    "velocities", "accelerations", "mass", "force", "slopes", "drift", "multipliers",
    "constraints", "degrees", "positions", "definitions", "opaque",
)  # fmt: skip
#: The names of the two claims.
IDENTITIES = ("power", "solution")
_LARGEST_DEGREE = 100

Texts = Sequence[str]


def claims_of_identities(
    claim_data: Mapping[str, object], claim: Claim, data: object
) -> Mapping[str, Mapping[str, object]]:
    """The two claims that together prove an integral, by name; CheckError if they do not.

    Parameters
    ----------
    claim_data : mapping
        Data of the claim.
    claim : Claim
        The claim.
    data : mapping
        Linear equations of the rates from a certificate.
    """
    if claim.law.kind != "Integral" or claim.law.on:
        raise CheckError("linear equations of the rates prove integrals on the whole phase space")
    rates = _LinearRates(claim_data, claim, mapping(data, "the equations of the rates"))
    claims = dict(zip(IDENTITIES, (rates.power(), rates.solution()), strict=True))
    own = _divisors(domain(claim, {}))
    for word, whole in claims.items():
        if not _divisors(domain(read_claim(whole, f"the claim {word!r}"), {})) <= own:
            raise CheckError(f"the claim {word!r} is not defined wherever the law is")
    return claims


def _divisors(of: Domain) -> set[object]:
    """Formulas that must be nonzero or positive; of products only their factors."""
    nonzero = {
        (side, f)
        for side, f in of.nonzero
        if not (f.kind == "product" or (f.kind == "power" and f.parts[1].kind == "number"))
    }
    return {*nonzero, *of.positive, *of.bases, *of.logarithms}


class _LinearRates:
    """Linear equations of a certificate, as formulas in text form."""

    def __init__(
        self, claim_data: Mapping[str, object], claim: Claim, data: Mapping[str, object]
    ) -> None:
        what = "the equations of the rates"
        only(data, what, *FIELDS)
        self.claim = claim
        system = mapping(claim_data["system"], what)
        self.system = system
        self.value = str(mapping(claim_data["law"], what)["value"])
        self.relations = [str(f) for f in as_list(system["relations"], what)]
        self.velocities = _names_in_field(data, "velocities")
        self.accelerations = _names_in_field(data, "accelerations")
        size = len(self.velocities)
        if len(set(self.velocities)) != size or not {*self.velocities} <= {*claim.system.state}:
            raise CheckError(f"{what} are not those of different variables of the state")
        if len(self.accelerations) != size:
            raise CheckError(f"{what} name {len(self.accelerations)} rates of {size} velocities")
        self.multipliers = _formulas(field(data, "multipliers", what))
        count = len(self.multipliers)
        self.mass = [_formulas(r, size) for r in items(field(data, "mass", what), size, what)]
        self.force = _formulas(field(data, "force", what), size)
        self.slopes = [_formulas(r, size) for r in items(field(data, "slopes", what), count, what)]
        self.drift = _formulas(field(data, "drift", what), count)
        last = len(self.relations) - 1
        numbers = items(field(data, "constraints", what), count, what)
        self.constraints = [integer(n, f"a constraint of {what}", 0, last) for n in numbers]
        self.degrees = [
            integer(n, f"a degree of {what}", -_LARGEST_DEGREE, _LARGEST_DEGREE)
            for n in items(field(data, "degrees", what), count, what)
        ]
        self.positions = self._positions(field(data, "positions", what), what)
        if {*self.constraints, *self.positions} != {*range(last + 1)}:
            raise CheckError(f"{what} do not say how each relation is kept")
        self.definitions: list[tuple[str, str]] = []
        for pair in [
            *as_list(system["definitions"], what),
            *as_list(field(data, "definitions", what), what),
        ]:
            word, formula = items(pair, 2, f"a definition of {what}")
            self.definitions.append((text(word, what), _formula(formula)))
        self.opaque = set(_names_in_field(data, "opaque"))

    def _positions(self, data: object, what: str) -> dict[int, int | None]:
        """Relations, each with the index of the constraint that is its rate, if any."""
        last = len(self.relations) - 1
        found: dict[int, int | None] = {}
        for pair in as_list(data, what):
            relation, rate = items(pair, 2, what)
            number = integer(relation, f"a relation of {what}", 0, last)
            found[number] = None if rate is None else integer(rate, f"a rate of {what}", 0, last)
        return found

    def power(self) -> dict[str, object]:
        """Claim F' = uᵀ(A a − h), C u = κ f, f' = C a − b."""
        a, u = self.accelerations, self.velocities
        terms = [
            f"({velocity})*({_sum_of_products(row, a)} - ({force}))"
            for velocity, row, force in zip(u, self.mass, self.force, strict=True)
        ]
        values = [f"Rate({self.value}) - ({' + '.join(terms) or '0'})"]
        constraints = zip(self.slopes, self.degrees, self.drift, self.constraints, strict=True)
        for row, degree, drift, number in constraints:
            f = self.relations[number]
            values.append(f"{_sum_of_products(row, u)} - ({degree})*({f})")
            values.append(f"Rate({f}) - ({_sum_of_products(row, a)}) + ({drift})")
        for number, rate in self.positions.items():
            kept = "0" if rate is None else self.relations[rate]
            values.append(f"Rate({self.relations[number]}) - ({kept})")
        own = dict(zip(self.claim.system.state, map(str, self._list("rates")), strict=True))
        moving = {**own, **dict(zip(u, a, strict=True))}
        names = {
            *moving,
            *a,
            *self.claim.system.parameters,
            *(word for word, _ in self.definitions),
        }
        # Free symbols are state variables with rate zero, so that they need no domain of their
        # own.
        still = [*a, *self._free(values, self.definitions, names)]
        return self._identity(
            "power",
            {**moving, **dict.fromkeys(still, "0")},
            self.definitions,
            values,
            [str(f) for f in self._list("guards")],
        )

    def solution(self) -> dict[str, object]:
        """Claim A u̇ = h + Cᵀλ and C u̇ = b, with opaque names as independent variables."""
        rates = dict(zip(self.claim.system.state, map(str, self._list("rates")), strict=True))
        own = [rates[velocity] for velocity in self.velocities]
        values = []
        for i, (row, force) in enumerate(zip(self.mass, self.force, strict=True)):
            reaction = _sum_of_products(self.multipliers, [slopes[i] for slopes in self.slopes])
            values.append(f"{_sum_of_products(row, own)} - ({force}) - ({reaction})")
        for row, drift in zip(self.slopes, self.drift, strict=True):
            values.append(f"{_sum_of_products(row, own)} - ({drift})")
        definitions = self._definitions_below(values)
        names = {*self.claim.system.parameters, *(word for word, _ in definitions)}
        free = self._free(values, definitions, names) or list(self.velocities[:1])
        return self._identity("solution", dict.fromkeys(free, "0"), definitions, values, [])

    def _list(self, key: str) -> Sequence[object]:
        return as_list(self.system.get(key, []), "the equations of the rates")

    def _definitions_below(self, values: Texts) -> list[tuple[str, str]]:
        """Definitions on which formulas depend, without the opaque names."""
        wanted = names_in(parse(value, "a formula") for value in values)
        chosen = []
        for word, formula in reversed(self.definitions):
            if word in wanted and word not in self.opaque:
                chosen.append((word, formula))
                wanted |= names_in([parse(formula, "a definition")])
        return chosen[::-1]

    @staticmethod
    def _free(values: Texts, definitions: Iterable[tuple[str, str]], names: set[str]) -> list[str]:
        """Names without a definition; the identity holds for any value of them."""
        texts = [*values, *(formula for _, formula in definitions)]
        return sorted(names_in(parse(t, "a formula") for t in texts) - names - {*CONSTANTS})

    def _identity(
        self,
        word: str,
        rates: Mapping[str, str],
        definitions: Iterable[tuple[str, str]],
        values: Texts,
        guards: Texts,
    ) -> dict[str, object]:
        return {
            "system": {
                "name": word,
                "state": list(rates),
                "rates": list(rates.values()),
                "definitions": [list(pair) for pair in definitions],
                "parameters": list(self.claim.system.parameters),
                "relations": [],
                "guards": list(guards),
                "admissible": list(self._list("admissible")),
            },
            "law": {
                "kind": "Identity",
                "name": word,
                "on": [],
                "quantities": [],
                "value": list(values),
            },
        }


def _formula(data: object) -> str:
    """Text of a formula, which must be possible to parse."""
    words = text(data, "a formula of the equations of the rates")
    parse(words, "a formula of the equations of the rates")
    return words


def _formulas(data: object, size: int | None = None) -> list[str]:
    what = "a row of the equations of the rates"
    return [_formula(f) for f in (as_list(data, what) if size is None else items(data, size, what))]


def _names_in_field(data: Mapping[str, object], key: str) -> list[str]:
    what = "the equations of the rates"
    return [text(word, f"the {key} of {what}") for word in as_list(field(data, key, what), what)]


def _sum_of_products(left: Texts, right: Texts) -> str:
    return " + ".join(f"({x})*({y})" for x, y in zip(left, right, strict=True)) or "0"
