from .arnold_tongues import locked_interval as locked_interval, staircase as staircase
from .continuation import Branch as Branch, continue_orbit as continue_orbit
from .floquet import Multipliers as Multipliers, multipliers as multipliers
from .high_precision import refine_orbit as refine_orbit
from .limit_cycles import enclose_limit_cycle as enclose_limit_cycle
from .periodic import NoOrbitError as NoOrbitError, Orbit as Orbit, find_periodic as find_periodic
from .return_map import Circle as Circle, ReturnMap as ReturnMap
from .reversor import Reversor as Reversor, reversing_symmetries as reversing_symmetries
from .rotation import Rotation as Rotation, rotation_number as rotation_number
