import pytest
from msgspec import structs

from allworlds.documents.document import replace
from allworlds.maps import named_map
from allworlds.outcome import Completed
from allworlds.protocol.actions import Estimate, Move
from allworlds.reports.formats import brief, text as text_of
from allworlds.reports.plain_text import LONGEST_WALK, finding_in_words as finding_text
from allworlds.studies.check.exhaustive import check
from allworlds.studies.count import count
from allworlds.studies.fuzz.sample_sweep import fuzz
from allworlds.studies.run import replay, run
from allworlds.world import Directional, World

pytestmark = pytest.mark.usefixtures("without_workers")


def check_text(report, width):
    return text_of(report, width)


def run_text(told, width):
    return text_of(told, width)


def replay_text(told, width):
    return text_of(told, width)


def count_text(census, width):
    return text_of(census, width)


def lazy(first):
    from allworlds.explorers.builtin.algorithm1 import algorithm1

    answer = yield from algorithm1(first)
    return answer if first.degree != 2 else None


def single_edge(first):
    from allworlds import CombinatorialMap, Estimate

    return Estimate(CombinatorialMap((0, 1), (1, 0)), 0)
    yield


def texts():
    options = {"engine": "python", "edges": 2}
    for explore in (
        "algorithm1",
        lambda f: (yield from lazy(f)),
        lambda f: (yield from single_edge(f)),
    ):
        report = check(explore, **options)
        yield lambda width, report=report: check_text(report, width)
        for finding in report.findings:
            yield lambda width, finding=finding: finding_text(finding, width)
            again = replay(finding, explore)
            yield lambda width, again=again: replay_text(again, width)
            fixed = replay(finding, "algorithm1")
            yield lambda width, fixed=fixed: replay_text(fixed, width)
    every = check("algorithm1", schedules="all", **options)
    yield lambda width: check_text(every, width)
    stopped = check("algorithm1", engine="python", edges=8, time_limit=0.5)
    yield lambda width: check_text(stopped, width)
    shard = check("algorithm1", shard=(1, 2), **options)
    yield lambda width: check_text(shard, width)
    for name in ("k4", "theta-torus"):
        told = run("algorithm1", World(named_map(name), Directional(0)))
        yield lambda width, told=told: run_text(told, width)
    yield lambda width: count_text(count(edges=3), width)


@pytest.fixture(scope="module")
def every_text():
    return list(texts())


@pytest.mark.parametrize("width", [40, 100, 200])
def test_no_line_ends_with_blanks(every_text, width):
    for text in every_text:
        for line in text(width).splitlines():
            assert line == line.rstrip(), repr(line)


def test_the_text_says_what_was_checked():
    text = check_text(check("algorithm1", engine="python", edges=2), 100)
    assert "HOLDS" in text
    assert "12 worlds, 30 runs" in text
    for law in ("map", "pose", "invariant-1", "variant", "folding", "bound (paper)"):
        assert law in text
    assert "at most 2 edges" in text
    assert "log-series of permutations" in text


def test_the_text_of_an_incomplete_check_says_so():
    text = check_text(check("algorithm1", engine="python", edges=8, time_limit=0.5), 100)
    assert "INCONCLUSIVE" in text
    assert "INCOMPLETE the time limit of 0.5 s was reached; finished levels: 1 edge" in text


def test_the_text_of_a_shard_defers_the_gate():
    text = check_text(check("algorithm1", engine="python", edges=2, shard=(0, 2)), 100)
    assert "shard 0/2" in text
    assert "not for a shard: the merge of all shards compares the counts" in text


def test_a_shard_without_worlds_does_not_hold():
    report = check("algorithm1", engine="python", edges=2, shard=(5, 1000))
    assert report.exit_code == 0
    text = check_text(report, 100)
    assert "HOLDS" not in text
    assert "EMPTY" in text
    assert "has nothing to" in text


def test_a_finding_of_the_corpus_counts_in_its_scope_only(tmp_path):
    def explore(first):
        return (yield from lazy(first))

    alone = check_text(check(explore, edges=2, corpus=tmp_path), 100)
    assert "from the corpus" not in alone
    again = check_text(check(explore, edges=2, corpus=tmp_path), 100)
    assert "from the corpus" in again
    assert "beyond the scope" not in again
    # What the check of simple maps finds and keeps is beyond the scope of the last, too.
    for kept, other in [(1, {"map_class": "simple"}), (2, {"lighthouse": "position"})]:
        beyond = check_text(check(explore, edges=2, corpus=tmp_path, **other), 100)
        assert f"{kept} still refuted, but beyond the scope (" in " ".join(beyond.split())
        assert "from the corpus" not in beyond


def test_one_is_singular():
    assert "a SAMPLE of 1 map (seed 0)" in check_text(fuzz(edges=1, runs=1), 200)
    simple = count(edges=1, map_class="simple")
    assert "1 rooted map of" in count_text(simple, 100)
    row = structs.replace(simple.rows[0], counted={2: 2})
    wrong = structs.replace(simple, rows=(row,))
    assert "found 1 map with 1 edge and 2 vertices, but" in count_text(wrong, 100)


def test_the_text_of_a_run_has_a_row_for_every_step():
    told = run("algorithm1", World(named_map("theta-torus"), Directional(0)))
    walk = run_text(told, 100).partition("\nThe walk\n\n")[2].split("\n\n")[0]
    percepts = told.outcome.episode.transcript.percepts
    rows = walk.splitlines()[1:]
    assert [row.split()[0] for row in rows] == [str(i) for i in range(len(percepts))]
    for row, percept in zip(rows, percepts, strict=True):
        assert str(percept) in row


