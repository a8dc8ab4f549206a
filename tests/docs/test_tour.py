"""The notebook of the examples runs from its first cell to its last, and shows what is kept."""

import json
import re
from pathlib import Path
from xml.etree import ElementTree as ET

TOUR = Path(__file__).parents[2] / "examples/tour.ipynb"
SVG = "image/svg+xml"


def outputs(notebook):
    """The outputs of each cell of code."""
    return [cell["outputs"] for cell in notebook["cells"] if cell["cell_type"] == "code"]


def substance(output):
    """The kind of an output, and the numbers in it, without its wording and its layout."""
    data = output.get("data", {})
    text = output.get("text", "") or data.get("text/plain", "")
    if SVG in data:
        text = " ".join(ET.fromstring(data[SVG]).itertext()).partition("\n#map")[0]
    return sorted(data), re.findall(r"\d[\d,.]*\d|\d", text)


def test_the_outputs_that_are_kept_are_small_and_show_every_picture():
    text = TOUR.read_text(encoding="utf-8")
    assert len(text) < 100_000
    every = [out for each in outputs(json.loads(text)) for out in each]
    assert not any(out["output_type"] == "error" for out in every)
    assert sum(SVG in out.get("data", {}) for out in every) == 3
    assert "srcdoc" not in text


def test_another_number_or_kind_is_another_substance():
    one = {"output_type": "stream", "text": "walks 12 of 1,204, 0.5\n"}
    assert substance(one) == ([], ["12", "1,204", "0.5"])
    assert substance({**one, "text": "it  walks 12 of 1,204,\n 0.5"}) == substance(one)
    assert substance({**one, "text": "walks 12 of 1,205, 0.5"}) != substance(one)
    assert substance({"data": {"text/plain": "12 1,204 0.5"}}) != substance(one)
