"""A running laboratory under load: many pages, hostile ones, pages that go away, and its end."""

from __future__ import annotations

import contextlib
import http.client
import json
import os
import re
import signal
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import pytest

from browser import Opened, browsers
from needs import needs

pytestmark = [pytest.mark.server, needs("starlette", "uvicorn")]

EXPERIMENT = 'system = {name = "veselova"}\nrun = {until = 5.0, samples = 11}\n'
#: A search that takes minutes.
LONG = {"do": "find", "kind": "integrals", "degree": 6, "gamma_degree": 6}

#: An experiment that takes long to be refused: reading a name takes the square of its length.
LARGE = f"[{'a.' * 100_000}a]"


@dataclass
class Laboratory:
    """A process that serves, and how to speak to it."""

    process: subprocess.Popen[str]
    port: int
    token: str
    folder: Path

    def send(
        self,
        body: bytes,
        path: str | None = None,
        method: str = "POST",
        headers: dict[str, str] | None = None,
    ) -> tuple[int, str]:
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=120)
        sent = {"content-type": "application/json"} if headers is None else headers
        try:
            connection.request(method, path or f"/{self.token}/ask", body, sent)
            answer = connection.getresponse()
            return answer.status, answer.read().decode()
        finally:
            connection.close()

    def line(self, body: str) -> socket.socket:
        """A connection on which a message has been sent, and nobody reads."""
        line = socket.create_connection(("127.0.0.1", self.port), timeout=60)
        head = (
            f"POST /{self.token}/ask HTTP/1.1\r\nHost: 127.0.0.1:{self.port}\r\n"
            f"Content-Type: application/json\r\nContent-Length: {len(body)}\r\n\r\n"
        )
        line.sendall((head + body).encode())
        return line

    def ask(self, message: dict[str, object]) -> list[dict[str, object]]:
        status, text = self.send(json.dumps(message).encode())
        assert status == 200, text
        return [json.loads(line) for line in text.splitlines()]


def start(folder: Path, *arguments: str) -> subprocess.Popen[str]:
    command = [sys.executable, "-m", "chaplygin", "lab", *arguments]
    return subprocess.Popen(command, cwd=folder, stderr=subprocess.PIPE, text=True)


def opened(folder: Path, *arguments: str) -> Laboratory:
    process = start(folder, *arguments)
    assert process.stderr is not None
    for line in process.stderr:
        if found := re.search(r"http://127\.0\.0\.1:(\d+)/([\w-]+)/", line):
            return Laboratory(process, int(found[1]), found[2], folder)
    raise AssertionError("the laboratory did not start")


def ended(process: subprocess.Popen[str]) -> str:
    """End a process that is still running; what it has said."""
    process.kill()
    return process.communicate()[1]


def children(process: int) -> set[int]:
    """The processes that a process has started, and those that they have."""
    found: set[int] = set()
    for path in Path("/proc").glob("[0-9]*/stat"):
        try:
            parts = path.read_text().rpartition(")")[2].split()
        except OSError:
            continue
        if int(parts[1]) == process and parts[0] != "Z":
            child = int(path.parent.name)
            found |= {child} | children(child)
    return found


def gone(process: int) -> bool:
    try:
        return Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0] == "Z"
    except OSError:
        return True


def until(condition: object, seconds: float = 60.0) -> None:
    end = time.monotonic() + seconds
    while not condition():  # type: ignore[operator]
        assert time.monotonic() < end, "it did not come to pass"
        time.sleep(0.05)


@pytest.fixture(scope="module")
def laboratory(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Laboratory]:
    folder = tmp_path_factory.mktemp("lab")
    (folder / "own.toml").write_text(EXPERIMENT)
    running = opened(folder, "own.toml", "--port", "0")
    try:
        yield running
    finally:
        ended(running.process)


def test_a_page_is_served_that_may_ask_its_server_alone(laboratory: Laboratory) -> None:
    status, text = laboratory.send(b"", f"/{laboratory.token}/", "GET", {})
    assert status == 200
    assert "Veselova system" in text
    assert "connect-src &#39;self&#39;" in text


def test_what_pages_ask_is_answered(laboratory: Laboratory) -> None:
    *verdicts, last = laboratory.ask({"do": "prove", "subject": {"what": "veselova"}})
    assert last == {"done": True}
    found = [part["verdict"] for part in verdicts if "verdict" in part]
    assert {v["name"]: v["verdict"] for v in found}["energy"] == "proven"  # type: ignore[index]
    motion = laboratory.ask({"do": "motion", "subject": {"what": "own.toml"}})[0]["motion"]
    assert motion["times"][-1] == 5.0  # type: ignore[index]
    assert len(motion["columns"]["gamma"]) == 33  # type: ignore[index]


