"""A friction law given by formulas in slip speed, spin and normal force."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.arguments import FormulaParameters, Quantity, arguments_checked
from flowlanes.errors import InputError
from flowlanes.parsing import RESERVED_WORDS, parse
from flowlanes.system.system import Guard, Parameter
from flowlanes.system.vectors import Vector, norm_squared, real_symbol

from ...mechanics.formula_parameters import formula_parameters
from .friction_law import FrictionLaw, Reaction
from .modes import Mode
from .symbols import (
    N,
    friction,
    gamma,
    holding_couple,
    slip,
    slip_floor,
    slip_speed,
    spin,
    spin_sign,
)
from .viscous_friction import creep_guard

#: Names that formulas of force and couple may use; `spin` means |Ω| in them.
VARIABLES: Mapping[str, Mapping[str, sp.Symbol]] = {
    "force": {"slip_speed": slip_speed, "spin": spin, "normal_force": N},
    "couple": {"slip_speed": slip_speed, "spin": spin},
}

_static = real_symbol("mu_static")

#: Speeds (m/s), angular velocities (rad/s) and normal forces (N) at which a law is checked.
_TRIALS = np.geomspace(1e-6, 1e3, 19)


@arguments_checked
@dataclass(frozen=True)
class UserFriction(FrictionLaw):
    """Friction for each unit of normal force by formulas in slip speed, spin and normal force.

    Parameters
    ----------
    force : str or sympy.Expr
        Force against the slip for each unit of normal force, in ``slip_speed`` = |u| (m/s),
        ``spin`` = |Ω| (rad/s) and ``normal_force`` (N).  Its limit at zero slip is one number; it
        holds the contact, unless it is zero.
    couple : str or sympy.Expr
        Couple against the spin for each unit of normal force (m), in ``slip_speed`` and ``spin``.
        Its value at zero spin is the greatest couple that prevents spinning, and may not depend on
        the slip.
    mu_static : float, optional
        Coefficient of static friction, where it exceeds the limit of `force` at zero slip.
    parameters : mapping of str or Symbol to float
        Further names in the formulas, with their values.  The law has them with its coefficient of
        static friction, as parameters of its equations.

    Raises
    ------
    InputError
        If a formula is invalid, or negative at one of many values from 1e-6 to 1e3 of its
        variables, or its limit at rest is not one number.

    Examples
    --------
    Friction after Stribeck: more at rest than in motion.

    >>> from nonholonomic.contact.friction.user_friction import UserFriction
    >>> law = UserFriction(
    ...     "mu*(1 + 0.3*exp(-slip_speed/v))", mu_static=0.3, parameters={"mu": 0.2, "v": 0.1}
    ... )
    >>> law.description
    'friction mu*(1 + 3*exp(-slip_speed/v)/10), mu_static = 0.3'
    >>> round(law.kinetic_mu, 12), law.static_mu
    (0.26, 0.3)
    """

    force: Quantity
    couple: Quantity = sp.S.Zero
    mu_static: float | None = None
    parameters: FormulaParameters = ()

    kind = "user"
    depends_on_speed = True

    def __post_init__(self) -> None:
        named = _named(self.parameters)
        object.__setattr__(self, "parameters", named)
        own = {_name(p): p.symbol for p in named}
        for key, variables in VARIABLES.items():
            known = {**variables, **own}
            object.__setattr__(self, key, _formula(key, getattr(self, key), known))
            self._require_dissipation(key)
        kinetic = self.kinetic_mu
        self._spin_limit  # noqa: B018  (refuses a limit that is not one number)
        if self.mu_static is not None and not (
            kinetic is not None and math.isfinite(self.mu_static) and self.mu_static >= kinetic
        ):
            least = "a force that does not vanish there" if kinetic is None else f"{kinetic:g}"
            raise InputError(
                f"mu_static {self.mu_static}: it must be a finite number and at least the force "
                f"at zero slip, {least}"
            )
        if self.static_mu is not None:
            static = Parameter(_static, "coefficient of static friction", self.static_mu, "1")
            object.__setattr__(self, "parameters", (*named, static))

    # --- numbers ---------------------------------------------------------------------------

    @cached_property
    def _numbers(self) -> dict[sp.Symbol, sp.Float]:
        return {p.symbol: sp.Float(p.default) for p in _named(self.parameters)}

    def _limit_at_rest(self, key: str, at_rest: sp.Symbol, what: str) -> float:
        """The unique limit of a formula where a variable is zero."""
        rest = getattr(self, key).subs(at_rest, 0).xreplace(self._numbers)
        others = [name for name, symbol in VARIABLES[key].items() if rest.has(symbol)]
        if others:
            raise InputError(
                f"{key}: at zero {what} it depends on {' and '.join(others)}; there it must be one "
                "number"
            )
        if not rest.is_real or not math.isfinite(float(rest)):
            raise InputError(
                f"{key}: at zero {what} it has no finite value; write it so that {at_rest} = 0 "
                "can be inserted"
            )
        return float(rest)

    @property
    def static_mu(self) -> float | None:
        """`mu_static`, or the limit of the force if that is larger than zero; otherwise None."""
        return self.kinetic_mu if self.mu_static is None else self.mu_static

    @cached_property
    def kinetic_mu(self) -> float | None:
        """The limit of the force as the slip tends to zero; None if that is zero."""
        return self._limit_at_rest("force", slip_speed, "slip") or None

    @cached_property
    def _spin_limit(self) -> float:
        return self._limit_at_rest("couple", spin, "spin")

    @property
    def spin_arm(self) -> float:
        """The couple at zero spin."""
        return self._spin_limit

    @property
    def force_of_slip(self) -> sp.Expr | None:
        """The force, unless it is independent of the slip speed."""
        force = self.force.xreplace(self._numbers)
        return force if force.has(slip_speed) and not self.unknown_in_impacts else None

    @property
    def unknown_in_impacts(self) -> str:
        """Variables other than the slip speed in `force`, and any variable in `couple`."""
        others = [name for name, s in VARIABLES["force"].items() if self.force.has(s)]
        others = [f"force depends on {name}" for name in others if name != "slip_speed"]
        couple = [name for name, s in VARIABLES["couple"].items() if self.couple.has(s)]
        return "; ".join([*others, *(f"couple depends on {name}" for name in couple)])

    def _require_dissipation(self, key: str) -> None:
        variables = VARIABLES[key]
        formula = getattr(self, key).xreplace(self._numbers)
        function = sp.lambdify(list(variables.values()), formula, "numpy")
        trials = np.meshgrid(*[_TRIALS] * len(variables))
        with np.errstate(all="ignore"):
            values = np.broadcast_to(function(*trials), trials[0].shape)
        wrong = np.argwhere(~(np.isfinite(values) & (values >= 0)))
        if len(wrong):
            place = tuple(wrong[0])
            at = ", ".join(f"{n} = {x[place]:g}" for n, x in zip(variables, trials, strict=True))
            raise InputError(
                f"{key}: at {at} it is {values[place]:g}; it must be a number not below zero"
            )

    # --- the law ---------------------------------------------------------------------------

    @property
    def summary(self) -> str:
        """A sentence with the formulas of the law."""
        return f"For each unit of the normal force, {self.description}."

    @property
    def description(self) -> str:
        """A description of the law."""
        plain = {p.symbol: sp.Symbol(_name(p)) for p in _named(self.parameters)}
        plain[N] = sp.Symbol("normal_force")
        text = f"friction {self.force.xreplace(plain)}"
        if self.couple != 0:
            text += f", couple {self.couple.xreplace(plain)} m"
        return text if self.mu_static is None else f"{text}, mu_static = {self.mu_static:g}"

    def reaction_along(self, direction: Vector, speed: sp.Expr, mode: Mode) -> Reaction:
        """Force and couple of a slip with a direction and a speed; smooth from rest on."""
        force = -self._at(self.force, speed, mode) * direction
        return Reaction(p=force, q=self.couple_at(speed, mode))

    def reaction(self, mode: Mode) -> Reaction:
        """The force against slip and the couple against spin, unless these are held at zero."""
        p: MatrixExpr = Reaction().p
        if mode.sliding:
            per_slip = _even_quotient(self.force, slip_speed)
            if per_slip is not None and per_slip.is_polynomial(slip_speed):
                square = norm_squared(slip)
                ratio = self._at(per_slip, sp.sqrt(square), mode)
            else:
                ratio = self._at(self.force, slip_speed, mode) / slip_speed
            p = -ratio * slip
        return Reaction(p=p, q=self.couple_at(slip_speed if mode.sliding else sp.S.Zero, mode))

    def couple_at(self, speed: sp.Expr, mode: Mode) -> MatrixExpr:
        """Couple per normal force at a slip speed."""
        if not mode.spinning or self.couple == 0:
            return Reaction().q
        per_spin = _even_quotient(self.couple, spin)
        if per_spin is not None:
            return -per_spin.xreplace({slip_speed: speed}) * spin * gamma
        return -self._at(self.couple, speed, mode) * spin_sign * gamma

    @property
    def reaction_at_rest(self) -> Reaction:
        """The couple without slip minus the one that holds the spin, at the parameter values."""
        couple = (self.couple - sp.Float(self.spin_arm)).xreplace(self._numbers)
        size = sp.Abs(spin) + sp.Float(1e-300)
        per_spin = sp.expand(couple.xreplace({slip_speed: sp.S.Zero}) / spin)
        return Reaction(q=-per_spin.xreplace({spin: size}) * spin * gamma)

    def _at(self, formula: sp.Expr, speed: sp.Expr, mode: Mode) -> sp.Expr:
        turn = spin_sign * spin if mode.spinning else sp.S.Zero
        if mode.spinning and formula.xreplace({spin: -spin}) == formula:
            turn = spin
        return formula.xreplace({slip_speed: speed, spin: turn})

    @property
    def _depends_on_spin_sign(self) -> bool:
        """Whether the formulas depend on the sign of the spin, so that a mode must keep it."""
        force, couple = self.force, self.couple
        odd = couple != 0 and _even_quotient(couple, spin) is None
        return odd or force.xreplace({spin: -spin}) != force

    def guards(self, mode: Mode) -> tuple[Guard, ...]:
        """The slip and the spin while nonzero; the margins of friction while they are held."""
        guards: tuple[Guard, ...] = ()
        if not mode.sliding:
            if self.static_mu is not None:
                margin = _static**2 * N**2 - norm_squared(friction)
                guards += (Guard("slip", margin, "sliding begins"),)
        elif self.kinetic_mu is not None:
            margin = slip_speed - slip_floor
            guards += (Guard("stick", margin, "sliding ends"),)
        elif not _is_smooth(self.force):
            guards += (creep_guard("this law of friction"),)
        if mode.spinning and self._depends_on_spin_sign:
            guards += (Guard("spin stop", spin_sign * spin, "spinning ends"),)
        if not mode.spinning and self._spin_limit:
            limit = self._at(self.couple, sp.S.Zero, mode)
            guards += (Guard("spin start", limit**2 * N**2 - holding_couple**2, "spinning begins"),)
        return guards


def _even_quotient(formula: sp.Expr, variable: sp.Symbol) -> sp.Expr | None:
    """A formula divided by a variable, if the result is smooth and even in it."""
    ratio = sp.expand(formula / variable)
    at_zero = ratio.subs(variable, 0)
    if at_zero.has(sp.zoo, sp.nan, sp.oo, -sp.oo):
        return None
    return ratio if sp.expand(ratio - ratio.xreplace({variable: -variable})) == 0 else None


def _is_smooth(formula: sp.Expr) -> bool:
    """Whether the force is a smooth function of the slip vector, without a square root."""
    ratio = _even_quotient(formula, slip_speed)
    return ratio is not None and bool(ratio.is_polynomial(slip_speed))


#: Before a name chosen by the user, to keep it apart from those of the equations of motion.
_PREFIX = "user_"


def _name(parameter: Parameter) -> str:
    """The name of a parameter in the formulas."""
    return str(parameter.symbol).removeprefix(_PREFIX)


def _formula(key: str, text: Quantity, symbols: Mapping[str, sp.Symbol]) -> sp.Expr:
    """Parse a formula or check a SymPy expression; only known symbols are allowed."""
    if isinstance(text, str):
        try:
            return parse(text, symbols)
        except InputError as error:
            raise InputError(f"{key}: {error.message}") from None
    formula = sp.sympify(text)
    formula = formula.xreplace(
        {s: symbols[s.name] for s in formula.free_symbols if s.name in symbols}
    )
    unknown = sorted(map(str, formula.free_symbols - set(symbols.values())))
    if unknown:
        raise InputError(
            f"{key}: {', '.join(unknown)} is not known; it may use {', '.join(symbols)}"
        )
    return formula


def _named(given: FormulaParameters) -> tuple[Parameter, ...]:
    """The parameters with the symbols of the law, without the coefficient of static friction."""
    declared = formula_parameters(given, "parameter of the law of friction")
    named = [p for p in declared if p.symbol != _static]
    for name in map(_name, named):
        if not name.isidentifier() or name in RESERVED_WORDS or name in VARIABLES["force"]:
            raise InputError(
                f"parameter {name!r}: this is no free name; a name is a letter followed by "
                "letters, digits and underscores, and neither a function nor a variable"
            )
    return tuple(
        replace(p, symbol=real_symbol(f"{_PREFIX}{_name(p)}"), default=float(p.default))
        for p in named
    )
