"""The meanings that the restitution of an impact may have."""

from typing import Literal

ImpactLaw = Literal["stronge", "poisson", "newton"]
