"""Names of systems: the one that is meant, or the nearest there is."""

from __future__ import annotations

import difflib
from collections.abc import Mapping
from typing import TypeVar

from flowlanes.errors import InputError

Item = TypeVar("Item")


class UnknownSystemError(InputError, KeyError):
    """A name that no system of the catalogue has; a KeyError too, as of any mapping."""


def lookup(catalogue: Mapping[str, Item], name: object) -> Item:
    """The entry of that name, or an InputError that suggests the nearest one."""
    if not isinstance(name, str):
        raise UnknownSystemError(
            f"a system of the catalogue is asked for by its name in quotes, not by {name!r}"
        )
    if name not in catalogue:
        close = difflib.get_close_matches(name, list(catalogue), n=1)
        nearest = f" (did you mean {close[0]!r}?)" if close else ""
        raise UnknownSystemError(
            f"no system {name!r} in the catalogue{nearest}; "
            "`chaplygin list` and `nonholonomic.CATALOGUE` show all of them"
        )
    return catalogue[name]
