"""The notebook of the examples runs from its first cell to its last, and shows what is kept."""

from docs import tour
from docs.test_tour import SVG, outputs, substance


def test_the_tour_runs_shows_its_pictures_and_keeps_what_it_puts_out(tmp_path):
    # Without the extra 'notebook' it fails, so that no skipped test is taken for a passed one.
    notebook = tour.executed(tmp_path)
    assert (tmp_path / "theta-torus.svg").read_text(encoding="utf-8").startswith("<svg")
    shown = [out["data"] for each in outputs(notebook) for out in each if "data" in out]
    assert sum(SVG in data for data in shown) == 3
    assert sum("srcdoc" in data.get("text/html", "") for data in shown) == 2
    found, kept = outputs(tour.kept(notebook)), outputs(tour.read())
    assert [[*map(substance, each)] for each in found] == [[*map(substance, each)] for each in kept]
