"""Attitude along a winding of the torus, reduced to a uniform rotation.

Let the angular velocity be a function Ω(v) on the torus (body axes, per unit of τ) while the phases
grow as v = v₀ + Vτ.  The attitude satisfies the linear equation Q′ = Q[Ω] with quasi-periodic
coefficients. Here it is brought to the form

    Q = S R(λτ) F(v),

with a constant S, the rotation R about the first axis and a triad F(v) on the torus.  The first row
of F is a vector fixed in space; it need not be a formula in the state.

After one turn of one phase the attitude is Q A(θ), where θ is the other phase, which has grown by
α.  A vector K of the body with A(θ)ᵀK(θ) = K(θ + α) is fixed in space; its Fourier coefficients are
the null vector of a matrix.  In a frame whose first vector is K, an angle φ(θ) = λT + χ(θ + α) −
χ(θ) remains, where T is the time of the turn.  All this is done in double precision: the accuracy
is observed, not proven; :attr:`FloquetReduction.residual` measures it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.linalg import solve_triangular
from scipy.spatial.transform import Rotation

from flowlanes.system.arrays import ComplexArray, FloatArray

from ..base.no_closed_form import NoClosedFormError
from .attitude import continuous_signs
from .quadrature import Series, series

#: Initial and maximum number of grid points in the phase that is not turned.
_PLACES = (64, 512)
#: Initial and maximum number of steps of one turn.
_STEPS = (128, 2048)
#: Number of steps from one stored plane to the next.
_STRIDE = 4
#: Largest accepted change of an attitude when the steps are halved.
_CONVERGENCE = 4e-14
#: Largest accepted size of the Fourier coefficients of the highest waves.
_LEVEL = 1e-14
#: Largest residual of a null vector.
_NULL = 3e-13
#: The three Gauss points of a step.
_GAUSS = 0.5 + np.sqrt(15) / 10 * np.array([-1.0, 0.0, 1.0])


@dataclass(frozen=True)
class FloquetReduction:
    """The attitude as a uniform rotation times a function on the torus.

    Attributes
    ----------
    rate : float
        λ, rad per unit of τ.
    parts : tuple of 4 Series
        The quaternion (w, x, y, z) of F; of period 2 or 4 in each phase.
    start : array (4,)
        The quaternion of S.
    residual : float
        The largest difference of A(θ)ᵀK(θ) and K(θ + α), for K of unit length.
    """

    rate: float
    parts: tuple[Series, ...]
    start: FloatArray
    residual: float

    def attitude(self, v: FloatArray, tau: FloatArray) -> FloatArray:
        """Quaternions (n, 4), body to space, continuous from the start.

        Parameters
        ----------
        v : array (n, 2)
            The phases v₀ + Vτ, modulo 4.
        tau : array (n,)
        """
        half = self.rate * tau / 2
        zero = np.zeros_like(half)
        turn = np.stack([np.cos(half), np.sin(half), zero, zero], axis=-1)
        return _product(_product(self.start, turn), self._triad(v))

    def fixed_vector(self, v: FloatArray) -> FloatArray:
        """The unit vector fixed in space, body axes, (3, n), at phases v (n, 2)."""
        triads: FloatArray = Rotation.from_quat(np.roll(self._triad(v), -1, axis=-1)).as_matrix()
        return triads[:, 0].T

    def _triad(self, v: FloatArray) -> FloatArray:
        """The quaternion of F at phases v (n, 2), (n, 4)."""
        quaternions = np.stack([part(v) for part in self.parts], axis=-1)
        lengths: FloatArray = np.linalg.norm(quaternions, axis=-1, keepdims=True)
        return quaternions / lengths


def reduction(
    turning: Callable[[FloatArray], FloatArray],
    V: Sequence[float],
    v_0: FloatArray,
    attitude: FloatArray,
) -> FloquetReduction:
    """Reduce the equation of the attitude.

    Parameters
    ----------
    turning : callable
        Phases (n, 2) ↦ Ω (3, n), the angular velocity times dt/dτ, body axes; of period 2.
    V : 2 floats
        Velocity of the phases in τ.
    v_0 : array (2,)
        Phases at τ = 0.
    attitude : 4 floats
        The quaternion at τ = 0.

    Raises
    ------
    NoClosedFormError
        If the equation does not reduce on the finest grid.
    """
    first = int(abs(V[1]) > abs(V[0]))
    speeds = (float(V[first]), float(V[1 - first]))
    # The phase that makes the turn comes first.
    waves = [f if first == 0 else f.transpose() for f in series(turning)]
    places = _PLACES[0]
    while True:
        planes = _turn_attitudes(waves, speeds, places)
        alpha = speeds[1] / abs(speeds[0])
        K, residual = _fixed_vector(planes[-1], alpha)
        if residual < _NULL:
            rate, grid = _uniform_rotation(planes, K, speeds)
            if _is_resolved(grid):
                break
        places *= 2
        if places > _PLACES[-1]:
            raise NoClosedFormError(
                "the equation of the attitude does not reduce to a uniform rotation on "
                f"{_PLACES[-1]} places around the torus"
            )
    parts = _quaternions(grid if first == 0 else grid.swapaxes(0, 1))
    motion = FloquetReduction(rate, parts, np.array([1.0, 0.0, 0.0, 0.0]), residual)
    here = motion.attitude(np.asarray(v_0, dtype=float)[None, :], np.zeros(1))[0]
    start = _product(np.asarray(attitude, dtype=float), here * np.array([1, -1, -1, -1]))
    return FloquetReduction(rate, parts, start, residual)


# --- one turn ------------------------------------------------------------------------------


def _values_along(
    f: Series, tau: FloatArray, speeds: tuple[float, float], theta: FloatArray
) -> FloatArray:
    """Values (n, places) of a function at the phases (V₁τ, θ + V₂τ)."""
    here: ComplexArray = np.exp(1j * np.pi * speeds[0] * np.outer(tau, f.first)) @ f.coefficients
    here = here * np.exp(1j * np.pi * speeds[1] * np.outer(tau, f.second))
    values: ComplexArray = here @ np.exp(1j * np.pi * np.outer(f.second, theta))
    return values.real


def _turn_attitudes(
    waves: Sequence[Series], speeds: tuple[float, float], places: int
) -> FloatArray:
    """A(θ) after fractions of a turn of the first phase: (planes + 1, places, 3, 3)."""
    steps = max(_STEPS[0], 2 * places)
    planes = _magnus_attitudes(waves, speeds, places, steps)
    while True:
        steps *= 2
        if steps > _STEPS[1]:
            raise NoClosedFormError("the attitude turns too fast to be followed around the torus")
        finer = _magnus_attitudes(waves, speeds, places, steps)
        if np.max(np.abs(finer[-1] - planes[-1])) < _CONVERGENCE:
            return finer
        planes = finer


def _magnus_attitudes(
    waves: Sequence[Series], speeds: tuple[float, float], places: int, steps: int
) -> FloatArray:
    """A(θ) along a turn, by the sixth-order Magnus method with a given number of steps."""
    theta = 2.0 * np.arange(places) / places
    h = 2.0 / abs(speeds[0]) / steps
    tau = h * np.add.outer(np.arange(steps), _GAUSS).ravel()
    turning = np.array([_values_along(f, tau, speeds, theta) for f in waves])
    # Commutators for Q′ = Q[Ω] are those for Q′ = [Ω]Q in reversed order.
    # Sixth-order Magnus integrator with three Gauss points (Blanes, Casas, Oteo & Ros, The Magnus
    # expansion and some of its applications, Physics Reports 470, 2009): with one, two, three for
    # α₁, α₂, α₃, C₁ = [α₁, α₂], C₂ = −[α₁, 2α₃ + C₁]/60 and the exponent α₁ + α₃/12 + [−20α₁ − α₃ +
    # C₁, α₂ + C₂]/240.
    early, middle, late = (turning[:, place::3] for place in range(3))
    one = h * middle
    two = np.sqrt(15) * h / 3 * (late - early)
    three = 10 * h / 3 * (late - 2 * middle + early)
    inner = -_cross(one, two)
    outer = two + _cross(one, 2 * three + inner) / 60
    angle = one + three / 12 - _cross(-20 * one - three + inner, outer) / 240
    parts = Rotation.from_rotvec(angle.reshape(3, -1).T).as_matrix()
    A = np.tile(np.eye(3), (places, 1, 1))
    products = [A]
    for step, part in enumerate(parts.reshape(steps, places, 3, 3), 1):
        A = A @ part
        if step % _STRIDE == 0:
            products.append(A)
    return np.array(products)


def _cross(u: FloatArray, v: FloatArray) -> FloatArray:
    return np.cross(u, v, axis=0)


# --- the vector fixed in space -------------------------------------------------------------


def _fixed_vector(A: FloatArray, alpha: float) -> tuple[FloatArray, float]:
    """K (places, 3) with A(θ)ᵀK(θ) = K(θ + α), and the residual of that equation."""
    places = len(A)
    # K is sought among the lower half of the wave numbers of the grid, with about twice as many
    # equations as unknowns: a small residual shows that it is resolved.
    k = np.arange(-(places // 4), places // 4 + 1)
    waves = np.exp(2j * np.pi * np.outer(np.arange(places) / places, k))
    # Columns: waves k times unit vectors; rows: components at the grid points.
    matrix = np.einsum("nji,nk->nikj", A, waves)
    moved = waves * np.exp(2j * np.pi * k * alpha)
    for i in range(3):
        matrix[:, i, :, i] -= moved
    coefficients, residual = _null_vector(matrix.reshape(3 * places, -1))
    K = np.einsum("nk,kj->nj", waves, coefficients.reshape(len(k), 3))
    # The null vector is determined up to a complex factor.  A real K exists, so the phase of any
    # component, best of the largest, makes all components real.
    largest = K.ravel()[np.argmax(np.abs(K))]
    real = (K * (np.conj(largest) / abs(largest))).real
    return real / np.linalg.norm(real, axis=1, keepdims=True), residual


def _null_vector(matrix: ComplexArray) -> tuple[ComplexArray, float]:
    """The unit vector that a tall matrix shortens most, and its image's length."""
    upper = np.linalg.qr(matrix, mode="r")
    diagonal = np.einsum("ii->i", upper)
    diagonal[diagonal == 0] = np.finfo(float).eps
    vector = np.ones(len(upper), dtype=complex)
    # Inverse iteration with MᴴM = RᴴR from the QR decomposition: per step the other components
    # shrink by the squared ratio of the smallest two singular values.
    for _ in range(4):
        vector = solve_triangular(upper, solve_triangular(upper, vector, trans="C"))
        vector /= np.linalg.norm(vector)
    return vector, float(np.linalg.norm(upper @ vector))


