from .attractor_dimension import kaplan_yorke as kaplan_yorke
from .indicators import (
    fast_lyapunov_indicator as fast_lyapunov_indicator,
    maximal_exponent as maximal_exponent,
    megno as megno,
    smaller_alignment_index as smaller_alignment_index,
)
from .report import Spectrum as Spectrum
from .spectrum import lyapunov_spectrum as lyapunov_spectrum
