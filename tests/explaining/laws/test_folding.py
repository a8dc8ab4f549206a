"""Logs that do not determine the map, in words."""


def test_folding_names_the_open_darts_and_the_vertex_seen_as_several(told):
    law, step, text = told("no-retracing")
    assert (law, step) == ("folding", None)
    assert "v1: darts 1, 3 and 5" in text
    assert "dart 3 to dart 5 of v1" in text
    assert "came to v1 in 2 ways" in text
