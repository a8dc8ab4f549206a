"""The navigation, once all pages are known: a folder in it stands for its pages."""

from __future__ import annotations

from typing import Any

from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import Files


def on_files(files: Files, config: MkDocsConfig) -> Files:
    """No other files; the navigation names each page."""
    known = [file.src_uri for file in files.documentation_pages()]
    config.nav = [unfolded(entry, known) for entry in config.nav or []]
    return files


def unfolded(entry: Any, known: list[str]) -> Any:
    """An entry of the navigation; for a folder its pages, in the order in which they are known."""
    match entry:
        case dict():
            return {title: unfolded(below, known) for title, below in entry.items()}
        case list():
            return [unfolded(each, known) for each in entry]
        case str() if entry.endswith("/"):
            return [page for page in known if page.startswith(entry)]
        case _:
            return entry
