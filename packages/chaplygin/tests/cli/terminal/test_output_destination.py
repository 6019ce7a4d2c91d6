"""What commands write and where, and mistakes that are told before anything is computed."""

from __future__ import annotations

import io
import json
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
import xarray as xr

from borisov_mamaev_2008.audit import TITLES
from chaplygin.cli import audit, bifurcation, main
from chaplygin.cli.terminal import option_table
from chaplygin.experiment.dataset import open_dataset
from chaplygin.experiment.poincare import DIRECTIONS
from nonholonomic.closed_form.bifurcation.families import PLANES

Ask = Callable[..., tuple[int, str, str]]

PROGRAM = "from chaplygin.__main__ import main; main()"


@pytest.fixture
def ask(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path) -> Ask:
    """Run a command in an empty folder; exit code, standard output, standard error."""
    monkeypatch.chdir(tmp_path)

    def run(*arguments: object) -> tuple[int, str, str]:
        monkeypatch.setattr(sys, "argv", ["chaplygin", *map(str, arguments)])
        with pytest.raises(SystemExit) as end:
            main()
        output = capsys.readouterr()
        return int(end.value.code or 0), output.out, output.err

    return run


def program(*arguments: str, folder: Path, script: str = PROGRAM) -> subprocess.Popen[bytes]:
    return subprocess.Popen(
        [sys.executable, "-c", script, *arguments],
        cwd=folder,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        env={name: value for name, value in os.environ.items() if name != "COLUMNS"},
    )


@pytest.mark.slow
def test_a_dash_is_standard_output(tmp_path: Path) -> None:
    run = program("run", "chaplygin-sleigh", "-o", "-", folder=tmp_path)
    out, err = run.communicate()
    assert run.returncode == 0
    assert "energy" in xr.open_dataset(io.BytesIO(out), engine="h5netcdf")
    assert b"drift" in err
    proof = program(
        *("prove", "chaplygin-sleigh", "--law", "energy", "--certificate", "-"), folder=tmp_path
    )
    out, err = proof.communicate()
    assert json.loads(out)
    assert b"proven" in err
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (
            ("run", "veselova", "-o", "-", "--json"),
            "--output - and --json both write",
        ),
        (("study", "veselova", "-o", "-"), "a study is a folder; it cannot go to standard output"),
        (("section", "veselova", "--on", "gamma_3", "-o", "-"), "a store is a folder"),
        (("solve", "veselova", "--figure", "-"), "--figure -: its name must end in .png"),
        (("run", "veselova", "-o", "/dev/null", "--force"), "/dev/null is a device"),
        (("audit", "-o", "/dev/full", "--force"), "/dev/full is a device"),
        (("prove", "veselova", "--certificate", "/dev/null", "--force"), "is a device"),
        (("solve", "veselova", "--figure", "pipe.png", "--force"), "pipe.png is a pipe"),
        (
            (
                "chart",
                "veselova",
                *("--of", "energy", "--x", "a=0:1:2", "--y", "b=0:1:2"),
                *("-o", "pipe.zarr"),
            ),
            "pipe.zarr is no store of a computation in blocks",
        ),
        (("ensemble", "veselova", "-o", "pipe.zarr", "--force"), "pipe.zarr is no store"),
        (
            ("ensemble", "veselova", "-o", "lost.zarr", "--force"),
            "lost.zarr is a link to a file that is not there",
        ),
        (
            ("section", "veselova", "--on", "gamma_3", "-o", "round.zarr"),
            "round.zarr cannot be written: Too many levels of symbolic links",
        ),
    ],
)
def test_what_cannot_be_written_is_refused(
    ask: Ask, tmp_path: Path, arguments: tuple[str, ...], sentence: str
) -> None:
    for name in ("pipe.png", "pipe.zarr"):
        os.mkfifo(tmp_path / name)
    for name, leads_to in (("lost.zarr", "nowhere"), ("round.zarr", "round.zarr")):
        (tmp_path / name).symlink_to(leads_to)
    code, out, err = ask(*arguments)
    assert (code, out, err.count("\n")) == (2, "", 1)
    assert sentence in err
    assert sorted(path.name for path in tmp_path.iterdir()) == [
        *("lost.zarr", "pipe.png", "pipe.zarr", "round.zarr"),
    ]


def test_a_store_behind_a_link_is_not_removed(ask: Ask, tmp_path: Path) -> None:
    asked = ("ensemble", "veselova", "--set", "run.until=0.1", "-o")
    assert ask(*asked, "own.zarr")[0] == 0
    (tmp_path / "link.zarr").symlink_to(tmp_path / "own.zarr")
    code, _, err = ask(*asked, "link.zarr", "--force")
    assert code == 2
    assert "link.zarr is a link: give the name of the store itself" in err
    assert (tmp_path / "own.zarr" / "zarr.json").exists()


