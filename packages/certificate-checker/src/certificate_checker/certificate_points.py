"""Checks of the points in certificates: counterexamples and sample points.

Coordinates are rational numbers, roots of triangular polynomials that change sign, or values of
formulas.  Equations between them are decided exactly (see :mod:`.exact_values`), inequalities with
balls.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from functools import cached_property

from flint import arb, ctx, fmpq

from .claim.claim import Claim, ClaimedSystem
from .claim.domain import domain
from .claim.errors import CheckError, UndefinedError
from .claim.evaluate import Point
from .claim.formulas import CONSTANTS, Formula, names_in, number
from .claim.json_data import as_list, field, integer, mapping, only, rational, text
from .claim.parsing import parse
from .claim.polynomials import Poly, Ring
from .claim.real_functions import RealFunctions, ball
from .claim.residuals import each_residual, is_on_rank, rank_at_least, residuals, target_point
from .exact_values import ExactValues
from .identities.proof import Condition

PRECISION = 1200
#: Number of bisections until a polynomial is monotone on the interval.
BISECTIONS = 300
#: Number of Newton steps, each of which nearly doubles the number of digits.
NEWTON_STEPS = 60

_DECIMAL = re.compile(r"-?\d{1,2000}(\.\d{1,2000})?([eE][+-]?\d{1,4})?")


def check_witness(claim: Claim, data: object) -> None:
    """Check a refutation: at a point of the level a residual is certainly nonzero."""
    what = "the witness"
    data = mapping(data, what)
    only(data, what, "point", "what", "index", "residual", "functions")
    with ctx.workprec(PRECISION):
        point = _StatedPoint(claim, field(data, "point", what))
        point.check()
        values = residuals(claim, point.evaluate)
        index = integer(field(data, "index", what), f"the index of {what}", 0, len(values) - 1)
        if values[index].contains(0):
            raise CheckError("the residual at the witness is not certainly different from zero")
        stated = field(data, "residual", what)
        if not _stated_number(stated).overlaps(values[index]):
            raise CheckError(f"the residual at the witness is not {stated}")


def point_of_level(claim: Claim, data: object) -> Point:
    """Evaluation at a point on the level in the domain of the law; otherwise CheckError."""
    with ctx.workprec(PRECISION):
        point = _StatedPoint(claim, data)
        point.check()
        return point.evaluate


def failing(claim: Claim, data: object) -> tuple[int, str]:
    """Index and value of the first residual that is certainly nonzero at a point of the level.

    Raises
    ------
    CheckError
        If there is no such residual, or the point does not lie on the level.
    """
    with ctx.workprec(PRECISION):
        point = _StatedPoint(claim, data)
        point.check()
        for index, value in enumerate(each_residual(claim, point.evaluate)):
            if not value.contains(0):
                return index, str(value.str(30))
    raise CheckError("every residual may be zero at the point")


def check_sample(claim: Claim, data: object, conditions: Sequence[Condition]) -> None:
    """Check that the law is defined, and has the stated rank, at a point of its level."""
    with ctx.workprec(PRECISION):
        point = _StatedPoint(claim, data)
        point.check()
        for condition in conditions:
            value = point.evaluate(condition.formula)
            if not (value > 0 if condition.positive else value != 0):
                raise CheckError(f"the sample does not satisfy {condition.text}")
        residuals(claim, point.evaluate)
        if is_on_rank(claim) and not rank_at_least(claim, point.evaluate):
            raise CheckError("at the sample the rank is not the stated one")


def _stated_number(data: object) -> arb:
    """Number from text: a fraction, a decimal, or a ball such as ``[1.5 +/- 1e-20]``."""
    words = text(data, "the residual at the witness")
    try:
        return ball(rational(words, "the residual"))
    except CheckError:
        pass
    try:
        return arb(words)
    except ValueError:
        raise CheckError(f"the residual at the witness, {words!r}, is not a number") from None


def _decimal(data: object, what: str) -> Fraction:
    words = text(data, what)
    if _DECIMAL.fullmatch(words) is None:
        raise CheckError(f"{what} is not a decimal number")
    return Fraction(words)


class _StatedPoint:
    """Values of state and parameters, exact where possible."""

    def __init__(self, claim: Claim, data: object) -> None:
        self.claim = claim
        self.system = claim.system
        # Each point has its own random values of unspecified functions, because with some values a
        # root would not exist.
        self.functions = RealFunctions(json.dumps(data, sort_keys=True))
        self.balls: dict[str, arb] = {}
        self.rationals: dict[str, Fraction] = {}
        self.chain: list[tuple[str, dict[tuple[int, ...], fmpq]]] = []
        self._formulas: dict[str, Formula] = {}
        self._zeros = tuple(c for c in claim.conditions if c.kind == "function")
        zeros = [c for c in claim.conditions if c.kind == "function"]
        for word, value in mapping(data, "the point").items():
            if word not in self.system.symbols:
                raise CheckError(f"the point gives {word}, which is neither state nor parameter")
            self._set_vanishing_functions(zeros)
            self._read(word, value)
        for word in self.system.symbols:
            if word not in self.balls:
                raise CheckError(f"the point does not give {word}")
        self._set_vanishing_functions(zeros)
        settled = {word: number(value) for word, value in self.rationals.items()}
        self.evaluate = self.system.point(self.balls, self.functions, settled)

    def _partial_point(self) -> Point:
        settled = {word: number(value) for word, value in self.rationals.items()}
        return Point(self.balls, self.system.definitions, {}, self.functions, settled)

    def _set_vanishing_functions(self, zeros: list[Formula]) -> None:
        """Set the values of unspecified functions that are zero by a condition."""
        for zero in list(zeros):
            if self.system.reach(zero.parts) <= {*self.balls, *self.system.definitions}:
                partial = self._partial_point()
                word, orders = zero.word
                self.functions.settle(word, orders, [partial(p) for p in zero.parts], arb(0))
                zeros.remove(zero)

    def _read(self, word: str, data: object) -> None:
        what = f"the value of {word}"
        if not isinstance(data, Mapping):
            self.rationals[word] = rational(data, what)
            self.balls[word] = ball(self.rationals[word])
            return
        only(data, what, "root", "formula")
        if set(data) == {"formula"}:
            formula = parse(data["formula"], what)
            if not names_in([formula]) <= {*self.balls, *self.system.definitions, *CONSTANTS}:
                raise CheckError(f"{what} uses a symbol that is not known before it")
            self.balls[word] = self._partial_point()(formula)
            # A ball cannot show that an equation holds, so the formula is kept too.
            self._formulas[word] = formula
        elif set(data) == {"root"}:
            self._read_root(word, mapping(data["root"], what), what)
        else:
            raise CheckError(f"{what} is neither a number, a root nor a formula")

    def _read_root(self, word: str, data: Mapping[str, object], what: str) -> None:
        only(data, what, "poly", "near", "radius")
        stated = mapping(field(data, "poly", what), what)
        only(stated, what, "ring", "terms")
        names = [text(n, what) for n in as_list(field(stated, "ring", what), what)]
        if word not in names or not set(names) <= {*self.balls, word}:
            raise CheckError(
                f"{what} is a root of a polynomial in a symbol that is not known before it"
            )
        if len(set(names)) < len(names):
            raise CheckError(f"{what} has a generator twice")
        small = Ring(names)
        poly = small.read(field(stated, "terms", what), what)
        middle = _decimal(field(data, "near", what), what)
        radius = _decimal(field(data, "radius", what), what)
        if radius <= 0:
            raise CheckError(f"{what} has a radius that is not positive")
        self.balls[word] = _root(poly, small, word, self.balls, middle, radius, what)
        # The polynomial is rewritten over all symbols of the system for the exact arithmetic.
        table = {n: self.system.symbols.index(n) for n in names}
        terms: dict[tuple[int, ...], fmpq] = {}
        for exponents, coefficient in poly.to_dict().items():
            spread = [0] * len(self.system.symbols)
            for name, exponent in zip(names, exponents, strict=True):
                spread[table[name]] = int(exponent)
            terms[tuple(spread)] = coefficient
        self.chain.append((word, terms))

    # --- what must hold ------------------------------------------------------------------------

    def check(self) -> None:
        """Check that the point lies on the level and in the domain of the system and the law."""
        for condition in self.claim.conditions:
            if not self._vanishes(condition):
                raise CheckError("the point does not satisfy a condition of the level")
        for formula, sign in self.system.admissible:
            if not self._admissible(formula, sign):
                raise CheckError("the parameters of the point are not admissible")
        for options in self.system.either:
            if not any(all(self._admissible(*part) for part in option) for option in options):
                raise CheckError("the parameters of the point are not admissible")
        for guard in self.system.guards:
            if not self.evaluate(guard) > 0:
                raise CheckError("a guard is not positive at the point")
        settled = {word: number(value) for word, value in self.rationals.items()}
        try:
            domain(self.claim, settled).require(self.evaluate)
        except UndefinedError:
            raise CheckError("the law is not certainly defined at the point") from None
        if self.claim.law.target is not None:
            self._check_target(self.claim.law.target)

    def _check_target(self, target: ClaimedSystem) -> None:
        """Check that the parameters of the target are admissible at the point."""
        there = target_point(self.claim, self.evaluate)

        def holds(formula: Formula, sign: str) -> bool:
            exact = there.exact(formula)
            value = there(formula) if exact is None else exact
            known = {">": value > 0, ">=": value >= 0, "!=": value != 0}
            return bool(known.get(sign, exact == 0))

        for options in ((target.admissible,), *target.either):
            if not any(all(holds(*part) for part in option) for option in options):
                raise CheckError("the parameters of the target are not admissible at the point")

    def _admissible(self, formula: Formula, sign: str) -> bool:
        value = self.evaluate(formula)
        if sign == ">":
            return bool(value > 0)
        if sign == "!=":
            return bool(value != 0)
        return bool(sign == ">=" and value >= 0) or self._vanishes(formula)

    @cached_property
    def _exact(self) -> ExactValues:
        formulas = {**self.system.definitions, **self._formulas}
        return ExactValues(
            self.system.symbols,
            self.rationals,
            self.chain,
            formulas,
            self.evaluate,
            self.balls,
            self._zeros,
        )

    def _vanishes(self, formula: Formula) -> bool:
        """True if a formula is exactly zero at the point."""
        try:
            return self._exact.vanishes(formula)
        except UndefinedError:
            return False


def _root(
    poly: Poly,
    ring: Ring,
    word: str,
    balls: Mapping[str, arb],
    middle: Fraction,
    radius: Fraction,
    what: str,
) -> arb:
    """Ball around the root in an interval at the ends of which a polynomial has opposite signs."""

    def value(at: arb, of: Poly = poly) -> arb:
        values = [at if n == word else balls[n] for n in ring.names]
        result: arb = ring.value(of, values, RealFunctions(""))
        return result

    def sign(at: Fraction) -> int:
        here = value(ball(at))
        return 1 if here > 0 else -1 if here < 0 else 0

    low, high = middle - radius, middle + radius
    left, right = sign(low), sign(high)
    # Opposite signs guarantee a root.  Bisection makes the interval so short that the polynomial
    # is monotone on it; then there is one root, and Newton's method converges.
    if left * right >= 0:
        raise CheckError(f"{what} is no certain root in the interval given")
    slope = poly.derivative(ring.index[word])
    while high - low > radius / 2**BISECTIONS:
        here = ball(low).union(ball(high))
        if value(here, slope) != 0:
            return _newton_narrowed(here, value, lambda at: value(at, slope))
        # The midpoint may itself be a root and has no sign then, so two other points are tried.
        points = [low + (high - low) * Fraction(share, 8) for share in (4, 3, 5)]
        inside = next(((at, side) for at in points if (side := sign(at))), None)
        if inside is None:
            break
        low, high = (inside[0], high) if inside[1] == left else (low, inside[0])
    return ball(low).union(ball(high))


def _newton_narrowed(here: arb, value: Callable[[arb], arb], slope: Callable[[arb], arb]) -> arb:
    """Ball with one root, narrowed by the interval Newton method, in which the root stays."""
    # The intersection of two balls is rounded outwards, so only its width is checked.
    for _ in range(NEWTON_STEPS):
        middle = here.mid()
        after = here.intersection(middle - value(middle) / slope(here))
        if not after.rad() < here.rad() / 2:
            break
        here = after
    return here
