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