def own_store(path: Path) -> bytes:
    """A trajectory of the user's at this place; something of its content."""
    xr.Dataset({"x": ("time", [1.0, 2.0])}, attrs={"events": "[]"}).to_zarr(path, zarr_format=2)
    return (path / ".zmetadata").read_bytes()


def test_trajectories_do_not_replace_what_is_behind_a_link_or_no_store(
    ask: Ask, tmp_path: Path
) -> None:
    """It was told after the run, with the words of rmtree."""
    before = own_store(tmp_path / "own.zarr")
    (tmp_path / "link.zarr").symlink_to("own.zarr")
    (tmp_path / "file.zarr").write_text("mine")
    for name, sentence in (
        ("link.zarr", "link.zarr is a link: give the name of the store itself"),
        ("file.zarr", "file.zarr is a file: a Zarr store is a folder; choose another name"),
    ):
        for force in ((), ("--force",)):
            for command in (("run", "chaplygin-sleigh"), ("solve", "veselova", "--at", "1")):
                assert ask(*command, "-o", name, *force) == (2, "", f"error: {sentence}\n")
    assert (tmp_path / "own.zarr" / ".zmetadata").read_bytes() == before
    assert (tmp_path / "file.zarr").read_text() == "mine"


def test_a_read_only_store_is_not_replaced(ask: Ask, tmp_path: Path) -> None:
    store = tmp_path / "own.zarr"
    before = own_store(store)
    store.chmod(0o555)
    try:
        code, out, err = ask("run", "chaplygin-sleigh", "-o", "own.zarr", "--force")
        assert (code, out, err.count("\n")) == (2, "", 1)
        assert "own.zarr is read-only and is not replaced" in err
        assert (store / ".zmetadata").read_bytes() == before
    finally:
        store.chmod(0o755)


def test_a_study_is_not_written_behind_a_link_that_leads_nowhere(ask: Ask, tmp_path: Path) -> None:
    (tmp_path / "lost").symlink_to("nowhere")
    code, out, err = ask("study", "chaplygin-sleigh", "-o", "lost", "--force")
    assert (code, out) == (2, "")
    assert err == "error: lost is a link to a folder that is not there: choose another name\n"


@pytest.mark.slow
def test_a_picture_that_was_named_is_not_replaced_unasked(ask: Ask, tmp_path: Path) -> None:
    asked = (
        *("chart", "chaplygin-sleigh", "--of", "mean:energy", "--until", "0.1"),
        *("--x", "I=0.5:1:2", "--y", "u=1:2:2", "-o", "c.zarr"),
    )
    code, _, err = ask(*asked)
    assert code == 0, err
    assert ask(*asked)[0] == 0
    (tmp_path / "mine.png").write_text("mine")
    code, _, err = ask(*asked, "--figure", "mine.png")
    assert code == 2
    assert "mine.png exists already" in err
    assert (tmp_path / "mine.png").read_text() == "mine"


