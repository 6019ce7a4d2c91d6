"""Limit cycles on a torus, proven in ball arithmetic with bounds on their multipliers.

On a torus with angles α and β, where β increases, a motion satisfies dα/dβ = f(α, β). If f lies
between two bounds on a box, a motion in it lies between two lines. Polygons of such lines enclose
all motions that begin in an interval, and the integral of ∂f/∂α along them is the logarithm of the
derivative of the return map P over one turn of β. If P maps an interval into itself and P′ < 1
there, it has exactly one fixed point in it: an attracting limit cycle. If P maps the ends outwards
and P′ > 1, it has exactly one repelling limit cycle.
"""

from __future__ import annotations

import operator
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from flint import arb, ctx

from ..arguments import arguments_checked
from ..errors import InputError
from ..formulas.graph import Term, of_system, term_values, topological_order
from ..system.parameters import require_parameters
from ..system.system import System

#: Precision in bits; the polygons are much coarser.
_BITS = 64
#: Radius of the pieces into which a box is divided for evaluation.
_FINE = 0.02


@dataclass(frozen=True)
class Cycle:
    """The enclosure of the return map on an interval.

    Attributes
    ----------
    interval : pair of arb
        α at β = 0.
    image : pair of arb
        For an attracting cycle, a lower bound of P at the lower end and an upper bound at the
        upper end; for a repelling one, the opposite bounds; without full turns.
    multiplier : arb
        Contains P′ on the whole interval, and therefore the multiplier.
    kind : str
        ``"attracting"`` or ``"repelling"``, both *proven*; else ``"undecided"``.
    """

    interval: tuple[arb, arb]
    image: tuple[arb, arb]
    multiplier: arb
    kind: str


@dataclass(frozen=True)
class _Slope:
    """dα/dβ, its derivative with respect to α, and dβ/dt, on boxes."""

    terms: tuple[Term, Term, Term]
    nodes: list[Term]
    constants: list[arb]
    places: tuple[int, int]

    def __call__(self, alpha: arb, beta: arb) -> tuple[arb, arb, arb]:
        state = dict(zip(self.places, (alpha, beta), strict=True))

        def leaf(node: Term) -> arb:
            if node.number is not None:
                return arb(node.number.numerator) / node.number.denominator
            return state[node.args[0]] if node.kind == "state" else self.constants[node.args[0]]

        known = term_values(self.nodes, leaf, _OPERATIONS)
        slope, bend, clock = (known[id(term)] for term in self.terms)
        return slope, bend, clock


_OPERATIONS: Mapping[str, Callable[..., arb]] = {
    "recip": lambda x: 1 / x,
    **{name: getattr(operator, name) for name in ("neg", "add", "sub", "mul")},
    **{name: getattr(arb, name) for name in ("sqrt", "sin", "cos", "exp", "log")},
}


def _slope(
    system: System, parameters: Mapping[str, arb | str | float], angle: str, clock: str
) -> _Slope:
    names = [str(s) for s in system.symbols]
    if sorted(names) != sorted((angle, clock)):
        raise InputError(f"{system.name}: its state must be {angle} and {clock}, not {names}")
    known = {str(p.symbol): p.default for p in system.parameters}
    require_parameters(system.name, known, parameters)
    reader, rates = of_system(system)
    places = names.index(angle), names.index(clock)
    slope = rates[places[0]] / rates[places[1]]
    graph = reader.graph
    unit = {graph.state(i): graph.number(int(i == places[0])) for i in range(2)}
    terms = (slope, graph.directional_derivative([slope], unit)[0], rates[places[1]])
    nodes = topological_order(terms)
    for node in nodes:
        if node.operands and node.kind not in _OPERATIONS:
            raise InputError(f"{system.name}: {node.kind} is not known to ball arithmetic")
    constants = [
        _ball(name, parameters.get(name, repr(default))) for name, default in known.items()
    ]
    return _Slope(terms, nodes, constants, places)


def _ball(name: str, value: arb | str | float) -> arb:
    try:
        return arb(value)
    except (ValueError, TypeError):
        raise InputError(f"{name} = {value}: it must be a decimal number or a ball") from None


