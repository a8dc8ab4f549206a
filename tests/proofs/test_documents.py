"""JSON files are read strictly."""

import pytest

DEEP = "[" * 100_000


@pytest.fixture
def read_json(checkers, tmp_path):
    """A function that reads a text as a JSON file."""

    def read(text):
        (tmp_path / "file.json").write_bytes(text.encode())
        return checkers("documents").read_json(tmp_path / "file.json")

    return read


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (DEEP, "file.json is nested too deeply to be read"),
        ('{"a":' * 100_000, "file.json is nested too deeply to be read"),
        ("", "file.json is no JSON"),
        ("[1,]", "file.json is no JSON"),
        ("[1] 2", "file.json is no JSON"),
        ('{"a": 1, "a": 2}', "the name 'a' stands twice"),
        ('{"x": {"a": 1, "b": 0, "a": 1}}', "the name 'a' stands twice"),
        ("[0.0]", "the number 0.0 is no integer"),
        ("[1e3]", "the number 1e3 is no integer"),
        ("[NaN]", "the number NaN is no integer"),
        ("[-Infinity]", "the number -Infinity is no integer"),
        (f"[{'1' * 5000}]", "file.json is no JSON"),
        ('["\u00e9"]', "file.json is damaged"),
    ],
)
def test_what_is_not_exactly_a_document_is_refused_in_one_line(checkers, read_json, text, message):
    with pytest.raises(checkers("lrat").Refused) as error:
        read_json(text)
    assert message in str(error.value)
    assert len(str(error.value)) < 200
    assert "\n" not in str(error.value)


def test_what_is_a_document_is_read(read_json):
    assert read_json('{"a": [1, -2, "x", null, true]}\n') == {"a": [1, -2, "x", None, True]}


WORLD = {"sigma": [1, 0], "alpha": [1, 0], "start": 0}


@pytest.mark.parametrize(
    ("lighthouse", "shown", "message"),
    [
        ("none", {}, None),
        ("position", {"dart": 1}, None),
        ("directional", {"dart": 1}, None),
        ("compass", {"darts": [1]}, None),
        ("none", {"dart": 0}, "with the names kind alone"),
        ("position", {"dart": 2}, "a reference dart is 2, but the darts are 0 to 1"),
        ("directional", {"dart": False}, "not a list of integers"),
        ("directional", {"darts": [0]}, "with the names dart, kind alone"),
        ("compass", {"darts": [0, 1]}, "not exactly one reference dart"),
        ("compass", {"darts": []}, "not exactly one reference dart"),
        ("compass", {"darts": 0}, "not a list of integers"),
    ],
)
def test_a_lighthouse_has_exactly_the_darts_that_its_kind_has(checkers, lighthouse, shown, message):
    world_of = checkers("documents").world_of
    document = {**WORLD, "lighthouse": {"kind": lighthouse, **shown}}
    if message is None:
        assert world_of(document, lighthouse).lighthouse == lighthouse
        return
    with pytest.raises(checkers("lrat").Refused, match=message):
        world_of(document, lighthouse)


def test_a_lighthouse_that_there_is_not_shows_nothing_and_is_refused(checkers):
    maps = checkers("maps")
    world = maps.World([1, 0], [1, 0], 0, "xyz", (0,))
    with pytest.raises(checkers("lrat").Refused, match="there is no lighthouse 'xyz'"):
        maps.percepts(world)
