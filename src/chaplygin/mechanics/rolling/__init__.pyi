from .body import Body as Body
from .equations import Forces as Forces, Rolling as Rolling, roll as roll
from .mechanism import rolling_mechanism as rolling_mechanism
