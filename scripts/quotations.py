"""Comparison of the statements of the audit with the text of the paper, word by word.

    python scripts/quotations.py TEXT [--section N] [--show] [--accept]

TEXT is a file with the text of the paper, with formulas in LaTeX between dollar signs; it is not
in the repository.  A statement is a shortened form of the printed text and is compared with its
passage.  Words that occur in only one of them, and words such as "if" and "only" in the rest of
the sentences at both ends of the passage, must be allowed for it in ``quotations.txt`` (in the
folder of this script).  Other differences are printed, and the exit status is 1.  ``--show``
prints all differences, allowed or not; ``--accept`` writes them to ``quotations.txt``, to be read
before they are committed.
"""

from __future__ import annotations

import argparse
import re
import sys
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple, TypeAlias

import numpy as np

from borisov_mamaev_2008 import claims
from flowlanes.printing.symbol_names import GREEK

ALLOWED = Path(__file__).with_suffix(".txt")

Key: TypeAlias = tuple[int, str, int]
"""Section, place, and number of the claim at this place."""

#: End of a sentence, in the words of a passage.
STOP = "¶"
#: Words on which the meaning of a sentence depends.
QUALIFIERS = frozenset(
    [
        *("if", "unless", "except", "only", "special", "provided", "suppose", "assume", "when"),
        *("likely", "might", "could", "possible", "possibility", "theoretically", "generally"),
        *("general", "generic", "usually", "least", "almost", "approximately", "small", "most"),
        *("sometimes", "not", "never", "no", "without", "simulations", "experiments"),
        *("numerically", "preliminary", "indicate", "opinion", "reported"),
    ]
)
#: Costs of an additional word, of a gap in the passage, and of each further word of the gap.
ADDED, GAP, LONGER = 1.0, 1.2, 0.01
#: Longer gaps in the passage are shortened in the list.
SHOWN = 8

_FONTS = r"\\(?:mathbf|boldsymbol|mathcal|mathrm|text|operatorname|overline|bar|left|right)\b"
_LAYOUT = re.compile(
    r"\\(?:quad|qquad|,|;|!|\\)|\\tag\{[^}]*\}|\\(?:begin|end)\{[^}]*\}(?:\{[^}]*\})?|[&{}~]"
)
_WORDS = re.compile(r"\\[A-Za-z]+|[A-Za-z]+(?:['-][A-Za-z]+)*|\d+|[^\sA-Za-z\d,.;:()\[\]\"*!?-]")
_SIGNS = re.compile(r"\\[A-Za-z]+|[A-Za-z]|\d|[^\s,.;]")
_SAME = {"\\ldots": "\\dots", "\\rightarrow": "\\to", "\\varkappa": "\\kappa", "\\mid": "|"}
_LETTERS = str.maketrans(
    {"’": "'", "‘": "'", "“": '"', "”": '"', "–": "-", "—": "-", "−": "-", "·": " ", "²": "^2"}
    | {letter: f"$\\{name}$" for name, letter in GREEK.items() if len(letter) == 1}
)


