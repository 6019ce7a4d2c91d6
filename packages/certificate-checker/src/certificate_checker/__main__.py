"""``python -m certificate_checker FILE…`` checks certificates.

A file holds one certificate or a list of certificates.  Exit status 0: all of them are valid; 1:
at least one is not valid; 2: the file contains something else.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import NoReturn

from .certificate import check
from .claim.errors import BadInputError, CheckError
from .identities.error_bound import SECURITY

USAGE = "usage: python -m certificate_checker FILE [FILE ...]"


def main(arguments: Sequence[str]) -> int:
    """Check the certificates in files, and print the result for each."""
    if not arguments or arguments[0] in ("-h", "--help"):
        print(USAGE, file=sys.stdout if arguments else sys.stderr)
        return 0 if arguments else 2
    worst = 0
    for file in arguments:
        try:
            data = _read(file)
        except BadInputError as error:
            print(f"{file}: {error}", file=sys.stderr)
            worst = 2
            continue
        several = data if isinstance(data, list) else [data]
        if not several:
            print(f"{file}: the file contains no certificate", file=sys.stderr)
            worst = 2
        for number, one in enumerate(several, 1):
            label = f"{file}, certificate {number}" if isinstance(data, list) else file
            worst = max(worst, _exit_status(one, label))
    return worst


def _exit_status(certificate: object, label: str) -> int:
    """Check one certificate, print the result and return its exit status."""
    try:
        check(certificate)
    except BadInputError as error:
        print(f"{label}: {error}", file=sys.stderr)
        return 2
    except CheckError as error:
        print(f"{label}: does not check: {error}")
        return 1
    assert isinstance(certificate, Mapping)
    exact = certificate["verdict"] == "refuted"
    odds = "" if exact else f"; a false one would pass with a probability below 2^-{SECURITY}"
    print(f"{label}: checks{odds}")
    return 0


def _read(file: str) -> object:
    try:
        return json.loads(
            Path(file).read_text(encoding="utf-8"),
            object_pairs_hook=_distinct,
            parse_constant=_refuse_constant,
        )
    except OSError as error:
        raise BadInputError(f"the file cannot be read: {error.strerror}") from None
    except (ValueError, RecursionError) as error:
        raise BadInputError(f"this is not JSON: {error}") from None


def _distinct(pairs: list[tuple[str, object]]) -> dict[str, object]:
    """Dictionary of the pairs; ValueError if a name occurs twice."""
    mapping = dict(pairs)
    if len(mapping) < len(pairs):
        raise ValueError("a name occurs twice in one mapping")
    return mapping


def _refuse_constant(word: str) -> NoReturn:
    raise ValueError(f"{word} is not a number")


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
