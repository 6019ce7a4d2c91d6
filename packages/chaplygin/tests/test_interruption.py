"""Ctrl-C, whatever the program is doing."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from chaplygin.interruption import interruptible, message_on_interrupt

#: Ctrl-C may be ignored where tests are run in the background, and would be in the program too.
HEARING = "import signal; signal.signal(signal.SIGINT, signal.default_int_handler)\n"
BEGIN = f"""{HEARING}
import hashlib, sys, time
from chaplygin.interruption import interruptible, message_on_interrupt
from chaplygin.interruption import print_interruption, results_on_interrupt

def ready():
    print("ready", flush=True)

def machine_code(count):
    # machine code that lets Python act on nothing until it is done
    hashlib.pbkdf2_hmac("sha256", b"", b"", count)

with interruptible():
"""
LONG = 2 * 10**9


def interrupted(
    script: str, times: int = 1, sent: signal.Signals = signal.SIGINT
) -> tuple[int, str, str, float]:
    """Exit code, outputs and seconds after Ctrl-C, given when the script says it is ready."""
    program = subprocess.Popen(
        [sys.executable, "-c", script],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    assert program.stdout is not None
    first = program.stdout.readline()
    assert first == "ready\n"
    time.sleep(0.1)
    began = time.monotonic()
    for number in range(times):
        if number:
            time.sleep(1.5)
        program.send_signal(sent)
    out, err = program.communicate(timeout=60)
    return program.returncode, out, err, time.monotonic() - began


def block(text: str) -> str:
    return BEGIN + "".join(f"    {line}\n" for line in text.strip().splitlines())


def test_machine_code_does_not_hold_up_the_end() -> None:
    script = block(f"""
with message_on_interrupt(lambda: "half of it is kept"):
    ready()
    machine_code({LONG})
""")
    code, _, err, seconds = interrupted(script)
    assert (code, err) == (130, "interrupted: half of it is kept\n")
    # alone it would take minutes
    assert seconds < 10


@pytest.mark.parametrize("work", ["time.sleep(60)", f"machine_code({LONG})"])
def test_an_end_from_outside_is_in_order_too(work: str) -> None:
    script = block(f"""
try:
    with message_on_interrupt(lambda: "half of it is kept"):
        ready()
        {work}
finally:
    print("removed", flush=True)
""")
    # where Ctrl-C is ignored, as in what a script starts in the background
    script = script.replace(HEARING, "import signal; signal.signal(2, signal.SIG_IGN)\n")
    code, out, err, seconds = interrupted(script, sent=signal.SIGTERM)
    assert (code, err) == (143, "interrupted: half of it is kept\n")
    assert out == "removed\n" or "machine" in work
    assert seconds < 10


def test_nothing_half_written_stays_where_machine_code_is_given_up(tmp_path: Path) -> None:
    script = block(f"""
from flowlanes.files.partial_files import write_lock, partial_file, partial_folder
from pathlib import Path
place = Path({str(tmp_path)!r})
with write_lock(place / "a.zarr"), partial_folder(place), partial_file(place):
    print(len(list(place.iterdir())), file=sys.stderr)
    ready()
    machine_code({LONG})
""")
    code, _, err, _ = interrupted(script)
    assert (code, err[0]) == (130, "3")
    assert list(tmp_path.iterdir()) == []


def test_what_says_nothing_has_saved_nothing() -> None:
    code, _, err, _ = interrupted(block("ready()\ntime.sleep(60)"))
    assert (code, err) == (
        130,
        "interrupted: nothing was saved; the same command starts from the beginning\n",
    )


def test_each_command_says_it_where_ctrl_c_is_ignored(
    capsys: pytest.CaptureFixture[str],
) -> None:
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        for words in ("a third is kept", "a half is kept"):
            with pytest.raises(KeyboardInterrupt), interruptible(), message_on_interrupt(words):
                raise KeyboardInterrupt
            assert capsys.readouterr().err == f"interrupted: {words}\n"
    finally:
        signal.signal(signal.SIGINT, before)


def test_what_is_saved_is_waited_for() -> None:
    script = block("""
with message_on_interrupt("nothing was written", "the rest is being saved"):
    try:
        ready()
        time.sleep(60)
    except KeyboardInterrupt:
        time.sleep(2)
        print("saved")
print_interruption("all of it was saved")
sys.exit(130)
""")
    code, out, err, _ = interrupted(script)
    assert code == 130
    assert out == "saved\n"
    assert err == (
        "interrupted: the rest is being saved; Ctrl-C again ends at once\n"
        "interrupted: all of it was saved\n"
    )


@pytest.mark.slow
def test_results_that_machine_code_holds_up_are_printed() -> None:
    script = block("""
with results_on_interrupt("the results are about to be printed"):
    ready()
    try:
        machine_code(4_000_000)
        time.sleep(60)
    except KeyboardInterrupt:
        print("results")
sys.exit(130)
""")
    code, out, _, _ = interrupted(script)
    assert (code, out) == (130, "results\n")


def test_an_error_that_hides_the_interruption_is_none() -> None:
    script = block("""
try:
    ready()
    time.sleep(60)
except KeyboardInterrupt:
    raise SystemError("returned a result with an exception set")
""")
    code, _, err, _ = interrupted(script)
    assert code == 130
    assert err == "interrupted: nothing was saved; the same command starts from the beginning\n"


def test_what_cannot_raise_an_interruption_shows_no_traceback() -> None:
    script = block("""
class Lost:
    def __del__(self):
        ready()
        time.sleep(60)
