"""The checker of sensors: it takes what the package writes, and no other statement."""

import copy
import json

import pytest

from allworlds.ambiguity import sensors, weakest
from recorded.record import HERE

KINDS = ("position", "door", "word:12", "word:01*", "directional", "none")
OWN = f"{HERE}/features.py:Ends"


@pytest.fixture(scope="module")
def compared():
    return json.loads(json.dumps(sensors(*KINDS, edges=2).to_json()))


@pytest.fixture(scope="module")
def coarsened():
    return json.loads(json.dumps(weakest(OWN, edges=2).to_json()))


@pytest.fixture
def refusal(checkers):
    def refused(document):
        with pytest.raises(checkers("lrat").Refused) as error:
            checkers("sensor_twins").check(document)
        return str(error.value)

    return refused


def test_what_the_package_writes_is_verified(checkers, compared, coarsened):
    check = checkers("sensor_twins").check
    assert check(compared) == [
        "position: alike: m = 2 and m = 2",
        "door: no two worlds with m <= 2 are alike",
        "word:12: alike: m = 2 and m = 2",
        "word:01*: no two worlds with m <= 2 are alike",
        "directional: no two worlds with m <= 2 are alike",
        "none: alike: m = 1 and m = 2",
        "dominates, coarser, minimal: as in all these worlds",
    ]
    assert check(coarsened) == [
        "[['away', 'behind', 'door']]: alike: m = 1 and m = 2",
        "minimal: 3; sufficient: 4 of 5",
        "not checked: stated: tried",
    ]


EVERY = (
    *("none", "position", "directional", "directional:start=any", "door", "door:start=any"),
    *("word:012", "word:10*2", "compass", "cluster", "cluster:single=true", "natural", "labels"),
    *("cluster:single=true,start=any", "told:n,m,d,g", "told:g", "none+told:m,n", "door+compass"),
)


@pytest.mark.parametrize(
    "scope",
    [
        {"edges": 3},
        {"edges": 3, "vertices": 2},
        {"edges": 4, "map_class": "simple"},
        {"edges": 4, "map_class": "planar-simple", "vertices": 3},
    ],
    ids=str,
)
def test_of_every_kind_each_number_is_counted_anew(checkers, scope):
    said = checkers("sensor_twins").check(
        json.loads(json.dumps(sensors(*EVERY, **scope).to_json()))
    )
    assert len(said) == len(EVERY) + 1
    assert not any("not checked" in line for line in said)


# ---- Forgeries ----


def other(value):
    """Values that are not this one."""
    match value:
        case bool():
            return [not value, int(value)]
        case int():
            return [value + 1, value - 1, value + 200, str(value), float(value)]
        case str():
            return [f"{value}x", "", "labels", 7]
        case list():
            return [[*value, *value], value[1:], value[:-1], {}]
        case dict():
            changed = [{**value, key: each} for key in value for each in (None, [], "x")]
            return [{}, [], *(each for each in changed if each != value)]
    return [1, False, []]


def forgeries(document, rows):
    """Documents in which a row says something else: what was done, the rows, the document."""
    for i, row in enumerate(document[rows]):
        for key in row:
            values = [*other(row[key]), *([None] if row[key] is not None else [])]
            changed = [{**row, key: value} for value in values if value != row[key]]
            changed += [{name: row[name] for name in row if name != key}]
            for number, each in enumerate(changed):
                listed = [*document[rows]]
                listed[i] = each
                yield f"{key} {number}", (i,), {**document, rows: listed}
            for j, beside in enumerate(document[rows][:i]):
                if beside.get(key, row[key]) != row[key]:
                    listed = copy.deepcopy(document[rows])
                    listed[i][key], listed[j][key] = beside[key], row[key]
                    yield f"{key} with that of {j}", (i, j), {**document, rows: listed}


KINDS_OF_ROWS = [("compared", "rows"), ("coarsened", "refuted"), ("coarsened", "minimal")]


