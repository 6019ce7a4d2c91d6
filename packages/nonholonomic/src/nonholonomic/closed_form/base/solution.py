"""Base classes of closed-form solutions: motions known at every time."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass
from typing import NoReturn

import numpy as np
import numpy.typing as npt
import sympy as sp
from flint import arb

from flowlanes.arguments import NumberOrText, arguments_checked
from flowlanes.errors import InputError
from flowlanes.flow.sampled_motion import SampledMotion, sampled
from flowlanes.formulas.array_evaluation import as_float_array
from flowlanes.system.arrays import FloatArray
from flowlanes.system.overview import Overview, WithOverview
from flowlanes.system.system import System

#: Largest phase Ωt in double precision: beyond 1e15 its digits are lost.
LATEST = 1e13


@dataclass(frozen=True)
class NamedConstant:
    """A constant of a closed form, with its value.

    Attributes
    ----------
    symbol : str
        The symbol, such as ``"Omega_1"``.
    value : flint.arb
        The value with its error bound.
    meaning, unit : str

    Examples
    --------
    >>> import nonholonomic
    >>> from flint import arb
    >>> print(nonholonomic.closed_form.NamedConstant("h", arb(2), "energy", "J").meaning)
    energy
    """

    symbol: str
    value: arb
    meaning: str
    unit: str = ""

    def __reduce__(self) -> NoReturn:
        raise TypeError(
            "a constant of a closed form is a ball of python-flint, which cannot be pickled: "
            "pickle float(constant.value), or the text constant.value.str()"
        )

    def text(self) -> str:
        """The value to ten digits, with unit and meaning."""
        number = f"{float(self.value):.10g} {self.unit}".rstrip()
        return f"{number}, {self.meaning}" if self.meaning else number


@dataclass(frozen=True, repr=False)
class ClosedForm(WithOverview):
    """The formulas and constants of a closed form.

    Attributes
    ----------
    title : str
        A description of the system.
    motion : str
        The kind of motion: "two-frequency motion on a torus", "periodic", "asymptotic to a
        permanent rotation", …
    equations : tuple of (left, right)
        SymPy formulas: the curve, the differential equations, the time rescaling.
    constants : tuple of NamedConstant
        Constants, roots, frequencies, periods, rotation number.
    ovals : tuple of (low, high)
        The intervals of the separated variables (floats).
    source : str

    Examples
    --------
    >>> import nonholonomic
    >>> disk = nonholonomic.from_catalogue("rubber-disk")
    >>> form = nonholonomic.solve(disk, nonholonomic.CATALOGUE["rubber-disk"].start.values).form
    >>> round(float(form["T"].value), 6), form["T"].meaning
    (1.255333, 'period of the nutation')
    """

    title: str
    motion: str
    equations: tuple[tuple[sp.Expr, sp.Expr], ...]
    constants: tuple[NamedConstant, ...]
    ovals: tuple[tuple[float, float], ...] = ()
    source: str = ""

    def __getitem__(self, symbol: str) -> NamedConstant:
        """A constant by its symbol, such as ``"T"``.

        Raises
        ------
        InputError
            If the closed form has no constant of this symbol.
        """
        for constant in self.constants:
            if constant.symbol == symbol:
                return constant
        known = ", ".join(constant.symbol for constant in self.constants)
        raise InputError(f"{self.title}: no constant {symbol!r} in the closed form; it has {known}")

    def overview(self) -> Overview:
        """System, kind of motion, source, and the constants."""
        ovals = ", ".join(f"[{low:.9g}, {high:.9g}]" for low, high in self.ovals)
        return Overview(
            f"{self.title}: {self.motion}",
            (
                ("source", self.source),
                ("separated variables in", ovals),
                *((one.symbol, one.text()) for one in self.constants),
            ),
        )


def finite_times(times: npt.ArrayLike) -> FloatArray:
    """Times as doubles (n,).

    Raises
    ------
    InputError
        If one is not finite, or they lie in a table.
    """
    moments = np.atleast_1d(as_float_array("times", times))
    if moments.ndim != 1:
        raise InputError("times: they must be one number or a sequence of numbers")
    if not np.all(np.isfinite(moments)):
        raise InputError("times: all of them must be finite numbers")
    return moments


def times_in_range(times: npt.ArrayLike, phase_rate: float) -> FloatArray:
    """Times (n,) at which states in double precision are meaningful.

    Parameters
    ----------
    times : numbers (n,)
    phase_rate : float
        The rate of the fastest phase of the motion.

    Raises
    ------
    InputError
        If one is not finite, or the phases there are beyond `LATEST`.
    """
    moments = finite_times(times)
    if np.any(np.abs(moments) * phase_rate > LATEST):
        raise InputError(
            "times: in double precision they must be within "
            f"±{LATEST / (phase_rate or 1.0):.3g}, beyond which the phase of the motion is lost; "
            "evaluation with error bounds (--digits, rigorous) goes further"
        )
    return moments


class Solution(WithOverview):
    """A motion in closed form.

    Attributes
    ----------
    system : System
        Lifted to space if it has a motion there.
    parameters : mapping of Symbol to number

    Examples
    --------
    >>> import nonholonomic
    >>> disk = nonholonomic.from_catalogue("rubber-disk")
    >>> solution = nonholonomic.solve(disk, nonholonomic.CATALOGUE["rubber-disk"].start.values)
    >>> solution.form.motion
    'periodic in shape: the axis nods while it precesses, with two frequencies'
    """

    system: System
    parameters: Mapping[sp.Symbol, NumberOrText]

    @property
    @abstractmethod
    def form(self) -> ClosedForm:
        """The formulas and constants of the closed form."""

    @abstractmethod
    def states(self, times: npt.ArrayLike) -> FloatArray:
        """Lifted states at `times` (n,), as an array (n, size), in double precision."""

    @property
    @abstractmethod
    def phase_rate(self) -> float:
        """Approximate rate at which the phases of the motion grow; 0 at rest."""

    @property
    def not_rigorous(self) -> str:
        """A sentence on the part of the state for which :meth:`rigorous` has no bounds; or ""."""
        return ""

    @abstractmethod
    def rigorous(self, time: NumberOrText, digits: int = 30) -> tuple[arb, ...]:
        """The lifted state at one time as balls (``flint.arb``) that contain the exact state.

        Parameters
        ----------
        time : float, int, str, Fraction or arb
        digits : int
            Requested relative accuracy; the radii of the balls give the accuracy attained. They are
            infinite for a position and an attitude without bounds.

        Raises
        ------
        InputError
            If so many digits cannot be obtained.
        """

    def __reduce__(self) -> NoReturn:
        raise TypeError(
            "a closed form cannot be pickled: pickle solution(times).to_dataset(), or call solve "
            "again"
        )

    def overview(self) -> Overview:
        """The overview of the closed form, and of the quantities without rigorous bounds."""
        form = self.form.overview()
        return Overview(form.heading, (*form.rows, ("left open", self.not_rigorous)))

    @arguments_checked
    def __call__(self, times: npt.ArrayLike) -> SampledMotion:
        """The motion at `times`: its states, by name.

        Raises
        ------
        InputError
            If a time is not finite, or so large that doubles lose the phase.
        """
        moments = times_in_range(times, self.phase_rate)
        return sampled(self.system, self.parameters, moments, self._states_in_range)

    def _states_in_range(self, times: FloatArray) -> FloatArray:
        return self.states(times_in_range(times, self.phase_rate))
