from .compiled import CompiledContact as CompiledContact
from .dry_friction import (
    ContensouErismann as ContensouErismann,
    Coulomb as Coulomb,
    SpinFriction as SpinFriction,
)
from .events import ContactEvent as ContactEvent
from .friction_law import FrictionLaw as FrictionLaw
from .modes import MODE_NAMES as MODE_NAMES
from .motion import ContactMotion as ContactMotion, contact_motion as contact_motion
from .realisation.convergence import (
    Convergence as Convergence,
    convergence as convergence,
)
from .realisation.dry_limit import DryContact as DryContact
from .realisation.rolling_limit import ViscousContact as ViscousContact
from .realisation.skate import Skate as Skate
from .rolling_friction import (
    ContourResistance as ContourResistance,
    RollingResistance as RollingResistance,
    ViscousRolling as ViscousRolling,
)
from .rules import Rules as Rules
from .situation import FrictionalContact as FrictionalContact
from .starts import start_in_contact as start_in_contact, start_in_space as start_in_space
from .user_friction import UserFriction as UserFriction
from .viscous_friction import (
    NormalViscous as NormalViscous,
    PowerFriction as PowerFriction,
    Viscous as Viscous,
)
