from .computation import compute as compute
from .members import (
    from_lists as from_lists,
    grid as grid,
    random_starts as random_starts,
    single as single,
)
from .run import ensemble as ensemble
from .task import IncompleteError as IncompleteError, Task as Task, Variable as Variable
