"""What a command says while it works: in time, though it is told nothing until then."""

from __future__ import annotations

import os
import pty
import subprocess
import sys
import time

#: A first block of two seconds, then a second one.
WORK = """
import time
from chaplygin.cli.terminal.progress import progress, waiting
with waiting("importing"):
    time.sleep(0.01)
with progress("first block of 200 [starts]") as report:
    time.sleep(2.5)
    report(0.5)
    report.say("second block")
    time.sleep(1)
"""


def test_a_bar_appears_before_the_first_block_is_done() -> None:
    leader, follower = pty.openpty()
    began = time.monotonic()
    with subprocess.Popen(
        [sys.executable, "-c", WORK], stderr=follower, env={**os.environ, "TERM": "xterm"}
    ) as program:
        os.close(follower)
        seen = b""
        while b"first block of 200 [starts]" not in seen:
            seen += os.read(leader, 1024)
        assert program.poll() is None
        assert time.monotonic() - began < 60
        try:
            while more := os.read(leader, 1024):
                seen += more
        except OSError:  # the other end is closed
            pass
    os.close(leader)
    assert b"second block" in seen
    assert b"importing" not in seen
    # the cursor is shown again
    assert seen.rindex(b"\x1b[?25h") > seen.rindex(b"\x1b[?25l")


def test_a_log_has_a_line_and_no_bar() -> None:
    done = subprocess.run([sys.executable, "-c", WORK], capture_output=True, text=True, check=True)
    assert done.stderr == "first block of 200 [starts] …\n"


def test_what_is_done_in_a_moment_says_nothing() -> None:
    script = (
        "from chaplygin.cli.terminal.progress import progress\n"
        "with progress('work') as report: report(1)"
    )
    done = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=True
    )
    assert done.stderr == ""


def test_a_log_has_what_is_told_while_something_is_waited_for() -> None:
    script = (
        "import time\nfrom chaplygin.cli.terminal.progress import waiting\n"
        "with waiting('reading') as report:\n    time.sleep(1)\n    report.say('preparing')\n"
        "    time.sleep(1.5)"
    )
    done = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=True
    )
    assert done.stderr == "preparing …\n"


def test_a_line_of_a_log_comes_before_what_is_said_afterwards() -> None:
    """The line is being written while the task ends, into something slow."""
    script = (
        "import sys, threading, time\nfrom chaplygin.cli.terminal.progress import progress\n"
        "class Slow:\n"
        "    entered = threading.Event()\n"
        "    def write(self, text):\n"
        "        if 'work' in text: self.entered.set(); time.sleep(0.5)\n"
        "        sys.stdout.write(text)\n"
        "    def flush(self): pass\n"
        "    def isatty(self): return False\n"
        "sys.stderr = Slow()\n"
        "with progress('work'): Slow.entered.wait()\n"
        "sys.stderr.write('error\\n')"
    )
    done = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=True
    )
    assert done.stdout == "work …\nerror\n"