@pytest.mark.slow
@pytest.mark.parametrize(
    "arguments",
    [
        ("run", "veselova", "-o", "there.nc"),
        ("run", "nowhere.toml", "-o", "new.nc"),
        ("study", "veselova", "-o", "there.nc"),
        ("lyapunov", "veselova", "-o", "there.nc"),
        ("lyapunov", "veselova", "--until", "-1"),
        ("solve", "veselova", "-o", "there.nc"),
        ("solve", "veselova", "--figure", "x.gif"),
        ("show", "veselova", "--as", "fortran"),
        ("prove", "veselova", "--certificate", "there.nc"),
        ("audit", "--section", "77"),
        ("audit", "-o", "there.nc"),
        ("section", "veselova", "--on", "gamma_3", "-o", "there.nc"),
        ("ensemble", "veselova", "-o", "there.nc"),
        ("ensemble", "veselova", "-o", "x.zarr", "--workers", "0"),
        ("chart", "veselova", "--of", "n", "--x", "x", "--y", "y", "-o", "there.nc"),
        ("find", "something", "veselova"),
        ("run", "no-such-system", "-o", "new.nc"),
        ("find", "integrals", "no-such-system"),
        ("bifurcation", "no-such-system"),
        ("prove", "no-such-system"),
        ("lab", "no-such-system"),
        ("lab", "--port", "99999"),
        ("list", "--contact", "glue"),
        ("lyapunov", "veselova", "--tolerance", "0"),
        ("orbit", "veselova", "--on", "gamma_3", "--tolerance", "nan"),
        ("orbit", "veselova", "--on", "gamma_3", "--direction", "up"),
        ("section", "veselova", "--on", "gamma_3", "-o", "x.zarr", "--points", "0"),
        ("section", "veselova", "--on", "gamma_3", "-o", "x.zarr", "--starts", "0"),
        ("section", "veselova", "--on", "gamma_3", "-o", "full.zarr"),
        ("chart", "veselova", "--of", "n", "--x", "x=0:1", "--y", "y=0:1:2", "-o", "x.zarr"),
        ("sweep", "veselova", "--over", "I_1", "-o", "x.zarr"),
        ("sweep", "veselova", "--over", "I_1=0:1:0", "-o", "x.zarr"),
        ("ensemble", "veselova", "--over", "I_1=1,2", "-o", "x.zarr"),
    ],
)
def test_mistakes_that_cost_nothing_are_told_before_anything_heavy_is_imported(
    tmp_path: Path, arguments: tuple[str, ...]
) -> None:
    (tmp_path / "there.nc").write_text("mine")
    (tmp_path / "full.zarr").mkdir()
    (tmp_path / "full.zarr" / "mine").touch()
    heavy = "{'sympy', 'numpy', 'xarray', 'heyoka', 'matplotlib', 'scipy', 'zarr'}"
    script = (
        "import sys\nfrom chaplygin.__main__ import main\n"
        f"try: main()\nfinally: print(sorted({heavy} & set(sys.modules)))"
    )
    run = program(*arguments, folder=tmp_path, script=script)
    out, err = run.communicate()
    assert run.returncode == 2
    assert err.startswith(b"error: ")
    assert out.decode().strip() == "[]"
    assert (tmp_path / "there.nc").read_text() == "mine"


@pytest.mark.parametrize(
    ("text", "heavy"),
    [
        ('[system]\nnam = "veselova"\n', "sympy"),
        (
            "[body]\nmass = 1.0\ninertia = [1.0, 1.5, 2.1]\n"
            '[body.shape]\nkind = "ball"\nradius = 1.0\n'
            "[start]\ngamma = [0, 0, 1]\nomegaa = [1, 2, 0]\n",
            "sympy",
        ),
        (
            "[body]\nmass = -1.0\ninertia = [1.0, 1.5, 9.1]\n"
            '[body.shape]\nkind = "ball"\nradius = 1.0\n'
            "[start]\ngamma = [0, 0, 1]\nomega = [1, 2, 0]\n",
            "sympy",
        ),
        (
            "[body]\nmass = 1.0\ninertia = [1.0, 1.5, 2.1]\n"
            '[body.shape]\nkind = "revolution"\nsupport = "sqrt(gamma_4)"\n'
            "[start]\ngamma = [0, 0, 1]\nomega = [1, 2, 0]\n",
            "llvmlite",
        ),
    ],
    ids=["misspelt key", "misspelt key of a body", "wrong values", "formula"],
)
def test_mistakes_in_files_are_told_before_anything_heavy_is_imported(
    tmp_path: Path, text: str, heavy: str
) -> None:
    (tmp_path / "mine.toml").write_text(text)
    script = (
        "import sys\nfrom chaplygin.__main__ import main\n"
        "try: main()\nfinally: print(sorted({'llvmlite', 'heyoka', 'xarray', 'matplotlib', "
        f"'scipy', '{heavy}'}} & set(sys.modules)))"
    )
    run = program("run", "mine.toml", "-o", "new.nc", folder=tmp_path, script=script)
    out, err = run.communicate()
    assert (run.returncode, err[:7]) == (2, b"error: ")
    assert out.decode().strip() == "[]"


@pytest.mark.parametrize(
    "arguments",
    [
        ("rattleback", "--set", "I_1=-1"),
        pytest.param(("rattleback", "--set", "system.parameters.s=0"), marks=pytest.mark.slow),
        pytest.param(("snakeboard", "--set", "m=0"), marks=pytest.mark.slow),
        pytest.param(("suslov-nd", "--set", "dimension=40"), marks=pytest.mark.slow),
    ],
)
def test_parameters_are_refused_before_what_integrates_is_imported(
    tmp_path: Path, arguments: tuple[str, ...]
) -> None:
    script = (
        "import sys\nfrom chaplygin.__main__ import main\n"
        "try: main()\nfinally: print(sorted({'llvmlite', 'heyoka', 'xarray', 'matplotlib', "
        "'scipy', 'pandas'} & set(sys.modules)))"
    )
    run = program("run", *arguments, "-o", "new.nc", folder=tmp_path, script=script)
    out, err = run.communicate()
    assert (run.returncode, err[:7]) == (2, b"error: ")
    assert out.decode().strip() == "[]"