def test_a_chart_is_streamed_and_read_from_its_store_again(laboratory: Laboratory) -> None:
    request: dict[str, object] = {
        "do": "chart",
        "of": "megno",
        "x": "omega_1=0.5:1.5:40",
        "y": "omega_3=0.5:1.5:90",
        "until": 5.0,
        "subject": {"what": "own.toml"},
    }
    first, again = laboratory.ask(request), laboratory.ask(request)
    tiles = [part["tile"] for part in first if "tile" in part]
    assert len(tiles) > 1
    assert sum(tile["height"] for tile in tiles) == 90  # type: ignore[index, misc]
    assert tiles == [part["tile"] for part in again if "tile" in part]
    chart: dict[str, str] = next(part["chart"] for part in first if "chart" in part)  # type: ignore[misc]
    store = laboratory.folder / chart["store"]
    assert (store / "done").exists()


@pytest.mark.parametrize(
    ("path", "headers", "status"),
    [
        ("/", {}, 404),
        ("/TOKEN", {}, 404),
        ("/wrong/", {}, 404),
        ("/TOKEN/../etc/passwd", {}, 404),
        ("/TOKEN/static/lab.js", {}, 404),
        ("/TOKEN/", {"host": "evil.example"}, 421),
        ("/TOKEN/", {"host": "127.0.0.1:1"}, 421),
        ("/TOKEN/", {"origin": "http://evil.example"}, 403),
        ("/TOKEN/", {"origin": "null"}, 403),
        ("/TOKEN/?open=../../etc/passwd", {}, 400),
        ("/TOKEN/?open=script.py", {}, 400),
        ("/TOKEN/" + "x" * 20_000, {}, 404),
    ],
)
def test_what_does_not_come_from_its_own_page_is_refused(
    laboratory: Laboratory, path: str, headers: dict[str, str], status: int
) -> None:
    path = path.replace("TOKEN", laboratory.token)
    answered, text = laboratory.send(b"", path, "GET", headers)
    assert answered == status
    assert "root:" not in text


def test_messages_of_other_kinds_and_sizes_are_refused(laboratory: Laboratory) -> None:
    assert laboratory.send(b"{}", headers={"content-type": "text/plain"})[0] == 415
    assert laboratory.send(b" " * 300_000)[0] == 413
    assert "JSON" in laboratory.send(b"{" * 50_000)[1]
    path = f"/{laboratory.token}/ask"
    assert laboratory.send(b"", path, "GET", {})[0] == 405
    assert laboratory.send(b"{}", f"/{laboratory.token}/other")[0] == 404


def test_an_oversized_message_without_a_length_is_refused(laboratory: Laboratory) -> None:
    with socket.create_connection(("127.0.0.1", laboratory.port), timeout=60) as line:
        head = (
            f"POST /{laboratory.token}/ask HTTP/1.1\r\nHost: 127.0.0.1:{laboratory.port}\r\n"
            "Content-Type: application/json\r\nTransfer-Encoding: chunked\r\n\r\n"
        )
        line.sendall(head.encode())
        chunk = b"4000\r\n" + b" " * 0x4000 + b"\r\n"
        try:
            for _ in range(200):
                line.sendall(chunk)
        except OSError:
            # it has been refused, and nobody reads the rest
            pass
        answer = line.recv(100)
    assert b" 413 " in answer


@pytest.mark.parametrize("sent", [b"", b"GET / HTTP/1.1\r\nHost: "])
def test_connections_without_a_request_are_closed(laboratory: Laboratory, sent: bytes) -> None:
    with socket.create_connection(("127.0.0.1", laboratory.port), timeout=60) as line:
        line.sendall(sent)
        assert line.recv(100) == b""


def test_checking_an_experiment_holds_up_nobody(laboratory: Laboratory) -> None:
    """It ends too when the page goes away that has asked to save the experiment."""
    with laboratory.line(json.dumps({"do": "save", "file": "a.toml", "experiment": LARGE})):
        until(lambda: workers(laboratory))
        time.sleep(2.0)
        before = workers(laboratory)
        motion = {"do": "motion", "subject": {"what": "own.toml"}}
        assert laboratory.ask(motion)[-1] == {"done": True}
    until(lambda: before - workers(laboratory))
    laboratory.ask({"do": "save", "file": "b.toml", "experiment": EXPERIMENT})
    assert (laboratory.folder / "b.toml").read_text() == EXPERIMENT


def test_an_answer_that_nobody_reads_holds_no_place(laboratory: Laboratory) -> None:
    """The computation ends, and others have its process."""
    large = {"what": "own.toml", "set": {"run.samples": 20_001, "run.until": 50.0}}
    asked = json.dumps({"do": "motion", "subject": large})
    lines = [laboratory.line(asked) for _ in range(max(1, (os.cpu_count() or 2) - 1))]
    try:
        motion = {"do": "motion", "subject": {"what": "own.toml"}}
        assert laboratory.ask(motion)[-1] == {"done": True}
    finally:
        for line in lines:
            line.close()


