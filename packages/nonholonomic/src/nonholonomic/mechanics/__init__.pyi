from . import (
    ball as ball,
    constraints as constraints,
    lagrangian as lagrangian,
    reduction as reduction,
    rolling as rolling,
    shapes as shapes,
    sympy_models as sympy_models,
)
