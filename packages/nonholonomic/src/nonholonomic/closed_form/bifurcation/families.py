"""Planes of two integrals, with the curve of genus two over each point.

Most planes come from a `SeparatedSystem`.  The Chaplygin ball with arbitrary area constant has
three integrals, of which the plane shows two.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction

import sympy as sp

from flowlanes.arguments import NumberOrText
from flowlanes.errors import InputError
from flowlanes.formulas.balls import exact
from flowlanes.system.named_formulas import scalars
from flowlanes.system.parameters import require_parameters
from flowlanes.system.system import System
from flowlanes.system.vectors import dot, norm_squared, real_symbol, vectors

from ...catalogue import from_catalogue
from ...catalogue.chaplygin_ball.chaplygin_bracket import D, I
from ..genus_two.separation import SeparatedSystem
from ..separations import ball_sphere, rubber_sphere
from ..separations.bruns import rubber_ball_in_bruns_field, veselova_in_bruns_field
from ..separations.bruns_ball import chaplygin_ball_in_bruns_field
from ..separations.bruns_sphere import hollow_ball_in_bruns_field
from ..separations.chaplygin_ball import chaplygin_ball
from ..separations.clebsch import clebsch_case
from ..separations.fedorov import fedorov
from ..separations.neumann import neumann_system
from ..separations.rubber_ball_plane import rubber_ball_plane
from ..separations.veselova import veselova

#: The variable of the curve.
Z = real_symbol("z")
M, gamma, omega = vectors("M gamma omega")

#: Description of a motion with ν_i = 0, where {} stands for the index i.
UNSAID = "motion in the plane ν_{} = 0"
ROTATION = "permanent rotation about axis {}"
PENDULUM = "turning or swinging about axis {} alone"
GREAT_CIRCLE = "motion on the great circle Γ_{} = 0"
RESTING: Mapping[str, str] = {
    "veselova": ROTATION,
    "veselova-bruns": PENDULUM,
    "chaplygin-ball": ROTATION,
    "chaplygin-ball-bruns": PENDULUM,
    "rubber-chaplygin-ball": ROTATION,
    "rubber-chaplygin-ball-bruns": PENDULUM,
    "rubber-ball-on-plane": ROTATION,
    "rubber-ball-of-ratio": ROTATION,
    "rubber-ball-around-sphere": ROTATION,
    "ball-around-sphere": ROTATION,
    "ball-around-sphere-zero-area": ROTATION,
    "ball-around-sphere-bruns": PENDULUM,
    "neumann": GREAT_CIRCLE,
    "clebsch": GREAT_CIRCLE,
}


@dataclass(frozen=True)
class Axis:
    """One axis of a diagram.

    Attributes
    ----------
    symbol : sympy.Symbol
    value : sympy expression
        The integral, in state, definitions and parameters of the system.
    meaning, unit : str
        The meaning in words and the SI unit; empty if the system has none.
    """

    symbol: sp.Symbol
    value: sp.Expr
    meaning: str = ""
    unit: str = ""


@dataclass(frozen=True)
class Bound:
    """A formula that is positive on the level of every motion except those described by `words`.

    It vanishes on these; they are periodic and surrounded by tori.
    """

    formula: sp.Expr
    words: str


@dataclass(frozen=True, kw_only=True)
class IntegralPlane:
    """A plane of integrals, and its curves y² = ∏(z − e_i) · cofactor(z).

    Attributes
    ----------
    level : tuple of sympy.Expr
        Expressions that vanish on the level on which the curve is valid.
    axes : (Axis, Axis)
    poles : three formulas
        e_i, in parameters; the i-th belongs to the body axis i.
    cofactor : formula
        In parameters, the symbols of the axes and :data:`Z`.
    fixed_parameters : pairs of Symbol to float
        Constants of the motion that are fixed in the plane, with their default values.
    resting : str
        A description of a motion with νᵢ = 0, with a placeholder for the number of the axis.
    """

    name: str
    title: str
    system: System
    level: tuple[sp.Expr, ...] = ()
    axes: tuple[Axis, Axis]
    poles: tuple[sp.Expr, sp.Expr, sp.Expr]
    cofactor: sp.Expr
    bounds: tuple[Bound, ...] = ()
    fixed_parameters: tuple[tuple[sp.Symbol, float], ...] = ()
    resting: str = UNSAID


def plane_of(separable: SeparatedSystem) -> IntegralPlane:
    """The plane of the two constants of a separated system.

    Raises
    ------
    InputError
        If it has another number of constants.
    """
    known = {symbol for symbol, _ in separable.constants} | set(separable.system.defaults)
    # Some constants only abbreviate combinations of others.
    abbreviations = [(s, value) for s, value in separable.constants if _symbols(value) <= known]
    own = [pair for pair in separable.constants if pair not in abbreviations]
    if len(own) != 2:
        raise InputError(
            f"{separable.name}: a diagram needs two constants of the motion, and this separation "
            f"has {len(own)}"
        )
    (x, first), (y, second) = own
    movable = sp.Mul(*(Z - root for root in separable.roots[3:]))
    return IntegralPlane(
        name=separable.name,
        title=separable.title,
        system=separable.system,
        level=separable.level,
        axes=(_axis(x, first, separable.system), _axis(y, second, separable.system)),
        poles=separable.poles,
        cofactor=(separable.leading * movable).subs(abbreviations[::-1]),
        resting=RESTING.get(separable.name, UNSAID),
    )


def _axis(symbol: sp.Symbol, value: sp.Expr, system: System) -> Axis:
    """An axis with the meaning that the system states for this integral."""
    steps = dict(system.scalar_definitions)
    (wanted,) = scalars(value)
    for law in system.scalar.integrals:
        if sp.expand(steps.get(law.value, law.value) - wanted) == 0:
            return Axis(symbol, value, law.meaning, law.unit)
    return Axis(symbol, value)


def _symbols(formula: sp.Expr) -> set[sp.Symbol]:
    return {s for part in scalars(formula) for s in part.free_symbols}


def chaplygin_ball_with_area() -> IntegralPlane:
    """The Chaplygin ball with any area constant g = (M, γ), at a fixed f = M².

    With J = I + D and 1/κ a root x of Q(x) = (2hx − f)(x − D) − Dg² the ball moves as one with
    x in place of D, the same J and zero area constant (Chaplygin 1903).  The other root of Q takes
    the place of f/2h, so that in z = w + x the curve is y² = z Q(z) ∏(J_i − z), in which h, f and
    g² are polynomial and neither root is preferred.  f = g² where M is vertical.
    """
    h, f, g = real_symbol("h"), real_symbol("f"), real_symbol("g")
    ball = from_catalogue("chaplygin-ball")
    poles = tuple(s + D for s in I.symbols)
    return IntegralPlane(
        name="chaplygin-ball-area",
        title="Chaplygin ball with any area constant",
        system=ball,
        level=(f - norm_squared(M),),
        axes=(_axis(h, dot(M, omega) / 2, ball), _axis(g, dot(M, gamma), ball)),
        poles=(poles[0], poles[1], poles[2]),
        cofactor=-4 * Z * ((2 * h * Z - f) * (Z - D) - D * g**2),
        bounds=(Bound(f - g**2, "motion with the momentum M vertical"),),
        fixed_parameters=((f, 1.0),),
        resting=ROTATION,
    )


def bruns_problem() -> IntegralPlane:
    """The Clebsch case with α = 0 and β = 1, on its plane of the two integrals."""
    plane = plane_of(clebsch_case())
    system = from_catalogue("clebsch", alpha=0.0, beta=1.0)
    return replace(plane, name="bruns", title="Bruns problem at zero area constant", system=system)


SEPARATIONS: Mapping[str, Callable[[], SeparatedSystem]] = {
    "veselova": veselova,
    "veselova-bruns": veselova_in_bruns_field,
    "chaplygin-ball": chaplygin_ball,
    "chaplygin-ball-bruns": chaplygin_ball_in_bruns_field,
    "chaplygin-ball-fedorov": fedorov,
    "rubber-chaplygin-ball": rubber_ball_plane,
    "rubber-chaplygin-ball-bruns": rubber_ball_in_bruns_field,
    "rubber-ball-on-plane": rubber_sphere.on_plane,
    "rubber-ball-of-ratio": rubber_sphere.of_ratio,
    "rubber-ball-around-sphere": rubber_sphere.hollow_ball,
    "ball-around-sphere": ball_sphere.hollow_ball,
    "ball-around-sphere-zero-area": ball_sphere.of_tensor,
    "ball-around-sphere-bruns": hollow_ball_in_bruns_field,
    "neumann": neumann_system,
    "clebsch": clebsch_case,
}
"""Separated systems of two constants, by their names."""

PLANES: Mapping[str, Callable[[], IntegralPlane]] = {
    "chaplygin-ball-area": chaplygin_ball_with_area,
    "bruns": bruns_problem,
}
"""Further planes."""


def plane_named(name: str) -> IntegralPlane:
    """The plane with a given name.

    Raises
    ------
    InputError
        If there is none; the sentence lists the names.
    """
    if name in SEPARATIONS:
        return plane_of(SEPARATIONS[name]())
    if name in PLANES:
        return PLANES[name]()
    known = ", ".join(sorted((*SEPARATIONS, *PLANES)))
    raise InputError(f"no bifurcation diagram {name!r}; there are {known}")


def numbers(
    plane: IntegralPlane, replacements: Mapping[sp.Symbol | str, NumberOrText]
) -> dict[sp.Symbol, Fraction]:
    """All parameters and fixed constants, defaults replaced by given values; exact.

    Raises
    ------
    InputError
        If a name is unknown, a value is no number, or a held constant is not positive.
    """
    known = {str(s): (s, value) for s, value in plane.system.defaults.items()}
    known |= {str(s): (s, value) for s, value in plane.fixed_parameters}
    values = dict(known.values())
    require_parameters(plane.name, known, replacements)
    for name, value in replacements.items():
        values[known[str(name)][0]] = value
    try:
        exact_values = {symbol: exact(value) for symbol, value in values.items()}
    except (ValueError, ZeroDivisionError) as problem:
        raise InputError(
            f"{plane.name}: the parameters must be numbers, decimal or rational"
        ) from problem
    for symbol, _ in plane.fixed_parameters:
        if exact_values[symbol] <= 0:
            raise InputError(
                f"{plane.name}: {symbol} = {exact_values[symbol]}: it must be positive"
            )
    return exact_values
