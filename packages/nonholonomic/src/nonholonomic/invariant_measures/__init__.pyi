from .equilibria import (
    EquilibriumObstruction as EquilibriumObstruction,
    equilibrium_obstruction as equilibrium_obstruction,
)
from .existence import invariant_measure as invariant_measure
