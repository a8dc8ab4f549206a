"""A finding leads to the line of the user's code, and shows what the explorer believed there."""

import inspect
import json
import sys

import pytest

from allworlds import Checkpoint, CombinatorialMap, Estimate, Move, check, run
from allworlds.explorers.builtin.algorithm1 import algorithm1
from allworlds.judging.findings.finding import Finding
from allworlds.reports.formats import file_of
from allworlds.studies.explain import explain
from allworlds.world import world_named


def inner(first):
    percept = yield Move(0)  # inner
    if percept.degree > 2:
        raise ValueError(percept)  # raises
    return percept


def crashes(first):
    yield Move(0)  # outer
    yield from inner(first)
    return (yield from algorithm1(first))


def twists(first):
    walk, reply = algorithm1(first), None
    while True:
        try:
            message = walk.send(reply)
        except StopIteration as end:
            return end.value
        if isinstance(message, Checkpoint) and len(message.alpha) > 3:
            here = (message.here + 1) % len(message.alpha)
            message = Checkpoint(message.sigma, message.alpha, here)
            reply = yield message  # twisted
        else:
            reply = yield message


def guesses(first):
    yield Move(0)
    if first.degree > 1:
        return Estimate(CombinatorialMap([0, 1], [1, 0]), 0)  # guess
    return Estimate(CombinatorialMap([0, 1], [1, 0]), 1)


def numbers(first):
    yield 1


def stands(first):
    yield Move(0)


def on_and_on(first):
    while True:
        yield Move(1)


def line_of(comment):
    """The line of this file that ends in that comment, as findings name it."""
    lines = inspect.getsource(sys.modules[__name__]).splitlines()
    (number,) = [i for i, line in enumerate(lines, 1) if line.endswith(f"  # {comment}")]
    return number


def found(explorer, **options):
    (finding,) = check(explorer, **{"edges": 3, **options}).findings
    return finding


def ends_at(place, comment):
    return place.rpartition(":")[2] == str(line_of(comment))


def test_each_step_has_its_line_through_yield_from():
    code = found(crashes, laws=["map"]).code
    assert len(code.steps) == 3
    assert all(map(ends_at, code.steps, ("outer", "inner", "raises")))
    assert code.source(code.steps[-1]).endswith(": raise ValueError(percept)  # raises")


def test_the_line_of_a_crash_runs_in_no_right_run_and_is_shown():
    finding = found(crashes, laws=["map"])
    assert ends_at(finding.code.alone[-1], "raises")
    assert finding.code.right > 0
    assert f":{line_of('raises')}: raise ValueError(percept)  # raises" in str(finding)
    assert f"(not run in {finding.code.right} runs that broke no law)" in " ".join(
        str(finding).split()
    )


def test_lines_that_run_in_right_runs_are_not_among_them():
    assert not any(ends_at(place, "outer") for place in found(crashes, laws=["map"]).code.alone)


def test_a_wrong_answer_that_was_guessed_is_at_its_return():
    finding = found(guesses, laws=["map"])
    assert f":{line_of('guess')}: return" in str(finding)


def test_a_finding_keeps_its_lines_in_its_file():
    finding = found(crashes, laws=["map"])
    assert Finding.from_json(finding.to_json()).code == finding.code


def test_a_run_has_lines_and_an_explorer_that_acts_otherwise_when_it_is_traced_has_none():
    world = world_named("theta", "directional")
    assert ends_at(run(crashes, world).finding.code.steps[0], "outer")

    def changing(first):
        yield Move(int("TracedPlay" in repr(sys.gettrace())))
        raise ValueError

    assert run(changing, world).finding.code is None


def test_sarif_is_at_the_line_of_the_first_wrong_step():
    (result,) = json.loads(file_of("sarif", check(crashes, edges=3, laws=["map"])))["runs"][0][
        "results"
    ]
    region = result["locations"][0]["physicalLocation"]["region"]
    assert region["startLine"] == line_of("raises")


def test_who_traced_before_traces_afterwards():
    def tracer(*_):
        return None

    before = sys.gettrace()
    sys.settrace(tracer)
    try:
        found(crashes, laws=["map"])
        assert sys.gettrace() is tracer
    finally:
        sys.settrace(before)


# ---------------------------------------------------------------- what it believed


