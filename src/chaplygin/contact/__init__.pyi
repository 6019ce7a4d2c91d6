from .friction import (
    ContensouErismann as ContensouErismann,
    ContourResistance as ContourResistance,
    Coulomb as Coulomb,
    FrictionLaw as FrictionLaw,
    NormalViscous as NormalViscous,
    RollingResistance as RollingResistance,
    SpinFriction as SpinFriction,
    Viscous as Viscous,
    ViscousRolling as ViscousRolling,
)
from .realisation.convergence import (
    Convergence as Convergence,
    convergence as convergence,
)
from .realisation.dry_limit import DryContact as DryContact
from .realisation.rolling_limit import ViscousContact as ViscousContact
from .realisation.skate import Skate as Skate
