"""Every system of the catalogue by its name, in the order of the paper."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, MutableMapping
from importlib import import_module
from itertools import chain
from typing import TYPE_CHECKING, Any

from flowlanes.arguments import Setting, arguments_checked
from flowlanes.system.overview import Overview, WithOverview

from .entry_files import EntryFile, entry_file, entry_files
from .names import lookup

if TYPE_CHECKING:
    from flowlanes.system.laws import Law
    from flowlanes.system.system import System

    from ..mechanics.rolling.equations import RollingBody
    from .catalogue_entry import Entry


def entry_of(file: EntryFile) -> Entry:
    """The entry of a file with equations, a Lagrangian or a body, or of a Python module.

    Names and titles need no SymPy, equations no mechanics, and a body no Lagrangian; all of them
    take time to import.
    """
    if file.python:
        entries = import_module(f".{file.python}", __package__).ENTRIES
        found: Entry = next(item for item in entries if item.name == file.name)
        return found
    if "body" in file.tables:
        from ..system_files.bodies import is_ball_file

        if is_ball_file(file.tables):
            from .ball_entries import entry_of_ball

            return entry_of_ball(file)
        from .body_entries import body_entry

        return body_entry(file)
    if "lagrangian" in file.tables:
        from .mechanism_systems import mechanism_entry

        return mechanism_entry(file)
    from .file_systems import equations_entry

    return equations_entry(file)


class Catalogue(WithOverview, MutableMapping[str, "Entry"]):
    """The entries by name, each made when it is first asked for; printed, it shows the names."""

    def __init__(self) -> None:
        self._entries: dict[str, Entry | None] = {file.name: None for file in entry_files()}

    def __getitem__(self, name: str) -> Entry:
        found = lookup(self._entries, name)
        if found is None:
            found = self._entries[name] = entry_of(entry_file(name))
        return found

    def __setitem__(self, name: str, item: Entry) -> None:
        self._entries[name] = item

    def __delitem__(self, name: str) -> None:
        del self._entries[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._entries)

    def __len__(self) -> int:
        return len(self._entries)

    def __contains__(self, name: object) -> bool:
        return name in self._entries

    @property
    def titles(self) -> dict[str, str]:
        """The titles by name, for which no system is made."""
        return {
            name: entry_file(name).title if item is None else item.title
            for name, item in self._entries.items()
        }

    def overview(self) -> Overview:
        """The names of the systems."""
        return Overview(f"{len(self)} systems", (("names", ", ".join(self)),))


CATALOGUE = Catalogue()
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


def catalogue_system(name: str, parameters: Mapping[str, Any]) -> System:
    """A system of the catalogue, onto which an isomorphism may lead.

    Raises
    ------
    InputError
        If there is none of that name, or it has no such parameter.
    """
    return lookup(CATALOGUE, name).system(parameters)


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
def known_laws_of(rolling: RollingBody, system: System) -> tuple[Law, ...]:
    """The laws that the catalogue knows of a body, whether or not it was named.

    Parameters
    ----------
    rolling : RollingBody
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
    >>> rolling = nonholonomic.RollingBody(
    ...     nonholonomic.Body(1.0, (0.4, 0.5, 0.6), nonholonomic.Ball(1.0))
    ... )
    >>> [law.name for law in nonholonomic.catalogue.known_laws_of(rolling, rolling.system())][:3]
    ['area', 'momentum', 'measure']
    """
    from .fluid_laws import laws_with_fluid

    if rolling.body.fluids:
        return laws_with_fluid(rolling)
    # of those with one name the first
    laws: dict[str, Law] = {}
    files = ((name, entry_file(name)) for name in CATALOGUE)
    items = (CATALOGUE[name] for name, file in files if file.python or file.laws)
    for law in chain.from_iterable(item.laws(rolling, system) for item in items):
        laws.setdefault(law.name, law)
    return tuple(laws.values())
