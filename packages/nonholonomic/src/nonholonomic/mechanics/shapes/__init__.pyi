from .implicit import ImplicitShape as ImplicitShape
from .revolution import ShapeOfRevolution as ShapeOfRevolution
from .shape_base import Shape as Shape, SupportShape as SupportShape
from .shapes import Ball as Ball, Disk as Disk, Ellipsoid as Ellipsoid, Torus as Torus
from .surfaces import Plane as Plane, Sphere as Sphere, Surface as Surface
