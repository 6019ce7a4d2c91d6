from . import (
    classification as classification,
    lyapunov as lyapunov,
    orbits as orbits,
    scans as scans,
)
