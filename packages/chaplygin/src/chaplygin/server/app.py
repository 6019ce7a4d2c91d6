"""The application: one page, and one address for its requests."""

from __future__ import annotations

import asyncio
import json
from collections.abc import AsyncGenerator
from contextlib import aclosing
from dataclasses import dataclass

from starlette.applications import Starlette
from starlette.requests import ClientDisconnect, Request
from starlette.responses import HTMLResponse, PlainTextResponse, Response, StreamingResponse
from starlette.routing import Route

from flowlanes.errors import InputError
from nonholonomic.catalogue import CATALOGUE

from ..page.element import page
from .access_control import AccessControl
from .answers import Assignment
from .charts import store_name
from .folder import Folder
from .requests import LARGEST, Chart, Computation, Listing, Saving, request_of
from .workers import BusyError, Message, Pool

#: Seconds within which a message must have arrived.
MESSAGE_TIMEOUT = 20.0


@dataclass(frozen=True)
class Laboratory:
    """The resources of the application.

    Attributes
    ----------
    folder : Folder
    what : str
        Name or file that the page opens.
    pool : Pool
    savers : Pool
        Workers that save experiments, independent of running computations.
    token : str
    port : int
    """

    folder: Folder
    what: str
    pool: Pool
    savers: Pool
    token: str
    port: int

    @property
    def base(self) -> str:
        """The path of the page."""
        return f"/{self.token}/"

    def application(self) -> AccessControl:
        """The application with its access control."""
        routes = [
            Route(self.base, self.show, methods=["GET"]),
            Route(f"{self.base}ask", self.ask, methods=["POST"]),
        ]
        application = Starlette(routes=routes)
        # no redirection from nearly correct addresses
        application.router.redirect_slashes = False
        return AccessControl(application, self.token, self.port)

    async def show(self, request: Request) -> Response:
        """The page of a system: that of the command line, or the one named in the address."""
        what = request.query_params.get("open", self.what)
        body = json.dumps({"do": "open", "subject": {"what": what}}).encode()
        error = "the page could not be made"
        try:
            async with aclosing(self._answer(body)) as parts:
                async for part in parts:
                    if "model" in part:
                        model = part["model"]
                        assert isinstance(model, dict)
                        return HTMLResponse(page(model, base=self.base))
                    error = str(part.get("error", error))
        except InputError as problem:
            error = str(problem)
        return PlainTextResponse(f"{error}\n", 400)

    async def ask(self, request: Request) -> Response:
        """The response to a request, one JSON object per line, as they are computed."""
        kind = request.headers.get("content-type", "").partition(";")[0].strip()
        if kind != "application/json":
            return _refusal("a request is sent as application/json", 415)
        try:
            async with asyncio.timeout(MESSAGE_TIMEOUT):
                body = await _body(request)
        except TimeoutError:
            return _refusal("the message did not arrive in time", 408)
        except ClientDisconnect:
            return _refusal("the page went away", 400)
        if body is None:
            return _refusal(f"a message has at most {LARGEST // 1024} kB", 413)
        return StreamingResponse(self._lines(body), media_type="application/x-ndjson")

    async def _lines(self, body: bytes) -> AsyncGenerator[str, None]:
        try:
            async with aclosing(self._answer(body)) as parts:
                async for part in parts:
                    yield json.dumps(part, allow_nan=False, ensure_ascii=False) + "\n"
        except InputError as problem:
            yield json.dumps({"error": str(problem)}) + "\n"
        except BusyError:
            yield json.dumps({"error": "too many computations wait; try again in a moment"}) + "\n"

    async def _answer(self, body: bytes) -> AsyncGenerator[Message, None]:
        """The parts of the answer to a message.

        Raises
        ------
        InputError
            If the message is not a valid request.
        BusyError
            If too many computations wait.
        """
        request = request_of(body)
        if isinstance(request, Listing):
            systems = [{"name": entry.name, "title": entry.title} for entry in CATALOGUE.values()]
            yield {
                "systems": systems,
                "files": [*self.folder.named_experiments, *self.folder.files()],
            }
            yield {"done": True}
            return
        pool = self.savers if isinstance(request, Saving) else self.pool
        async with aclosing(pool.ask(self._assignment(request))) as parts:
            async for part in parts:
                yield part

    def _assignment(self, request: Computation) -> Assignment:
        """Prepare the task of a worker; experiments are validated there too, as this may be slow.

        Raises
        ------
        InputError
            If there is no such subject.
        """
        if isinstance(request, Saving):
            return Assignment(request, None, str(self.folder.path))
        text = request.subject.experiment or self.folder.experiment(request.subject.what)
        store = ""
        if isinstance(request, Chart):
            store = str(self.folder.store(store_name(request, text)))
        return Assignment(request, text, store)


def _refusal(sentence: str, status: int) -> Response:
    return Response(
        json.dumps({"error": sentence}) + "\n", status, media_type="application/x-ndjson"
    )


async def _body(request: Request) -> bytes | None:
    """The complete message; None if it is too large."""
    declared = request.headers.get("content-length", "0")
    if declared.isdecimal() and int(declared) > LARGEST:
        return None
    parts = bytearray()
    async for part in request.stream():
        parts += part
        if len(parts) > LARGEST:
            return None
    return bytes(parts)
