from .existence import measure_exists as measure_exists
