"""Writes the answers of `show` and `prove` about the catalogue, which come with the package.

    python scripts/answers.py [NAME ...]

Answers that are up to date are computed again as well; verdicts come from the cache of the user
where nothing on which they depend has changed.
"""

from __future__ import annotations

import sys

from chaplygin.answers.compute import catalogue_answers
from chaplygin.answers.stored import SHIPPED, write_shipped
from nonholonomic.catalogue.groups import NAMES


def main() -> None:
    """Write the files of the named systems, or of all; remove those of systems that are gone."""
    for name in sys.argv[1:] or NAMES:
        write_shipped(name, catalogue_answers(name))
        print(name, flush=True)
    for path in SHIPPED.glob("*.json"):
        if path.stem not in NAMES:
            path.unlink()


if __name__ == "__main__":
    main()
