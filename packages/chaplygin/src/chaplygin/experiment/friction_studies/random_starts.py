"""Random starts of motions with friction: numbers of the file drawn from ranges."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from flowlanes.errors import InputError
from flowlanes.flow.ensembles.members import ListedMembers, Members
from flowlanes.system.arrays import FloatArray

#: Quantities drawn as directions, with their number of components.
DIRECTIONS = {"gamma": 3, "attitude": 4}

#: Lowest and highest value; None for a direction.
Range = tuple[float, float] | None


@dataclass(frozen=True, eq=False)
class DrawnMembers(ListedMembers):
    """Members with numbers drawn from ranges.

    Parameters
    ----------
    values : mapping of str to array
    sentence : str
        The ranges and the seed.
    seed : int
    """

    sentence: str = ""
    seed: int = 0

    def __str__(self) -> str:
        return self.sentence


def random_numbers(count: int, ranges: Mapping[str, Range], seed: int = 0) -> Members:
    """Members with random numbers, each uniform in its range and independent of the others.

    Member k depends only on the ranges, the seed and k.

    Parameters
    ----------
    count : int
    ranges : mapping of str to (float, float) or None
        Lowest and highest value by the name of a number of the file; None for the normal ``gamma``
        or the ``attitude`` as a whole, which is then uniform over all directions or rotations.
    seed : int

    Raises
    ------
    InputError
        If there is nothing to be drawn, or a range cannot be used.

    Examples
    --------
    >>> from chaplygin.experiment.friction_studies.random_starts import random_numbers
    >>> print(random_numbers(3, {"omega_3": (0.0, 5.0), "attitude": None}, seed=2))
    3 with omega_3 from 0 to 5 and any attitude (seed 2)
    """
    if count < 1:
        raise InputError(f"{count} starts cannot be drawn; at least one is needed")
    if not ranges:
        raise InputError("random starts: at least one range is needed")
    for name, span in ranges.items():
        if span is None and name not in DIRECTIONS:
            raise InputError(f"{name}: it needs a range; only gamma and attitude are drawn without")
        if span is not None and name in DIRECTIONS:
            raise InputError(f"{name}: it is drawn over all directions, so without a range")
        if span is not None and not (np.isfinite(span).all() and span[0] < span[1]):
            raise InputError(
                f"{name}: {span[0]:g} to {span[1]:g} is no range to draw from; it needs two finite "
                "numbers, the smaller one first"
            )
    widths = [1 if span else 2 * DIRECTIONS[name] for name, span in ranges.items()]
    uniform = np.random.default_rng(seed).random((count, sum(widths)))
    values: dict[str, FloatArray] = {}
    words = []
    first = 0
    for (name, span), width in zip(ranges.items(), widths, strict=True):
        columns = uniform[:, first : first + width]
        first += width
        if span is None:
            # normal random numbers, whose direction is uniform
            radii = np.sqrt(-2 * np.log1p(-columns[:, : width // 2]))
            values[name] = radii * np.cos(2 * np.pi * columns[:, width // 2 :])
            words.append(f"any {name}")
        else:
            values[name] = span[0] + (span[1] - span[0]) * columns[:, 0]
            words.append(f"{name} from {span[0]:g} to {span[1]:g}")
    *most, last = words
    sentence = f"{', '.join(most)} and {last}" if most else last
    return Members((DrawnMembers(values, f"{count:,} with {sentence} (seed {seed})", seed),))
