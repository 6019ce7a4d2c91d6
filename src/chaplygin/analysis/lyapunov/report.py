"""A Lyapunov spectrum in words, as a dataset, and as plain values for other programs."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from math import floor, log10
from typing import TYPE_CHECKING

import numpy as np

from ...core.arrays import FloatArray
from ...core.overview import Overview, WithOverview
from ...core.system import System
from ..orbits.reversing_symmetries import Reversor
from .attractor_dimension import kaplan_yorke
from .averages import Average, batch_means
from .divergence import Volume
from .zero_exponents import TrivialExponent

if TYPE_CHECKING:
    import xarray as xr

#: Draws of the bootstrap, and its seed.
DRAWS, SEED = 400, 20080830
#: A relative error of the computation above which it is reported.
CAREFUL = 0.1


@dataclass(frozen=True, repr=False)
class Spectrum(WithOverview):
    """The Lyapunov exponents of one motion.

    Attributes
    ----------
    system : System
    parameters : dict of str to float
    start : (size,) array
    until, interval : float
        Length of the motion, and of the intervals after which deviations are made orthonormal.
    began : float
        Before this time nothing is counted.
    exponents : tuple of Average
        The genuine ones, the largest first.
    trivial : tuple of (TrivialExponent, float or None)
        Removed directions, with the observed rate of growth, which is to vanish; None for
        relations.
    dependent : tuple of str
        Integrals and symmetries that force nothing at this start.
    fading : tuple of str
        Directions that would force a zero if they kept their size: the flow of a motion that comes
        to rest.  It is not removed.
    total : Average
        The sum of the genuine exponents.
    volume : Volume
    growth : (intervals, exponents) array
        Logarithms of the growth in each interval, from the start on.
    tolerance : float

    Examples
    --------
    >>> import chaplygin as ch
    >>> import sympy as sp
    >>> x, v = sp.symbols("x v", real=True)
    >>> pendulum = ch.System("pendulum", "Pendulum", {x: v, v: -sp.sin(x)})
    >>> spectrum = ch.lyapunov_spectrum(pendulum, (1.0, 0.0), until=20.0)
    >>> spectrum.values.shape
    (1,)
    """

    system: System
    parameters: dict[str, float]
    start: FloatArray
    until: float
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
        """Whether every exponent agrees in both halves of the motion."""
        return all(item.halves_agree for item in self.exponents)

    @property
    def values(self) -> FloatArray:
        """The genuine exponents."""
        return np.array([item.value for item in self.exponents])

    @property
    def errors(self) -> FloatArray:
        """Their errors."""
        return np.array([item.error for item in self.exponents])

    @property
    def chaotic(self) -> bool:
        """Whether the largest exponent is settled and positive beyond its error: observed."""
        return any(one.halves_agree and one.value > one.error for one in self.exponents[:1])

    @property
    def within(self) -> int:
        """Zeros that belong to directions within the levels of the integrals."""
        return sum(r.kind in ("flow", "symmetry", "quadrature") for r, _ in self.trivial)

    @cached_property
    def dimension(self) -> tuple[float, float]:
        """The Kaplan–Yorke dimension on the level of the integrals, and its error.

        The error is the standard deviation over bootstrap draws of the batches.
        """
        began = round(self.began / self.interval)
        means = batch_means(self.growth[began:]) / self.interval
        draws = np.random.default_rng(SEED).integers(len(means), size=(DRAWS, len(means)))
        zeros = np.zeros(self.within)
        dimensions = [kaplan_yorke(np.append(means[draw].mean(axis=0), zeros)) for draw in draws]
        return kaplan_yorke(np.append(self.values, zeros)), float(np.std(dimensions))

    @property
    def symmetric(self) -> bool:
        """Whether the exponents come in pairs of opposite sign, within their errors."""
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

        (intervals, exponents); not a number before anything is counted.
        """
        began = round(self.began / self.interval)
        averages = np.full(self.growth.shape, np.nan)
        count = np.arange(1, len(averages) - began + 1)[:, None]
        averages[began:] = np.cumsum(self.growth[began:], axis=0) / (self.interval * count)
        return averages

    def overview(self) -> Overview:
        """The exponents with their errors, and the zeros that are forced."""
        shown = [
            " ± ".join(significant_digits(one.value, one.error)) + f", {sign_word(one)}"
            for one in self.exponents
        ]
        forced = [z.name if z.name == z.kind else f"{z.kind} {z.name}" for z, _ in self.trivial]
        return Overview(
            f"Lyapunov exponents of {self.system.title}, t = {self.began:g} to {self.until:g}",
            (
                *((f"λ_{i}", text) for i, text in enumerate(shown, 1)),
                ("sum", " ± ".join(significant_digits(self.total.value, self.total.error))),
                ("trivial", "; ".join(forced)),
            ),
        )

    def dataset(self) -> xr.Dataset:
        """Exponents, errors and the way they settled, with what they are of."""
        return dataset(self)


