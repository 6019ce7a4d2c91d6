"""Integration methods by name, for :func:`flowlanes.flow.integrator.integrate`."""

from __future__ import annotations

from collections.abc import Mapping

from ..errors import InputError
from .collocation import Collocation
from .integration_method import IntegrationMethod, MotionRequest
from .taylor_trajectory import TaylorSeries

_METHODS: dict[str, IntegrationMethod] = {
    method.name: method for method in (TaylorSeries(), Collocation())
}


def register(method: IntegrationMethod) -> None:
    """Make a method available under its name.

    Raises
    ------
    InputError
        If another method has this name.
    """
    known = _METHODS.setdefault(method.name, method)
    if type(known) is not type(method):
        raise InputError(f"there are two integration methods with the name {method.name!r}")


def methods() -> Mapping[str, IntegrationMethod]:
    """All methods by name, in the order in which they were registered."""
    return dict(_METHODS)


def method_named(name: str) -> IntegrationMethod:
    """Method with a given name.

    Raises
    ------
    InputError
        If there is no such method.
    """
    if name not in _METHODS:
        raise InputError(f"method {name!r}: it must be {' or '.join(map(repr, _METHODS))}")
    return _METHODS[name]


def require_options(method: IntegrationMethod, request: MotionRequest) -> None:
    """Raise InputError if a request has an option that a method does not support."""
    asked = {
        "tolerance": request.tolerance is not None,
        "time_limit": request.time_limit is not None,
        "dense": request.dense,
    }
    for option, given in asked.items():
        if given and option not in method.options:
            others = [repr(name) for name, other in _METHODS.items() if option in other.options]
            raise InputError(
                f"{option}: method {method.name!r} has none; use method {' or '.join(others)}"
            )
