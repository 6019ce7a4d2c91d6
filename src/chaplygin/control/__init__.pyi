from .controllable import (
    Controllability as Controllability,
    controllability as controllability,
    growth_vector as growth_vector,
)
from .controlled import ControlledSystem as ControlledSystem
from .equations import (
    controlled_system as controlled_system,
    driftless_system as driftless_system,
    driven_system as driven_system,
)
from .robot import (
    MovingMass as MovingMass,
    Rotor as Rotor,
    SphericalRobot as SphericalRobot,
    pendulum as pendulum,
)
