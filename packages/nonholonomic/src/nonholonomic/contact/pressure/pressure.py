r"""Coulomb's friction over a round patch of contact that slides and spins at once.

A patch of radius a slides with velocity u, spins with angular velocity Ω and is pressed with the
pressure p(ρ), in all N.  At each of its points Coulomb's law holds, so that the power lost is

    Φ(u, Ω) = μ ∫ p |u + Ω γ×ρ| dA = μ N a |Ω| φ(k),        k = |u|/(a |Ω|),

the force is −∂Φ/∂u = −μ N F(k) u/|u| and the couple about the normal −∂Φ/∂Ω = −μ N a M(k) sgn Ω,

    F = φ′,        M = φ − k φ′.

F rises from 0 to 1 and M falls from φ(0) to 0; dM = −k dF (Contensou, Erismann).
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from dataclasses import dataclass
from fractions import Fraction
from typing import final

import numpy as np
import numpy.typing as npt

from flowlanes.errors import InputError
from flowlanes.system.arrays import FloatArray

from .hypergeometric import half_beta, half_hypergeometric, series_coefficients

#: Above this k Hertz's factors are summed as series in 1/k², since the closed form loses a bit
#: there.
_HERTZ_SERIES_FROM = 1.5
_HALF = Fraction(1, 2)
_HERTZ_FORCE = [float(c) for c in series_coefficients(-_HALF, _HALF, Fraction(5, 2), 40)]
_HERTZ_COUPLE = [float(c) for c in series_coefficients(_HALF, _HALF, Fraction(7, 2), 40)]
#: Value of k² above which the same holds for uniform pressure.
_UNIFORM_COUPLE = [float(c) for c in series_coefficients(_HALF, _HALF, Fraction(3), 44)]


class CoupledFriction(ABC):
    """Force and couple of friction that depend on k = |u|/(a|Ω|), the sliding beside the spinning.

    The force is −μ N F(k) u/|u|, the couple about the normal −μ N a M(k) sgn Ω.

    Examples
    --------
    >>> from nonholonomic.contact.pressure import Hertz
    >>> Hertz().force([0.0, float("inf")]).tolist()
    [0.0, 1.0]
    """

    @abstractmethod
    def force(self, k: npt.ArrayLike) -> FloatArray:
        """The force factor F(k), from F(0) = 0 to F(∞) = 1.

        Parameters
        ----------
        k : array
            k ≥ 0, `inf` allowed.

        Returns
        -------
        array of the same shape

        Raises
        ------
        InputError
            If a k is negative or not a number.
        """

    @abstractmethod
    def couple(self, k: npt.ArrayLike) -> FloatArray:
        """The couple factor M(k), down to M(∞) = 0; as `force` otherwise."""


def checked_ratio(k: npt.ArrayLike) -> FloatArray:
    """Convert to an array and require k ≥ 0."""
    ratio = np.asarray(k, dtype=float)
    if not np.all(ratio >= 0):
        wrong = ratio[~(ratio >= 0)].flat[0]
        raise InputError(f"k = {wrong}: the ratio of sliding to spinning is at least 0")
    return ratio


def _square_and_complement(k: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """The modulus κ = min(k, 1/k), κ² and 1 − κ² without cancellation."""
    modulus = np.minimum(k, 1) / np.maximum(k, 1)
    # Above 1e9 the complement rounds to 1.
    above = np.clip(k, 1, 1e9)
    below = np.minimum(k, 1)
    complement = np.where(k <= 1, (1 - below) * (1 + below), (above - 1) / above * (1 + 1 / above))
    return modulus, modulus**2, complement


@final
@dataclass(frozen=True)
class Hertz(CoupledFriction):
    """Friction under Hertz's pressure, p = (3N/2πa²) √(1 − ρ²/a²): round elastic bodies.

    Notes
    -----
    In closed form, with α = arcsin(1/k) and s = √(k² − 1):

    * k ≤ 1: F = (3π/8) k (1 − k²/4) and M = (3π/16) (1 − k² + 3k⁴/8);
    * k ≥ 1: F = (3/16) [(4k − k³) α + (k + 2/k) s] and
      M = (3/64) [(8 − 8k² + 3k⁴) α + 3 (2 − k²) s];
    * F = ₂F₁(−½, ½; 5/2; 1/k²) and M = ₂F₁(½, ½; 7/2; 1/k²)/(5k) as series for large k, where the
      closed form cancels.

    At k = 1, F has two continuous derivatives and no third.

    Examples
    --------
    >>> from nonholonomic.contact.pressure import Hertz
    >>> Hertz().force([0.0, 0.01, 1.0, float("inf")])
    array([0.        , 0.01178068, 0.88357293, 1.        ])
    >>> float(Hertz().couple(0.0))  # 3π/16
    0.5890486225480862
    """

    def force(self, k: npt.ArrayLike) -> FloatArray:
        """F(k), exact to a few units in the last place."""
        k = checked_ratio(k)
        inner = np.minimum(k, 1)
        middle = np.clip(k, 1, _HERTZ_SERIES_FROM)
        s = np.sqrt((middle - 1) * (middle + 1))
        closed = (4 * middle - middle**3) * np.arctan2(1, s) + (middle + 2 / middle) * s
        far = np.polynomial.polynomial.polyval(_inverse_square(k), _HERTZ_FORCE)
        return _by_range(
            k, 3 * math.pi / 8 * inner * (1 - inner**2 / 4), 3 / 16 * closed, np.asarray(far)
        )

    def couple(self, k: npt.ArrayLike) -> FloatArray:
        """M(k), exact to a few units in the last place."""
        k = checked_ratio(k)
        w = (1 - np.minimum(k, 1)) * (1 + np.minimum(k, 1))
        middle = np.clip(k, 1, _HERTZ_SERIES_FROM)
        s, square = np.sqrt((middle - 1) * (middle + 1)), middle**2
        closed = (8 - 8 * square + 3 * square**2) * np.arctan2(1, s) + 3 * (2 - square) * s
        far = np.polynomial.polynomial.polyval(_inverse_square(k), _HERTZ_COUPLE)
        far = far / np.maximum(k, 1) / 5
        # 1 − k² + 3k⁴/8 as a sum of positive terms, with w = 1 − k².
        return _by_range(
            k, 3 * math.pi / 16 * (3 + 2 * w + 3 * w**2) / 8, 3 / 64 * closed, np.asarray(far)
        )


def _inverse_square(k: FloatArray) -> FloatArray:
    """1/k² where the series is used, and the threshold value below."""
    inverse: FloatArray = (1 / np.maximum(k, _HERTZ_SERIES_FROM)) ** 2
    return inverse


def _by_range(
    k: FloatArray, inner: FloatArray, middle: FloatArray, outer: FloatArray
) -> FloatArray:
    return np.where(k <= 1, inner, np.where(k < _HERTZ_SERIES_FROM, middle, outer))


@final
@dataclass(frozen=True)
class Uniform(CoupledFriction):
    """Friction under uniform pressure, p = N/(πa²): a flat disk, a curling stone.

    Notes
    -----
    With the complete elliptic integrals K, E of modulus k for k ≤ 1 and 1/k for k ≥ 1:

    * k ≤ 1: F = (4/3πk) [(1 + k²) E − (1 − k²) K] and M = (4/9π) [(4 − 2k²) E − (1 − k²) K];
    * k ≥ 1: F = (4/3π) [(k² + 1) E − (k² − 1) K] and
      M = (4k/9π) [(4 − 2k²) E + (2k² − 5 + 3/k²) K].

    They are evaluated with D = (K − E)/k² in place of K, which cancels nothing, and M by its series
    ₂F₁(½, ½; 3; 1/k²)/(4k) for k² ≥ 2.

    Examples
    --------
    >>> from nonholonomic.contact.pressure import Uniform
    >>> Uniform().couple([0.0, 0.6530017892, 1.0])
    array([0.66666667, 0.47169351, 0.28294212])
    """

    def force(self, k: npt.ArrayLike) -> FloatArray:
        """F(k), exact to a few units in the last place."""
        k = checked_ratio(k)
        E, D = _elliptic(k)
        _, _, complement = _square_and_complement(k)
        return 4 / (3 * math.pi) * (2 * E - complement * D) * np.minimum(k, 1)

    def couple(self, k: npt.ArrayLike) -> FloatArray:
        """M(k), exact to a few units in the last place."""
        k = checked_ratio(k)
        E, D = _elliptic(k)
        modulus, square, complement = _square_and_complement(k)
        inner = (3 - square) * E - square * complement * D
        outer = ((3 * square - 1) * E + complement * (2 - 3 * square) * D) * np.clip(k, 1, 2)
        far = modulus / 4 * np.polynomial.polynomial.polyval(square, _UNIFORM_COUPLE)
        closed = 4 / (9 * math.pi) * np.where(k <= 1, inner, outer)
        return np.where((k > 1) & (square <= 0.5), far, closed)


@final
@dataclass(frozen=True)
class Ring(CoupledFriction):
    """Friction over a thin ring of radius a under uniform pressure.

    Notes
    -----
    With the complete elliptic integrals K, E of modulus k for k ≤ 1:
    F = (2/πk) [E − (1 − k²) K] and M = (2/π) E; F(k) = M(1/k) and M(k) = F(1/k) for k ≥ 1.

    Examples
    --------
    >>> from nonholonomic.contact.pressure import Ring
    >>> float(Ring().force(2.0)) == float(Ring().couple(0.5))
    True
    """

    def force(self, k: npt.ArrayLike) -> FloatArray:
        """F(k), exact to a few units in the last place."""
        k = checked_ratio(k)
        lesser, greater = _ring_factors(k)
        return np.where(k <= 1, lesser, greater)

    def couple(self, k: npt.ArrayLike) -> FloatArray:
        """M(k), exact to a few units in the last place."""
        k = checked_ratio(k)
        lesser, greater = _ring_factors(k)
        return np.where(k <= 1, greater, lesser)


def _ring_factors(k: FloatArray) -> tuple[FloatArray, FloatArray]:
    """F and M of the ring at min(k, 1/k)."""
    E, D = _elliptic(k)
    modulus, _, complement = _square_and_complement(k)
    return 2 / math.pi * modulus * (E - complement * D), 2 / math.pi * E


def _elliptic(k: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Complete elliptic integrals E and D = (K − E)/κ² of modulus κ = min(k, 1/k); D(1) as 0."""
    from scipy.special import ellipe, elliprd

    _, square, complement = _square_and_complement(k)
    # D grows logarithmically towards κ = 1, but is always multiplied by 1 − κ².
    D = np.where(complement > 0, elliprd(0, np.where(complement > 0, complement, 1.0), 1) / 3, 0.0)
    return np.asarray(ellipe(square)), D


