"""Sensors side by side, the weakest ones, and the theorem on sensors at v0."""

from itertools import product
from types import SimpleNamespace

import numpy as np
import pytest

from allworlds import ambiguity
from allworlds.engines.listeners import NOBODY
from allworlds.inputs.checks import InputError
from allworlds.maps.quotient import classes_of_union
from allworlds.outcome import Disagreement
from allworlds.protocol.actions import Percept
from allworlds.reports.formats import text
from allworlds.studies.ambiguity import coarsenings, sensed_classes, side_by_side
from allworlds.world import worlds
from allworlds.world.bisimulation import flaw
from allworlds.world.lighthouses.kinds import lighthouse_kind
from recorded.record import HERE
from small import EDGE

sensors, weakest = ambiguity.sensors, ambiguity.weakest
ENDS = f"{HERE}/features.py:Ends"


def alike_by_hand(kind, edges, letters=None):
    """Whether two of all worlds look alike: of all the quotient is made at once, by Hopcroft."""
    every = [*worlds(edges=edges, lighthouse=kind, places="all")]
    seen = [
        [(p.degree, letters[p.marks]) if letters else p for p in world.percepts] for world in every
    ]
    classes = classes_of_union(*((w.map, s, 0) for w, s in zip(every, seen, strict=True)))
    groups = {}
    for world, found in zip(every, classes, strict=True):
        groups.setdefault((found[0], str(world.told)), set()).add(world.map)
    return {map_ for maps in groups.values() if len(maps) > 1 for map_ in maps}


@pytest.mark.parametrize("kind", ["none", "position", "door", "word:12", "word:01*", "compass"])
def test_sensors_fail_where_all_worlds_refined_at_once_do(kind):
    (row,) = sensors(kind, edges=2).rows
    found = [{*alike_by_hand(kind, edges)} for edges in (1, 2)]
    first = next((edges for edges, maps in enumerate(found, 1) if maps), None)
    assert row.first == first
    assert row.sufficient == (first is None)
    assert row.ambiguous == (len(found[first - 1]) if first else 0)
    if row.twins:
        one, other = row.twins.worlds
        assert one.map != other.map
        assert flaw(row.twins.worlds, row.twins.bisimulation) is None


def test_the_door_suffices_and_is_coarser_than_a_direction():
    report = sensors("position", "word:1", "door", "directional", "word:12", edges=3)
    assert [row.sufficient for row in report.rows] == [False, False, True, True, False]
    assert report.minimal == ("door",)
    assert ("door", "directional") in report.coarser
    assert ("directional", "door") not in report.coarser
    assert ("word:1", "word:12") in report.coarser
    # They tell the same in the end: who scans all doors knows the bearing.
    assert {("door", "directional"), ("directional", "door")} <= {*report.dominates}
    assert ("word:12", "word:1") in report.dominates
    assert ("word:1", "word:12") not in report.dominates


def test_sensors_with_other_places_are_not_compared():
    report = sensors("position", "door", "none", "word:1", edges=2)
    assert [row.places for row in report.rows] == [0, 1, 2, 1]
    named = {name for pair in (*report.dominates, *report.coarser) for name in pair}
    assert named == {"door", "word:1"}


def test_what_is_told_is_a_part_of_what_is_known():
    free, told = sensors("none", "told:n,m,g", edges=2).rows
    assert 0 < told.ambiguous < free.ambiguous


def test_the_report_draws_the_order_and_the_smallest_twins():
    said = text(sensors("position", "door", "word:12", "word:1", "none", edges=2), 100)
    assert "  door\n     word:12\n        word:1\n" in said
    assert "Worlds that look alike under 'position' and 'word:1'\n" in said
    assert said.count("World B") == 3


def test_of_two_that_are_equal_in_the_end_the_one_that_senses_less_at_a_step_is_told():
    said = text(sensors("directional", "door", "word:1", edges=2), 100)
    assert " in one step door tells less than directional, after many as much\n" in said
    assert said.count(", after many as much") == 1  # word:1 does, too, and tells less


def test_worlds_that_are_taken_for_alike_are_noticed_by_their_proof(monkeypatch):
    by_size = lambda code, told=None: f"{len(code)} {told}"  # noqa: E731  # short
    monkeypatch.setattr(sensed_classes, "digest", by_size)
    with pytest.raises(Disagreement, match="the proof about"):
        sensors("door", edges=2)


