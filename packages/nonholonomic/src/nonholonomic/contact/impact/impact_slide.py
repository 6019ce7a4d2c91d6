"""Sliding that turns during an impact, up to the next event.

The direction of a slip s n turns ever faster as s tends to zero, but not in the logarithmic time θ
with dP = s dθ: n′ = G n⊥ and s′ = H s, where the rate of the sliding velocity is β − F A n = H n +
G n⊥ with the friction F = μ + ν sᵖ per unit of normal force.
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Literal

import numpy as np
import sympy as sp

from flowlanes.errors import RunError
from flowlanes.flow.taylor.compiled_system import StateSeries, compile_system
from flowlanes.system.arrays import FloatArray
from flowlanes.system.system import Guard, Parameter, System
from flowlanes.system.tolerance import FINEST_TOLERANCE
from flowlanes.system.vectors import real_symbol

from ..friction.symbols import slip_speed

#: Factor by which the speed of a slide may decrease before its equations are rescaled.
LEAST = float(np.exp(-8.0))

#: The same for a slide that accelerates.
MOST = 1 / LEAST

#: Restitution below this fraction of the work of the slide counts as zero.
LEAST_RETURN = 1e-18

#: Maximum duration of a slide in θ, and maximum number of steps.
_LONGEST, _STEPS = 1e9, 2000

SlideEvent = Literal["compressed", "approaching again", "returned", "spin stopped", "spin starts"]

#: Outcome of each event of the compiled equations, in their order.
_EVENTS: tuple[SlideEvent | None, ...] = (
    "compressed",
    "approaching again",
    "returned",
    "spin stopped",
    "spin starts",
    "spin starts",
    None,
    None,
)

_PARAMETERS = 26


@dataclass(frozen=True)
class SlidingFriction:
    """Friction per unit of normal force while a contact slides: F(s) + ν sᵖ at the speed s.

    Attributes
    ----------
    mu : float
        μ, the limit of F(s) at rest; it may be infinite.
    viscous : float
        ν ((s/m)^p).
    order : float
        p.
    force : sympy.Expr or None
        F as a formula in the slip speed; None: it is μ at every speed.
    """

    mu: float
    viscous: float = 0.0
    order: float = 1.0
    force: sp.Expr | None = None

    @property
    def varies(self) -> bool:
        """Whether friction depends on the speed."""
        return bool(self.viscous) or self.force is not None

    @cached_property
    def _force(self) -> Callable[[float], float]:
        function: Callable[[float], float] = sp.lambdify(slip_speed, self.force, "numpy")
        return function

    def at(self, speed: float) -> float:
        """Friction at a speed (m/s)."""
        dry = self.mu if self.force is None else float(self._force(speed))
        return dry + (self.viscous * speed**self.order if self.viscous else 0.0)


@dataclass(frozen=True, eq=False)
class Linear:
    """A quantity c₀ + c P + (d, f) of the impulses P (normal) and f (friction) of a slide.

    Attributes
    ----------
    constant, normal : float
    friction : (2,) array
    """

    constant: float
    normal: float
    friction: FloatArray

    def times(self, factor: float) -> Linear:
        """The quantity multiplied by a factor."""
        return Linear(factor * self.constant, factor * self.normal, factor * self.friction)

    def at(self, impulse: float, friction: FloatArray) -> float:
        """The value at given impulses."""
        return self.constant + self.normal * impulse + float(self.friction @ friction)


@dataclass(frozen=True, eq=False)
class Slide:
    """The outcome of a phase of sliding.

    Attributes
    ----------
    event : str
        The event that ends it; None if its speed has become small or large, or after many steps.
    direction : (2,) array
    speed : float
    clock : float
        ∫ s dθ, the normal impulse where friction is finite.
    friction : (2,) array
        Impulse of friction.
    work : float
        ∫ u_n d(clock).
    """

    event: SlideEvent | None
    direction: FloatArray
    speed: float
    clock: float
    friction: FloatArray
    work: float


@dataclass(frozen=True, eq=False)
class Ends:
    """Conditions that end a phase of sliding before the slip vanishes.

    Attributes
    ----------
    compressing : bool
        Whether the normal velocity ends a phase by becoming positive, or by becoming negative.
    work, clock, normal, offset : float
        Restitution ends where work·W + clock·P + normal·u_n + offset becomes positive.
    spin : Linear or None
        The spin times its sign, if it ends by becoming negative.
    couple : (3,) array or None
        Constant and slope along the direction of the couple that holds the spin, in units of the
        greatest one.
    """

    compressing: bool
    work: float
    clock: float
    normal: float
    offset: float
    spin: Linear | None
    couple: FloatArray | None


def slide_integrator(friction: SlidingFriction) -> StateSeries:
    """Compiled equations of a slide for use by `slide`; each thread has its own copy.

    Parameters
    ----------
    friction : SlidingFriction
    """
    return _integrator_of_thread(friction.varies, friction.force, threading.get_ident())


@lru_cache(maxsize=64)
def _integrator_of_thread(varies: bool, force: sp.Expr | None, _: int) -> StateSeries:
    return _integrator(varies, force).copy()


def slide(
    integrator: StateSeries,
    beta: FloatArray,
    A: FloatArray,
    friction: SlidingFriction,
    slip: FloatArray,
    normal: Linear,
    ends: Ends,
) -> Slide:
    """Slide with the rate β − F A n of the slip s n, up to the first of its ends.

    The unknowns are (n, s, P, f, W): direction, speed, clock, friction impulse and work of the
    normal force, as functions of the logarithmic time θ with dP = s dθ (see the head of this
    module).  With the initial speed as unit of velocity and the largest rate |β| + F max|A| as
    unit of 1/θ all numbers are of order one, and the right-hand sides are analytic while s > 0,
    so that Taylor steps do not shrink as s → 0.  One call follows s over at most a factor of e⁸;
    the caller restarts with the new speed as unit.  The slide is called endless if it takes more
    than _STEPS steps, which happens near a direction with H = G = 0.

    Parameters
    ----------
    integrator : StateSeries
        As `slide_integrator` returns it.
    beta, A : (2,) and (2, 2) array
    friction : SlidingFriction
        Friction per unit of the clock.
    slip : (2,) array
        The slip at the start.
    normal : Linear
        The normal velocity as a function of clock and friction impulse.
    ends : Ends

    Raises
    ------
    RunError
        If the slide does not end.
    """
    speed = float(np.hypot(*slip))
    mu = friction.at(speed)
    # Scale θ by the largest rate and velocities by the initial speed: all numbers are of order one.
    unit = float(np.hypot(*beta)) + mu * float(np.abs(A).max())
    clock, force = speed / unit, -mu * speed / unit
    scale = max(speed, abs(normal.constant))
    # layout: β (0–1), A (2–5), normal velocity (6–9), compression (10), end of restitution (11–14),
    # spin (15–18), couple that holds the spin (19–21), friction as a function of speed (22–25)
    pars = np.zeros(_PARAMETERS)
    pars[:6] = *(beta / unit), *(mu / unit * A.ravel())
    pars[6:10] = _coefficients(normal, clock, force, scale)
    pars[10] = float(ends.compressing)
    pars[11:15] = ends.work * clock * scale, ends.clock * clock, ends.normal * scale, ends.offset
    size = float(np.abs(pars[11:15]).max())
    pars[11:15] = pars[11:15] / size if size else (0, 0, 0, -1)
    if not ends.compressing and normal.constant == 0 and -LEAST_RETURN < pars[14] < 0:
        # The end is so near that rounding hides it: the restitution is zero.
        return Slide("returned", slip / speed, speed, 0.0, np.zeros(2), 0.0)
    pars[15] = 1.0
    if ends.spin is not None:
        size = max(abs(ends.spin.constant), abs(ends.spin.normal) * clock, 1e-300)
        pars[15:19] = _coefficients(ends.spin, clock, force, size)
    if ends.couple is not None:
        pars[19:22] = ends.couple
    # Relative contributions of μ (or the formula) and of the power law to the initial friction.
    power = friction.viscous * speed**friction.order if friction.viscous else 0.0
    pars[22:] = power / mu if mu else 0.0, friction.order, speed, 1 / mu if mu else 0.0
    integrator.reset()
    integrator.time = 0.0
    integrator.parameters[:_PARAMETERS] = pars
    integrator.parameters[_PARAMETERS:] = 1.0
    integrator.state[:] = [*(slip / speed), 1.0, 0.0, 0.0, 0.0, 0.0]
    event: SlideEvent | None = None
    # Near a direction in which the slip neither grows nor decays a slide lasts long.
    for _ in range(_STEPS):
        step = integrator.step(_LONGEST - integrator.time)
        if step.is_failure or integrator.time >= _LONGEST:
            raise RunError("the sliding of an impact does not end", 0.0)
        if step.event is not None:
            event = _EVENTS[step.event]
            break
    n1, n2, w, p, f1, f2, work = integrator.state.tolist()
    return Slide(
        event=event,
        direction=np.array([n1, n2]),
        speed=speed * w,
        clock=clock * p,
        friction=force * np.array([f1, f2]),
        work=clock * scale * work,
    )


def _coefficients(quantity: Linear, clock: float, force: float, scale: float) -> FloatArray:
    terms = quantity.constant, quantity.normal * clock, *(force * quantity.friction)
    return np.array(terms) / scale


@lru_cache(maxsize=64)
def _integrator(varies: bool, force: sp.Expr | None) -> StateSeries:
    return compile_system(_equations(varies, force), FINEST_TOLERANCE["double"]).series


def _equations(varies: bool, force: sp.Expr | None) -> System:
    """The equations of a slide, with its ends as guards."""
    n1, n2, w, p, f1, f2, work = names = [
        real_symbol(name) for name in ("n1", "n2", "w", "p", "f1", "f2", "work")
    ]
    q = [real_symbol(f"q{i}") for i in range(_PARAMETERS)]
    # Friction relative to its initial value, opposite to the direction n.
    dry = 1 - q[22] if force is None else q[25] * force.subs(slip_speed, q[24] * w)
    share = dry + q[22] * sp.exp(q[23] * sp.log(w)) if varies else sp.S.One
    f, g = share * n1, share * n2
    x = q[0] - q[2] * f - q[3] * g
    y = q[1] - q[4] * f - q[5] * g
    growth, turning = n1 * x + n2 * y, n1 * y - n2 * x
    normal = q[6] + q[7] * p + q[8] * f1 + q[9] * f2
    rates = (-turning * n2, turning * n1, growth * w, w, w * f, w * g, normal * w)
    rising = [
        q[10] * normal + q[10] - 1,
        -(1 - q[10]) * normal - q[10],
        q[11] * work + q[12] * p + q[13] * normal + q[14],
        -(q[15] + q[16] * p + q[17] * f1 + q[18] * f2),
        q[19] + q[20] * f + q[21] * g - 1,
        -(q[19] + q[20] * f + q[21] * g) - 1,
        sp.Rational(*LEAST.as_integer_ratio()) - w,
        w - sp.Rational(*MOST.as_integer_ratio()),
    ]
    return System(
        name="impact-slide",
        title="Sliding during an impact",
        field=tuple(zip(names, rates, strict=True)),
        parameters=tuple(Parameter(symbol, "coefficient", 0.0, "1") for symbol in q),
        guards=tuple(
            Guard(f"end {i}", -formula, "the slide ends") for i, formula in enumerate(rising)
        ),
    )
