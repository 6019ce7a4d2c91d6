from .ball import RollingBall as RollingBall
from .surface import (
    CircularCylinder as CircularCylinder,
    Cone as Cone,
    EllipsoidSurface as EllipsoidSurface,
    EllipticCylinder as EllipticCylinder,
    FlatSurface as FlatSurface,
    ImplicitSurface as ImplicitSurface,
    Paraboloid as Paraboloid,
    Ring as Ring,
    SmoothSurface as SmoothSurface,
    SphericalSurface as SphericalSurface,
)