def _parts(whole: arb) -> list[arb]:
    """A cover of a ball by small ones, on which bounds are tighter."""
    count = int(float(whole.rad()) / _FINE) + 1
    half = whole.rad() / count
    return [whole.mid() + (2 * k + 1 - count) * half + arb(0, 1) * half for k in range(count)]


@arguments_checked
def enclose_limit_cycle(
    system: System,
    parameters: Mapping[str, Any],
    interval: tuple[Any, Any],
    turns: int,
    *,
    angle: str = "alpha",
    clock: str = "beta",
    steps: int = 4000,
    max_slope: float = 8.0,
) -> Cycle:
    """Prove the existence of a limit cycle through an interval, with bounds on its multiplier.

    Parameters
    ----------
    system : System
        A system whose state consists of the two angles, both 2π-periodic.
    parameters : mapping of str to str or arb
        Values that replace the defaults; a string is taken as an exact decimal number.
    interval : pair of str or arb
        α at β = 0, radians, lower end first.
    turns : int
        Full turns of α during one turn of β.
    angle, clock : str
        α and β.
    steps : int
        Number of sides of the polygons.
    max_slope : float
        Assumed bound of |dα/dβ|, which is verified on the boxes.

    Returns
    -------
    Cycle
        Attracting or repelling, with a ball that contains its multiplier; or undecided.

    Raises
    ------
    InputError
        If the state does not consist of the two angles, or a number cannot be parsed.
    ArithmeticError
        If β does not increase on some box, or the slope exceeds the assumed bound.

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> alpha, beta = sp.symbols("alpha beta", real=True)
    >>> rate = sp.Rational(1, 10) - sp.Rational(3, 10) * sp.sin(alpha)
    >>> flow = flowlanes.System("sines", "Sines", {alpha: rate, beta: 1})
    >>> cycle = flowlanes.orbits.enclose_limit_cycle(
    ...     flow, {}, ("0.2", "0.5"), 0, steps=300, max_slope=1.0
    ... )
    >>> cycle.kind
    'attracting'
    """
    with ctx.workprec(_BITS):
        slope = _slope(system, parameters, angle, clock)
        step = 2 * arb.pi() / steps
        reach = arb(0, 1) * (step * max_slope).upper()
        ends = [_ball("interval", x) for x in interval]
        outer, inner, growth = list(ends), list(ends), arb(0)
        for i in range(steps):
            # A motion that starts at an end of the polygon stays within `reach` of it during the
            # step, since its slope is less than `max_slope`; this is verified below on the same
            # boxes. `outer` bounds the motions from the two ends from outside, `inner` from
            # inside.
            beta = (step * i).union(step * (i + 1))
            low, high = outer[0] + reach, outer[1] + reach
            inside = inner[0] + reach, inner[1] + reach
            edges = [slope(alpha, beta) for alpha in (low, high, *inside)]
            slopes = [f for f, _, _ in edges]
            band = [slope(part, beta) for part in _parts(low.union(high))]
            bend = band[0][1]
            for _, other, _ in band[1:]:
                bend = bend.union(other)
            if not all(rate > 0 for _, _, rate in (*edges, *band)):
                raise ArithmeticError(f"{clock} does not grow all the way along these motions")
            if not all(abs(f) < max_slope for f, _, _ in (*edges, *band)):
                raise ArithmeticError("the slope on the torus exceeds its assumed bound")
            outer = [outer[0] + step * slopes[0].lower(), outer[1] + step * slopes[1].upper()]
            inner = [inner[0] + step * slopes[2].upper(), inner[1] + step * slopes[3].lower()]
            # ln P′ = ∫ ∂f/∂α dβ; the union over the band covers every motion in the interval.
            growth += step * bend
        whole_turns = 2 * turns * arb.pi()
        multiplier = growth.exp()
        inwards = [x - whole_turns for x in outer]
        outwards = [x - whole_turns for x in inner]
        first, last = ends
        if inwards[0] > first and inwards[1] < last and multiplier < 1:
            return Cycle((first, last), (inwards[0], inwards[1]), multiplier, "attracting")
        if outwards[0] < first and outwards[1] > last and multiplier > 1:
            return Cycle((first, last), (outwards[0], outwards[1]), multiplier, "repelling")
        return Cycle((first, last), (inwards[0], inwards[1]), multiplier, "undecided")
