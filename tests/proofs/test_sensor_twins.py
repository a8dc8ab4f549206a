"""The checker of the twins of sensors: it takes what the package writes, and nothing else."""

import copy
import json

import pytest

from allworlds.ambiguity import sensors, weakest
from recorded.record import HERE

KINDS = ("position", "door", "word:12", "word:01*", "none")


@pytest.fixture(scope="module")
def compared():
    return json.loads(json.dumps(sensors(*KINDS, edges=2).to_json()))


@pytest.fixture(scope="module")
def coarsened():
    return json.loads(json.dumps(weakest(f"{HERE}/features.py:Ends", edges=2).to_json()))


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
        "word:12: alike: m = 2 and m = 2",
        "none: alike: m = 1 and m = 2",
    ]
    (said,) = check(coarsened)
    assert said.endswith("sensed as the file says")


def changes(row):
    """Every document in which something of the twins of a row is another."""
    for world in (0, 1):
        for key, dart in (("sigma", 0), ("alpha", 1), ("start", None)):
            other = copy.deepcopy(row)
            place = other["twins"]["worlds"][world]
            if dart is None:
                place[key] = len(place["sigma"])
            else:
                place[key][dart] = place[key][dart - 1]
            yield other
        for dart in range(len(row["twins"]["bisimulation"][world])):
            other = copy.deepcopy(row)
            other["twins"]["bisimulation"][world][dart] += 17
            yield other
            for key in ("degree", "marks"):
                other = copy.deepcopy(row)
                other["twins"]["sensed"][world][dart][key] += 1
                yield other
    other = copy.deepcopy(row)
    for column in other["twins"].values():
        column[1] = column[0]
    yield other
    yield {**row, "first": row["first"] + 1, "edges": row.get("edges", 0) + 1}


def test_no_changed_pair_is_verified(refusal, compared, coarsened):
    for i, row in enumerate(compared["rows"]):
        for other in changes(row) if "twins" in row else ():
            rows = [*compared["rows"][:i], other, *compared["rows"][i + 1 :]]
            assert refusal({**compared, "rows": rows})
    (row,) = coarsened["refuted"]
    for other in changes({**row, "first": 0}):
        other.pop("first")
        assert refusal({**coarsened, "refuted": [other]})


def test_a_verdict_without_its_pair_is_refused(refusal, compared, coarsened):
    rows = [{k: v for k, v in row.items() if k != "twins"} for row in compared["rows"]]
    assert "look alike just where it does not suffice" in refusal({**compared, "rows": rows})
    minimal = [{"letters": [["away"], ["behind"], ["door"]], "below": [0]}]
    assert "nothing refutes" in refusal({**coarsened, "minimal": minimal})
    assert "nothing to verify" in refusal({"rows": [], "refuted": []})


def test_the_program_answers_by_its_exit_code(checkers, compared, tmp_path, capsys):
    main = checkers("sensor_twins").main
    (tmp_path / "twins.json").write_text(json.dumps(compared))
    assert main([str(tmp_path / "twins.json")]) == 0
    assert capsys.readouterr().out.endswith("VERIFIED\n")
    (tmp_path / "other.json").write_text('{"rows": [{}]}')
    assert main([str(tmp_path / "other.json")]) == 1
    assert main([str(tmp_path / "none.json")]) == 2
    assert main([]) == 2
