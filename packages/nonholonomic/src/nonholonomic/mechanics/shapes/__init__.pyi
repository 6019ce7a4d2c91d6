from .implicit import Implicit as Implicit
from .revolution import Revolution as Revolution
from .shapes import Ball as Ball, Disk as Disk, Ellipsoid as Ellipsoid, Torus as Torus
from .surfaces import Plane as Plane, Sphere as Sphere
