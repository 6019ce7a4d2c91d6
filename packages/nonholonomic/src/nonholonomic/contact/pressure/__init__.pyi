from .elliptic_patch import EllipticHertz as EllipticHertz
from .pressure import (
    CoupledFriction as CoupledFriction,
    Hertz as Hertz,
    PowerPressure as PowerPressure,
    Ring as Ring,
    Uniform as Uniform,
)
from .pressure_approximations import (
    best_constants as best_constants,
    ellipsoid_law as ellipsoid_law,
    greatest_errors as greatest_errors,
    zhuravlev_first_order as zhuravlev_first_order,
    zhuravlev_second_order as zhuravlev_second_order,
)
