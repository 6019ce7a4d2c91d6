"""Write public.txt of each package: the names that are used by other packages.

    python scripts/borders.py

A test compares the lists, which should only become shorter.
"""

from __future__ import annotations

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))

from workspace import HOMES, borders

if __name__ == "__main__":
    for package, names in borders().items():
        place = HOMES[package].parents[1] / "public.txt"
        place.write_text("".join(f"{name}\n" for name in sorted(names)), encoding="utf-8")
        print(f"{len(names):5}  {place}")