Lost()
time.sleep(60)
""")
    code, _, err, _ = interrupted(script)
    assert code == 130
    assert err == "interrupted: nothing was saved; the same command starts from the beginning\n"


def test_the_exit_code_is_130_as_a_module_too(tmp_path: Path) -> None:
    """It was −2 where a string was being executed, as dataclasses do."""
    (tmp_path / "long.py").write_text(block("""exec("ready(); time.sleep(60)")"""))
    script = f"import os, sys; os.chdir({str(tmp_path)!r})\n"
    script += 'os.execv(sys.executable, [sys.executable, "-m", "long"])'
    code, _, err, _ = interrupted(script)
    assert code == 130
    assert err == "interrupted: nothing was saved; the same command starts from the beginning\n"


def test_nothing_is_interrupted_while_the_interpreter_ends() -> None:
    script = f"""
{HEARING}
import atexit, contextlib, io, sys, time
def late():
    print("ready", flush=True)
    time.sleep(1)
atexit.register(late)
sys.argv[1:] = ["--version"]
from chaplygin.__main__ import main
with contextlib.redirect_stdout(io.StringIO()):
    main()
"""
    code, _, err, _ = interrupted(script)
    assert (code, err) == (0, "")


def test_what_listens_to_ctrl_c_is_itself_imported() -> None:
    """An import was interrupted there, with a traceback."""
    script = f"""{HEARING}
import importlib.abc, sys, time
class Slow(importlib.abc.MetaPathFinder):
    def find_spec(self, name, path, target=None):
        if name == "chaplygin.interruption":
            print("ready", flush=True)
            time.sleep(60)
sys.meta_path.insert(0, Slow())
from chaplygin.__main__ import main
main()
"""
    code, _, err, seconds = interrupted(script)
    assert (code, err) == (
        130,
        "interrupted: nothing was saved; the same command starts from the beginning\n",
    )
    assert seconds < 10


@pytest.mark.slow
def test_a_second_interruption_ends_at_once() -> None:
    script = block(f"""
with results_on_interrupt("the results are about to be printed"):
    ready()
    machine_code({LONG})
""")
    code, _, err, seconds = interrupted(script, times=2)
    assert code == 130
    assert err.startswith("interrupted: the results are about to be printed; Ctrl-C again")
    assert seconds < 10


def test_processes_that_compute_end_too() -> None:
    script = block("""
import multiprocessing
child = multiprocessing.get_context("spawn").Process(target=time.sleep, args=(60,))
child.start()
print(child.pid, file=sys.stderr, flush=True)
ready()
time.sleep(60)
""")
    code, _, err, _ = interrupted(script)
    assert code == 130
    with pytest.raises(ProcessLookupError):
        os.kill(int(err.splitlines()[0]), 0)


BILLIARD = Path(__file__).parents[3] / "examples" / "billiard_ball.toml"

#: Each command with what it is to be at work at for minutes.
COMMANDS = {
    "list": "list",
    "show": "show rattleback",
    "run": "run rattleback -o motion.nc --set run.until=1e6 --set run.samples=10",
    "study": "study rattleback",
    "solve": "solve veselova --digits 900",
    "find": "find integrals chaplygin-ball --degree 4 --gamma-degree 4",
    "prove": "prove marble-ball-on-sphere --effort 3",
    "ensemble": "ensemble veselova -o e.zarr --starts 2000 --level energy=1 --set run.until=1e4",
    "sweep": "sweep veselova --over I_1=1:2:400 -o w.zarr --set run.until=1e4",
    "orbit": "orbit unbalanced-rubber-ball-centred --on gamma_1 --after 2000 --hold energy",
    "bifurcation": "bifurcation veselova -o v.png",
    "animate": "animate rattleback -o r.gif --width 1920 --height 1080",
    "lab": "lab --port 0",
    "section": "section veselova --on gamma_3 -o s.zarr --starts 200 --points 4000",
    "lyapunov": "lyapunov rattleback --until 2e4",
    "chart": "chart rattleback --of lyapunov --x omega_1=0.1:1:40 --y omega_3=0:1:40 -o c.zarr",
    "audit": "audit",
    "run with friction": f"run {BILLIARD} -o m.nc --set run.until=1e7 --set run.samples=9999",
    "study with friction": f"study {BILLIARD} -o s --set run.until=1e6",
    "ensemble with friction": f"ensemble {BILLIARD} -o e.zarr --draw mu=0.1:0.4 --starts 99999",
    "chart with friction": f"chart {BILLIARD} --of energy_lost --x mu=0.1:0.3:60 "
    "--y omega_1=0:60:60 -o c.zarr",
    "section with friction": f"section {BILLIARD} -o s.zarr --on omega_1 --until 1e6 --points 9999",
}


@pytest.mark.slow
@pytest.mark.parametrize("moment", [0.3, 1.0, 3.0, 7.0, 15.0])
@pytest.mark.parametrize("name", COMMANDS)
def test_every_command_ends_with_a_sentence(name: str, moment: float, tmp_path: Path) -> None:
    environment = {**os.environ, "FLOWLANES_CACHE": str(tmp_path / "cache")}
    program = subprocess.Popen(
        [
            sys.executable,
            "-c",
            f"{HEARING}from chaplygin.__main__ import main; main()",
            *COMMANDS[name].split(),
        ],
        cwd=tmp_path,
        env=environment,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    )
    try:
        program.wait(moment)
    except subprocess.TimeoutExpired:
        os.killpg(program.pid, signal.SIGINT)
        began = time.monotonic()
        out, err = program.communicate(timeout=60)
        assert "Traceback" not in err
        assert time.monotonic() - began < 20
        # it may have been at its very end
        over = program.returncode in (0, 1) and out
        assert over or program.returncode == 130, err
        assert over or "interrupted: " in err
    else:
        out, err = program.communicate()
        assert program.returncode in (0, 1), out + err
