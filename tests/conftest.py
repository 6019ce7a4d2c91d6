"""Settings for all tests."""

from __future__ import annotations

import os
from pathlib import Path

# code compiled by tests stays out of the user's own cache
os.environ.setdefault(
    "CHAPLYGIN_CACHE", str(Path(__file__).parents[1] / ".pytest_cache" / "compiled")
)
