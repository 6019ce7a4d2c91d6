from .body import Body as Body
from .equations import Forces as Forces, Rolling as Rolling, roll as roll
from .mechanism import rolling_mechanism as rolling_mechanism
from .shapes import (
    Ball as Ball,
    Disk as Disk,
    Ellipsoid as Ellipsoid,
    Implicit as Implicit,
    Revolution as Revolution,
    Torus as Torus,
)
from .surfaces import Plane as Plane, Sphere as Sphere