def sign_word(item: Average) -> str:
    """An exponent in a word."""
    if not item.halves_agree:
        return "not converged"
    if item.zero:
        return "zero within its error"
    return "nearby motions diverge" if item.value > 0 else "nearby motions converge"


def significant_digits(value: float, error: float) -> tuple[str, str]:
    """A number and its error, to two digits of the error."""
    places = max(0, 1 - floor(log10(error))) if error > 0 else 12
    # a zero has no sign
    return f"{round(value, places) + 0.0:.{places}f}", f"{error:.{places}f}"


def remarks(spectrum: Spectrum, reversors: Sequence[Reversor] = ()) -> Iterator[str]:
    """Sentences on what a spectrum shows; all of them observed unless they say proven.

    Parameters
    ----------
    spectrum : Spectrum
    reversors : sequence of Reversor
        Those of the system; the ones that hold with these parameters are used.
    """
    yield from _convergence(spectrum)
    for name in spectrum.fading:
        yield (
            f"no exponent is made trivial by {name} on this motion, because its size does not "
            "last: the motion comes to rest, or runs away"
        )
    yield from _kind(spectrum)
    yield from _volumes(spectrum)
    holding = [reversor for reversor in reversors if reversor.holds(spectrum.parameters)]
    if holding:
        yield from _pairs(spectrum, holding[0])


def _is_undecided(spectrum: Spectrum) -> bool:
    """Whether an error is no smaller than the fluctuations of the growth."""
    counted = spectrum.growth[round(spectrum.began / spectrum.interval) :]
    rates = counted.std(axis=0) / spectrum.interval
    return any(
        item.error > max(2 * item.resolution, CAREFUL * rate)
        for item, rate in zip(spectrum.exponents, rates, strict=True)
    )


def _convergence(spectrum: Spectrum) -> Iterator[str]:
    for number, item in enumerate(spectrum.exponents, 1):
        if not item.halves_agree:
            first, second = item.halves
            yield (
                f"λ{number} has not converged: {first:.3g} over the first half of the time, "
                f"{second:.3g} over the second; integrate for longer (--until)"
            )
    if abs(spectrum.volume.balance) > CAREFUL * spectrum.total.error:
        yield (
            f"the mean of the divergence has a further uncertainty of "
            f"{abs(spectrum.volume.balance):.2g}: it varies faster than it is sampled"
        )


def _kind(spectrum: Spectrum) -> Iterator[str]:
    if not spectrum.exponents:
        yield "integrals, relations and symmetries make all exponents trivial"
    elif spectrum.chaotic:
        yield "the largest exponent is positive: the motion is chaotic (observed)"
    elif all(item.zero for item in spectrum.exponents) and _is_undecided(spectrum):
        yield (
            "no exponent differs from zero beyond its error, but the errors are not small beside "
            "the rates at which deviations grow and shrink along the motion: nothing can be "
            "concluded yet; integrate for longer (--until)"
        )
    elif all(item.zero for item in spectrum.exponents) and spectrum.halves_agree:
        yield (
            "no exponent differs from zero beyond its error: the motion is regular as far as this "
            "time shows (observed)"
        )
    elif spectrum.halves_agree and spectrum.exponents[0].value < -spectrum.exponents[0].error:
        yield "all exponents are negative: a periodic or steady motion attracts this one (observed)"


