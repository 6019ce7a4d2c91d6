from .body import Body as Body
from .cavity import Cavity as Cavity
from .equations import (
    Forces as Forces,
    RollingBody as RollingBody,
    rolling_system as rolling_system,
)
from .mechanism import rolling_mechanism as rolling_mechanism
