from .isomorphism import Isomorphism as Isomorphism
from .laws import (
    ConformallyHamiltonian as ConformallyHamiltonian,
    Identity as Identity,
    Integral as Integral,
    Law as Law,
    Measure as Measure,
    PoissonStructure as PoissonStructure,
    Rate as Rate,
    Reduction as Reduction,
    Separation as Separation,
    Symmetry as Symmetry,
)
from .system import (
    Conventions as Conventions,
    Guard as Guard,
    Observable as Observable,
    Parameter as Parameter,
    System as System,
    VariablesByName as VariablesByName,
)
from .vector_operators import unit_vector as unit_vector
from .vectors import (
    Diagonal as Diagonal,
    Vector as Vector,
    constant as constant,
    cross as cross,
    dot as dot,
    norm_squared as norm_squared,
    real_symbol as real_symbol,
    to_components as to_components,
)
