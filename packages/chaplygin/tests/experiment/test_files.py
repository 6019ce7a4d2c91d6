"""Files: what may be written, and what stays as it was."""

from __future__ import annotations

import os
import stat
from pathlib import Path

import pytest

from chaplygin import load_experiment
from chaplygin.experiment.files import atomic_file, check_target
from chaplygin.report.study_folder import begin, check_folder, end
from flowlanes.errors import InputError
from flowlanes.files import partial_files


def filled(target: Path, text: str = "new") -> None:
    check_target(target, force=True)
    with atomic_file(target) as place:
        place.write_text(text)


def refused(target: Path, words: str, force: bool = True) -> None:
    with pytest.raises(InputError) as error:
        check_target(target, force)
    assert words in str(error.value)
    assert "\n" not in str(error.value)


@pytest.mark.parametrize("name", ["con.toml", "NUL", "Com1.nc", "aux .tar.gz"])
def test_names_of_devices_are_refused_on_windows(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / name).write_text('system = {name = "veselova"}')
    load_experiment(tmp_path / name)
    check_target(tmp_path / name, force=True)
    monkeypatch.setattr(partial_files, "WINDOWS", True)
    check_target(tmp_path / "console.toml")
    refused(tmp_path / name, "is the name of a device on Windows")
    with pytest.raises(InputError, match="is the name of a device on Windows"):
        load_experiment(tmp_path / name)


def test_only_regular_files_are_replaced(tmp_path: Path) -> None:
    refused(Path("/dev/null"), "/dev/null is a device: the name of a regular file is needed")
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    refused(pipe, "is a pipe")
    refused(tmp_path, "is a folder")
    (tmp_path / "loop").symlink_to(tmp_path / "loop")
    refused(tmp_path / "loop", "cannot be written")
    (tmp_path / "null").symlink_to("/dev/null")
    refused(tmp_path / "null", "is a device")
    with pytest.raises(InputError, match="is a pipe"), atomic_file(pipe) as place:
        place.write_text("new")
    assert stat.S_ISFIFO(pipe.stat().st_mode)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["loop", "null", "pipe"]


def test_a_file_behind_a_link_is_replaced_and_the_link_stays(tmp_path: Path) -> None:
    (tmp_path / "elsewhere").mkdir()
    file, link = tmp_path / "elsewhere" / "motion.nc", tmp_path / "motion.nc"
    file.write_text("old")
    link.symlink_to(file)
    refused(link, "exists already", force=False)
    filled(link)
    assert link.is_symlink()
    assert file.read_text() == "new"
    file.unlink()
    refused(link, "is a link to a file that is not there")


def test_a_read_only_file_stays(tmp_path: Path) -> None:
    file = tmp_path / "motion.nc"
    file.write_text("old")
    file.chmod(0o444)
    refused(file, "is read-only and is not replaced")
    with pytest.raises(InputError, match="read-only"), atomic_file(file) as place:
        place.write_text("new")
    assert file.read_text() == "old"
    assert list(tmp_path.iterdir()) == [file]


def test_a_file_that_is_replaced_hands_on_its_permissions(tmp_path: Path) -> None:
    file = tmp_path / "secret.nc"
    file.write_text("old")
    file.chmod(0o600)
    filled(file)
    assert stat.S_IMODE(file.stat().st_mode) == 0o600


def test_a_long_name_is_no_obstacle(tmp_path: Path) -> None:
    file = tmp_path / ("n" * 252 + ".nc")
    filled(file)
    assert file.read_text() == "new"


def test_a_folder_of_something_else_is_no_place_for_a_study(tmp_path: Path) -> None:
    check_folder(tmp_path)
    check_folder(tmp_path / "new")
    (tmp_path / "experiment.toml").write_text("mine")
    with pytest.raises(InputError, match=r"holds experiment\.toml already"):
        check_folder(tmp_path)
    with pytest.raises(InputError, match="is the experiment file itself"):
        check_folder(tmp_path, force=True, what=str(tmp_path / "experiment.toml"))
    check_folder(tmp_path, force=True)
    os.mkfifo(tmp_path / "report.html")
    with pytest.raises(InputError, match="is a pipe"):
        check_folder(tmp_path, force=True)


def test_an_unfinished_study_goes_on_and_no_other_takes_its_place(tmp_path: Path) -> None:
    folder = tmp_path / "study"
    begin(folder, "mine", force=False)
    (folder / "trajectory.nc").write_text("")
    check_folder(folder)
    begin(folder, "mine", force=False)
    with pytest.raises(InputError, match="an unfinished study of another experiment"):
        begin(folder, "other", force=False)
    begin(folder, "other", force=True)
    end(folder)
    with pytest.raises(InputError, match=r"holds trajectory\.nc, figures already"):
        check_folder(folder)