def test_classes_that_are_never_joined_miss_twins(monkeypatch):
    every = lambda arrays: np.argsort(arrays.sigma, axis=1)  # noqa: E731  # a class for each dart
    monkeypatch.setattr(sensed_classes, "classes", every)
    (row,) = sensors("position", edges=2).rows
    assert row.sufficient
    assert alike_by_hand("position", 2)


@pytest.mark.parametrize("edges", [1, 2])
def test_every_coarsening_is_as_all_worlds_refined_at_once_say(edges):
    report = weakest(ENDS, edges=edges)
    every = coarsenings.partitions(3)
    enough = {one for one in every if not alike_by_hand(ENDS, edges, one)}
    assert (report.coarsenings, report.sufficient) == (5, len(enough))
    number = {name: i for i, name in enumerate(report.features)}
    minimal = {one for one in enough if not {*coarsenings.lower(one)} & enough}
    found = [
        {number[f]: i for i, block in enumerate(m.letters) for f in block} for m in report.minimal
    ]
    assert {tuple(letters[i] for i in range(3)) for letters in found} == minimal
    for one in report.minimal:
        assert len(one.below) == len(one.letters) * (len(one.letters) - 1) // 2
    for refuted in report.refuted:
        assert flaw(refuted.twins.shown, refuted.twins.bisimulation) is None
        assert refuted.twins.worlds[0].map != refuted.twins.worlds[1].map


def test_coarsenings_are_counted_by_bell_and_ordered_by_joining_letters():
    assert [len(coarsenings.partitions(n)) for n in range(1, 7)] == [1, 2, 5, 15, 52, 203]
    assert coarsenings.lower((0, 1, 0, 2)) == [(0, 0, 0, 1), (0, 1, 0, 0), (0, 1, 0, 1)]
    every = coarsenings.partitions(4)
    assert all(
        every.index(below) < every.index(one) for one in every for below in coarsenings.lower(one)
    )


# ---------------------------------------------------------------- the theorem


