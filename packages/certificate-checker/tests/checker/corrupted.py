"""Every certificate that differs from a given one in a single datum."""

from __future__ import annotations

from collections.abc import Iterator
from copy import deepcopy
from typing import Any

Path = tuple[str | int, ...]


def corrupted(data: Any, path: Path = ()) -> Iterator[tuple[Path, str, Any]]:
    """Where, how, and the datum in place of the one there."""
    if isinstance(data, bool):
        yield path, "turned", not data
    elif isinstance(data, int):
        yield path, "raised", data + 1
        yield path, "lowered", data - 1
        yield path, "negated", -data
    elif isinstance(data, str):
        yield path, "one more", _more(data)
        yield path, "renamed", _renamed(data)
        yield path, "negated", data[1:] if data.startswith("-") else f"-{data}"
        yield path, "emptied", ""
    elif isinstance(data, dict):
        for key, part in data.items():
            yield (*path, key), "removed", {k: v for k, v in data.items() if k != key}
            yield from corrupted(part, (*path, key))
        yield (*path, "strange"), "added", {**data, "strange": 0}
    elif isinstance(data, list):
        for i, part in enumerate(data):
            yield (*path, i), "removed", data[:i] + data[i + 1 :]
            yield (*path, i), "doubled", [*data[: i + 1], *data[i:]]
            yield from corrupted(part, (*path, i))
        for i in range(len(data) - 1):
            if data[i] != data[i + 1]:
                yield (*path, i), "exchanged", [*data[:i], data[i + 1], data[i], *data[i + 2 :]]
    if path:
        yield path, "replaced by none", None
        yield path, "replaced by a list", [] if data != [] else ["1"]


def _more(text: str) -> str:
    """One more of a number or a formula; another name otherwise."""
    try:
        return str(int(text) + 1)
    except ValueError:
        return f"{text} + 1"


def _renamed(text: str) -> str:
    for old, new in (("x", "y"), ("y", "x"), ("aux0", "aux1"), ("q", "p"), ("r", "m"), ("w", "x")):
        if old in text:
            return text.replace(old, new)
    return text + "_"


def put(data: Any, path: Path, how: str, value: Any) -> Any:
    """The data with one datum in place of another."""
    made = deepcopy(data)
    whole = how in ("removed", "doubled", "exchanged", "added")
    place = path[:-1] if whole else path
    if not place:
        return value
    inner = made
    for step in place[:-1]:
        inner = inner[step]
    inner[place[-1]] = value
    return made


#: Lists that may be empty or missing alike.
OPTIONAL = (
    "auxiliary",
    "settled",
    "exchanged",
    "inverted",
    "zeros",
    "signs",
    "guards",
    "admissible",
)
#: Lists in which neither order nor repetition matters.
SETS = (
    "admissible",
    "divisors",
    "guards",
    "identities",
    "parameters",
    "positive",
    "proofs",
    "signs",
)


def meaning(data: Any, key: str = "") -> Any:
    """A certificate up to names, the order of terms and repetitions: what it says."""
    if isinstance(data, dict):
        gone = {"name", "what"}
        if "residual" in data and not any(data.get("quotients") or ["none"]):
            # constant · ∏ factors · 0 = 0
            gone |= {"constant", "factors"}
        return {
            k: meaning(part, k)
            for k, part in data.items()
            if k not in gone and not (k in OPTIONAL and part in ([], ["1"]))
        }
    if not isinstance(data, list):
        return "0" if data == "-0" else data
    parts = [meaning(part) for part in data]
    if _is_polynomial(data) or key in ("factors", "denominator", "weight"):
        return sorted(parts, key=repr)
    if key in SETS:
        return sorted({repr(part): part for part in parts}.items())
    return parts


def _is_polynomial(data: list[Any]) -> bool:
    return all(
        isinstance(term, list)
        and len(term) == 2
        and isinstance(term[0], str)
        and isinstance(term[1], list)
        for term in data
    )
