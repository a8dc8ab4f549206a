"""The folder from which reports name files."""

from __future__ import annotations

import os
from pathlib import Path


def project_folder() -> Path:
    """Where a CI service has laid the project; elsewhere the folder of the check."""
    return Path(os.environ.get("GITHUB_WORKSPACE") or Path.cwd()).resolve()
