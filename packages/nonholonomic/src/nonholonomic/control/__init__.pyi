from .accessible import Accessibility as Accessibility, accessibility as accessibility
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
from .path import (
    PlanePath as PlanePath,
    figure_of_eight as figure_of_eight,
    path_through as path_through,
)
from .plan import MotionPlan as MotionPlan
from .planner import motion_along as motion_along, motion_without_spin as motion_without_spin
from .robot import (
    MovingMass as MovingMass,
    Rotor as Rotor,
    SphericalRobot as SphericalRobot,
    pendulum as pendulum,
)