@pytest.mark.parametrize(("name", "rows"), KINDS_OF_ROWS)
def test_no_key_of_a_row_may_be_left_out_null_changed_or_that_of_another(
    request, refusal, name, rows
):
    row, tried = "row" if rows == "rows" else rows, 0
    for what, numbers, forged in forgeries(request.getfixturevalue(name), rows):
        said = refusal(forged)
        assert any(f"{row} {i}" in said for i in numbers), (what, numbers, said)
        tried += 1
    assert tried >= {"rows": 200, "refuted": 15, "minimal": 30}[rows]


@pytest.mark.parametrize("name", ["compared", "coarsened"])
def test_no_key_of_a_document_may_be_another(request, refusal, name):
    document = request.getfixturevalue(name)
    for key in document.keys() - {"schema", "made_by", "rows", "refuted", "tried"}:
        assert refusal({each: document[each] for each in document if each != key})
        for value in [None, *other(document[key])]:
            assert refusal({**document, key: value}), (key, value)
    for key in document["scope"]:
        scope = {each: document["scope"][each] for each in document["scope"] if each != key}
        assert refusal({**document, "scope": scope})


def deep(row):
    """Every row in which something of the twins is another."""
    for world in (0, 1):
        for key, dart in (("sigma", 0), ("alpha", 1), ("start", None)):
            changed = copy.deepcopy(row)
            place = changed["twins"]["worlds"][world]
            if dart is None:
                place[key] = len(place["sigma"])
            else:
                place[key][dart] = place[key][dart - 1]
            yield changed
        for dart in range(len(row["twins"]["bisimulation"][world])):
            changed = copy.deepcopy(row)
            changed["twins"]["bisimulation"][world][dart] += 17
            yield changed
            for key in ("degree", "marks", "bearing"):
                changed = copy.deepcopy(row)
                at = changed["twins"]["sensed"][world][dart]
                at[key] = (at[key] or 0) + 1
                yield changed
        for wrong in (-1, 1.0, None, "0", 99):
            changed = copy.deepcopy(row)
            changed["twins"]["worlds"][world]["lighthouse"]["dart"] = wrong
            yield changed
    changed = copy.deepcopy(row)
    for column in changed["twins"].values():
        column[1] = column[0]
    yield changed


@pytest.mark.parametrize(("name", "rows"), KINDS_OF_ROWS[:2])
def test_nothing_in_two_worlds_may_be_another(request, refusal, name, rows):
    document = request.getfixturevalue(name)
    for i, row in enumerate(document[rows]):
        for changed in deep(row) if "twins" in row else ():
            listed = [*document[rows][:i], changed, *document[rows][i + 1 :]]
            said = refusal({**document, rows: listed})
            assert said.startswith((f"row {i}", f"refuted {i}")), said


# ---- Statements of a stranger's ----


def with_row(document, i, **changed):
    rows = [*document["rows"]]
    rows[i] = {**rows[i], **changed}
    return {**document, "rows": rows}


def test_the_twins_of_position_are_none_of_the_door(refusal, compared):
    twins = compared["rows"][0]["twins"]
    fails = {"sufficient": False, "first": 2, "ambiguous": 3}
    said = refusal(with_row(compared, 1, twins=twins, **fails))
    assert said == "row 1, door: the lighthouse of a world is position, not door"
    twins = copy.deepcopy(twins)
    for world in twins["worlds"]:
        world["lighthouse"]["kind"] = "door"
    said = refusal(with_row(compared, 1, twins=twins, **fails))
    assert said == "row 1, door: the sensor shows something else than what is sensed"
    for one in (*twins["sensed"][0], *twins["sensed"][1]):
        one["marks"] = 0
    assert said == refusal(with_row(compared, 1, twins=twins, **fails))


