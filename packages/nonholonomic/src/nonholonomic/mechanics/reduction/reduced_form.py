"""A generalised Chaplygin system in reduced form, and its description."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator
from dataclasses import dataclass

import sympy as sp

from flowlanes.printing.formula import text
from flowlanes.system.laws import Law
from flowlanes.system.overview import Overview, WithOverview
from flowlanes.system.system import System

from .base_coordinates import Base
from .closed_form import ClosedFormParts
from .gyroscopic_form import Flux
from .horizontal_lift import PointwiseForm
from .integrals import Linear
from .multiplier import Multiplier, Obstruction, poles

WIDTH = 100
MARGIN = 16
LONG = 30
BY_QUADRATURE = (
    "ln N = ∫(A₂ dq₁ − A₁ dq₂) by quadrature: the 1-form is closed, but N is no product of powers "
    "of the factors that the system brings along"
)
OPEN = (
    "undecided: A₂ dq₁ − A₁ dq₂ is closed at the points tried, but N is no product of powers of "
    "the factors that the system brings along"
)


@dataclass(frozen=True, repr=False)
class ChaplyginForm(WithOverview):
    """A mechanism as a generalised Chaplygin system, by Theorem 6.

    Attributes
    ----------
    original : System
        The equations of motion of the mechanism, with its linear integrals as laws.
    base : Base
        The two coordinates.
    integrals : tuple of (Expr, Linear)
        Value and integral of each linear integral on whose level the system is reduced.
    role : str
        The integral in place of the energy in L = E₂ − E₀.
    closed : ClosedFormParts
        Metric, S and the lift, in closed form.
    multiplier : Multiplier or None
        N up to a constant factor.
    obstruction : Obstruction or None
        A point at which d ln N = A₂ dq₁ − A₁ dq₂ is not closed: there is no multiplier.
    closed_form : bool
        Whether the 1-form is closed, exactly.  Without `multiplier`, N is the exponential of its
        integral, see :func:`nonholonomic.mechanics.reduction.numerical.log_multiplier`.
    singular : tuple of Expr
        Factors of N that vanish somewhere on the sphere, at the default parameters.
    flux : Flux or None
        The integral of S̄, if there is a multiplier.
    system : System
        (4.7), with the laws of Theorem 6 and the map to `original`.
    gyroscopic : Expr or None
        S̄ of (4.5), if there is a multiplier.
    lifted : System or None
        `system` with the additional coordinates of `original`, if there are any; it then has the
        map to `original`.
    hamiltonian : System or None
        `system` in the time τ and canonical variables, if S̄ is exact in closed form.
    local : PointwiseForm
        Evaluation of (4.4) at points.
    level : tuple of Expr
        Expressions in the parameters that vanish for the values of the mechanism and form a special
        case, in which a multiplier exists or differs. All systems here use these relations.

    Examples
    --------
    >>> import nonholonomic
    >>> import sympy as sp
    >>> x, y, z, xdot, ydot, zdot = sp.symbols("x y z xdot ydot zdot", real=True)
    >>> lagrangian, constraint = (xdot**2 + ydot**2 + zdot**2) / 2, zdot - y * xdot
    >>> particle = nonholonomic.Mechanism(
    ...     "particle", nonholonomic.coordinates(x, y, z), lagrangian, (constraint,)
    ... )
    >>> form = nonholonomic.chaplygin_form(particle)
    >>> form.closed_form, form.multiplier.value
    (True, 1/sqrt(y**2 + 1))
    """

    original: System
    base: Base
    integrals: tuple[tuple[sp.Expr, Linear], ...]
    role: str
    closed: ClosedFormParts
    multiplier: Multiplier | None
    obstruction: Obstruction | None
    closed_form: bool
    singular: tuple[sp.Expr, ...]
    flux: Flux | None
    system: System
    gyroscopic: sp.Expr | None
    lifted: System | None
    hamiltonian: System | None
    local: PointwiseForm
    level: tuple[sp.Expr, ...] = ()

    def claims(self) -> Iterator[tuple[System, Law]]:
        """All laws, as pairs of a system and a law."""
        for system in (self.original, self.system, self.lifted, self.hamiltonian):
            if system is not None:
                yield from ((system, law) for law in system.laws)

    def overview(self) -> Overview:
        """Coordinates, levels, multiplier, gyroscopic forces and what follows."""
        return Overview(self.system.title, tuple(_rows(self)))

    def __str__(self) -> str:
        return page(self)


def page(form: ChaplyginForm) -> str:
    """Coordinates, levels, multiplier and gyroscopic forces, 100 columns wide."""
    lines = [form.system.title]
    for head, words in _rows(form):
        lines += textwrap.wrap(
            words,
            WIDTH,
            initial_indent=f"  {head}".ljust(MARGIN),
            subsequent_indent=" " * MARGIN,
            break_long_words=False,
            break_on_hyphens=False,
        )
    return "\n".join(lines)


def _rows(form: ChaplyginForm) -> Iterator[tuple[str, str]]:
    names = ", ".join(map(text, form.base.coordinates))
    vector = form.base.normal
    yield "coordinates", names if vector is None else f"{names}, angles of {text(vector)}"
    velocities = ", ".join(map(text, form.base.motion.velocities))
    for constant, integral in form.integrals:
        momenta = f"{text(constant)} = {text(integral.in_momenta)}, M = ∂L/∂({velocities})"
        yield "level", momenta
    yield "energy", f"L = E₂ − E₀ from {form.role}"
    if form.level:
        yield "where", f"{', '.join(f'{text(f)} = 0' for f in form.level)}, a case of its own"
    if form.multiplier is None:
        yield from _refusal_rows(form)
        return
    yield "multiplier", f"N = {text(form.multiplier.value)}"
    for factor in poles(form.multiplier):
        yield "", f"not where {text(factor)} = 0, which is a case of its own"
    for factor in form.singular:
        yield "singular", f"where {text(factor)} = 0"
    yield "gyroscopic", f"S̄ = {text(form.gyroscopic)}"
    monopole = form.flux
    if monopole is not None and monopole.value is not None:
        yield "integral", f"∫S̄ = {text(monopole.value)}: {monopole.words}"
    elif monopole is not None:
        yield "integral", f"of S̄: {monopole.words}"
    if form.hamiltonian is not None:
        yield "canonical", "Hamiltonian in the time τ, dτ = N dt, with momenta on the whole base"
    elif monopole is not None and monopole.value == 0:
        yield (
            "canonical",
            "momenta exist on the whole sphere: S̄ = dw, as its integral is 0",
        )
    elif monopole is not None and monopole.value is not None:
        yield "canonical", "no momenta on the whole sphere, as the integral of S̄ is not zero"


def _refusal_rows(form: ChaplyginForm) -> Iterator[tuple[str, str]]:
    obstruction = form.obstruction
    if obstruction is None:
        yield "multiplier", BY_QUADRATURE if form.closed_form else OPEN
        return
    at = ", ".join(f"{name} = {value}" for name, value in obstruction.point.items())
    exact = str(obstruction.curl)
    value = exact if len(exact) < LONG else f"{float(sp.Rational(exact)):.6g} (a fraction exactly)"
    yield "multiplier", f"none: d(A₂ dq₁ − A₁ dq₂) is {value} dq₂ ∧ dq₁ at {at}"
    if obstruction.vanishing:
        yield (
            "",
            f"it vanishes where {' or '.join(f'{text(f)} = 0' for f in obstruction.vanishing)}",
        )
