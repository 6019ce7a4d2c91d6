"""The folder of a study: new, or that of an interrupted study."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path

from flowlanes.errors import InputError
from flowlanes.files.partial_files import write_lock

from ..experiment.files import atomic_file, check_target

FILES = ("report.html", "trajectory.nc", "experiment.toml", "figures")

#: File with the experiment of an unfinished study.
MARK = ".unfinished.toml"
#: File with its trajectory, once that is complete.
TRAJECTORY = ".unfinished.npz"


def check_folder(folder: Path, force: bool = False, what: str = "") -> None:
    """Raise InputError if a study can certainly not be written to `folder`.

    Parameters
    ----------
    folder : Path
    force : bool
        Whether files of a study may be replaced.
    what : str
        The file of the experiment, which is never replaced.
    """
    if folder.exists() and not folder.is_dir():
        raise InputError(f"{folder} is a file: a study is written to a folder")
    if folder.is_symlink() and not folder.exists():
        raise InputError(f"{folder} is a link to a folder that is not there: choose another name")
    present = [name for name in FILES if (folder / name).exists()]
    if present and not (force or is_begun(folder)):
        raise InputError(
            f"{folder} holds {', '.join(present)} already: choose another folder, or --force to "
            "replace them"
        )
    for name in present:
        target = folder / name
        if name == "figures":
            if not target.is_dir():
                raise InputError(f"{target} is a file: figures are written to a folder")
            continue
        if what and Path(what).exists() and target.samefile(what):
            raise InputError(f"{target} is the experiment file itself: choose another folder")
        check_target(target, force=True)


def is_begun(folder: Path) -> bool:
    """Whether the folder holds an interrupted study."""
    return (folder / MARK).is_file()


@contextmanager
def being_written(folder: Path) -> Iterator[None]:
    """A context in which no other process writes to the folder, which is created if necessary.

    Raises
    ------
    InputError
        If the folder cannot be written, or another process is writing to it.
    """
    with ExitStack() as stack:
        try:
            folder.mkdir(parents=True, exist_ok=True)
            stack.enter_context(write_lock(folder, inside=True))
        except OSError as problem:
            raise InputError(f"{folder} cannot be written: {problem.strerror}") from problem
        yield


def begin(folder: Path, experiment: str, force: bool) -> None:
    """Create the folder, and mark it as that of an unfinished study.

    Parameters
    ----------
    folder : Path
    experiment : str
        Text of the complete experiment file, by which the study is recognised.
    force : bool
        Whether an unfinished study of another experiment may be replaced.

    Raises
    ------
    InputError
        If the folder cannot be written, or holds an unfinished study of another experiment.
    """
    mark = folder / MARK
    try:
        if is_begun(folder) and not force and mark.read_text(encoding="utf-8") != experiment:
            raise InputError(
                f"{folder} holds an unfinished study of another experiment: choose another "
                "folder, or --force to replace it"
            )
        (folder / "figures").mkdir(parents=True, exist_ok=True)
    except OSError as problem:
        raise InputError(f"{folder} cannot be written: {problem.strerror}") from problem
    with atomic_file(mark) as temporary:
        temporary.write_text(experiment, encoding="utf-8")


def end(folder: Path) -> None:
    """Mark the study in the folder as complete."""
    (folder / TRAJECTORY).unlink(missing_ok=True)
    (folder / MARK).unlink(missing_ok=True)
