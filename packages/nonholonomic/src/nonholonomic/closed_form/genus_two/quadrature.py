"""∫ f dτ along a linear flow on the torus: a linear drift and a quasi-periodic part.

With f(v) = Σ f_k exp(iπ(k, v)) and v = v₀ + Vτ,

    ∫ f dτ = f_0 τ + Σ f_k exp(iπ(k, v₀)) (exp(iπ(k, V)τ) − 1)/(iπ(k, V)).

Terms with small divisors are large and slow; near a resonance they are kept separate and written as
τ exp(ix/2) sin(x/2)/(x/2), x = π(k, V)τ, which has no divisor.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from flint import arb

from flowlanes.formulas.balls import number
from flowlanes.system.arrays import ComplexArray, FloatArray, IntArray

from ..base.no_closed_form import NoClosedFormError
from .phases import phase_grid, wave_rates

#: Relative size below which coefficients count as rounding.
_LEVEL = 2e-16
#: Initial number of grid points per period 2.
_GRID = 32
#: Maximum number of grid points.
_POINTS = 2**18
#: A term counts as slow if integration over a turn of the phases would amplify it by more than
#: this, relative to all terms.
_SLOW = 100.0


@dataclass(frozen=True)
class Series:
    """A real function on the torus, of period 2 in both phases.

    Attributes
    ----------
    first, second : array of int
        The wave numbers k₁ and k₂ that occur, k₂ ≥ 0.
    coefficients : array (len(first), len(second)), complex
        f is the real part of Σ coefficients exp(iπ(k, v)).
    grid : (int, int)
        Points of the grid from which it was computed.
    """

    first: FloatArray | IntArray
    second: FloatArray | IntArray
    coefficients: ComplexArray
    grid: tuple[int, int]

    def transpose(self) -> Series:
        """The function with its two phases exchanged."""
        return Series(self.second, self.first, self.coefficients.T, self.grid[::-1])

    def waves(self, v: FloatArray) -> tuple[ComplexArray, ComplexArray]:
        """exp(iπk₁v₁) and exp(iπk₂v₂) at phases v (n, 2)."""
        return (
            np.exp(1j * np.pi * np.outer(v[:, 0], self.first)),
            np.exp(1j * np.pi * np.outer(v[:, 1], self.second)),
        )

    def __call__(self, v: FloatArray) -> FloatArray:
        """Values at phases v (n, 2)."""
        return _wave_sum(self.waves(v), self.coefficients)


def _wave_sum(waves: tuple[ComplexArray, ComplexArray], coefficients: ComplexArray) -> FloatArray:
    values: ComplexArray = np.einsum("nk,nk->n", waves[0] @ coefficients, waves[1])
    return values.real


def series(function: Callable[[FloatArray], FloatArray]) -> tuple[Series, ...]:
    """Fourier series of smooth functions on the torus, accurate relative to the largest.

    Parameters
    ----------
    function : callable
        Phases (n, 2) ↦ values (functions, n).

    Raises
    ------
    NoClosedFormError
        If they are not resolved by the finest grid.
    """
    sizes = [_GRID, _GRID]
    while True:
        values = function(phase_grid(sizes))
        spectra = [np.fft.rfft2(block.reshape(sizes)) / block.size for block in values]
        # One of them may consist of rounding alone: the largest sets the scale.
        scale = max(float(np.max(np.abs(spectrum))) for spectrum in spectra)
        rough = [not all(_is_resolved(f, axis, scale) for f in spectra) for axis in (0, 1)]
        if not any(rough):
            return tuple(_significant_series(spectrum, sizes, scale) for spectrum in spectra)
        sizes = [2 * size if more else size for size, more in zip(sizes, rough, strict=True)]
        if sizes[0] * sizes[1] > _POINTS:
            raise NoClosedFormError(
                "the motion is so near a separatrix that its closed form is not resolved by "
                f"{_POINTS} points of the torus; `chaplygin run` integrates it"
            )


def _is_resolved(spectrum: ComplexArray, axis: int, scale: float) -> bool:
    """Whether the highest quarter of the wave numbers along one axis is at rounding level."""
    size = spectrum.shape[0] if axis == 0 else 2 * (spectrum.shape[1] - 1)
    waves = np.abs(np.fft.fftfreq(size, 1 / size)) if axis == 0 else np.arange(size // 2 + 1)
    high = np.abs(np.take(spectrum, np.flatnonzero(waves > 3 * size // 8), axis=axis))
    return bool(np.max(high) <= 8 * _LEVEL * scale)


def _significant_series(spectrum: ComplexArray, sizes: Sequence[int], scale: float) -> Series:
    doubled = spectrum.copy()
    # The other half of the wave numbers is the complex conjugate.
    doubled[:, 1:] *= 2
    high = np.abs(doubled) > _LEVEL / 8 * scale
    rows, columns = np.flatnonzero(high.any(axis=1)), np.flatnonzero(high.any(axis=0))
    first = np.fft.fftfreq(sizes[0], 1 / sizes[0]).round().astype(int)
    second = np.arange(spectrum.shape[1])
    return Series(
        first[rows], second[columns], (doubled * high)[np.ix_(rows, columns)], (sizes[0], sizes[1])
    )


@dataclass(frozen=True)
class Quadrature:
    """∫ f dτ from τ = 0.

    Attributes
    ----------
    rate : Series
        f without its mean and its slow terms.
    whole : Series
        The integral of `rate`, up to a constant.
    origin : float
        Value of `whole` at v₀.
    slow : array (terms, 2), complex
        exp(iπ(k, v₀)) f_k and π(k, V).
    """

    mean: float
    rate: Series
    whole: Series
    origin: float
    slow: ComplexArray

    def quasi(self, v: FloatArray, tau: FloatArray) -> tuple[FloatArray, FloatArray]:
        """The integral without its drift, and its derivative in τ.

        Parameters
        ----------
        v : array (n, 2)
            The phases v₀ + Vτ, modulo 2.
        tau : array (n,)
        """
        waves = self.rate.waves(v)
        rate = _wave_sum(waves, self.rate.coefficients)
        value = _wave_sum(waves, self.whole.coefficients) - self.origin
        for coefficient, speed in self.slow:
            x = speed.real * tau
            value = value + tau * (coefficient * np.exp(0.5j * x)).real * np.sinc(x / (2 * np.pi))
            rate = rate + (coefficient * np.exp(1j * x)).real
        return value, rate


def quadrature(
    function: Series, V: Sequence[arb], v_0: FloatArray, mean: float | None = None
) -> Quadrature:
    """Integrate a function on the torus along the flow.

    Parameters
    ----------
    V : two arb
        Velocity of the phases.
    v_0 : array (2,)
        Phases at τ = 0.
    mean : float, optional
        The mean of the function, if it is known better than from the series.
    """
    speeds, phases = wave_rates(function.first, function.second, V, v_0)
    coefficients = function.coefficients.copy()
    still = (function.first[:, None] == 0) & (function.second == 0)
    own = float(coefficients[still].real.sum())
    coefficients[still] = 0
    # A bound of the error amplified by dividing by a small number.
    turn = max(abs(number(x)) for x in V)
    with np.errstate(divide="ignore", invalid="ignore"):
        divided = np.where(speeds == 0, np.inf, turn * np.abs(coefficients) / np.abs(speeds))
    # A function of rounding size contributes nothing.
    scale = np.max(np.abs(function.coefficients), initial=0.0)
    apart = ~still & (np.abs(coefficients) > 0) & (divided > _SLOW * scale)
    slow = np.array([(coefficients * phases)[apart], speeds[apart].astype(complex)]).T
    coefficients[apart] = 0
    rate = Series(function.first, function.second, coefficients, function.grid)
    safe = np.where(still | apart | (speeds == 0), 1.0, speeds)
    whole = Series(function.first, function.second, coefficients / (1j * safe), function.grid)
    return Quadrature(
        own if mean is None else mean, rate, whole, float(whole(v_0[None, :])[0]), slow
    )
