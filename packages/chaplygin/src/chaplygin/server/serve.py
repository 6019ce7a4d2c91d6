"""Start a laboratory on this machine only, until Ctrl-C or SIGTERM."""

from __future__ import annotations

import asyncio
import contextlib
import errno
import http.client
import os
import secrets
import socket
from collections.abc import Callable, Iterator

import uvicorn
from uvicorn.protocols.http.h11_impl import H11Protocol

from flowlanes.errors import InputError

from .answers import answer
from .app import MESSAGE_TIMEOUT, Laboratory
from .folder import Folder
from .workers import Pool

#: The loopback address, which other machines cannot reach.
HOST = "127.0.0.1"

#: Seconds within which a page must have read the response sent so far.
READING_TIMEOUT = 20.0

#: Seconds that the validation of an experiment may take before it is saved.
SAVING_TIMEOUT = 60.0

#: Maximum number of connections; further ones are told to retry.
CONNECTIONS = 256

#: Maximum number of idle connections; of more, the longest idle ones are closed.
IDLE_CONNECTIONS = 64


class _Server(uvicorn.Server):
    """A server that leaves signal handling to the command line."""

    @contextlib.contextmanager
    def capture_signals(self) -> Iterator[None]:
        yield


class _Connection(H11Protocol):
    """A connection that is closed if no request arrives, or the response is not read.

    The numbers of connections and of worker processes are limited.
    """

    _unread: asyncio.TimerHandle | None = None
    _since = 0.0

    def pause_writing(self) -> None:
        """Wait until more has been read, but only for a limited time."""
        super().pause_writing()
        self._unread = self.loop.call_later(READING_TIMEOUT, self.transport.abort)

    def resume_writing(self) -> None:
        """Continue sending the response."""
        super().resume_writing()
        if self._unread is not None:
            self._unread.cancel()

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
        """Start watching the connection."""
        super().connection_made(transport)
        self._since = self.loop.time()
        self._watch()
        idle = [
            other
            for other in self.connections
            if isinstance(other, _Connection)
            and other._is_idle()
            and not other.transport.is_closing()
        ]
        if len(idle) > IDLE_CONNECTIONS:
            # connections without any request so far are closed first
            min(idle, key=lambda other: (other.cycle is not None, other._since)).transport.close()

    def _watch(self) -> None:
        self.loop.call_later(MESSAGE_TIMEOUT, self._close_if_idle, self._is_idle(), self.cycle)

    def _is_idle(self) -> bool:
        return self.cycle is None or self.cycle.response_complete

    def _close_if_idle(self, before: bool, cycle: object) -> None:
        """Close the connection if it was idle before, and no request has arrived since."""
        if before and self.cycle is cycle and self._is_idle():
            self.transport.close()
        elif not self.transport.is_closing():
            self._watch()


def serve(folder: Folder, what: str, port: int, announce: Callable[[str], None]) -> None:
    """Serve a laboratory until it is interrupted; no process remains afterwards.

    Parameters
    ----------
    folder : Folder
        The folder that may be read and written.
    what : str
        The subject that the page opens.
    port : int
        Port number; 0 for any free one.
    announce : callable
        Called with the address of the page as soon as it can be opened.

    Raises
    ------
    InputError
        If the port is taken.
    """
    listening = listen(port)
    place = listening.getsockname()[1]
    pool, savers = Pool(answer, max(1, (os.cpu_count() or 2) - 1)), Pool(answer, 1, SAVING_TIMEOUT)
    laboratory = Laboratory(folder, what, pool, savers, secrets.token_urlsafe(18), place)
    config = uvicorn.Config(
        laboratory.application(),
        http=_Connection,
        ws="none",
        lifespan="off",
        log_level="error",
        access_log=False,
        server_header=False,
        date_header=False,
        limit_concurrency=CONNECTIONS,
        timeout_keep_alive=5,
        timeout_graceful_shutdown=0,
        h11_max_incomplete_event_size=16 * 1024,
    )
    with listening:
        announce(f"http://{HOST}:{place}{laboratory.base}")
        asyncio.run(_serve(_Server(config), listening, [pool, savers]))


async def _serve(server: _Server, listening: socket.socket, pools: list[Pool]) -> None:
    try:
        await server.serve([listening])
    finally:
        # before the event loop waits for threads, which wait for workers
        for pool in pools:
            pool.close()


def listen(port: int) -> socket.socket:
    """A socket that only this machine can reach.

    Raises
    ------
    InputError
        If the port is taken.
    """
    listening = socket.socket(socket.AF_INET, socket.SOCK_STREAM)
    listening.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    try:
        listening.bind((HOST, port))
        listening.listen(CONNECTIONS)
    except OSError as problem:
        listening.close()
        if problem.errno != errno.EADDRINUSE:
            raise InputError(f"--port {port}: {problem.strerror}") from None
        who = "another laboratory" if _is_laboratory(port) else "another program"
        raise InputError(
            f"{who} is running on port {port} already: choose another one with --port, or any "
            "free one with --port 0"
        ) from None
    return listening


def _is_laboratory(port: int) -> bool:
    """Whether the listening server identifies itself as a laboratory."""
    connection = http.client.HTTPConnection(HOST, port, timeout=1.0)
    try:
        connection.request("GET", "/")
        return connection.getresponse().getheader("server") == "chaplygin lab"
    except (OSError, http.client.HTTPException):
        return False
    finally:
        connection.close()
