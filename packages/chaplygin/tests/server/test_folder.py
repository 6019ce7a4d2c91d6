"""Never a file outside the folder that a laboratory was started for."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from chaplygin.server.folder import Folder
from flowlanes.errors import InputError

EXPERIMENT = 'system = {name = "veselova"}\n'


@pytest.fixture
def folder(tmp_path: Path) -> Folder:
    home = tmp_path / "home"
    home.mkdir()
    (home / "own.toml").write_text(EXPERIMENT)
    (home / "script.py").write_text("raise SystemExit('run')")
    (home / "below").mkdir()
    (home / "below" / "other.toml").write_text(EXPERIMENT)
    (tmp_path / "secret.toml").write_text(EXPERIMENT)
    (home / "link.toml").symlink_to(tmp_path / "secret.toml")
    (home / "out").symlink_to(tmp_path)
    return Folder(home, {"given.py": EXPERIMENT})


OUTSIDE = [
    "../secret.toml",
    "link.toml",
    "out/secret.toml",
    "below/other.toml",
    "./own.toml",
    "/etc/passwd.toml",
    "..\\secret.toml",
    "own.toml\0",
    "\u202elmot.toml",
    ".hidden.toml",
    "~/x.toml",
    "a" * 5000 + ".toml",
    "..",
    "",
]


@pytest.mark.parametrize("name", OUTSIDE)
def test_nothing_outside_is_read(folder: Folder, name: str) -> None:
    with pytest.raises(InputError):
        folder.experiment(name)


@pytest.mark.parametrize("name", OUTSIDE)
def test_nothing_outside_is_written(folder: Folder, name: str) -> None:
    before = {path: path.lstat().st_mtime_ns for path in folder.path.parent.rglob("*")}
    with pytest.raises(InputError):
        folder.save(name, EXPERIMENT, replace=True)
    assert {path: path.lstat().st_mtime_ns for path in folder.path.parent.rglob("*")} == before


def test_a_python_file_is_not_read_unless_it_was_named_on_the_command_line(folder: Folder) -> None:
    with pytest.raises(InputError, match="no system or experiment file"):
        folder.experiment("script.py")
    assert folder.experiment("given.py") == EXPERIMENT
    assert folder.experiment("own.toml") == EXPERIMENT
    assert folder.experiment("veselova") is None


def test_files_of_the_folder_are_listed(folder: Folder) -> None:
    assert folder.files() == ["link.toml", "own.toml"]


def test_an_experiment_is_saved_whole_and_replaces_none_unasked(folder: Folder) -> None:
    with pytest.raises(InputError, match="exists already"):
        folder.save("own.toml", EXPERIMENT + "# new\n", replace=False)
    folder.save("own.toml", EXPERIMENT + "# new\n", replace=True)
    assert (folder.path / "own.toml").read_text().endswith("# new\n")
    with pytest.raises(InputError):
        folder.save("wrong.toml", "system = {name = 'nothing of the kind'}", replace=False)
    with pytest.raises(InputError, match=r"ends in \.toml"):
        folder.save("new.py", EXPERIMENT, replace=False)
    folder.save("new.toml", EXPERIMENT, replace=False)
    assert (folder.path / "new.toml").read_text() == EXPERIMENT
    assert not (folder.path / "wrong.toml").exists()


def test_a_store_stays_in_the_folder(folder: Folder, tmp_path: Path) -> None:
    assert folder.store("a.zarr").parent == folder.path / "charts"
    other = Folder(tmp_path)
    (tmp_path / "charts").symlink_to("/")
    with pytest.raises(InputError, match="out of the folder"):
        other.store("a.zarr")
    (folder.path / "charts" / "b.zarr").symlink_to(tmp_path)
    with pytest.raises(InputError, match="out of the folder"):
        folder.store("b.zarr")


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="this system has no pipes with names")
def test_a_pipe_is_not_waited_for(folder: Folder) -> None:
    os.mkfifo(folder.path / "pipe.toml")
    with pytest.raises(InputError, match="no file"):
        folder.experiment("pipe.toml")
