"""The Lyapunov spectrum of a motion, and its dataset."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from math import floor, log10
from typing import TYPE_CHECKING

import numpy as np

from ..system.arrays import FloatArray
from ..system.overview import Overview, WithOverview
from ..system.system import System
from .attractor_dimension import kaplan_yorke
from .averages import Average, batch_means
from .divergence import Volume
from .zero_exponents import TrivialExponent

if TYPE_CHECKING:
    import xarray as xr

#: Number of bootstrap samples, and their seed.
DRAWS, SEED = 400, 20080830
#: Relative error of the computation above which it is reported.
CAREFUL = 0.1


@dataclass(frozen=True, repr=False)
class Spectrum(WithOverview):
    """The Lyapunov exponents of one motion.

    Attributes
    ----------
    system : System
    parameters : dict of str to float
    start : (size,) array
    t_end, interval : float
        Length of the motion, and of the intervals after which deviations are orthonormalised.
    began : float
        End of the transient, which is not counted.
    exponents : tuple of Average
        The genuine exponents, largest first.
    trivial : tuple of (TrivialExponent, float or None)
        Removed directions with their observed rate of growth, which should vanish; None for
        relations.
    dependent : tuple of str
        Integrals and symmetries that are dependent at this start and force no further zero.
    fading : tuple of str
        Directions that would force a zero if their size did not vanish or diverge, such as the
        flow of a motion that comes to rest. They are not removed.
    total : Average
        The sum of the genuine exponents.
    volume : Volume
    growth : (intervals, exponents) array
        Logarithmic growth in each interval, from the start on.
    tolerance : float

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> x, v = sp.symbols("x v", real=True)
    >>> pendulum = flowlanes.System("pendulum", "Pendulum", {x: v, v: -sp.sin(x)})
    >>> spectrum = flowlanes.lyapunov_spectrum(pendulum, (1.0, 0.0), t_end=20.0)
    >>> spectrum.values.shape
    (1,)
    """

    system: System
    parameters: dict[str, float]
    start: FloatArray
    t_end: float
    interval: float
    began: float
    exponents: tuple[Average, ...]
    trivial: tuple[tuple[TrivialExponent, float | None], ...]
    dependent: tuple[str, ...]
    fading: tuple[str, ...]
    total: Average
    volume: Volume
    growth: FloatArray
    tolerance: float

    @property
    def halves_agree(self) -> bool:
        """True if every exponent agrees in both halves of the motion."""
        return all(item.halves_agree for item in self.exponents)

    @property
    def values(self) -> FloatArray:
        """The genuine exponents."""
        return np.array([item.value for item in self.exponents])

    @property
    def errors(self) -> FloatArray:
        """The errors of the genuine exponents."""
        return np.array([item.error for item in self.exponents])

    @property
    def in_order(self) -> tuple[Average | TrivialExponent, ...]:
        """All exponents, largest first, including the exact zeros.

        Relations are not directions of the phase space and have no exponent.
        """
        above = sum(item.value > 0 for item in self.exponents)
        zeros = (item for item, rate in self.trivial if rate is not None)
        return (*self.exponents[:above], *zeros, *self.exponents[above:])

    @property
    def numbers(self) -> tuple[int, ...]:
        """The index of each genuine exponent among all, from 1."""
        return tuple(i for i, x in enumerate(self.in_order, 1) if isinstance(x, Average))

    @property
    def trivial_numbers(self) -> tuple[int | None, ...]:
        """The index of each trivial exponent among all, from 1; None for relations."""
        places = iter([i for i, x in enumerate(self.in_order, 1) if not isinstance(x, Average)])
        return tuple(None if rate is None else next(places) for _, rate in self.trivial)

    @property
    def chaotic(self) -> bool:
        """True if the largest exponent has converged and is positive beyond its error: observed."""
        return any(one.halves_agree and one.value > one.error for one in self.exponents[:1])

    @property
    def within(self) -> int:
        """Number of zero exponents of directions within the levels of the integrals."""
        return sum(r.kind in ("flow", "symmetry", "quadrature") for r, _ in self.trivial)

    @cached_property
    def dimension(self) -> tuple[float, float]:
        """The Kaplan–Yorke dimension on the level of the integrals, and its error.

        The error is the standard deviation over bootstrap samples of the batches.
        """
        began = round(self.began / self.interval)
        means = batch_means(self.growth[began:]) / self.interval
        draws = np.random.default_rng(SEED).integers(len(means), size=(DRAWS, len(means)))
        zeros = np.zeros(self.within)
        # A bootstrap sample draws batches with replacement; the exact zeros have no error.
        dimensions = [kaplan_yorke(np.append(means[draw].mean(axis=0), zeros)) for draw in draws]
        return kaplan_yorke(np.append(self.values, zeros)), float(np.std(dimensions))

    @property
    def symmetric(self) -> bool:
        """True if the exponents form pairs of opposite sign, within their errors."""
        pairs = self.values + self.values[::-1]
        return bool(np.all(np.abs(pairs) <= self.errors + self.errors[::-1]))

    @property
    def times(self) -> FloatArray:
        """The ends of the intervals."""
        ends = self.interval * np.arange(1, len(self.growth) + 1)
        return np.asarray(ends, dtype=np.float64)

    @property
    def running(self) -> FloatArray:
        """Running averages: each exponent as if the motion had ended earlier.

        (intervals, exponents); NaN before the averaging begins.
        """
        began = round(self.began / self.interval)
        averages = np.full(self.growth.shape, np.nan)
        count = np.arange(1, len(averages) - began + 1)[:, None]
        averages[began:] = np.cumsum(self.growth[began:], axis=0) / (self.interval * count)
        return averages

    def overview(self) -> Overview:
        """The exponents with their errors, and the trivial ones."""
        shown = [
            " ± ".join(significant_digits(one.value, one.error)) + f", {sign_word(one)}"
            if isinstance(one, Average)
            else f"0, {_origin(one)}"
            for one in self.in_order
        ]
        forced = [_origin(item) for item, _ in self.trivial]
        return Overview(
            f"Lyapunov exponents of {self.system.title}, t = {self.began:g} to {self.t_end:g}",
            (
                *((f"λ_{i}", text) for i, text in enumerate(shown, 1)),
                ("sum", " ± ".join(significant_digits(self.total.value, self.total.error))),
                ("trivial", "; ".join(forced)),
            ),
        )

    def dataset(self) -> xr.Dataset:
        """Exponents, errors and running averages, with metadata."""
        return dataset(self)


def _origin(item: TrivialExponent) -> str:
    return item.name if item.name == item.kind else f"{item.kind} {item.name}"


def sign_word(item: Average) -> str:
    """The sign of an exponent, in words."""
    if not item.halves_agree:
        return "not converged"
    if item.zero:
        return "zero within its error"
    return "nearby motions diverge" if item.value > 0 else "nearby motions converge"


def significant_digits(value: float, error: float) -> tuple[str, str]:
    """A number and its error, rounded to two significant digits of the error."""
    places = max(0, 1 - floor(log10(error))) if error > 0 else 12
    # Adding 0.0 turns −0.0 into 0.0.
    return f"{round(value, places) + 0.0:.{places}f}", f"{error:.{places}f}"


def dataset(spectrum: Spectrum) -> xr.Dataset:
    """The spectrum with its running averages as a dataset.

    Returns
    -------
    xarray.Dataset
        Dimensions ``exponent`` (the number among all exponents), ``removed`` (names) and ``time``
        (ends of the intervals).
    """
    import xarray as xr

    from .._version import __version__

    def variable(dims: object, values: object, name: str, units: str = "1/s") -> tuple[object, ...]:
        return dims, values, {"long_name": name, "units": units, "source": ""}

    rates = [np.nan if rate is None else rate for _, rate in spectrum.trivial]
    kinds = [item.kind for item, _ in spectrum.trivial]
    settled = np.array([item.halves_agree for item in spectrum.exponents], dtype=np.int8)
    total, divergence = spectrum.total, spectrum.volume.divergence
    start = zip(spectrum.system.symbols, spectrum.start, strict=True)
    return xr.Dataset(
        {
            "lyapunov": variable("exponent", spectrum.values, "Lyapunov exponent"),
            "error": variable("exponent", spectrum.errors, "error of the exponent"),
            "settled": variable("exponent", settled, "whether both halves agree", "1"),
            "running": variable(("time", "exponent"), spectrum.running, "exponent if ended here"),
            "seen": variable("removed", rates, "rate seen of a forced zero"),
            "kind": variable("removed", kinds, "why it was removed", "1"),
            "total": variable((), total.value, "sum of the exponents"),
            "total_error": variable((), total.error, "error of the sum"),
            "divergence": variable((), divergence.value, "mean divergence on the phase space"),
        },
        {
            "exponent": variable(
                "exponent", np.array(spectrum.numbers, dtype=np.int64), "number", "1"
            ),
            "number": variable(
                "removed", [i or 0 for i in spectrum.trivial_numbers], "number, 0 for none", "1"
            ),
            "removed": variable("removed", [r.name for r, _ in spectrum.trivial], "name", "1"),
            "time": variable("time", spectrum.times, "time", "s"),
        },
        {
            "Conventions": "CF-1.11",
            "system": spectrum.system.title,
            "system_name": spectrum.system.name,
            "parameters": "; ".join(f"{name} = {x!r}" for name, x in spectrum.parameters.items()),
            "start": "; ".join(f"{symbol} = {float(x)!r}" for symbol, x in start),
            "counted_from": spectrum.began,
            "tolerance": spectrum.tolerance,
            "versions": f"flowlanes {__version__}",
        },
    )
