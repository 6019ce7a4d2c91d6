from ..shapes.implicit import Implicit as Implicit
from ..shapes.revolution import Revolution as Revolution
from ..shapes.shapes import Ball as Ball, Disk as Disk, Ellipsoid as Ellipsoid, Torus as Torus
from ..shapes.surfaces import Plane as Plane, Sphere as Sphere
from .body import Body as Body
from .equations import Forces as Forces, Rolling as Rolling, roll as roll
from .mechanism import rolling_mechanism as rolling_mechanism