def _uniform_rotation(
    planes: FloatArray, K: FloatArray, speeds: tuple[float, float]
) -> tuple[float, FloatArray]:
    """λ, and F on a grid (planes, places, 3, 3) of both phases."""
    places = len(K)
    alpha = speeds[1] / abs(speeds[0])
    frame = _frame(K)
    back = frame @ planes[-1] @ _translation(frame, alpha).swapaxes(1, 2)
    angle = np.unwrap(np.arctan2(back[:, 2, 1], back[:, 1, 1]))
    # angle(θ) = λT + χ(θ + α) − χ(θ) is solved wave by wave.  The small divisors exp(2πikα) − 1
    # meet coefficients that decay geometrically; `_is_resolved` tests the result.
    spectrum = np.fft.fft(angle) / places
    k = np.fft.fftfreq(places, 1 / places)
    divisor = np.exp(2j * np.pi * k * alpha) - 1
    divisor[0] = 1
    divided = spectrum / divisor
    divided[0] = 0
    chi = (np.fft.ifft(divided) * places).real
    mean = float(spectrum[0].real)
    time = 2.0 / abs(speeds[0])
    steady = _about_first(chi) @ frame
    count = len(planes) - 1
    grid = []
    for plane in range(count):
        part = plane / count
        still = _about_first(np.full(places, -mean * part)) @ steady @ planes[plane]
        grid.append(_translation(still, -part * alpha))
    if speeds[0] < 0:
        # The planes lie at 0, −2/count, −4/count, ….
        grid = [grid[0], *grid[:0:-1]]
    return mean / time, np.array(grid)


