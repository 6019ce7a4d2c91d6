"""Builds the site: python website/build.py, from anywhere; `make site` does it.

The pages of the repository are laid out in build/site-source as they lie here, so that their
links hold; generated pages are written beside them; Sphinx makes build/site of it. Any warning
is an error. `--exhibits 12` builds a gallery of twelve exhibits only, for a quick check.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import os
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import claims
import gallery
import reference_pages
from exhibits import exhibits
from fences import live_pages
from links import faults
from notebooks import notebooks
from program import program_digest

from borisov_mamaev_2008.audit import audit
from chaplygin.experiment.models.schema import experiment_schema

HOME = Path(__file__).parent
ROOT = HOME.parent
BUILD = ROOT / "build"
SOURCE, FILES, SITE = BUILD / "site-source", BUILD / "site-files", BUILD / "site"
#: What was computed, kept for as long as the program is the same.
STORE = BUILD / "site-cache" / program_digest()[:16]
#: An exhibit is another also where another thing is asked of the program.
EXHIBITED = hashlib.sha256((HOME / "exhibits.py").read_bytes()).hexdigest()[:8]
#: Folders of pages, of the whole and of each package.
DOCS = (ROOT / "docs", *sorted(ROOT.glob("packages/*/docs")))
#: Pages of the repository that are pages of the site besides.
PAGES = (
    *(ROOT / name for name in ("CHANGELOG.md", "SECURITY.md", "CODE_OF_CONDUCT.md")),
    *(ROOT / "CONTRIBUTING.md", *sorted(ROOT.glob("packages/*/CONTRIBUTING.md"))),
    ROOT / "benchmarks/README.md",
)
#: What pages link to, and the examples that cells read, which are run in the folder of their page.
LINKED = {
    **{Path(name): ROOT / name for name in ("tests", "examples", "scripts")},
    **{
        path.relative_to(ROOT): path
        for package in ROOT.glob("packages/*")
        for path in (package / "src", package / "tests")
    },
    **{
        path.parent.relative_to(ROOT) / "examples": ROOT / "examples"
        for docs in DOCS
        for path in docs.rglob("*.md")
    },
}


def main() -> int:
    """Build and check; 0 where nothing is wrong."""
    options = argparse.ArgumentParser(description="Build the site.")
    options.add_argument("--exhibits", type=int, help="so many exhibits of the gallery at most")
    chosen, further = options.parse_known_args()
    lay_out(chosen.exhibits)
    # cells run the command line of this environment
    os.environ["PATH"] = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    os.environ["IPYTHONDIR"] = str(kernel_settings())
    code = subprocess.call(
        [sys.executable, "-m", "sphinx", "-b", "html", "-W", "--keep-going", "-q",
         "-c", str(HOME), "-d", str(BUILD / "site-doctrees"), *further, str(SOURCE), str(SITE)]
    )  # fmt: skip
    for path in (SITE / name for name in pages_of(SITE) - pages_of(SOURCE)):
        path.unlink()
    wrong = faults(SITE)
    print("\n".join(wrong), file=sys.stderr)
    return code or bool(wrong)


def kernel_settings() -> Path:
    """The folder of IPython's settings for the cells, whatever the user's own are."""
    settings = BUILD / "site-ipython"
    profile = settings / "profile_default"
    profile.mkdir(parents=True, exist_ok=True)
    # kernels speak to this machine alone, and each of them would warn that it does so in plain text
    (profile / "ipython_kernel_config.py").write_text("c.IPKernelApp.log_level = 40\n")
    return settings


def pages_of(folder: Path) -> set[Path]:
    """The pages below a folder, sources or built, without those that are copied as they are."""
    found = (path.relative_to(folder) for path in files(folder))
    return {
        place.with_suffix(".html")
        for place in found
        if place.suffix in (".md", ".html")
        and len(place.parts) > 1
        and place.parts[0] not in ("_static", "live")
    }


def lay_out(most: int | None) -> None:
    """Write pages where Sphinx reads them; what is no longer there goes."""
    wanted = dict(written()) | {Path(place): text.encode() for place, text in generated(most)}
    # before anything is written: nothing may be written through a link
    for path in links(SOURCE):
        if path.relative_to(SOURCE) not in LINKED:
            path.unlink()
    for place, content in wanted.items():
        write(content, SOURCE / place)
    for path in files(SOURCE):
        if path.relative_to(SOURCE) not in wanted:
            path.unlink()
    for folder, _, _ in os.walk(SOURCE, topdown=False):
        if not any(Path(folder).iterdir()):
            Path(folder).rmdir()
    for place, target in LINKED.items():
        if not (SOURCE / place).exists():
            (SOURCE / place).parent.mkdir(parents=True, exist_ok=True)
            (SOURCE / place).symlink_to(target)


def written() -> Iterator[tuple[Path, bytes]]:
    """Pages and pictures that are kept in the repository."""
    for path in files(HOME / "pages"):
        yield path.relative_to(HOME / "pages"), path.read_bytes()
    for path in [*(path for docs in DOCS for path in files(docs)), *PAGES]:
        yield path.relative_to(ROOT), path.read_bytes()


def generated(most: int | None) -> Iterator[tuple[str, str]]:
    """Pages that the program writes."""
    store = STORE / f"gallery-{EXHIBITED}"
    asked = {
        name
        for place, page in written()
        if place.suffix == ".md"
        for name in live_pages(page.decode())
    }
    found = list(exhibits(store, most, asked, say))
    yield from gallery.pages(found, store, FILES / "live")
    say("audit of the paper")
    done = audit(progress=tenths("audit of the paper"))
    judgements, left = done.judgements, done.unjudged
    if left:
        sys.exit("interrupted: the same command resumes")
    yield from claims.pages(judgements)
    schema = experiment_schema()
    for place, notebook in notebooks():
        write(notebook.encode(), FILES / place)
    (FILES / "schema").mkdir(parents=True, exist_ok=True)
    (FILES / "schema" / "experiment.schema.json").write_text(json.dumps(schema, indent=1))
    yield from reference_pages.pages(schema)


def say(what: str) -> None:
    """Say what is being done."""
    print(what, file=sys.stderr, flush=True)


def tenths(what: str) -> Callable[[float], None]:
    """Says how far something is, at every tenth."""
    last = 0

    def report(share: float) -> None:
        nonlocal last
        if int(10 * share) > last:
            last = int(10 * share)
            say(f"{what}: {10 * last}%")

    return report


def files(folder: Path) -> list[Path]:
    """All files below a folder; links to other folders are not followed."""
    return sorted(Path(at) / name for at, _, names in os.walk(folder) for name in names)


def links(folder: Path) -> list[Path]:
    """All links to folders below a folder."""
    found = (Path(at) / name for at, names, _ in os.walk(folder) for name in names)
    return [path for path in found if path.is_symlink()]


def write(content: bytes, place: Path) -> None:
    """Write a file unless it is there: one that stays as it was is not read again."""
    if place.exists() and place.read_bytes() == content:
        return
    place.parent.mkdir(parents=True, exist_ok=True)
    place.write_bytes(content)


if __name__ == "__main__":
    sys.exit(main())
