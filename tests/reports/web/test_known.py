"""The knowledge of an explorer, shown beside the world."""

from allworlds import run
from allworlds.documents.document import replace
from allworlds.protocol.actions import Checkpoint
from allworlds.reports.content.single_run import known
from allworlds.reports.formats import file_of
from allworlds.reports.web.sections import NEVER
from html_tree import read


def test_s_grows_to_the_whole_world_as_the_checkpoints_say():
    told = run("algorithm1", "k4-torus")
    seen = known(told)
    map_ = told.world.map
    assert {*seen.darts} == {*seen.edges} == {*map_.darts}
    for step, checkpoint in told.outcome.episode.checkpoints:
        explored = sum(a != d for d, a in enumerate(checkpoint.alpha))
        assert sum(since <= step for since in seen.edges.values()) == explored
        assert sum(since <= step for since in seen.darts.values()) == len(checkpoint.alpha)


def test_the_picture_tells_since_when_each_part_is_known():
    told = run("algorithm1", "theta-torus")
    seen = known(told)
    figure = read(file_of("html", told)).one(id="walk-1-known")
    edges = [e.attributes for e in figure.all("path") if "data-darts" in e.attributes]
    assert len(edges) == 3
    for edge in edges:
        dart = int(edge["data-darts"].split()[0])
        assert 0 < int(edge["data-since"]) == seen.edges[dart] < NEVER


def with_checkpoints(told, *checkpoints):
    episode = replace(told.outcome.episode, checkpoints=checkpoints)
    return replace(told, outcome=replace(told.outcome, episode=episode))


def test_what_is_not_a_part_of_the_world_is_not_drawn_as_one():
    told = run("algorithm1", "theta")
    assert known(with_checkpoints(told)) is None
    wrong = Checkpoint((1, 0), (0, 1), 0)  # two darts, where there are three
    assert known(with_checkpoints(told, (0, wrong))) is None
    apart = Checkpoint((1, 2, 0, 3), (0, 1, 2, 3), 0)
    assert known(with_checkpoints(told, (0, apart))) is None


def test_open_darts_stay_open_where_nothing_more_is_shown():
    told = run("algorithm1", "theta")
    first = Checkpoint((1, 2, 0), (0, 1, 2), 0)
    page = read(file_of("html", with_checkpoints(told, (0, first))))
    stubs = [s.attributes for s in page.one(id="walk-1-known").all("path", class_="stub open")]
    assert [(s["data-since"], s["data-until"]) for s in stubs[:3]] == [("0", str(NEVER))] * 3
