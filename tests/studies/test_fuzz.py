import pytest

from allworlds import Move, merge
from allworlds.engines.listeners import Listener
from allworlds.inputs.checks import InputError
from allworlds.maps.build import named_map
from allworlds.maps.classes import Extent, MapClass, condition_named
from allworlds.maps.mixture import PARTS
from allworlds.maps.quotient import classes_of_union
from allworlds.reports.content.check import scope_words, size_table
from allworlds.reports.formats import file_of, text as text_of
from allworlds.studies.check.covered import FEATURES, telling_apart
from allworlds.studies.fuzz.sample_sweep import fuzz
from allworlds.studies.fuzz.sampling import SMALL, SMALL_RUNS, SmallBatch
from allworlds.world import Directional


def test_algorithm_1_is_not_refuted_and_that_is_no_proof():
    report = fuzz("algorithm1", edges=14, runs=200)
    assert (report.verdict, report.exit_code) == ("not-refuted", 0)
    assert not report.complete
    assert report.runs == 200
    document = report.to_json()
    assert document["scope"]["sample"] == {
        "edges": 14,
        "min_edges": 1,
        "runs": 200,
        "seed": 0,
        "mix": [*PARTS],
    }
    assert document["scope"]["gate"] == "absent"
    assert not document["scope"]["complete"]
    assert sum(row["runs"] for row in document["rows"]) == 200


def test_a_sample_beyond_the_exhaustive_bound_has_a_row_for_each_number_of_edges():
    report = fuzz("algorithm1", edges=9, runs=40, min_edges=6)
    assert {row["edges"] for row in report.to_json()["rows"]} == {6, 7, 8, 9}
    table = size_table(report)
    header, rows = table.header, table.texts
    assert [row[0] for row in rows] == ["6", "7", "8", "9"]
    for what in ("worlds", "runs", "traversals"):
        told = sum(int(row[header.index(what)].replace(",", "")) for row in rows)
        assert told == sum(row[what] for row in report.to_json()["rows"])
    assert "of the class 'maps' with 6 to 9 edges" in dict(scope_words(report))["scope"]
    assert ': 40 random worlds with 6 to 9 edges" ' in file_of("junit", report)


def test_a_sample_without_any_place_of_the_lighthouse_is_vacuous():
    report = fuzz("algorithm1-natural", edges=1, runs=5, map_class="simple")
    assert (report.verdict, report.exit_code, report.left_out) == ("vacuous", 4, 5)
    assert text_of(report, 100).startswith("VACUOUS    the scope holds no run\n")


def test_a_shard_without_a_run_says_so(tmp_path):
    (tmp_path / "runs").mkdir()
    reports = [fuzz(edges=4, runs=2, shard=(k, 3), run=tmp_path / f"runs/{k}") for k in range(3)]
    assert [report.runs for report in reports] == [2, 0, 0]
    assert [text_of(report, 100).split()[0] for report in reports] == [
        "NOT-REFUTED",
        "EMPTY",
        "EMPTY",
    ]
    assert merge(*(tmp_path / "runs").iterdir()).to_json() == fuzz(edges=4, runs=2).to_json()


def test_the_text_of_a_sample_speaks_of_no_levels():
    for report in (
        fuzz("algorithm1", edges=4, runs=3),
        fuzz("algorithm1", edges=40, runs=10**6, time_limit=0.2),
        fuzz(stays, edges=2, runs=3),
    ):
        assert "level" not in text_of(report, 100)


def stays(first):
    return None
    yield


@pytest.mark.parametrize(
    ("least", "words"), [(0, "min-edges = 0 is not positive"), (10, "is more than edges = 9")]
)
def test_a_least_number_of_edges_that_no_world_can_have_is_refused(least, words):
    with pytest.raises(InputError, match=words):
        fuzz("algorithm1", edges=9, runs=1, min_edges=least)


