from .indicators import (
    FastLyapunovIndicator as FastLyapunovIndicator,
    MaximalExponent as MaximalExponent,
    Megno as Megno,
    SmallerAlignmentIndex as SmallerAlignmentIndex,
)
from .report import Spectrum as Spectrum, kaplan_yorke as kaplan_yorke
from .spectrum import lyapunov_spectrum as lyapunov_spectrum
