"""Run the notebook of the examples, and keep its outputs in it.

``python tests/docs/tour.py`` writes ``examples/tour.ipynb``; it takes half a minute, and needs the
extra ``notebook``.  ``test_tour.py`` compares.

Pages and bars are left out: pages do not move where a repository is read, and are large.  Their
texts stay.
"""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any

import nbclient
import nbformat

TOUR = Path(__file__).parents[2] / "examples" / "tour.ipynb"

SVG, HTML, TEXT = "image/svg+xml", "text/html", "text/plain"


def read() -> Any:
    """The notebook as it is kept."""
    return nbformat.read(TOUR, as_version=4)


def executed(folder: Path) -> Any:
    """The notebook with all that its cells put out, run in that folder."""
    notebook = read()
    resources = {"metadata": {"path": str(folder)}}
    nbclient.NotebookClient(notebook, timeout=300, resources=resources).execute()
    return notebook


def kept(notebook: Any) -> Any:
    """The notebook with the outputs that are kept."""
    for cell in notebook.cells:
        cell.metadata.pop("execution", None)  # it holds times
        if cell.cell_type == "code":
            cell.outputs = [output for output in map(_small, cell.outputs) if output]
    for name in ("version", "codemirror_mode", "nbconvert_exporter", "pygments_lexer"):
        notebook.metadata.language_info.pop(name, None)  # of whoever ran it last
    return notebook


def _small(output: Any) -> Any:
    """An output without its page."""
    data = output.get("data", {})
    if "srcdoc=" in data.get(HTML, ""):
        del data[HTML]
    if SVG in data:
        del data[TEXT]
    return output


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as made:
        nbformat.write(kept(executed(Path(made))), TOUR)