def _frame(K: FloatArray) -> FloatArray:
    """Triads (places, 3, 3), as rows, whose first vectors are K."""
    # The reference stays as far as possible from the line of K: its projection is normalised.
    directions = _spiral_directions(200)
    closest = np.max(np.abs(K @ directions.T), axis=0)
    reference = directions[np.argmin(closest)]
    two = reference - (K @ reference)[:, None] * K
    two /= np.linalg.norm(two, axis=1, keepdims=True)
    return np.stack([K, two, np.cross(K, two)], axis=1)


def _spiral_directions(count: int) -> FloatArray:
    """Directions distributed over the sphere (count, 3), on a spiral."""
    height = (np.arange(count) + 0.5) / count * 2 - 1
    turn = np.arange(count) * np.pi * (3 - np.sqrt(5))
    radius = np.sqrt(1 - height**2)
    return np.stack([radius * np.cos(turn), radius * np.sin(turn), height], axis=1)


def _about_first(angle: FloatArray) -> FloatArray:
    """Rotations about the first axis by given angles (n,)."""
    one, zero = np.ones_like(angle), np.zeros_like(angle)
    c, s = np.cos(angle), np.sin(angle)
    rows = [[one, zero, zero], [zero, c, -s], [zero, s, c]]
    return np.moveaxis(np.array(rows), -1, 0)


