"""Errors: mistakes of the user, and computations that could not be completed."""

from __future__ import annotations

import bisect
import difflib
import itertools
import re
from collections.abc import Iterable, Iterator
from typing import Any

#: Maximum number of characters of a message, and of one of its lines.
LONGEST, LONGEST_LINE = 2000, 600


#: Invisible characters other than tabs and line breaks: control characters, characters that change
#: the text direction, and those of zero width.
INVISIBLE = re.compile(
    "[\\x00-\\x08\\x0b\\x0c\\x0e-\\x1f\\x7f-\\x9f\\xad\\u061c\\u180e\\u200b-\\u200f"
    "\\u2028-\\u202e\\u2060-\\u206f\\ufeff\\U000e0000-\\U000e007f]"
)


def readable(text: str) -> str:
    """Text suitable for a terminal: no invisible characters, limited line and total length.

    Control characters and other non-printing characters except line breaks are escaped.  A long
    line is shortened in the middle, so that its beginning and end remain.
    """
    escaped = "".join(c if c.isprintable() or c == "\n" else _escape(c) for c in text)
    lines = [_abbreviation(line) for line in escaped.split("\n")]
    ends = list(itertools.accumulate(len(line) + 1 for line in lines))
    if ends[-1] <= LONGEST:
        return "\n".join(lines)
    shown = bisect.bisect(ends, LONGEST - 50)
    return "\n".join([*lines[:shown], f"... and {len(lines) - shown} more lines"])


def _escape(character: str) -> str:
    return character.encode("unicode_escape").decode("ascii")


def _abbreviation(line: str) -> str:
    half = LONGEST_LINE // 2 - 5
    return line if len(line) <= LONGEST_LINE else f"{line[:half]} [...] {line[-half:]}"


def nearest(name: str, names: Iterable[str]) -> str:
    """End of a sentence about an unknown name: the most similar name, and all allowed names.

    Parameters
    ----------
    name
        The unknown name.
    names
        Allowed names.

    Returns
    -------
    str

    Examples
    --------
    >>> nearest("radus", ["radius", "mass"])
    ", did you mean 'radius'? allowed: radius, mass"
    """
    allowed = list(names)
    same = [word for word in allowed if word.casefold() == name.casefold()]
    # One letter in two or three may be wrong; "diameter" should not match "parameters".
    likeness = 0.6 if len(name) < 5 else 0.7
    close = same or difflib.get_close_matches(name, allowed, n=1, cutoff=likeness)
    guess = f", did you mean '{close[0]}'?" if close else ";"
    return f"{guess} allowed: {', '.join(_families(allowed)) or 'none'}"


def _families(names: Iterable[str]) -> Iterator[str]:
    """Names, where three or more that differ only in a number are abbreviated as ``x_1 … x_3``."""
    for stem, group in itertools.groupby(names, key=lambda name: re.sub(r"\d+$", "", name)):
        members = list(group)
        several = len(members) > 2 and members == [f"{stem}{i}" for i in range(1, len(members) + 1)]
        yield from (f"{members[0]} … {members[-1]}",) if several else members


class InputError(ValueError):
    """Error caused by wrong input.

    Parameters
    ----------
    message
        One sentence with the mistake and the allowed values; for a formula also a two-line
        excerpt.
    where
        Location of the mistake, such as ``"body.toml, line 7, body.inertia"``; may be empty.

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> x, k = sp.symbols("x k", real=True)
    >>> try:
    ...     flowlanes.System("decay", "Decay", {x: -k * x})
    ... except flowlanes.InputError as error:
    ...     print(error)
    decay: the rate of x uses k, which is neither a state variable, an earlier definition nor a
    parameter
    """

    def __init__(self, message: str, where: str = "") -> None:
        super().__init__(message, where)
        self.message = readable(message)
        self.where = readable(where)

    def __str__(self) -> str:
        return readable(f"{self.where}: {self.message}" if self.where else self.message)


def require_label(name: str, title: str, *texts: str) -> None:
    """Raise InputError if a name is empty, or a text has invisible characters."""
    if not name.strip():
        raise InputError("the name of a system is empty; it must be a word such as 'top'")
    for what, text in (("name", name), ("title", title)):
        if not text.isprintable():
            raise InputError(f"the {what} {text!r} contains a character that cannot be seen")
    require_visible(texts)


def require_visible(texts: Iterable[str]) -> None:
    """Raise InputError if a text has an invisible character."""
    for text in texts:
        if found := INVISIBLE.search(text):
            raise InputError(
                f"the text {text!r} contains the character U+{ord(found[0]):04X}, "
                "which cannot be seen"
            )


class RunError(RuntimeError):
    """Computation that could not be completed.

    Parameters
    ----------
    reason
        One sentence with the reason.
    time
        Last instant at which the solution was valid.
    partial
        Results computed before the failure, such as a trajectory.

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> x = sp.Symbol("x", real=True)
    >>> try:
    ...     flowlanes.integrate(
    ...         flowlanes.System("blow-up", "Blow-up", {x: x**2}), [1.0], [0.0, 2.0]
    ...     )
    ... except flowlanes.RunError as error:
    ...     print(f"good until t = {error.time:.3f}")
    good until t = 1.000
    """

    def __init__(self, reason: str, time: float, partial: Any = None) -> None:
        super().__init__(reason, time)
        self.reason = readable(reason)
        self.time = time
        self.partial = partial

    def __str__(self) -> str:
        return f"{self.reason} (the last good time is {self.time:.9g})"


class InterruptionError(RunError):
    """Computation interrupted by the user; the results computed before are in `partial`."""


class EarlyEndError(RunError):
    """Motion that ended before its time.

    Parameters
    ----------
    system
        Name of the system.
    reason, time
        As in RunError.
    """

    def __init__(self, system: str, reason: str, time: float) -> None:
        super().__init__(reason, time)
        self.args = (system, reason, time)
        self.system = system

    def __str__(self) -> str:
        return f"{self.system}: the motion ends at t = {self.time:.6g} s: {self.reason}"