class Difference(NamedTuple):
    """Words only in the statement, and words only in the passage, at one place."""

    added: tuple[str, ...]
    omitted: tuple[str, ...]
    around: bool = False

    def __str__(self) -> str:
        if self.around:
            return f"around: {' '.join(self.omitted)}"
        omitted = list(self.omitted)
        if len(omitted) > SHOWN:
            omitted[SHOWN // 2 : -SHOWN // 2] = [f"({len(omitted) - SHOWN} more)"]
        parts = (f"-{' '.join(omitted)}" if omitted else "", f"+{' '.join(self.added)}")
        return " ".join(part for part in parts if len(part) > 1)


def tokens(text: str) -> tuple[str, ...]:
    """Words in lower case and signs of formulas, without fonts, layout and punctuation."""
    return tuple(word for word in words_and_stops(text) if word != STOP)


def words_and_stops(text: str) -> tuple[str, ...]:
    """Words, with STOP between sentences."""
    found: list[str] = []
    parts = re.split(r"\$+", text.translate(_LETTERS))
    for number, part in enumerate(parts):
        plain = re.sub(r"\\(?:text|mathrm|operatorname)\{([A-Za-z]+)\}", r"\\\1 ", part)
        plain = _LAYOUT.sub(" ", re.sub(_FONTS, " ", plain))
        if number % 2 == 0:
            plain = re.sub(r"\.\)?(?=\s+\(?[A-Z])", f" {STOP} ", plain)
        signs = (_SIGNS if number % 2 else _WORDS).findall(plain)
        found += (_SAME.get(sign, sign) for sign in signs)
    return tuple(sign.lower() if len(sign) > 1 and sign[0] != "\\" else sign for sign in found)


def sections(text: str) -> Mapping[int, tuple[str, ...]]:
    """Words of each section, without contents, acknowledgements and references."""
    heads = list(re.finditer(r"^(\d+)\. [A-Z][A-Z \-,():a-z]*$", text, flags=re.M))
    ends = [*(head.start() for head in heads[1:]), len(text)]
    last = re.search(r"^ACKNOWLEDGMENTS$", text, flags=re.M)
    if last is not None:
        ends[-1] = last.start()
    return {
        int(h[1]): words_and_stops(text[h.end() : end]) for h, end in zip(heads, ends, strict=True)
    }


def differences(statement: Sequence[str], passage: Sequence[str]) -> tuple[Difference, ...]:
    """Differences between `statement` and the part of `passage` that is nearest to it.

    The alignment of least cost is found by dynamic programming over prefixes of both: words
    outside the part cost nothing, a gap in it costs GAP and LONGER for each word (Gotoh 1982).
    """
    words = np.array(passage)
    size = len(words) + 1
    place = np.arange(size)
    best = np.zeros((len(statement) + 1, size))
    jumps = np.zeros((len(statement) + 1, size), dtype=int)
    for row, word in enumerate(statement, start=1):
        same = np.append(np.inf, np.where(words == word, best[row - 1, :-1], np.inf))
        reached = np.minimum(same, best[row - 1] + ADDED)
        # start of a gap that ends here: the minimum of reached − LONGER·place so far
        shifted = reached - LONGER * place
        least = np.minimum.accumulate(shifted)
        first = np.maximum.accumulate(np.where(shifted == least, place, 0))
        gap = np.append(np.inf, least[:-1] + GAP + LONGER * place[1:])
        jumps[row] = np.where(gap < reached, np.append(0, first[:-1]), place)
        best[row] = np.minimum(reached, gap)
    row, column = len(statement), int(best[-1].argmin())
    steps: list[tuple[str, tuple[str, ...]]] = []
    while row:
        start = int(jumps[row, column])
        if start < column:
            steps.append(("omitted", tuple(passage[start:column])))
            column = start
        word = statement[row - 1]
        row -= 1
        if (
            column
            and passage[column - 1] == word
            and best[row, column - 1] <= best[row, column] + ADDED
        ):
            column -= 1
            steps.append(("same", (word,)))
        else:
            steps.append(("added", (word,)))
    around = _around(passage, column, int(best[-1].argmin()))
    qualifying = tuple(word for word in around if word in QUALIFIERS)
    found = tuple(_grouped(steps[::-1]))
    return (*found, Difference((), qualifying, around=True)) if qualifying else found


def _around(passage: Sequence[str], start: int, end: int) -> Sequence[str]:
    """Words from the start of a sentence to `start`, and from `end` to the end of a sentence."""
    before, after = passage[:start], passage[end:]
    first = max((n + 1 for n, word in enumerate(before) if word == STOP), default=0)
    last = after.index(STOP) if STOP in after else len(after)
    return [*before[first:], *after[:last]]


def _grouped(steps: Sequence[tuple[str, tuple[str, ...]]]) -> Iterator[Difference]:
    changed: dict[str, tuple[str, ...]] = {"added": (), "omitted": ()}
    for kind, words in [*steps, ("same", ())]:
        if kind != "same":
            changed[kind] += words
        elif any(changed.values()):
            yield Difference(**changed)
            changed = {"added": (), "omitted": ()}


def allowed(text: str) -> dict[Key, tuple[str, ...]]:
    """Allowed differences of each claim in a list: a line for the claim, then one for each."""
    found: dict[Key, list[str]] = {}
    key: Key | None = None
    for line in text.splitlines():
        head = re.fullmatch(r"§(\d+) (.*?)(?: #(\d+))?", line)
        if head is not None:
            key = int(head[1]), head[2], int(head[3] or 1)
            found[key] = []
        elif line.startswith("    ") and key is not None:
            found[key].append(line.strip())
    return {name: tuple(lines) for name, lines in found.items()}


def listed(found: Mapping[Key, Sequence[Difference]]) -> str:
    """List that allows these differences."""
    lines = []
    for (section, source, number), changed in found.items():
        if changed:
            lines.append(f"§{section} {source}" + (f" #{number}" if number > 1 else ""))
            lines += (f"    {difference}" for difference in changed)
    return "".join(f"{line}\n" for line in lines)


def compared(text: str, section: int | None = None) -> dict[Key, tuple[Difference, ...]]:
    """Differences of each claim from the text of the paper."""
    passages = sections(text)
    found: dict[Key, tuple[Difference, ...]] = {}
    for number, claim in claims(section):
        which = 1 + sum(key[:2] == (number, claim.source) for key in found)
        found[number, claim.source, which] = differences(tokens(claim.statement), passages[number])
    return found


def main() -> int:
    """Compare, and print the differences that are not in a list."""
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("text", type=Path, metavar="TEXT", help="a file with the paper's text")
    arguments.add_argument("--section", type=int, help="of the paper")
    arguments.add_argument("--show", action="store_true", help="allowed differences too")
    arguments.add_argument("--accept", action="store_true", help="write the list anew")
    given = arguments.parse_args()
    found = compared(given.text.read_text(encoding="utf-8"), given.section)
    known = allowed(ALLOWED.read_text(encoding="utf-8")) if ALLOWED.exists() else {}
    strange = {k: v for k, v in found.items() if tuple(map(str, v)) != known.get(k, ())}
    sys.stdout.write(listed(found if given.show else strange))
    print(f"{len(found)} statements, {len(strange)} with differences that are not allowed")
    if given.accept and given.section is None:
        ALLOWED.write_text(listed(found), encoding="utf-8")
    return 1 if strange else 0


if __name__ == "__main__":
    sys.exit(main())
