from .equations.situation import FrictionalContact as FrictionalContact
from .friction.air_film import AirFilm as AirFilm
from .friction.dry_friction import (
    ContensouErismann as ContensouErismann,
    Coulomb as Coulomb,
    SpinFriction as SpinFriction,
)
from .friction.friction_law import FrictionLaw as FrictionLaw
from .friction.modes import MODE_NAMES as MODE_NAMES
from .friction.rolling_friction import (
    ContourResistance as ContourResistance,
    RollingResistance as RollingResistance,
    ViscousRolling as ViscousRolling,
)
from .friction.user_friction import UserFriction as UserFriction
from .friction.viscous_friction import (
    NormalViscous as NormalViscous,
    PowerFriction as PowerFriction,
    Viscous as Viscous,
)
from .impact.painleve import least_painleve_friction_of_body as least_painleve_friction_of_body
from .motion import ContactMotion as ContactMotion, contact_motion as contact_motion
from .rolling_limit.convergence import Convergence as Convergence, convergence as convergence
from .rolling_limit.dry_limit import DryContact as DryContact
from .rolling_limit.rolling_limit import ViscousContact as ViscousContact
from .rolling_limit.skate import Skate as Skate
from .simulation.compiled import CompiledContact as CompiledContact
from .simulation.event_rules import EventRules as EventRules
from .simulation.events import ContactEvent as ContactEvent