def test_whoever_listens_is_told_of_every_world():
    told = []

    class Listening(Listener):
        def level(self, edges, size):
            told.append((edges, size))

        def progress(self, worlds):
            told.append(worlds)

    fuzz(edges=6, runs=150, listener=Listening())
    levels = [(SMALL, SMALL_RUNS), (6, 16), (6, 48), (6, 86)]
    assert [each for each in told if each in levels] == levels
    assert sum(each for each in told if each not in levels) == SMALL_RUNS + 150


def walks_for_ever(first):
    while True:
        yield Move(1)


def answers_at_once(first):
    return 0
    yield


def test_who_walks_for_ever_is_found_in_a_small_world():
    report = fuzz(walks_for_ever, edges=50, min_edges=40, runs=16)
    (finding,) = report.findings
    assert (finding.law, finding.world.map.edge_count) == ("budget", 1)
    assert (report.runs, report.verdict.value) == (SMALL_RUNS, "refuted")
    assert report.traversals < 10_000
    # Any other slip is left to the sample.
    other = fuzz(answers_at_once, edges=5, runs=16)
    assert (other.findings[0].law, other.runs) == ("no-estimate", 16)


def test_a_sample_of_worlds_that_are_never_small_begins_with_none():
    kind = Extent(MapClass.MAPS, 9, where=condition_named("regular:9"))
    assert [*SmallBatch(0, ()).placed(kind, Directional)] == []


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"edges": 0}, "edges = 0"),
        ({"runs": 0}, "runs = 0 is not positive"),
        ({"workers": 0}, "workers 0"),
        ({"map_class": "trees"}, "'trees'"),
        ({"lighthouse": "lamp"}, "'lamp'"),
        ({"policy": "best"}, "'best'"),
        ({"laws": ("gravity",)}, "gravity"),
        ({"explore": "nobody"}, "nobody"),
        ({"time_limit": 0.0}, "time-limit 0.0"),
    ],
)
def test_a_bad_option_is_refused_by_name(options, message):
    with pytest.raises(InputError, match=message):
        fuzz(**{"edges": 5, "runs": 5, **options})


# ---------------------------------------------------------------- told honestly


def test_a_report_tells_what_was_covered_and_what_follows():
    report = fuzz("algorithm1", edges=9, runs=36, seed=1)
    covered = {row.feature: (row.least, row.median, row.most) for row in report.covered}
    assert [*covered] == [*FEATURES]
    edges = sorted(row.edges for row in report.rows for _ in range(row.worlds))
    assert covered["edges m"] == (edges[0], edges[17], edges[-1])
    assert all(least <= median <= most for least, median, most in covered.values())
    told = dict(scope_words(report))
    assert told["mixture"].startswith(
        "drawn in these ways in turn: uniform, cover, ring, regular, sparse, planar,"
    )
    assert told["chance"] == (
        "none of 36 random draws refutes the explorer; one more draw refutes it with a probability "
        "below 0.08333 (at 95 % confidence)"
    )
    # That is so: a slip that shows with this probability escapes 36 draws less often.
    bounds = {draws: float(f"{3 / draws:.4g}") for draws in (3, 36, *range(1000, 1100), 10**6)}
    assert all((1 - bound) ** draws < 0.05 for draws, bound in bounds.items())


def test_nothing_follows_for_a_shard_or_from_a_refuted_or_unfinished_sample():
    for report in (
        fuzz("algorithm1", edges=4, runs=8, shard=(0, 2)),
        fuzz(stays, edges=2, runs=3),
        fuzz("algorithm1", edges=40, runs=10**6, time_limit=0.1),
    ):
        assert "chance" not in dict(scope_words(report))


@pytest.mark.parametrize(
    ("name", "sheets", "test"),
    # All darts of a cycle look alike; of a path each dart and its mirror image.
    [("cycle-7", 14, 0), ("path-6", 2, 2), ("edge", 2, 0), ("fig1-left", 4, 2)],
)
def test_how_many_darts_look_alike_and_how_long_a_test_is(name, sheets, test):
    map_ = named_map(name)
    assert telling_apart(map_) == (sheets, test)
    partition = classes_of_union((map_, [0] * len(map_.sigma), 0))[0]
    assert len(map_.sigma) // len(set(partition)) == sheets
