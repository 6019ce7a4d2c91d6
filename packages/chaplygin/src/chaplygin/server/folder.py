"""The folder of a laboratory, in which it reads experiment files and writes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from types import MappingProxyType

from flowlanes.errors import InputError
from flowlanes.parsing import nearest
from nonholonomic.catalogue import CATALOGUE

from ..experiment.files import atomic_file, check_target
from ..experiment.models.experiment import parse_experiment
from ..experiment.study import Study

#: Maximum size of an experiment file in bytes.
LARGEST = 1_000_000

#: Maximum length of a file name in bytes.
LONGEST = 200

#: Folder for the stores of charts.
STORES = "charts"


@dataclass(frozen=True)
class Folder:
    """The folder and the experiment with which a laboratory was started.

    Attributes
    ----------
    path : Path
        Nothing outside it is read or written.
    named_experiments : mapping of str to str
        Further experiments by name: the one of the command line, which may come from any file.
    """

    path: Path
    named_experiments: Mapping[str, str] = field(default_factory=lambda: MappingProxyType({}))

    def files(self) -> list[str]:
        """Names of the experiment files in the folder itself."""
        try:
            found = [place.name for place in self.path.glob("*.toml") if place.is_file()]
        except OSError:
            return []
        return sorted(name for name in found if not name.startswith("."))

    def experiment(self, what: str) -> str | None:
        """The text of an experiment; None for a name of the catalogue.

        Raises
        ------
        InputError
            If there is none of this name, or it may not be read.
        """
        if what in self.named_experiments:
            return self.named_experiments[what]
        if what in CATALOGUE:
            return None
        if Path(what).suffix != ".toml":
            raise InputError(
                f"there is no system or experiment file {what!r}{nearest(what, CATALOGUE)}"
                if len(what) < 60 and what.isprintable()
                else "there is no such system or experiment file"
            )
        place = self.inside(what)
        try:
            if not place.is_file():
                # reading a pipe would block forever
                raise InputError(f"{what} is no file in the folder of the laboratory")
            if place.stat().st_size > LARGEST:
                raise InputError(f"{what} is no experiment file: it has more than a megabyte")
            return place.read_bytes().decode("utf-8-sig")
        except (OSError, UnicodeDecodeError):
            raise InputError(f"{what} cannot be read in the folder of the laboratory") from None

    def inside(self, name: str) -> Path:
        """The path of a file in the folder.

        Raises
        ------
        InputError
            If it would be elsewhere, links followed.
        """
        try:
            place = (self.path / name).resolve()
            root = self.path.resolve()
        except (OSError, ValueError):
            raise InputError("this is no name of a file") from None
        plain = place.name == name and not name.startswith(".") and name.isprintable()
        if place.parent != root or not plain or len(name.encode()) > LONGEST:
            raise InputError(
                "the laboratory reads and writes files in its own folder alone: give a name "
                "without a path"
            )
        return place

    def save(self, name: str, experiment: str, replace: bool) -> None:
        """Write an experiment file atomically.

        Raises
        ------
        InputError
            If the name or the experiment is wrong, or a file may not be replaced.
        """
        if not name.endswith(".toml"):
            raise InputError(f"{name}: the name of an experiment file ends in .toml")
        place = self.inside(name)
        Study.from_experiment(parse_experiment(experiment, name))
        if place.exists() and not replace:
            raise InputError(f"{name} exists already: choose another name, or replace it")
        check_target(place, force=replace)
        with atomic_file(place) as temporary:
            temporary.write_text(experiment, encoding="utf-8")

    def store(self, name: str) -> Path:
        """The path of the store of a chart; its folder is created."""
        stores = self.path / STORES
        try:
            stores.mkdir(exist_ok=True)
        except OSError as problem:
            raise InputError(f"{stores} cannot be written: {problem.strerror}") from None
        store = stores / name
        if store.resolve().parent != self.path.resolve() / STORES:
            raise InputError(f"{store} leads out of the folder of the laboratory")
        return store
