from .attractor_dimension import kaplan_yorke as kaplan_yorke
from .indicators import (
    FastLyapunovIndicator as FastLyapunovIndicator,
    MaximalExponent as MaximalExponent,
    Megno as Megno,
    SmallerAlignmentIndex as SmallerAlignmentIndex,
)
from .report import Spectrum as Spectrum
from .spectrum import lyapunov_spectrum as lyapunov_spectrum
