from .body import Body as Body
from .equations import Forces as Forces, Rolling as Rolling, roll as roll
from .implicit import Implicit as Implicit
from .mechanism import rolling_mechanism as rolling_mechanism
from .revolution import Revolution as Revolution
from .shapes import Ball as Ball, Disk as Disk, Ellipsoid as Ellipsoid, Torus as Torus
from .surfaces import Plane as Plane, Sphere as Sphere
