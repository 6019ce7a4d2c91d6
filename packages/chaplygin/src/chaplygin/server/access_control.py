"""Access control of a laboratory: only its own pages, for the user who started it.

Another page in the same browser, or a host name redirected to this machine (DNS rebinding), has a
different Origin or Host.  The token in the address excludes other users of the machine.
"""

from __future__ import annotations

import secrets
from dataclasses import dataclass

from starlette.responses import PlainTextResponse
from starlette.types import ASGIApp, Message, Receive, Scope, Send

#: Headers sent with every response.
HEADERS = {
    "cache-control": "no-store",
    "cross-origin-opener-policy": "same-origin",
    "cross-origin-resource-policy": "same-origin",
    "referrer-policy": "no-referrer",
    "server": "chaplygin lab",
    "x-content-type-options": "nosniff",
    "x-frame-options": "DENY",
}

_NOTHING = "There is nothing here. The address that chaplygin lab printed has all that is needed."


@dataclass(frozen=True)
class AccessControl:
    """An ASGI application that only accepts properly authorised requests.

    Parameters
    ----------
    app : ASGI application
    token : str
        The first part of every path.
    port : int
    """

    app: ASGIApp
    token: str
    port: int

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer permitted requests, and refuse all others."""
        if scope["type"] != "http":
            # Websockets are not supported; the server refuses them.
            raise RuntimeError(f"unsupported protocol: {scope['type']}")

        async def guarded(message: Message) -> None:
            if message["type"] == "http.response.start":
                own = [(name.encode(), value.encode()) for name, value in HEADERS.items()]
                message = {**message, "headers": [*message["headers"], *own]}
            await send(message)

        refusal = self._refusal(scope)
        if refusal is not None:
            await refusal(scope, receive, guarded)
            return
        await self.app(scope, receive, guarded)

    def _refusal(self, scope: Scope) -> PlainTextResponse | None:
        """The response to a refused request."""
        headers = [(name.lower(), value.decode("latin-1")) for name, value in scope["headers"]]
        places = {f"{name}:{self.port}" for name in ("127.0.0.1", "localhost")}
        hosts = [value for name, value in headers if name == b"host"]
        if len(hosts) != 1 or hosts[0] not in places:
            return PlainTextResponse("This is no name of the laboratory.", 421)
        origins = [value for name, value in headers if name == b"origin"]
        if any(origin not in {f"http://{place}" for place in places} for origin in origins):
            return PlainTextResponse("Another page may not ask the laboratory.", 403)
        first = scope["path"].partition("/")[2].partition("/")[0]
        if not secrets.compare_digest(first.encode(), self.token.encode()):
            return PlainTextResponse(_NOTHING, 404)
        return None
