from .grid import Axis as Axis, ScanGrid as ScanGrid, axis as axis, scan_grid as scan_grid
from .observables import (
    frequency as frequency,
    maximum as maximum,
    minimum as minimum,
    survival_time as survival_time,
    time_average as time_average,
)
from .scan_task import Scan as Scan, scan as scan
from .section_rotation import Winding as Winding
