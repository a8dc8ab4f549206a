"""The JSON Schemas, made from the classes of the documents whenever the package is built."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface


class SchemasHook(BuildHookInterface[Any]):
    """Writes ``src/allworlds/schemas``, which the package holds and no commit does."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:  # noqa: ARG002  # any
        """Write the schemas before the files of the package are collected."""
        source = Path(self.root) / "src"
        sys.path.insert(0, str(source))
        from allworlds.reports.schemas import main

        main(source / "allworlds" / "schemas")
