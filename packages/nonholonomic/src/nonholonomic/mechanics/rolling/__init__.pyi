from .body import Body as Body
from .cavity import Cavity as Cavity
from .equations import Forces as Forces, Rolling as Rolling, roll as roll
from .mechanism import rolling_mechanism as rolling_mechanism
