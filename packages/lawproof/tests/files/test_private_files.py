"""Kept files: whole or not there, and never believed where somebody else could have written."""

from __future__ import annotations

import errno
import json
import os
import stat
import subprocess
import sys
import tempfile
from dataclasses import replace
from importlib.metadata import version
from pathlib import Path
from random import Random

import pytest

from flowlanes.files import cache as core_cache, private_files, source_digest as provenance
from flowlanes.flow.machine_code import code_cache as cache
from lawproof.proof import verdict_cache as memory
from lawproof.proof.verdict import Verdict
from mutations import damaged, within

resource = pytest.importorskip("resource", reason="users of their own are those of POSIX")

CONTENT = b"some content"
PROVEN = Verdict("energy", "proven", finding="zero", effort=3)


@pytest.fixture(autouse=True)
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A cache of the test's own."""
    chosen = tmp_path / "cache"
    monkeypatch.setenv("FLOWLANES_CACHE", str(chosen))
    monkeypatch.setattr(cache, "_file_version", lambda path: object())
    private_files._warn_once.cache_clear()
    return chosen


@pytest.fixture
def kept(place: Path) -> Path:
    path = place / "inner" / "name"
    assert private_files.write_private(path, CONTENT)
    return path


def both(name: str) -> tuple[bool, bool]:
    """Whether a verdict and a piece of code are found after they were kept."""
    memory.store_verdict(name, PROVEN)
    cache.cached_entry(name, lambda: (b"code", 1))
    return memory.load_verdict(name) == PROVEN, cache.cached_entry(name, lambda: (b"new", 2))[1]


def test_what_is_written_is_read(kept: Path) -> None:
    assert private_files.read_private(kept) == CONTENT
    assert private_files.read_private(kept.with_name("other")) is None
    assert private_files.read_private(kept.parent / "nowhere" / "name") is None
    assert [path.name for path in kept.parent.iterdir()] == ["name"]


@pytest.mark.parametrize("umask", [0o000, 0o002, 0o022, 0o077])
def test_folders_are_this_users_alone_whatever_the_usual_permissions(
    tmp_path: Path, umask: int
) -> None:
    before = os.umask(umask)
    try:
        path = tmp_path / "a" / "b" / "c" / "name"
        assert private_files.write_private(path, CONTENT)
    finally:
        os.umask(before)
    for part in (path.parent, path.parent.parent, path.parent.parent.parent):
        assert stat.S_IMODE(part.stat().st_mode) == 0o700
    assert stat.S_IMODE(path.stat().st_mode) == 0o600
    assert private_files.read_private(path) == CONTENT


@pytest.mark.parametrize("mode", [0o720, 0o702, 0o777])
@pytest.mark.parametrize("above", [0, 1])
def test_a_folder_that_others_can_write_does_not_count(
    kept: Path, mode: int, above: int, caplog: pytest.LogCaptureFixture
) -> None:
    """Nor one beneath it, since who can write above can put another one in its place."""
    part = [kept.parent, kept.parent.parent][above]
    part.chmod(mode)
    assert private_files.read_private(kept) is None
    assert private_files.read_private(kept) is None
    assert not private_files.write_private(kept.with_name("more"), CONTENT)
    (record,) = caplog.records
    assert f"others can write to {part} (chmod go-w mends it)" in record.getMessage()
    part.chmod(0o700)
    assert private_files.read_private(kept) == CONTENT
    assert not kept.with_name("more").exists()


def test_the_sticky_bit_protects_what_is_in_a_shared_folder_but_not_in_ones_own(
    kept: Path,
) -> None:
    kept.parent.parent.chmod(0o1777)
    assert private_files.read_private(kept) == CONTENT
    kept.parent.chmod(0o1777)
    assert private_files.read_private(kept) is None


@pytest.mark.parametrize("mode", [0o620, 0o602, 0o666])
def test_a_file_that_others_can_write_does_not_count(kept: Path, mode: int) -> None:
    kept.chmod(mode)
    assert private_files.read_private(kept) is None


