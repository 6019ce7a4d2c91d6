"""The digest of all packages, by which what is built for the site is kept."""

from __future__ import annotations

from hashlib import sha256

from flowlanes.files.source_digest import computation_digest, package_digest

#: Packages whose modules do not compute; the others count in `computation_digest`.
PRESENTATION = ("borisov_mamaev_2008", "chaplygin")


def program_digest() -> str:
    """A digest of the modules of all packages."""
    parts = (computation_digest(), *map(package_digest, PRESENTATION))
    return sha256(" ".join(parts).encode()).hexdigest()