#: Ends a command where it first says what it does; prints that, and what was imported before.
FIRST_WORDS = """
import sys
from chaplygin.__main__ import main
from chaplygin.cli.terminal import progress
class First:
    def __init__(self, task):
        heavy = {'sympy', 'numpy', 'xarray', 'heyoka', 'matplotlib', 'scipy', 'zarr'}
        print(task, sorted(heavy & set(sys.modules)))
        raise SystemExit(0)
progress._Log = progress._Bar = First
sys.stderr.isatty = lambda: True
main()
"""


@pytest.mark.parametrize(
    "arguments",
    [
        ("show", "veselova", "--again"),
        ("run", "veselova", "-o", "x.nc"),
        ("study", "trailers"),
        ("solve", "veselova"),
        ("find", "integrals", "veselova"),
        ("prove", "veselova", "--again"),
        ("ensemble", "veselova", "--over", "I_1=1:2:2", "-o", "x.zarr"),
        ("sweep", "veselova", "--over", "I_1=1:2:2", "-o", "x.zarr"),
        ("section", "veselova", "--on", "gamma_3", "-o", "x.zarr"),
        ("orbit", "veselova", "--on", "gamma_3"),
        ("bifurcation", "veselova"),
        ("bifurcation", "bruns"),
        ("lyapunov", "veselova"),
        ("chart", "veselova", "--of", "n", "--x", "x=0:1:2", "--y", "y=0:1:2", "-o", "x.zarr"),
        ("animate", "veselova", "-o", "x.gif"),
        ("audit",),
    ],
)
def test_a_command_says_what_it_does_before_anything_heavy_is_imported(
    tmp_path: Path, arguments: tuple[str, ...]
) -> None:
    out, err = program(*arguments, folder=tmp_path, script=FIRST_WORDS).communicate()
    assert out.decode().endswith(" []\n"), err.decode()


def test_the_choices_of_options_are_those_of_what_computes() -> None:
    assert tuple(DIRECTIONS) == option_table.WORDS["direction"]
    assert tuple(PLANES) == bifurcation.PLANES


def test_the_sections_of_the_audit_are_those_of_the_paper() -> None:
    assert list(audit.SECTIONS) == list(TITLES)


@pytest.mark.slow
def test_a_reader_that_leaves_is_no_failure(tmp_path: Path) -> None:
    for arguments in (("list",), ("list", "--json"), ("show", "chaplygin-sleigh")):
        with program(*arguments, folder=tmp_path) as run:
            assert run.stdout is not None
            assert run.stderr is not None
            run.stdout.close()
            err = run.stderr.read()
        assert (run.returncode, err) == (0, b"")


@pytest.mark.slow
def test_tables_are_not_cut_in_a_pipe(tmp_path: Path) -> None:
    out, _ = program("list", folder=tmp_path).communicate()
    (line,) = (line for line in out.decode().splitlines() if "rubber-ball-on-surface " in line)
    assert max(map(len, out.decode().splitlines())) > 80
    assert "§" in line or "(" in line


#: A ball with its centre of mass above its centre, spun so fast that it would leap.
TOP_HEAVY = """
[body]
mass = 1.0
inertia = [0.4, 0.45, 0.5]
shape = { kind = "ball", radius = 1.0, centre = [0.0, 0.0, -0.3] }
[surface]
kind = "plane"
[contact]
model = "marble"
[field]
gravity = 9.81
[start]
omega = [20.0, 0.0, 0.0]
gamma = [0.0, 0.0, 1.0]
[run]
until = 0.2
"""


@pytest.mark.slow
def test_a_start_that_the_surface_cannot_hold_is_refused(ask: Ask, tmp_path: Path) -> None:
    (tmp_path / "top.toml").write_text(TOP_HEAVY)
    code, out, err = ask("run", "top.toml", "-o", "top.nc")
    assert (code, out) == (2, "")
    assert "top.toml, line 12, start: there is no motion from here: the normal force is" in err
    assert 'on_liftoff = "warn" in [run]' in err
    assert not (tmp_path / "top.nc").exists()
    code, _, err = ask("run", "top.toml", "-o", "top.nc", "--set", "run.on_liftoff=warn")
    assert code == 0, err
    assert len(open_dataset("top.nc").time) > 1


@pytest.mark.slow
def test_a_file_gives_its_system_a_name(ask: Ask, tmp_path: Path) -> None:
    egg = Path(__file__).parents[5] / "examples" / "egg.toml"
    code, out, _ = ask("run", egg, "-o", "egg.nc", "--set", "run.until=0.1", "--json")
    assert code == 0
    assert json.loads(out)["system"] == "rubber-egg"
