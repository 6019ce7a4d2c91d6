from .grid import Axis as Axis, ScanGrid as ScanGrid, axis as axis, scan_grid as scan_grid
from .observables import (
    Frequency as Frequency,
    Maximum as Maximum,
    Minimum as Minimum,
    SurvivalTime as SurvivalTime,
    TimeAverage as TimeAverage,
)
from .scan_task import Scan as Scan, scan as scan
from .section_rotation import Winding as Winding
