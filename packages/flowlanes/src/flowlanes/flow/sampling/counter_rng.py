"""Counter-based random numbers, which depend only on seed, member, attempt and slot.

Philox 4x32 with ten rounds (Salmon, Moraes, Dror & Shaw, "Parallel random numbers: as easy as 1,
2, 3", SC 2011) maps a counter to four random words, for whole arrays of counters at once.  With a
generator that has internal state, member k would depend on the members drawn before it.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from ...errors import InputError
from ...system.arrays import FloatArray, IntArray

_MULTIPLIERS = (np.uint64(0xD2511F53), np.uint64(0xCD9E8D57))
_WEYL = (0x9E3779B9, 0xBB67AE85)
_WORD = np.uint64(0xFFFFFFFF)
_HALF = np.uint64(32)
_ROUNDS = 10


def philox(
    key: tuple[int, int], counter: tuple[npt.ArrayLike, npt.ArrayLike, npt.ArrayLike, npt.ArrayLike]
) -> tuple[
    npt.NDArray[np.uint64], npt.NDArray[np.uint64], npt.NDArray[np.uint64], npt.NDArray[np.uint64]
]:
    """Four random 32-bit words, as uint64, from a key and arrays of 32-bit counters."""
    a, b, c, d = (np.asarray(word, dtype=np.uint64) for word in counter)
    for turn in range(_ROUNDS):
        first, second = (
            np.uint64((part + turn * step) & 0xFFFFFFFF)
            for part, step in zip(key, _WEYL, strict=True)
        )
        left, right = _MULTIPLIERS[0] * a, _MULTIPLIERS[1] * c
        a, b = (right >> _HALF) ^ b ^ first, right & _WORD
        c, d = (left >> _HALF) ^ d ^ second, left & _WORD
    return a, b, c, d


def uniforms(
    seed: int, members: npt.NDArray[np.integer], attempts: IntArray | FloatArray, many: int
) -> FloatArray:
    """Uniform random numbers in (0, 1), of 53 bits.

    Parameters
    ----------
    seed : int
        From 0 to 2⁶⁴ − 1.
    members, attempts : int arrays (k,)
        Members for which the numbers are drawn, and their attempts.
    many : int
        Number of values for each member.

    Returns
    -------
    array (many, k)

    Raises
    ------
    InputError
        If the seed is out of range.
    """
    if not 0 <= seed < 2**64:
        raise InputError(f"seed {seed}: it must be a whole number from 0 to 2**64 - 1")
    key = (seed & 0xFFFFFFFF, seed >> 32)
    member = np.asarray(members, dtype=np.uint64)
    attempt = np.asarray(attempts, dtype=np.uint64)
    rows: list[FloatArray] = []
    for slot in range((many + 1) // 2):
        words = philox(key, (slot, attempt & _WORD, member & _WORD, member >> _HALF))
        rows += [_fraction(*words[:2]), _fraction(*words[2:])]
    return np.array(rows[:many]).reshape(many, member.size)


def counter_normals(
    seed: int, members: npt.NDArray[np.integer], attempts: IntArray | FloatArray, many: int
) -> FloatArray:
    """Standard normal random numbers, array (many, k); see `uniforms`."""
    flat = uniforms(seed, members, attempts, many + many % 2)
    radius = np.sqrt(-2 * np.log(flat[0::2]))
    turn = 2 * np.pi * flat[1::2]
    pairs = np.concatenate([radius * np.cos(turn), radius * np.sin(turn)])
    return pairs[:many]


def _fraction(high: npt.NDArray[np.uint64], low: npt.NDArray[np.uint64]) -> FloatArray:
    bits = ((high >> np.uint64(5)) << np.uint64(26)) | (low >> np.uint64(6))
    return (bits.astype(float) + 0.5) * 2.0**-53
