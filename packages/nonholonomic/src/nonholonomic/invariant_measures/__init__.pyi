from .equilibria import (
    EquilibriumObstruction as EquilibriumObstruction,
    equilibrium_obstruction as equilibrium_obstruction,
)
from .existence import measure_exists as measure_exists
