"""The notebook of the examples runs from its first cell to its last."""

from pathlib import Path

import pytest

TOUR = Path(__file__).parents[2] / "examples/tour.ipynb"


@pytest.mark.slow
def test_the_tour_runs_and_shows_its_pictures(tmp_path):
    nbformat, nbclient = pytest.importorskip("nbformat"), pytest.importorskip("nbclient")
    pytest.importorskip("pandas")
    notebook = nbformat.read(TOUR, as_version=4)
    assert not any(cell.get("outputs") for cell in notebook.cells)
    resources = {"metadata": {"path": str(tmp_path)}}
    nbclient.NotebookClient(notebook, timeout=120, resources=resources).execute()
    assert (tmp_path / "theta-torus.svg").read_text(encoding="utf-8").startswith("<svg")
    shown = [
        out.data for cell in notebook.cells for out in cell.get("outputs", []) if "data" in out
    ]
    assert sum("image/svg+xml" in data for data in shown) == 3
    assert sum("srcdoc" in data.get("text/html", "") for data in shown) == 2
    assert any("<progress" in data.get("text/html", "") for data in shown)
