"""The definitions of the coefficient of restitution."""

from typing import Literal

ImpactLaw = Literal["stronge", "poisson", "newton"]