def test_fifty_pages_are_served_at_once(laboratory: Laboratory) -> None:
    def client(number: int) -> object:
        subject = {"what": "own.toml", "set": {"run.until": 1.0 + number / 10}}
        return laboratory.ask({"do": "motion", "subject": subject})[-1]

    with ThreadPoolExecutor(50) as pages:
        assert list(pages.map(client, range(50))) == [{"done": True}] * 50


def workers(laboratory: Laboratory) -> set[int]:
    """The processes of a laboratory that compute."""
    return {p for p in children(laboratory.process.pid) if b"spawn_main" in command_of(p)}


def command_of(process: int) -> bytes:
    try:
        return Path(f"/proc/{process}/cmdline").read_bytes()
    except OSError:
        return b""


def test_a_computation_ends_when_its_page_goes_away(laboratory: Laboratory) -> None:
    places = max(1, (os.cpu_count() or 2) - 1)
    lines = []
    for _ in range(4):
        lines.append(laboratory.line(json.dumps({**LONG, "subject": {"what": "unbalanced-ball"}})))
    until(lambda: len(workers(laboratory)) >= min(4, places))
    time.sleep(2.0)
    before = workers(laboratory)
    for line in lines:
        line.close()
    # the workers that were busy are ended, and the others wait for nobody
    until(lambda: len(before - workers(laboratory)) >= min(4, places))
    assert laboratory.ask({"do": "motion", "subject": {"what": "own.toml"}})[-1] == {"done": True}


@pytest.mark.parametrize("sent", [b"", b"POST / HTTP/1.1\r\nHost:"])
def test_connections_without_a_request_keep_nobody_out(laboratory: Laboratory, sent: bytes) -> None:
    """Three hundred of them kept the owner out for twenty seconds."""
    with contextlib.ExitStack() as lines:
        for _ in range(300):
            line = lines.enter_context(
                socket.create_connection(("127.0.0.1", laboratory.port), timeout=60)
            )
            with contextlib.suppress(OSError):
                line.sendall(sent)
        status, text = laboratory.send(b"", f"/{laboratory.token}/", "GET", {})
        assert status == 200, text


def test_a_process_that_was_killed_is_replaced(laboratory: Laboratory) -> None:
    motion = {"do": "motion", "subject": {"what": "own.toml"}}
    assert laboratory.ask(motion)[-1] == {"done": True}
    for process in workers(laboratory):
        os.kill(process, signal.SIGKILL)
    until(lambda: not workers(laboratory))
    # their other threads end a little later
    time.sleep(1.0)
    assert laboratory.ask(motion)[-1] == {"done": True}


def test_a_second_laboratory_on_the_port_says_so(laboratory: Laboratory) -> None:
    second = start(laboratory.folder, "own.toml", "--port", str(laboratory.port))
    _, words = second.communicate(timeout=120)
    assert second.returncode == 2
    assert words.strip().splitlines()[-1] == (
        f"error: another laboratory is running on port {laboratory.port} already: choose another "
        "one with --port, or any free one with --port 0"
    )


@pytest.mark.parametrize("sent", [signal.SIGINT, signal.SIGTERM, signal.SIGKILL])
def test_nothing_is_left_running(tmp_path: Path, sent: signal.Signals) -> None:
    (tmp_path / "own.toml").write_text(EXPERIMENT)
    running = opened(tmp_path, "own.toml", "--port", "0")
    threads = [
        threading.Thread(target=_ask_and_be_cut_off, args=(running,), daemon=True) for _ in range(3)
    ]
    for thread in threads:
        thread.start()
    until(lambda: len(children(running.process.pid)) > 0)
    time.sleep(1.0)
    below = children(running.process.pid)
    os.kill(running.process.pid, sent)
    running.process.wait(timeout=20)
    words = ended(running.process).strip().splitlines()
    if sent == signal.SIGINT:
        assert running.process.returncode == 130
        assert words[-1] == (
            "interrupted: the laboratory is closed; experiments and charts that were saved stay"
        )
    until(lambda: all(gone(process) for process in below))


def _ask_and_be_cut_off(running: Laboratory) -> None:
    with contextlib.suppress(OSError, http.client.HTTPException, AssertionError):
        running.ask({**LONG, "subject": {"what": "unbalanced-ball"}})


def test_the_page_asks_for_proofs_and_shows_them(laboratory: Laboratory) -> None:
    with browsers() as launch:
        address = f"http://127.0.0.1:{laboratory.port}/{laboratory.token}/"
        opened = Opened(launch(), address).ready()
        opened.page.get_by_role("tab", name="Python").click()
        opened.page.get_by_role("button", name="Prove the laws").click()
        answers = opened.page.locator(".lab-answers:not([role])")
        answers.get_by_text("energy").first.wait_for(timeout=120_000)
        assert "energy proven" in answers.inner_text()
        asked = {url for url in opened.strangers if url != f"{address}ask"}
        assert asked == set()
        assert opened.complaints == []