@pytest.mark.parametrize("whose", ["all", "file"])
def test_what_is_anothers_does_not_count(
    kept: Path, whose: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The folders are another user's, or the file alone is."""
    ours = os.geteuid()
    if whose == "all":
        monkeypatch.setattr(os, "geteuid", lambda: ours + 1)
    else:
        look = os.fstat

        def foreign(handle: int) -> os.stat_result:
            found = list(look(handle))
            found[stat.ST_UID] = ours + 1
            return os.stat_result(found)

        monkeypatch.setattr(os, "fstat", foreign)
    assert private_files.read_private(kept) is None


@pytest.mark.skipif(
    sys.platform == "win32" or os.geteuid() != 0, reason="only root can give files away"
)
@pytest.mark.parametrize("which", ["name", "inner", "cache"])
def test_what_was_given_away_does_not_count(kept: Path, which: str) -> None:
    part = next(p for p in (kept, *kept.parents) if p.name == which)
    os.chown(part, 12345, 12345)
    assert private_files.read_private(kept) is None


def test_a_link_to_a_folder_counts_as_what_it_leads_to(kept: Path, tmp_path: Path) -> None:
    link = tmp_path / "link"
    link.symlink_to(kept.parent)
    assert private_files.read_private(link / "name") == CONTENT
    kept.parent.chmod(0o777)
    assert private_files.read_private(link / "name") is None


@pytest.mark.parametrize("what", ["link", "pipe", "folder", "loop"])
def test_what_is_no_plain_file_does_not_count(kept: Path, what: str) -> None:
    path = kept.with_name("strange")
    if what == "link":
        path.symlink_to(kept)
    elif what == "pipe":
        os.mkfifo(path, 0o600)
    elif what == "folder":
        path.mkdir()
    else:
        path.symlink_to(path)
    with within(5):
        assert private_files.read_private(path) is None


def test_a_renamed_file_does_not_count(kept: Path) -> None:
    other = kept.rename(kept.with_name("other"))
    assert private_files.read_private(other) is None


def test_no_damage_is_read(kept: Path) -> None:
    whole = kept.read_bytes()
    random = Random(7)
    for _ in range(500):
        content = damaged(whole, random)
        kept.write_bytes(content)
        assert private_files.read_private(kept) == (CONTENT if content == whole else None)


def test_an_altered_verdict_is_no_proof(place: Path) -> None:
    memory.store_verdict("law", replace(PROVEN, decision="undecided", reason="too large"))
    (path,) = place.iterdir()
    text = path.read_text()
    path.write_text(text.replace("undecided", "proven"))
    assert path.read_text() != text
    assert memory.load_verdict("law") is None
    path.write_text(json.dumps({"law": "energy", "decision": "proven"}))
    assert memory.load_verdict("law") is None


def test_a_verdict_of_one_law_is_not_taken_for_another(place: Path) -> None:
    memory.store_verdict("one", PROVEN)
    (path,) = place.iterdir()
    path.rename(path.with_name("other.json"))
    assert memory.load_verdict("other") is None
    memory.store_verdict("other", PROVEN)
    assert memory.load_verdict("other") == PROVEN


def test_a_verdict_of_another_version_is_not_there(place: Path) -> None:
    """One with a field that this version does not know, or without one that it needs."""
    for content in ({"law": "x", "decision": "proven", "mood": 1}, {"law": "x"}, [1], "x", None):
        private_files.write_private(place / "name.json", json.dumps(content).encode())
        assert memory.load_verdict("name") is None


def test_code_of_another_version_is_compiled_again(place: Path) -> None:
    """A pickle of something that is not there any more."""
    gone = b"\x80\x04\x8c\x10chaplygin.no_one\x8c\x04gone\x93."
    private_files.write_private(place / "name.code", gone)
    assert cache.cached_entry("name", lambda: "made anew") == ("made anew", False)
    assert cache.cached_entry("name", lambda: "not made") == ("made anew", True)


def test_another_version_of_a_library_makes_other_names(monkeypatch: pytest.MonkeyPatch) -> None:
    code, verdict = cache.code_name("x"), core_cache.entry_name("x")
    for library in core_cache.LIBRARIES:

        def changed(name: str, library: str = library) -> str:
            return "0.0" if name == library else version(name)

        core_cache._versions.cache_clear()
        monkeypatch.setattr(core_cache, "version", changed)
        assert cache.code_name("x") != code
        assert core_cache.entry_name("x") != verdict
    monkeypatch.setattr(core_cache, "version", version)
    core_cache._versions.cache_clear()
    assert cache.code_name("x") == code


def test_where_one_text_ends_and_the_next_begins_counts() -> None:
    texts = [("a", "b"), ("ab",), ("ab", ""), ("b", "a")]
    assert len({core_cache.entry_name(*parts) for parts in texts}) == len(texts)


def test_code_goes_by_the_machine_and_verdicts_do_not(monkeypatch: pytest.MonkeyPatch) -> None:
    code, verdict = cache.code_name("x"), core_cache.entry_name("x")
    monkeypatch.setattr(cache, "_machine", lambda: "another one")
    assert cache.code_name("x") != code
    assert core_cache.entry_name("x") == verdict


WRITER = """
import sys
from flowlanes.files.cache import folder
from flowlanes.flow.machine_code import code_cache as cache
from lawproof.proof import verdict_cache as memory
from lawproof.proof.verdict import Verdict
cache._file_version = lambda path: object()
for turn in range(60):
    name = f"name{turn % 3}"
    value = (name.encode() * 40_000, turn % 3)
    made, found = cache.cached_entry(name, lambda: value)
    assert made == value, turn
    verdict = Verdict(name, "proven", finding=name * 20_000, effort=1)
    memory.store_verdict(name, verdict)
    kept = memory.load_verdict(name)
    assert kept == verdict, turn
    if turn % 7 == 0:
        (folder() / f"{name}.code").unlink(missing_ok=True)
"""


@pytest.mark.slow
def test_six_processes_write_at_once(place: Path) -> None:
    """Each finds what it kept, whole, whoever wrote it last; nothing is left behind."""
    processes = [
        subprocess.Popen([sys.executable, "-c", WRITER], stderr=subprocess.PIPE, text=True)
        for _ in range(6)
    ]
    for process in processes:
        _, said = process.communicate(timeout=120)
        assert process.returncode == 0, said
    names = {path.name for path in place.iterdir()}
    verdicts = {f"name{k}.json" for k in range(3)}
    assert verdicts <= names <= verdicts | {f"name{k}.code" for k in range(3)}


def test_on_a_full_disk_nothing_is_kept_and_nothing_left(place: Path) -> None:
    """No file may grow beyond a few bytes, which a write runs into as into a full disk."""
    both("before")
    before = sorted(path.name for path in place.rglob("*"))
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (10, limits[1]))
    try:
        found = both("after")
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
    assert found == (False, False)
    assert sorted(path.name for path in place.rglob("*")) == before
    assert both("after") == (True, True)