def test_a_verdict_without_two_worlds_is_refused(refusal, compared):
    twins = {"sufficient": True, "first": None, "ambiguous": 0, "twins": None}
    said = refusal(with_row(compared, 0, **twins))
    assert said == "row 0, position: first is None, not 2"
    assert "row 0, position: two worlds look alike just where" in refusal(
        with_row(compared, 0, twins=None)
    )
    assert "nothing to verify" in refusal({**compared, "rows": []})


def test_more_sensors_do_not_suffice_than_those_that_are_finer(refusal, coarsened):
    for number in (203, 5, 3, 0, None, True):
        assert refusal({**coarsened, "sufficient": number}).startswith("sufficient, by the minimal")


def test_the_blank_sensor_is_not_minimal(refusal, coarsened):
    blank = [{"letters": [["away", "behind", "door"]], "below": []}]
    said = refusal({**coarsened, "minimal": blank, "sufficient": 5, "tried": 1})
    assert said.startswith("minimal 0, [['away', 'behind', 'door']]: a sensor that is no coarser")
    other_one = {**coarsened, "minimal": coarsened["minimal"][:1], "sufficient": 2}
    assert "suffices, and is not there" in refusal(other_one)
    three = {"letters": [["away"], ["behind"], ["door"]], "below": [0, 0, 0]}
    said = refusal({**coarsened, "minimal": [*coarsened["minimal"], three]})
    assert said.startswith("minimal 3, [['away'], ['behind'], ['door']]: nothing refutes")


def test_what_is_said_to_suffice_is_tried_in_all_worlds(refusal, coarsened):
    """With 3 edges both ends of the door's edge with one letter are not enough, with 2 they are."""
    scope = {**coarsened["scope"], "edges": 3}
    said = refusal({**coarsened, "scope": scope})
    assert said == "minimal 2, [['away'], ['behind', 'door']]: it does not suffice"
    simple = json.loads(json.dumps(sensors("position", edges=3, map_class="simple").to_json()))
    simple["scope"]["class"] = "maps"
    assert refusal(simple) == "row 0, position: first is None, not 2"


V0_AND_TWO = [1, 0, 3, 4, 2, 6, 7, 5]
LOOPS, BETWEEN = [2, 5, 0, 4, 3, 1, 7, 6], [2, 5, 0, 7, 6, 1, 4, 3]


def test_a_start_off_v0_is_refused(checkers):
    """Two vertices are joined to v0, and have a loop each, or are joined by two edges."""
    twins = checkers("sensor_twins")
    shows = twins.shown_by(checkers("sensed").known("position"))
    scope = twins.Scope(4, None, "maps", narrowed=False)
    stands = {"kind": "position", "dart": 0}
    sensed = [{"degree": 2, "marks": 1, "bearing": None}] * 2
    sensed += [{"degree": 3, "marks": 0, "bearing": None}] * 6

    def pair(start):
        world = {"sigma": V0_AND_TWO, "start": start, "lighthouse": stands}
        worlds = [{**world, "alpha": alpha} for alpha in (LOOPS, BETWEEN)]
        classes = [0, 0, 1, 2, 3, 1, 2, 3]
        return {"worlds": worlds, "sensed": [sensed] * 2, "bisimulation": [classes] * 2}

    assert twins.check_pair(pair(1), shows, scope) == ("alike: m = 4 and m = 4", 4)
    with pytest.raises(checkers("lrat").Refused, match=r"cannot stand at .* where the start is 2"):
        twins.check_pair(pair(2), shows, scope)
    for edges, of_class in ((3, "maps"), (4, "simple")):
        small = twins.Scope(edges, None, of_class, narrowed=False)
        with pytest.raises(checkers("lrat").Refused, match=r"a world is (larger|not in the class)"):
            twins.check_pair(pair(1), shows, small)