def test_the_wrong_checkpoint_is_kept_and_drawn_beside_the_world():
    finding = found(twists, laws=["invariant-1"])
    shown = finding.believed
    assert shown.step == finding.step
    assert ends_at(finding.code.checkpoints[shown.number], "twisted")
    text = str(finding)
    assert f"The world after step {shown.step}\n" in text
    title = f"The S after step {shown.step}, in the explorer's numbers (darts at '?' lead to"
    assert f"{title} unknown vertices)" in " ".join(text.split())
    page = finding._repr_html_()
    assert f"The S after step {shown.step}" in page


def test_the_belief_is_kept_in_the_file():
    finding = found(twists, laws=["invariant-1"])
    assert Finding.from_json(finding.to_json()).believed == finding.believed


def test_a_checkpoint_that_is_no_map_is_told_by_its_lists():
    def shows(first):
        yield Move(0)
        yield Checkpoint([0, 0], [1, 0], 0)
        yield from on_and_on(first)

    lists = "in the explorer's numbers: sigma [0, 0], alpha [1, 0], here 0. This is no map"
    assert lists in " ".join(str(found(shows)).split())


# ---------------------------------------------------------------- walks without an end


def test_of_an_endless_walk_both_ends_are_shown():
    rows = str(found(on_and_on)).partition("The walk\n")[2].partition("\n\nconf")[0].split("\n")
    numbers = [row.split()[0] for row in rows if " v0, " in row]
    assert numbers == [*map(str, range(8)), *map(str, range(101, 109))]


def test_a_walk_is_shown_up_to_its_first_wrong_step():
    def goes_on(first):
        yield from twists(first)
        yield from on_and_on(first)

    finding = run(goes_on, world_named("theta", "directional")).finding
    assert finding.law == "budget"
    last = str(finding).partition("The walk\n")[2].partition("...")[0].strip().splitlines()[-1]
    assert last.split()[0] == str(finding.step)


@pytest.mark.parametrize(
    ("task", "expected", "left"),
    [
        ("cover", "every vertex visited within ", "The robot never visited v"),
        ("cover:edges", "every edge walked along within ", "The robot never walked along the edge"),
    ],
)
def test_what_was_left_out_is_named(task, expected, left):
    finding = found(on_and_on, task=task)
    assert str(finding.expected).startswith(expected)
    assert left in " ".join(explain(finding).sentences)


# ---------------------------------------------------------------- small things


def test_a_number_that_is_yielded_is_told_as_a_move():
    assert found(numbers).expected.endswith("such as Move(1)")


def test_labels_are_no_markers():
    finding = run(stands, world_named("theta", "labels")).finding
    text = str(finding) + finding._repr_html_() + " ".join(explain(finding).sentences)
    assert "label 1" in text
    assert "marked," not in text
    assert ">marked<" not in text
    assert "●" not in text


def test_a_plain_python_shows_at_most_twenty_lines():
    report = check(on_and_on, edges=3)
    for shown in (report, report.findings[0]):
        assert len(repr(shown).splitlines()) == 20
    assert repr(report).splitlines()[-1] == str(report).splitlines()[0] or "REFUTED" in repr(report)


def test_a_function_without_a_name_is_run_again_by_a_line_of_python():
    def mine(first):
        yield from on_and_on(first)

    finding = found(mine, laws=["map", "bound"], bound="2*m", step_budget=30)
    names = {"mine": mine, "allworlds": sys.modules["allworlds"]}
    again = eval(finding.reproduce, names).finding
    assert (again.law, again.world, again.rules.the_bound.name) == ("budget", finding.world, "2*m")


def test_a_run_without_a_world_is_told_so(refused, tmp_path):
    assert "WORLD is missing: 'mine.py' is an explorer" in refused("run", "mine.py")


def test_of_a_library_that_does_not_repeat_itself_unwritten_memory_is_asked():
    finding = found(stands, laws=["map"])
    wrong = {"law": "nondeterministic", "expected": "a", "seen": "b"}
    changed = finding.to_json() | wrong | {"explorer": "native:./explorer.so"}
    text = " ".join(explain(Finding.from_json(changed)).sentences)
    assert "valgrind -q --trace-children=yes --track-origins=yes" in text
    assert "-fsanitize=address" in text