@final
@dataclass(frozen=True)
class PowerPressure(CoupledFriction):
    """Friction under the pressure p = (n + 1)N/(πa²) (1 − ρ²/a²)ⁿ.

    Parameters
    ----------
    exponent : float
        n > −1: −½ is a rigid punch, 0 uniform, ½ Hertz's pressure; n → −1 the ring.

    Raises
    ------
    InputError
        If the exponent is not a finite number above −1.

    Notes
    -----
    With φ(0) = B(½, n + 2)/2:

    * k ≤ 1: F = φ(0) (n + 3/2) k ₂F₁(½, −n − ½; 2; k²) and M = φ(0) ₂F₁(½, −n − 3/2; 1; k²);
    * k ≥ 1: F = ₂F₁(−½, ½; n + 2; 1/k²) and M = ₂F₁(½, ½; n + 3; 1/k²)/(2(n + 2)k).

    Examples
    --------
    >>> from nonholonomic.contact.pressure import PowerPressure
    >>> PowerPressure(-0.5).force([0.5, 1.0])  # πk/4
    array([0.39269908, 0.78539816])
    """

    exponent: float

    def __post_init__(self) -> None:
        if not (math.isfinite(self.exponent) and self.exponent > -1):
            raise InputError(
                f"exponent {self.exponent} of the pressure: it must be a finite number above -1"
            )

    @property
    def _couple_at_rest(self) -> float:
        return half_beta(self.exponent + 2) / 2

    def force(self, k: npt.ArrayLike) -> FloatArray:
        """F(k), exact to some 1e-15 of itself for moderate exponents."""
        k, n = checked_ratio(k), self.exponent
        slope = self._couple_at_rest * (n + 1.5)
        inner, outer = _inner_and_outer(k, (-n - 0.5, 2.0), (-0.5, n + 2))
        return np.where(k <= 1, slope * np.minimum(k, 1) * inner, outer)

    def couple(self, k: npt.ArrayLike) -> FloatArray:
        """M(k), exact to some 1e-15 of itself for moderate exponents."""
        k, n = checked_ratio(k), self.exponent
        inner, outer = _inner_and_outer(k, (-n - 1.5, 1.0), (0.5, n + 3))
        modulus, _, _ = _square_and_complement(k)
        return np.where(k <= 1, self._couple_at_rest * inner, outer * modulus / (2 * (n + 2)))


def _inner_and_outer(
    k: FloatArray, inner: tuple[float, float], outer: tuple[float, float]
) -> tuple[FloatArray, FloatArray]:
    """₂F₁(a, ½; c; κ²) with one pair (a, c) for k ≤ 1 and another for k ≥ 1."""
    _, square, complement = _square_and_complement(k)
    values = []
    for chosen, (a, c) in ((k <= 1, inner), (k > 1, outer)):
        value = np.zeros(k.shape)
        value[chosen] = half_hypergeometric(a, c, square[chosen], complement[chosen])
        values.append(value)
    return values[0], values[1]
