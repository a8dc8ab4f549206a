"""The text of explain."""

import pytest

from reports.test_explain_text import explain_text, explanation_of


@pytest.mark.parametrize("width", [40, 80])
def test_every_sentence_stands_in_the_text_and_fits_the_width(width):
    explanation = explanation_of("no-retracing")
    text = explain_text(explanation, width)
    told = text.partition("\n\nThe world")[0]
    assert all(len(line) <= width for line in told.splitlines()[1:])
    for sentence in explanation.sentences:
        assert sentence in " ".join(told.split())
