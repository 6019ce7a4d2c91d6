"""Print the disk sizes of the packages of this environment, largest first.

Usage: python installed_sizes.py [HOW_MANY], with the Python of the environment.
"""

from __future__ import annotations

import sys
from importlib.metadata import distributions
from pathlib import Path

#: Bytes of a megabyte, as everywhere on these pages.
MEGABYTE = 1_000_000


def sizes() -> dict[str, int]:
    """Bytes of each package, including its compiled modules."""
    found = {}
    for package in distributions():
        files = {Path(str(package.locate_file(file))) for file in package.files or ()}
        found[package.metadata["Name"]] = sum(f.stat().st_size for f in files if f.is_file())
    return dict(sorted(found.items(), key=lambda item: -item[1]))


if __name__ == "__main__":
    most = int(sys.argv[1]) if len(sys.argv) > 1 else None
    measured = sizes()
    for name, size in list(measured.items())[:most]:
        print(f"{size / MEGABYTE:8.1f} MB  {name}")
    print(f"{sum(measured.values()) / MEGABYTE:8.1f} MB  all {len(measured)} packages")
