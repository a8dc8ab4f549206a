"""The document of a result."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any

from allworlds.reports.file_format import Format
from allworlds.words import harmless_json


def document_text(document: Mapping[str, Any]) -> str:
    """The document as a text."""
    return harmless_json(json.dumps(document, indent=2)) + "\n"


FORMAT = Format(lambda telling: document_text(telling.result.to_json()), ".json", ())
