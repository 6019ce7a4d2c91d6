from .mechanism import (
    Frame as Frame,
    Mechanism as Mechanism,
    coordinates as coordinates,
    euclidean as euclidean,
)
from .plan import Plan as Plan
from .poincare_suslov import equations_of_motion as equations_of_motion
