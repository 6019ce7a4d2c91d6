"""Builds the site: python website/build.py, from anywhere; `make site` does it.

The pages of the repository are laid out in build/site-source as they lie here, so that their
links hold; generated pages are written beside them; Sphinx makes build/site of it. Any warning
is an error.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

from links import faults

HOME = Path(__file__).parent
ROOT = HOME.parent
SOURCE, SITE = ROOT / "build" / "site-source", ROOT / "build" / "site"
#: Pages of the repository that are pages of the site, beside docs/.
PAGES = ("CONTRIBUTING.md", "CHANGELOG.md", "benchmarks/README.md")
#: What they link to, and the examples that cells read, which are run in the folder of their page.
LINKED = ("src", "tests", "examples", "docs/examples", "docs/start/examples")


def main() -> int:
    """Build and check; 0 where nothing is wrong."""
    lay_out()
    code = subprocess.call(
        [sys.executable, "-m", "sphinx", "-b", "html", "-W", "--keep-going", "-q",
         "-c", str(HOME), *sys.argv[1:], str(SOURCE), str(SITE)]
    )  # fmt: skip
    wrong = faults(SITE)
    print("\n".join(wrong), file=sys.stderr)
    return code or bool(wrong)


def lay_out() -> None:
    """Copy pages to where Sphinx reads them; what is no longer there goes."""
    wanted = {path.relative_to(HOME / "pages"): path for path in files(HOME / "pages")}
    wanted |= {path.relative_to(ROOT): path for path in files(ROOT / "docs")}
    wanted |= {Path(name): ROOT / name for name in PAGES}
    for place, path in wanted.items():
        copy(path, SOURCE / place)
    for path in files(SOURCE):
        if path.relative_to(SOURCE) not in wanted:
            path.unlink()
    for folder, _, _ in os.walk(SOURCE, topdown=False):
        if not any(Path(folder).iterdir()):
            Path(folder).rmdir()
    for name in LINKED:
        if not (SOURCE / name).exists():
            (SOURCE / name).symlink_to(ROOT / Path(name).name)


def files(folder: Path) -> list[Path]:
    """All files below a folder; links to other folders are not followed."""
    return sorted(Path(at) / name for at, _, names in os.walk(folder) for name in names)


def copy(path: Path, place: Path) -> None:
    """Copy a file unless it is there: one that stays as it was is not read again."""
    if place.exists() and place.read_bytes() == path.read_bytes():
        return
    place.parent.mkdir(parents=True, exist_ok=True)
    shutil.copyfile(path, place)


if __name__ == "__main__":
    sys.exit(main())