def test_of_many_choices_the_first_are_told():
    def explore(first, *, choices):
        for _ in range(1000):
            choices.pick("ab", of="edge")
        return None
        yield

    text = check_text(check(explore, edges=1, policy="lifo"), 100)
    assert "1, 1, and 940 more" in " ".join(text.split())


def test_what_was_seen_is_a_number_and_what_was_expected_a_bound():
    words = " ".join(check_text(check(edges=1, bound=0), 100).split())
    assert "expected at most 0 traversals seen 1 traversal" in words


def test_a_run_and_a_replay_have_one_line_each():
    right = run("algorithm1", World(named_map("theta"), Directional(0)))
    assert brief(right, 40) == "HOLDS: 8 traversals of at most 17: no law is broken"
    explore = lambda f: (yield from single_edge(f))  # noqa: E731
    (finding,) = check(explore, edges=1, engine="python").findings
    wrong = run(explore, finding.world)
    assert brief(wrong, 40) == f"REFUTED: law {finding.law} is broken"
    again = brief(replay(finding, explore), 40)
    assert again == f"REPRODUCED: law '{finding.law}' is broken again"
    fixed = brief(replay(finding, "algorithm1"), 40)
    assert fixed == "FIXED: algorithm1 now keeps every law in the recorded world"
    other = brief(replay(replace(finding, law="pose"), explore), 40)
    assert other.startswith("REPRODUCED: law ")
    assert other.endswith("is broken now, where 'pose' was recorded")


def test_a_shard_says_that_it_is_one_in_its_one_line_too():
    whole = brief(check("algorithm1", engine="python", edges=2), 100)
    shard = brief(check("algorithm1", engine="python", edges=2, shard=(0, 2)), 100)
    assert "shard" not in whole
    assert shard.startswith("HOLDS: ")
    assert "in shard 0/2; the verdict on the whole needs the merge of all shards" in shard


def test_a_shard_of_a_sample_says_so_too():
    told = brief(fuzz("algorithm1", edges=6, runs=100, shard=(1, 2)), 100)
    assert "in shard 1/2; the verdict on the whole needs the merge of all shards" in told
    empty = brief(fuzz("algorithm1", edges=6, runs=1, shard=(1, 2)), 100)
    assert empty.startswith("EMPTY: ")


def test_laws_of_checkpoints_alone_are_vacuous_for_an_explorer_without_checkpoints():
    silent = {"laws": ("invariant-1", "variant")}
    for report in (
        check("folding", edges=1, engine="python", **silent),
        fuzz("folding", edges=3, runs=2, **silent),
        run("folding", "theta", **silent),
    ):
        assert (report.verdict, report.exit_code) == ("vacuous", 4)
        told = brief(report, 40)
        assert told.startswith("VACUOUS: nothing was checked: the explorer shows no checkpoint")
        assert "invariant-1 and variant" in told
        assert text_of(report, 400).count("needed for invariant-1 and variant") == 2
    spoken = run("algorithm1", "theta", **silent)
    assert (spoken.verdict, spoken.exit_code) == ("holds", 0)


def test_the_laws_are_those_of_which_something_was_checked():
    def laws(explorer, **options):
        text = check_text(check(explorer, engine="python", **{"edges": 2, **options}), 300)
        return next(line for line in text.splitlines() if line.startswith("laws"))

    assert "map, pose, invariant-1, invariant-2, variant, folding, bound (paper)" in laws(
        "algorithm1"
    )
    silent = laws("folding", bound="none")
    checked, _, left = silent.partition(";")
    assert checked.split() == ["laws", "map,", "pose,", "folding"]
    assert left.endswith("no checkpoint, so unchecked: invariant-1, invariant-2 and variant")
    assert "no law was checked" in laws("algorithm1", lighthouse="natural", edges=1)


def test_the_laws_of_one_run_are_those_of_which_something_was_checked():
    def laws(explorer):
        return " ".join(run_text(run(explorer, "theta"), 200).partition("\nlaws ")[2].split())

    assert laws("algorithm1") == "map, pose, invariant-1, invariant-2, variant, folding, bound"
    assert laws("folding") == "map, pose, folding"


def test_a_sample_has_no_gate_and_says_so(wrong):
    text = text_of(fuzz("algorithm1", edges=4, runs=2), 100)
    assert "gate       absent: a sample has no independent count" in text
    assert "the two plays" not in text_of(check(wrong("raises"), edges=1), 100)


def test_of_many_choices_the_first_are_told_and_how_many_follow(wrong):
    found = check(wrong("right"), edges=1, bound="0").findings[0]
    for choices, end in ((60, " 1\n"), (61, ", and 1 more\n"), (75, ", and 15 more\n")):
        told = finding_text(replace(found, choices=(1,) * choices), 1000)
        (line,) = (line for line in told.splitlines() if line.startswith("choices"))
        assert (line + "\n").endswith(end)


@pytest.mark.parametrize(("moves", "cut"), [(LONGEST_WALK - 1, False), (LONGEST_WALK, True)])
def test_a_walk_is_cut_if_it_has_more_lines_than_are_shown(moves, cut):
    def explore(first):
        for _ in range(moves):
            yield Move(0)
        return Estimate(named_map("edge"), 0)

    told = run(explore, World(named_map("edge"), Directional(0), 0), bound="none")
    assert ("more)" in run_text(told, 100)) == cut


def test_why_a_check_is_vacuous_is_told():
    report = check(edges=1)
    missing = replace(report, ending=Completed(("never",)))
    assert brief(missing, 100) == "VACUOUS: a witness is missing"
    assert "never met: never" in text_of(missing, 100)