def test_worlds_of_which_something_else_is_told_are_not_alike(checkers, compared):
    """The twins of the blank sensor have one edge, and two."""
    twins, pair = checkers("sensor_twins"), copy.deepcopy(compared["rows"][-1]["twins"])
    for world in pair["worlds"]:
        world["lighthouse"] = {"kind": "told", "names": ["m"]}
    shows = twins.shown_by(checkers("sensed").known("told:m"))
    with pytest.raises(checkers("lrat").Refused, match="told something else"):
        twins.check_pair(pair, shows, twins.Scope(2, None, "maps", narrowed=False))


def test_null_and_other_texts_are_no_document(refusal, compared):
    for nothing in (None, [], {}, 7, "rows", {"rows": None}, {"rows": [], "refuted": []}):
        assert refusal(nothing).startswith("the document: ")
    for rows in (None, {}, 7, [None], [[]], [compared["rows"][0], None]):
        assert refusal({**compared, "rows": rows})


# ---- What is not known ----


def test_of_a_sensor_of_ones_own_and_of_large_worlds_it_is_said_what_is_not_checked(
    checkers, refusal, monkeypatch, tmp_path
):
    (tmp_path / "blank.py").write_text(BLANK)
    own = f"{tmp_path}/blank.py:Blank"
    document = json.loads(json.dumps(sensors("door", own, edges=2).to_json()))
    check = checkers("sensor_twins").check
    said = check(document)
    assert said[0] == "door: no two worlds with m <= 2 are alike"
    assert "sensed as the file says; not checked: stated: what it shows" in said[1]
    assert "coarser, minimal: not checked: stated" in said[2]
    assert "nor FILE.py:Class" in refusal(with_row(document, 1, lighthouse="blank"))
    assert "the kind of a lighthouse is" in refusal(with_row(document, 1, lighthouse=f"{own}er"))
    assert "with the same places" in refusal(with_row(document, 1, worlds=1000))
    monkeypatch.setattr(checkers("sensor_worlds"), "FURTHEST", 1)
    said = check(document)
    assert said[0].startswith("door: no two worlds with m <= 1 are alike; not checked: stated: ")
    assert refusal(with_row(document, 0, worlds=1)).startswith("row 0, door: worlds is 1")
    where = {**document, "scope": {**document["scope"], "where": "cubic"}}
    assert check(where)[0].startswith("door: not checked: stated: sufficient")


BLANK = """
from dataclasses import dataclass
from allworlds import Lighthouse, Percept

@dataclass(frozen=True)
class Blank(Lighthouse):
    dart: int

    @classmethod
    def places(cls, map_, start):
        for bearing in range(map_.degree_at[start]):
            yield cls(map_.turn(start, bearing))

    def sensed(self, map_, here):
        return Percept(map_.degree_at[here])
"""


def test_features_that_are_not_known_show_what_the_file_says(checkers, refusal, coarsened):
    text = json.dumps(coarsened).replace('"away"', '"elsewhere"')
    said = checkers("sensor_twins").check(json.loads(text))
    assert said[0].endswith("sensed as the file says")
    assert "not checked: stated: what the finest sensor shows, that the minimal ones" in said[-1]
    assert refusal({**json.loads(text), "sufficient": 5}).startswith("sufficient")


def test_the_program_answers_by_its_exit_code(checkers, compared, tmp_path, capsys):
    main = checkers("sensor_twins").main
    (tmp_path / "twins.json").write_text(json.dumps(compared))
    assert main([str(tmp_path / "twins.json")]) == 0
    assert capsys.readouterr().out.endswith("VERIFIED\n")
    for wrong in ('{"rows": [{}]}', "null", "[", "1" * 5000, "[" * 100_000):
        (tmp_path / "other.json").write_text(wrong)
        assert main([str(tmp_path / "other.json")]) == 1, wrong[:9]
        assert capsys.readouterr().out.startswith("REFUSED: ")
    assert main([str(tmp_path / "none.json")]) == 2
    assert main([]) == 2