def test_a_disk_that_fills_while_a_file_is_closed(
    place: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(source: Path, target: Path) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(Path, "replace", refuse)
    assert both("name") == (False, False)
    assert [path for path in place.rglob("*") if path.is_file()] == []


READER = """
import os
from flowlanes.flow.machine_code import code_cache as cache
from lawproof.proof import verdict_cache as memory
from lawproof.proof.verdict import Verdict
if os.geteuid() == 0:  # to whom permissions mean nothing
    os.setgid(12345)
    os.setuid(12345)
memory.store_verdict("name", Verdict("law", "proven"))
made, found = cache.cached_entry("name", lambda: "made")
print(made, found, memory.load_verdict("name"))
"""


@pytest.mark.slow
@pytest.mark.parametrize("home", ["read-only", "missing", "a file"])
def test_on_a_read_only_home_nothing_is_kept_and_nothing_said(tmp_path: Path, home: str) -> None:
    place = tmp_path / "home"
    if home == "a file":
        place.write_text("")
    elif home == "read-only":
        place.mkdir(mode=0o555)
    where = place if home != "missing" else Path("/proc/nowhere")
    environment = {k: v for k, v in os.environ.items() if not k.startswith(("XDG_", "CHAPLYGIN"))}
    done = subprocess.run(
        [sys.executable, "-c", READER],
        env=environment | {"HOME": str(where)},
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    assert (done.stdout, done.stderr) == ("made False None\n", "")


def test_what_was_kept_is_used_on_a_home_that_is_read_only_since(
    place: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert both("name") == (True, True)

    def refuse(*_: object, **__: object) -> None:
        raise OSError(errno.EROFS, "Read-only file system")

    monkeypatch.setattr(Path, "touch", refuse)
    monkeypatch.setattr(tempfile, "NamedTemporaryFile", refuse)
    assert both("name") == (True, True)


def test_links_to_nowhere_among_the_modules_do_no_harm(tmp_path: Path) -> None:
    """Editors leave them beside a file that is being changed."""
    (tmp_path / "one.py").write_text("x = 1\n")
    before = provenance.module_digests(tmp_path)
    (tmp_path / ".#one.py").symlink_to("user@host.1234")
    assert provenance.module_digests(tmp_path) == before
    (tmp_path / "one.py").write_text("x = 2\n")
    assert provenance.module_digests(tmp_path) != before
