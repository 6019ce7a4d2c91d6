"""Linear involutions that reverse the direction of time.

A *reversor* R changes the signs of some state variables, such as those changed by a reflection of
space or the angular velocity, and maps every motion to a motion in reversed time: v(Rx) = −R v(x).
Some require parameters to vanish, such as components of the displacement of the centre of mass;
then R together with a sign change of these parameters reverses the whole family. Candidates are
found numerically and proven exactly. (Permutations of axes, which require equal parameters, are
not searched.)
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
import sympy as sp

from ..arguments import arguments_checked
from ..formulas.array_formulas import Formulas
from ..printing.formula import text
from ..system.arrays import FloatArray
from ..system.named_formulas import flat
from ..system.parameters import Parameters
from ..system.system import Parameter, System
from .sign_reversal import reverses

#: Maximum number of symbols whose signs are tried individually; otherwise vectors are.
SIGNS = 16
#: Number of states at which candidates are tested, and of attempts to draw them.
POINTS, DRAWS = 2, 60
SEED = 20080830
#: Relative difference below which two numbers count as equal in the numerical test.
CLOSE = 1e-9
#: Size of parameters of either sign at these states.
SMALL = 0.2


@arguments_checked
@dataclass(frozen=True)
class Reversor:
    """A sign change that provably reverses the equations.

    Attributes
    ----------
    odd : tuple of Symbol
        State variables that change sign, in flat order.
    vanishing : tuple of Symbol
        Parameters that must be zero.

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> x, v = sp.symbols("x v", real=True)
    >>> pendulum = flowlanes.System("pendulum", "Pendulum", {x: v, v: -sp.sin(x)})
    >>> [reversor.odd for reversor in flowlanes.reversing_symmetries(pendulum)]
    [(x,), (v,)]
    """

    odd: tuple[sp.Symbol, ...]
    vanishing: tuple[sp.Symbol, ...] = ()

    @arguments_checked
    def signs(self, system: System) -> FloatArray:
        """The diagonal of R: +1 and −1 in flat order."""
        return np.array([-1.0 if s in self.odd else 1.0 for s in system.symbols])

    @arguments_checked
    def holds(self, parameters: Parameters) -> bool:
        """True if the reversor holds for these parameters, given by Symbol or name."""
        values = {str(name): value for name, value in parameters.items()}
        return all(values[str(symbol)] == 0 for symbol in self.vanishing)

    @arguments_checked
    def words(self, system: System) -> str:
        """A description: the variables that change sign, and the conditions."""
        whole = [name for name in system.state if set(flat((name,))) <= set(self.odd)]
        scalars = [s for s in self.odd if s not in flat(whole)]
        names = [text(name) for name in (*whole, *scalars)]
        needs = "".join(f"{text(symbol)} = " for symbol in self.vanishing)
        verb = "changes" if len(names) == 1 else "change"
        return f"{', '.join(names)} {verb} sign" + (f" where {needs}0" if needs else "")


@arguments_checked
def reversing_symmetries(system: System) -> tuple[Reversor, ...]:
    """All sign changes that provably reverse a system.

    Parameters
    ----------
    system : System
        A system; parameters may have to vanish, see
        :meth:`~flowlanes.orbits.reversor.Reversor.holds`.
        :meth:`~flowlanes.orbits.reversor.Reversor.holds`.

    Returns
    -------
    tuple of Reversor
        Those without conditions first. Candidates that pass the numerical test but cannot be
        proven from the parities of the definitions are omitted.

    Raises
    ------
    InputError
        If the argument is not a system.

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> x, v, k = sp.symbols("x v k", real=True)
    >>> damping = flowlanes.Parameter(k, "damping", 0.1)
    >>> field = {x: v, v: -sp.sin(x) - k * v}
    >>> pendulum = flowlanes.System("pendulum", "Damped pendulum", field, (damping,))
    >>> [reversor.words(pendulum) for reversor in flowlanes.reversing_symmetries(pendulum)]
    ['x changes sign where k = 0', 'v changes sign where k = 0']
    """
    accepted: list[Reversor] = []
    for candidate in sorted(_candidates(system), key=lambda r: (len(r.vanishing), len(r.odd))):
        weaker = any(
            old.odd == candidate.odd and set(old.vanishing) <= set(candidate.vanishing)
            for old in accepted
        )
        if not weaker and reverses(system, {*candidate.odd, *candidate.vanishing}):
            accepted.append(candidate)
    return tuple(accepted)


def _candidates(system: System) -> Iterator[Reversor]:
    """Sign changes that reverse the equations at some states, numerically."""
    loose = [p.symbol for p in system.parameters if _sign_change(p)]
    units = [(s,) for s in (*system.symbols, *loose)]
    if len(units) > SIGNS:
        units = [flat((name,)) for name in system.state]
    places = {s: i for i, s in enumerate(system.symbols)}
    # Every bit pattern is a choice of signs; all choices are evaluated at once as rows.
    choices = np.arange(1, 2 ** len(units))
    flips = (choices[:, None] >> np.arange(len(units))) & 1 == 1
    states = np.ones((len(choices), len(system.symbols)))
    constants = {s: np.ones(len(choices)) for s in loose}
    for flip, unit in zip(flips.T, units, strict=True):
        for symbol in unit:
            column = states[:, places[symbol]] if symbol in places else constants[symbol]
            column[flip] = -1.0
    rates = Formulas(system, system.rates)
    good = np.ones(len(choices), dtype=bool)
    for point, values, rate in _points(system, loose, rates):
        turned = rates(states * point, {s: signs * values[s] for s, signs in constants.items()})
        with np.errstate(invalid="ignore"):
            missed = np.abs(turned + states * rate).max(axis=1)
            good &= missed <= CLOSE * np.abs(rate).max()
    for row, index in zip(states[good], np.flatnonzero(good), strict=True):
        yield Reversor(
            tuple(s for s, sign in zip(system.symbols, row, strict=True) if sign < 0),
            tuple(s for s in loose if constants[s][index] < 0),
        )


def _sign_change(parameter: Parameter) -> bool:
    """True if a parameter may have either sign."""
    conditions = [sp.sympify(c).subs(parameter.symbol, -SMALL) for c in parameter.admissible]
    return all(condition != sp.false for condition in conditions)


def _points(system: System, loose: list[sp.Symbol], rates: Formulas) -> Iterator[Any]:
    """States and parameters at which the equations are defined, with the rates there."""
    random = np.random.default_rng(SEED)
    count = 0
    for _ in range(DRAWS):
        state = random.uniform(0.1, 0.9, size=len(system.symbols))
        values = {s: SMALL * random.uniform(0.5, 1.5) for s in loose}
        (rate,) = rates([state], values)
        if np.isfinite(rate).all() and np.any(rate):
            count += 1
            yield state, values, rate
        if count == POINTS:
            return
