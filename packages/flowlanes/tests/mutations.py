"""Random damage to texts and bytes, and what may come of reading them."""

from __future__ import annotations

import re
import signal
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from random import Random
from types import FrameType

from flowlanes.errors import LONGEST

EXAMPLES = Path(__file__).parents[3] / "examples"

#: What stands in files where something else should stand.
VALUES = (
    "0", "-0.0", "1", "-1", "2.5", "1e-12", "1e12", "1e-320", "1e308", "-1e308", "1e400", "nan",
    "inf", "-inf", "9" * 400, "-" + "7" * 5000, "0x10", "1_000", "true", '""', "''", "[]", "{}",
    "[1]", "[1, 2]", "[1, 2, 3]", "[0, 0, 0]", "[1, [2]]", "[[1, 0, 0], [0, 1, 0], [0, 0, 1]]",
    '["x"]', "1979-05-27", "12:00:00", '"\\u0007\\u001b[31mred"', '"a\\u0000b"', '"\\n\\r\\t"',
    '"' + "x" * 20_000 + '"', '"x/0"', '"sqrt(-1)"', '"1e300*x"', '"x**y**z"',
    '"' + "(" * 300 + '"',
    '"γ₃"', '"1/(x - x)"', '"exp(exp(exp(9)))"', '"ball"', '"disk"', '"sphere"', '"quad"',
    '{ value = 1 }', '{ value = [1, 2, 3] }', '{ kind = "sphere", radius = -1 }',
    "[" * 200 + "]" * 200, "[" + "1, " * 4000 + "1]",
)  # fmt: skip
PIECES = (
    "", " ", "\n", "=", "[", "]", "{", "}", '"', "'", ".", "-", "#", ",", "(", ")", "*", "/", "0",
    "9" * 30, "e9", "\x00", "\x07", "\x1b[2J", "\x7f", "\x9b31m", "\u202e", "\ud7ff", "é", "γ",
    "\r\n", "\t", '"""', "[[", "x" * 3000,
)  # fmt: skip


def mutated(text: str, random: Random) -> str:
    """The text with one to three kinds of damage."""
    for _ in range(random.choice((1, 1, 1, 2, 3))):
        text = random.choice(DAMAGES)(text, random)
    return text


def _cut(text: str, random: Random) -> str:
    start = random.randrange(len(text) + 1)
    return text[:start] + text[start + random.randrange(1, 30) :]


def _insert(text: str, random: Random) -> str:
    start = random.randrange(len(text) + 1)
    return text[:start] + random.choice(PIECES) + text[start:]


def _character(text: str, random: Random) -> str:
    start = random.randrange(len(text) + 1)
    code = random.choice((random.randrange(32, 127), random.randrange(0x300)))
    return text[:start] + chr(code) + text[start + 1 :]


def _line(text: str, random: Random) -> str:
    """A line removed, doubled or moved."""
    lines = text.splitlines(keepends=True)
    if not lines:
        return text
    line = lines.pop(random.randrange(len(lines)))
    for _ in range(random.randrange(3)):
        lines.insert(random.randrange(len(lines) + 1), line)
    return "".join(lines)


def _at_one(pattern: str) -> Callable[[str, Random, Sequence[str]], str]:
    """Put something else in the place of one of the matches."""

    def damage(text: str, random: Random, others: Sequence[str]) -> str:
        found = list(re.finditer(pattern, text))
        if not found:
            return text
        match = random.choice(found)
        return text[: match.start(1)] + random.choice(others) + text[match.end(1) :]

    return damage


def _value(text: str, random: Random) -> str:
    return _at_one(r"=[ \t]*([^\n=]+)")(text, random, VALUES)


def _number(text: str, random: Random) -> str:
    return _at_one(r"(-?\d+\.?\d*(?:e-?\d+)?)")(text, random, VALUES)


def _word(text: str, random: Random) -> str:
    """A word replaced by another word of the text, or by one that is almost it."""
    words = re.findall(r"[A-Za-z_]\w*", text) or ["x"]
    word = random.choice(words)
    others = (random.choice(words), word[:-1], word + word, word.upper(), "m", "constructor")
    return _at_one(r"([A-Za-z_]\w*)")(text, random, others)


DAMAGES = (_cut, _insert, _character, _line, _value, _value, _number, _number, _word)


def damaged(content: bytes, random: Random) -> bytes:
    """Bytes with one kind of damage: cut, longer, with bits turned, or partly overwritten."""
    start = random.randrange(len(content) + 1)
    kind = random.randrange(5)
    if kind == 0:
        return content[:start]
    if kind == 1:
        return content + random.randbytes(random.randrange(1, 64))
    if kind == 2:
        size = random.randrange(1, 200)
        return content[:start] + random.randbytes(size) + content[start + size :]
    if kind == 3:
        return content[:start] + content[start + random.randrange(1, 200) :]
    bits = bytearray(content)
    for _ in range(random.randrange(1, 9)):
        if bits:
            bits[random.randrange(len(bits))] ^= 1 << random.randrange(8)
    return bytes(bits)


def check_message(text: str) -> None:
    """Fail unless a message can be read on a terminal: not empty, not long, nothing invisible."""
    assert text.strip()
    assert len(text) <= LONGEST, f"{len(text)} characters: {text[:200]!r}"
    unreadable = {c for c in text if not c.isprintable() and c != "\n"}
    assert not unreadable, f"{unreadable}: {text[:200]!r}"


@contextmanager
def within(seconds: float) -> Iterator[None]:
    """Fail when the block takes longer."""

    def stop(number: int, frame: FrameType | None) -> None:
        raise TimeoutError(f"nothing came back within {seconds:g} s")

    before = signal.signal(signal.SIGALRM, stop)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