def _volumes(spectrum: Spectrum) -> Iterator[str]:
    total = spectrum.total
    changing = bool(spectrum.exponents) and total.halves_agree and not total.zero
    for name, defect in spectrum.volume.measures.items():
        if abs(defect) <= CAREFUL * total.error:
            limit = "grows beyond all bounds" if total.value < 0 else "goes to zero"
            yield (
                f"the density of the invariant measure {name!r} accounts for the mean of the "
                f"divergence, to {abs(defect):.1g}"
                + (f": it {limit} along this motion, and so excludes nothing" if changing else "")
            )
        else:
            yield (
                f"the density of the invariant measure {name!r} does not account for the mean of "
                f"the divergence, by {abs(defect):.1g}: the motion runs where it is not defined"
            )
    if not changing:
        return
    way, end = ("contracts", "attracts") if total.value < 0 else ("expands", "repels")
    yield (
        f"phase volume {way} along this motion: near its limit set there is no invariant measure "
        "with a smooth positive density (observed, not proven)"
    )
    if spectrum.chaotic and total.value < 0:
        value, error = significant_digits(*spectrum.dimension)
        level = any(item.kind == "integral" for item, _ in spectrum.trivial)
        place = " on the level of the integrals" if level else ""
        yield f"a chaotic set {end} it, of Kaplan–Yorke dimension {value} ± {error}{place}"


def _pairs(spectrum: Spectrum, reversor: Reversor) -> Iterator[str]:
    yield (
        f"the equations are reversible (proven): {reversor.words(spectrum.system)} with the time"
    )
    if spectrum.exponents and spectrum.halves_agree and not _is_undecided(spectrum):
        yield (
            "the exponents form pairs of opposite sign within their errors"
            if spectrum.symmetric
            else "the exponents do not form pairs of opposite sign: the reversed motion has the "
            "opposite exponents and is a different motion"
        )


def record(spectrum: Spectrum, reversors: Sequence[Reversor] = ()) -> dict[str, object]:
    """A spectrum as numbers, texts and lists of these."""
    return {
        "system": spectrum.system.name,
        "parameters": spectrum.parameters,
        "start": spectrum.start.tolist(),
        "units": dict.fromkeys(("exponents", "seen", "sum", "mean_divergence"), "1/s")
        | dict.fromkeys(("until", "counted_from", "interval"), "s"),
        "until": spectrum.until,
        "counted_from": spectrum.began,
        "interval": spectrum.interval,
        "exponents": [_average(item) | {"word": sign_word(item)} for item in spectrum.exponents],
        "removed": [
            {"name": item.name, "kind": item.kind, "seen": rate} for item, rate in spectrum.trivial
        ],
        "dependent": list(spectrum.dependent),
        "fading": list(spectrum.fading),
        "sum": _average(spectrum.total),
        "mean_divergence": _average(spectrum.volume.divergence),
        "balance": spectrum.volume.balance,
        "measures": spectrum.volume.measures,
        "dimension": dict(zip(("value", "error"), spectrum.dimension, strict=True)),
        "settled": spectrum.halves_agree,
        "symmetric": spectrum.symmetric,
        "reversors": [
            {
                "odd": [str(s) for s in item.odd],
                "needs_zero": [str(s) for s in item.vanishing],
                "holds": item.holds(spectrum.parameters),
            }
            for item in reversors
        ],
        "remarks": list(remarks(spectrum, reversors)),
    }


def _average(item: Average) -> dict[str, object]:
    return {
        "value": item.value,
        "error": item.error,
        "statistical": item.statistical,
        "wandering": item.wandering,
        "resolution": item.resolution,
        "halves": list(item.halves),
        "settled": item.halves_agree,
    }


def dataset(spectrum: Spectrum) -> xr.Dataset:
    """A spectrum with the way it settled.

    Returns
    -------
    xarray.Dataset
        Dimensions ``exponent`` (from 1), ``removed`` (names) and ``time`` (ends of the intervals).
    """
    import xarray as xr

    from ..._version import __version__

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
                "exponent", np.arange(1, len(spectrum.exponents) + 1), "number", "1"
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
            "versions": f"chaplygin {__version__}",
        },
    )
