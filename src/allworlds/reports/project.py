"""The folder to which file names in reports are relative."""

from __future__ import annotations

import os
from pathlib import Path


def project_folder() -> Path:
    """The project's folder in a CI service; elsewhere the current folder."""
    return Path(os.environ.get("GITHUB_WORKSPACE") or Path.cwd()).resolve()
