"""Tolerances of integration and their default values.

A tolerance is the admissible estimate of the local error of one step, relative to the size of the
state. It is not the error of the motion after a long time: local errors accumulate, and chaotic
motions amplify them.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal

#: Precision of numbers: doubles, or 30 to 34 digits.
Precision = Literal["double", "quad"]

#: Default tolerance for a single motion, which is computed to the last digits.
TOLERANCE: Mapping[Precision, float] = {"double": 1e-15, "quad": 1e-30}

#: Default tolerance for many motions: ensembles, sections, Lyapunov exponents and scans. A few
#: digits of their results matter, and two more digits would double the time.
ENSEMBLE_TOLERANCE = 1e-13

#: Smallest accepted tolerance.
FINEST_TOLERANCE: Mapping[Precision, float] = {"double": 1e-16, "quad": 1e-30}