def suffices(word):
    """Theorem 1 at one degree: no proper power, and not blank throughout."""
    return any(word) and not any(
        word == word[:p] * (len(word) // p) for p in range(1, len(word)) if len(word) % p == 0
    )


def failing(degree, edges):
    """The words of that degree, of 0 and 1 or of 1 and 2, under which two worlds look alike."""
    kind = lighthouse_kind("directional")
    request = side_by_side.SensorsRequest(lighthouses=["directional"], edges=edges, listener=NOBODY)
    levels = []
    for level in request.extent.levels:
        found = side_by_side.worlds_of_level(request, request.extent, level, kind)
        some = [w for part in found for w in part if w[0].degree_at[0] == degree]
        arrays = sensed_classes.matrices(some)
        bearings = (arrays.sensed >> sensed_classes.BITS) & 0xFFFFF  # 0: not at v0
        degrees = arrays.sensed & 0xFFFFF
        roots = [map_ for map_, _ in some]
        if some:
            arrays = arrays._replace(sensed=degrees)
            levels.append(coarsenings.FinestLevel(some, arrays, bearings, roots))
    refuter = coarsenings.Refuter(levels)
    letters = {*product((0, 1), repeat=degree)} | {*product((1, 2), repeat=degree)}
    return {word for word in letters if refuter.pair((0, *word))}, letters


def disagreements(degree, edges, rule=suffices):
    alike, words = failing(degree, edges)
    return {word for word in words if (word in alike) == rule(word)}


@pytest.mark.parametrize(("degree", "edges"), [(1, 4), (3, 3), (4, 2)])
def test_a_word_suffices_if_it_is_primitive_and_not_blank(degree, edges):
    assert not disagreements(degree, edges)


@pytest.mark.parametrize(
    ("rule", "degree", "edges"),
    [
        (lambda word: suffices(word) or word in {(0, 1, 0, 1), (1, 0, 1, 0)}, 4, 2),
        (lambda word: suffices(word) or not any(word), 1, 4),
    ],
    ids=["a power is taken for primitive", "a blank word is taken to suffice"],
)
def test_a_wrong_rule_for_words_is_noticed(rule, degree, edges):
    assert disagreements(degree, edges, rule)


@pytest.mark.parametrize(
    ("verb", "asked", "said"),
    [
        (sensors, {"edges": 2}, "names none; legal are none"),
        (lambda **asked: sensors("movable", **asked), {"edges": 2}, "leaves marks itself"),
        (lambda **asked: sensors("door", **asked), {}, "needs a bound"),
        (lambda **asked: weakest("door", **asked), {"edges": 2}, "has features = None; legal is"),
    ],
)
def test_bad_requests_are_refused_in_a_line(verb, asked, said):
    with pytest.raises(InputError, match=said):
        verb(**asked)


def test_sensors_that_show_the_same_are_both_minimal():
    report = sensors("door", "word:10*", "directional", edges=2)
    assert report.minimal == ("door", "word:10*")


def test_twins_of_earlier_coarsenings_are_tried_first():
    report = weakest(f"{HERE.parents[1]}/papers/minimal_information/sensors.py:Features", edges=2)
    insufficient = report.coarsenings - report.sufficient
    assert report.tried < (insufficient + len(report.minimal)) / 2


def test_the_weakest_of_what_motions_do_not_decide_is_refused():
    with pytest.raises(InputError, match="sensors are compared by motions alone"):
        ambiguity.weakest("movable", edges=1)


def test_of_each_sensor_the_places_that_were_tried_are_told():
    found = sensors("compass", "none", edges=4)
    told = "every place up to 3 edges; beyond, "
    assert [row.tried[: len(told)] for row in found.rows] == [told, ""]


FINEST = """
from dataclasses import dataclass
from allworlds import Lighthouse, Percept

@dataclass(frozen=True)
class Finest(Lighthouse):
    dart: int
    features = ("away", "here")
    mark, bearing, word = 1, None, None

    @classmethod
    def places(cls, map_, start):
        yield cls(start)

    def sensed(self, map_, here):
        at = map_.vertex_of[here] == map_.vertex_of[self.dart]
        return Percept(map_.degree_at[here], self.mark if at else 0, self.bearing if at else None)

    def told(self, map_):
        return self.word

class Marks(Finest):
    mark = 2

class Bearing(Finest):
    bearing = 0

class Tells(Finest):
    word = 7

class Nine(Finest):
    features = tuple("abcdefghi")

class Twice(Finest):
    features = ("away", "away")

class Empty(Finest):
    features = ("away", "")
"""


@pytest.fixture
def finest(tmp_path):
    (tmp_path / "finest.py").write_text(FINEST)
    return lambda name, **asked: weakest(f"{tmp_path}/finest.py:{name}", **asked)


def test_a_finest_sensor_senses_numbers_of_its_features(finest):
    assert finest("Finest", edges=1).coarsenings == 2


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("Marks", "senses degree 1, marks 2; legal is a lighthouse whose marks are numbers of its"),
        ("Bearing", "senses degree 1, marked, bearing 0; legal is a lighthouse whose marks are "),
        ("Tells", "tells 7; legal is a lighthouse whose marks are numbers of its features"),
        ("Nine", r"has features = \('a', .*, with up to 8 different names"),
        ("Twice", r"has features = \('away', 'away'\); legal is .* with up to 8 different names"),
        ("Empty", r"has features = \('away', ''\); legal is .* with up to 8 different names"),
    ],
)
def test_what_is_no_number_of_a_feature_is_refused(finest, name, said):
    with pytest.raises(InputError, match=said):
        finest(name, edges=1)


def test_eight_features_are_the_most():
    for count in (1, 8):
        names = tuple("abcdefghi"[:count])
        given = SimpleNamespace(as_class=SimpleNamespace(features=names, leaves_marks=False))
        assert coarsenings._features(given) == names


def test_maps_that_are_left_out_are_noticed(monkeypatch):
    monkeypatch.setattr(side_by_side.units, "level_size", lambda *_: 3)
    with pytest.raises(Disagreement, match=r"2 rooted maps with 1 edges were met, but .* counts 3"):
        sensors("none", edges=1)


@pytest.mark.parametrize("marks", [(1 << 23) - 1, 1 << 23])
def test_marks_are_below_a_number(marks):
    class Marking:
        def percepts(self, map_):
            return tuple(Percept(degree, marks) for degree in map_.degree_at)

        def told(self, map_):
            return None

    def made():
        return sensed_classes.matrices([(EDGE, Marking())])

    if marks < 8_388_608:
        assert made().sensed.tolist() == [[(marks << 40) + 1] * 2]
    else:
        with pytest.raises(InputError, match="marks = 8388608 is not below 8388608"):
            made()
