"""Many worlds of files: workers, shards of every verb, a hundred thousand, Petersen's graph."""

import gc
import tracemalloc

import pytest

import allworlds
from allworlds.notations.given import files_of, worlds_of_files
from plan_files import NAMES, WRONG, as_json, of, write


@pytest.fixture
def plans(tmp_path, monkeypatch):
    """A file of a hundred and twenty worlds whose sizes are in no order."""
    monkeypatch.chdir(tmp_path)
    write(tmp_path / "plans.jsonl", *[as_json(name) for name in NAMES] * 20)
    return "plans.jsonl"


@pytest.mark.slowest
@pytest.mark.parametrize("more", [{"workers": 2}, {"dask": "local", "workers": 2}])
@pytest.mark.parametrize("explorer", ["folding", "mine.py:goes_on"])
def test_wherever_it_is_done_it_is_the_same(plans, tmp_path, explorer, more):
    (tmp_path / "mine.py").write_text(WRONG)
    options = {"worlds": plans, "task": "cover:edges"}
    one = allworlds.check(explorer, workers=1, **options)
    assert of(allworlds.check(explorer, **options, **more)) == of(one)


@pytest.mark.slowest
@pytest.mark.parametrize("verb", ["check", "compare", "census", "worst"])
def test_shards_of_every_verb_are_merged_to_the_whole(verb, plans):
    def answer(**options):
        match verb:
            case "check":
                return allworlds.check("folding", worlds=plans, where="cubic", **options)
            case "compare":
                return allworlds.compare("folding", "algorithm1", worlds=plans, **options)
            case "worst":
                return allworlds.worst(worlds=plans, edges=6, **options)
        return allworlds.ambiguity.census(worlds=plans, **options)

    runs = ["one", "other"]
    for k, run in enumerate(runs):
        assert answer(shard=(k, 2), run=run).exit_code == 0
    assert of(allworlds.merge(*runs)) == of(answer())


def test_every_embedding_of_the_petersen_graph_holds():
    # Of its 1024 rotations 40, 664 and 320 have the genera 1, 2 and 3; its group has 120 elements,
    # half of the 2 x 120 automorphisms of rotations keep the orientation.
    report = allworlds.check("folding", graph="petersen", embeddings="genus:1")
    assert report.verdict.value == "holds"
    assert report.runs == 3 * report.worlds == 90 * report.to_json()["scope"]["given"]


@pytest.fixture
def usual_garbage():
    """Garbage is collected as often as Python does by itself; the command line does it rarely."""
    rate = gc.get_threshold()
    gc.set_threshold(700, 10, 10)
    yield
    gc.set_threshold(*rate)


@pytest.mark.slowest
@pytest.mark.usefixtures("usual_garbage")
def test_a_hundred_thousand_worlds_stream(tmp_path):
    def most(count):
        tracemalloc.start()
        maps = worlds_of_files(files_of(files[count]), "clockwise", None)
        pieces = (maps.piece(1, number) for number in range(len(maps.weights(1))))
        assert sum(map(len, pieces)) == count
        held = tracemalloc.get_traced_memory()[1]
        tracemalloc.stop()
        return held

    files = {
        count: write(tmp_path / f"{count}.jsonl", *[as_json("edge", start=0)] * count)
        for count in (10, 1000, 20_000, 100_000)
    }
    most(10)
    # Four numbers of 8 bytes for each world, in an array that grows by an eighth, and its copy.
    assert most(100_000) - most(1000) < 99_000 * 80
    report = allworlds.check("folding", worlds=files[20_000])
    assert (report.worlds, report.verdict.value) == (20_000, "holds")


@pytest.mark.slowest
def test_past_findings_of_other_worlds_are_beyond_the_scope(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "mine.py").write_text(WRONG)
    one, other = (
        write(tmp_path / f"{name}.jsonl", as_json(name)) for name in ("theta", "theta-torus")
    )
    options = {"task": "cover:edges", "corpus": "findings", "workers": 1}
    first = allworlds.check("mine.py:goes_on", worlds=one, **options)
    again = allworlds.check("mine.py:goes_on", worlds=one, **options)
    assert again.past.report.reproduced == first.past.report.written
    third = allworlds.check("mine.py:goes_on", worlds=other, **options)
    assert third.past.report.beyond_scope == first.past.report.written
    assert third.findings[0].world.labels.name == "theta-torus"
