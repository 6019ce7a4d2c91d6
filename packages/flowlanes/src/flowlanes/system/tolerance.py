"""The tolerance of an integration: one meaning, and its values by default.

A tolerance is the estimated local error that is allowed in one step, relative to the size of the
state.  It is not the error of the motion after a long time: the errors of the steps add up, and
a chaotic motion multiplies them.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal

#: Of numbers: doubles, or numbers of 30 to 34 digits.
Precision = Literal["double", "quad"]

#: By default of a single motion, which is computed to the last digits.
TOLERANCE: Mapping[Precision, float] = {"double": 1e-15, "quad": 1e-30}

#: By default of many motions: ensembles, sections, Lyapunov exponents and scans.  Their figures are
#: read to a few digits, and the last two cost as much time again.
ENSEMBLE_TOLERANCE = 1e-13

#: The finest that is accepted.  Motions through many events have it by default, since an event
#: passes an error on magnified.
FINEST_TOLERANCE: Mapping[Precision, float] = {"double": 1e-16, "quad": 1e-30}
