"""Functions with a memory of their last results."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache, wraps
from typing import ParamSpec, TypeVar

P = ParamSpec("P")
T = TypeVar("T")


def memory(size: int) -> Callable[[Callable[P, T]], Callable[P, T]]:
    """Decorator that keeps the last results of a function without side effects.

    With arguments that cannot be hashed, such as systems with lists or matrices that may change,
    or with keyword arguments, the function is called every time.

    Parameters
    ----------
    size : int
        Number of results that are kept.

    Examples
    --------
    >>> calls = []
    >>> @memory(4)
    ... def length(items):
    ...     calls.append(items)
    ...     return len(items)
    >>> length((1, 2)), length((1, 2)), length([1]), length([1])
    (2, 2, 1, 1)
    >>> calls
    [(1, 2), [1], [1]]
    """

    def decorator(function: Callable[P, T]) -> Callable[P, T]:
        results = lru_cache(maxsize=size)(function)

        @wraps(function)
        def wrapper(*arguments: P.args, **keywords: P.kwargs) -> T:
            if keywords or not _can_be_hashed(arguments):
                return function(*arguments, **keywords)
            return results(*arguments)

        return wrapper

    return decorator


def _can_be_hashed(value: object) -> bool:
    try:
        hash(value)
    except TypeError:
        return False
    return True