def _translation(values: FloatArray, part: float) -> FloatArray:
    """A function of θ, given on its grid (places, …), at θ plus a fraction of a period."""
    spectrum = np.fft.fft(values, axis=0)
    k = np.fft.fftfreq(len(values), 1 / len(values))
    factor = np.exp(2j * np.pi * k * part)
    return np.fft.ifft(spectrum * factor.reshape(-1, *[1] * (values.ndim - 1)), axis=0).real


# --- Fourier series ------------------------------------------------------------------------


def _is_resolved(grid: FloatArray) -> bool:
    """Whether the highest quarter of the waves is at rounding level, in both phases."""
    spectrum = np.abs(np.fft.fft2(grid, axes=(0, 1))) / (grid.shape[0] * grid.shape[1])
    for axis in (0, 1):
        size = grid.shape[axis]
        k = np.abs(np.fft.fftfreq(size, 1 / size))
        if np.max(np.take(spectrum, np.flatnonzero(k > 3 * size / 8), axis=axis)) > _LEVEL:
            return False
    return True


def _quaternions(grid: FloatArray) -> tuple[Series, ...]:
    """Fourier series of the quaternions of triads on a grid (n_1, n_2, 3, 3)."""
    sizes = grid.shape[:2]
    table = Rotation.from_matrix(grid.reshape(-1, 3, 3)).as_quat().reshape(*sizes, 4)
    table = np.roll(table, 1, axis=-1)
    table[:, 0] *= continuous_signs(table[:, 0])[:, None]
    table *= np.array([continuous_signs(row) for row in table])[:, :, None]
    # If a quaternion returns with the opposite sign, its wave numbers are half-integers.
    halves = [
        0.5 if float(last @ table[0, 0]) < 0 else 0.0 for last in (table[-1, 0], table[0, -1])
    ]
    places = [2.0 * np.arange(size) / size for size in sizes]
    carrier = np.exp(-1j * np.pi * np.add.outer(halves[0] * places[0], halves[1] * places[1]))
    spectra = np.fft.fft2(table * carrier[:, :, None], axes=(0, 1)) / (sizes[0] * sizes[1])
    waves = [
        np.fft.fftfreq(size, 1 / size) + half for size, half in zip(sizes, halves, strict=True)
    ]
    high = np.max(np.abs(spectra), axis=2) > 1e-17
    rows, columns = np.flatnonzero(high.any(axis=1)), np.flatnonzero(high.any(axis=0))
    chosen = spectra[np.ix_(rows, columns)]
    return tuple(
        Series(waves[0][rows], waves[1][columns], chosen[:, :, i], (sizes[0], sizes[1]))
        for i in range(4)
    )


def _product(p: FloatArray, q: FloatArray) -> FloatArray:
    """Products of quaternions (w, x, y, z), (…, 4)."""
    a, b, c, d = np.moveaxis(p, -1, 0)
    w, x, y, z = np.moveaxis(q, -1, 0)
    return np.stack(
        [
            a * w - b * x - c * y - d * z,
            a * x + b * w + c * z - d * y,
            a * y - b * z + c * w + d * x,
            a * z + b * y - c * x + d * w,
        ],
        axis=-1,
    )
