"""Every system of the catalogue by its name, in the order of the paper."""

from __future__ import annotations

import pkgutil
import re
from importlib import import_module
from itertools import chain

from flowlanes.arguments import Setting, arguments_checked
from flowlanes.system.laws import Law
from flowlanes.system.overview import Overview, WithOverview
from flowlanes.system.system import System

from ..mechanics.rolling.equations import Rolling
from .catalogue_entry import Entry
from .fluid_laws import laws_with_fluid
from .names import lookup


def _place(item: Entry) -> tuple[int, ...]:
    """Section and subsection of the paper in which a system occurs first."""
    match = re.search(r"§(\d+)(?:\.(\d+))?", item.source)
    return tuple(int(number or 0) for number in match.groups()) if match else (99,)


def _entries() -> list[Entry]:
    package = import_module(__package__)
    found = pkgutil.walk_packages(package.__path__, f"{__package__}.")
    modules = [module.name for module in found if not module.ispkg]
    entries = [
        item
        for module in sorted(modules, key=lambda name: name.split(".")[-1])
        for item in getattr(import_module(module), "ENTRIES", ())
    ]
    return sorted(entries, key=_place)


class Catalogue(WithOverview, dict[str, Entry]):
    """The entries by name; printed, it shows the names."""

    def __getitem__(self, name: str) -> Entry:
        return lookup(self, name)

    def overview(self) -> Overview:
        """The names of the systems."""
        return Overview(f"{len(self)} systems", (("names", ", ".join(self)),))


CATALOGUE = Catalogue((item.name, item) for item in _entries())
"""Every system of the catalogue by its name, in the order of the paper."""


@arguments_checked
def entry(name: str) -> Entry:
    """The catalogue entry of a name; InputError names the nearest one if there is none.

    Parameters
    ----------
    name : str

    Returns
    -------
    Entry

    Raises
    ------
    InputError
        If there is none of that name.

    Examples
    --------
    >>> import nonholonomic
    >>> nonholonomic.catalogue.entry("suslov").source
    '§3.2'
    """
    return lookup(CATALOGUE, name)


@arguments_checked
def from_catalogue(name: str, **parameters: Setting) -> System:
    """A System of the catalogue, with some of its parameters given by symbol name.

    Parameters
    ----------
    name : str
        Such as ``"chaplygin-ball"``; :data:`~nonholonomic.CATALOGUE` has all of them.
    **parameters : float
        Values, in SI units, that replace the defaults: ``I_1=1.2``.  The systems of n dimensions
        also take ``dimension``, ``moments`` or ``mass_tensor``, and balls ``mass`` and ``radius``.

    Returns
    -------
    System
        With the laws that the paper names for it.

    Raises
    ------
    InputError
        If the catalogue has no such system, or the system no such parameter.

    Examples
    --------
    >>> import nonholonomic
    >>> ball = nonholonomic.from_catalogue("chaplygin-ball", I_1=1.2)
    >>> [law.name for law in ball.integrals]
    ['energy', 'area', 'momentum']
    """
    return entry(name).system(parameters)


@arguments_checked
def known_laws_of(rolling: Rolling, system: System) -> tuple[Law, ...]:
    """The laws that the catalogue knows of a body, whether or not it was named.

    Parameters
    ----------
    rolling : Rolling
    system : System
        Its equations.

    Returns
    -------
    tuple of Law
        Of those with one name the first.

    Raises
    ------
    InputError
        If an argument is of another type.

    Examples
    --------
    >>> import nonholonomic
    >>> rolling = nonholonomic.Rolling(
    ...     nonholonomic.Body(1.0, (0.4, 0.5, 0.6), nonholonomic.Ball(1.0))
    ... )
    >>> [law.name for law in nonholonomic.catalogue.known_laws_of(rolling, rolling.system())][:3]
    ['area', 'momentum', 'measure']
    """
    if rolling.body.fluids:
        return laws_with_fluid(rolling)
    # of those with one name the first
    laws: dict[str, Law] = {}
    for law in chain.from_iterable(item.laws(rolling, system) for item in CATALOGUE.values()):
        laws.setdefault(law.name, law)
    return tuple(laws.values())
