"""The line that reproduces a finding is run, and the same finding comes."""

import json
import shlex

import pytest

import allworlds
from allworlds import Estimate, Move
from allworlds.documents.document import replace
from allworlds.judging.findings.finding import Finding
from allworlds.judging.rules import Rules
from allworlds.studies.check.exhaustive import check
from allworlds.studies.run import run
from allworlds.world import Directional, World, world_named
from small import EDGE, PATH, TRIANGLE

pytestmark = pytest.mark.usefixtures("without_workers")

SAME = ("law", "world", "transcript", "choices", "expected", "seen", "options")

LIGHTHOUSES = ("position", "compass", "labels", "none", "whiteboard:states=3")
OPTIONS = (
    {},
    {"task": "cover"},
    {"task": "stop", "bound": "2*m"},
    {"policy": "random:5"},
    {"bound": "none"},
    {"bound": "n - 1", "laws": ("bound", "map")},
    {"laws": ("pose", "map"), "step_budget": 1},
    {"step_budget": 1, "bound": "m", "policy": "lifo"},
)


def far(_first):
    """Over the first edge and back, often, and then a path of two edges as the answer."""
    for _ in range(8):
        yield Move(0)
    return Estimate(PATH, 0)


def again_of(finding, cli):
    """The finding that the printed command gives."""
    program, *words = shlex.split(finding.reproduce)
    assert program == "allworlds"
    code, out, _ = cli(*words, "--json")
    assert code == 1
    return json.loads(out)["finding"]


GRID = [
    *(("directional", options) for options in OPTIONS),
    *zip(LIGHTHOUSES, OPTIONS[3:], strict=False),
]


@pytest.mark.parametrize(("lighthouse", "options"), GRID)
def test_the_printed_command_gives_the_same_finding(lighthouse, options, cli, wrong):
    finding = run(wrong("everywhere"), world_named("cycle:3", lighthouse), **options).finding
    again = again_of(finding, cli)
    for key in SAME:
        assert again[key] == finding.to_json()[key]


@pytest.mark.parametrize("options", OPTIONS)
def test_the_printed_line_of_python_gives_the_same_finding(options):
    finding = run(far, World(TRIANGLE, Directional(2), 2), **options).finding
    unnamed = replace(finding, explorer="somewhere:on.<far>")
    again = eval(unnamed.reproduce, {"far": far, "allworlds": allworlds}).finding
    for key in SAME:
        assert again.to_json()[key] == finding.to_json()[key]


@pytest.mark.parametrize(
    ("choices", "policy", "told"),
    [
        ((), "lifo", ""),
        ((0, 0), "fifo", ""),  # that is what the policy chooses
        ((0, 0), "lifo", " --choices 0,0"),
        ((1, 0), "fifo", " --choices 1,0"),
    ],
)
def test_choices_are_given_again_where_the_policy_would_not_make_them(choices, policy, told, wrong):
    finding = run(wrong("everywhere"), World(PATH, Directional(0), 0)).finding
    chosen = replace(finding, choices=choices, under=Rules(policy=policy))
    policy_told = "" if policy == "fifo" else f" --policy {policy}"
    assert chosen.reproduce == f"{finding.reproduce}{policy_told}{told}"


def test_the_choices_that_were_made_are_made_again(cli, wrong):
    (finding,) = check(wrong("one_schedule"), schedules="all", edges=1).findings
    assert finding.choices == (1, 0)
    assert again_of(finding, cli)["choices"] == [1, 0]
    recorded = Finding.from_json(finding.to_json())
    assert recorded.reproduce == finding.reproduce


def test_a_law_that_a_promise_makes_idle_is_not_checked_again(cli, tmp_path):
    # In planar maps an answer need not be proved by the log: the walk is too long, no more.
    file = tmp_path / "far.py"
    file.write_text(
        "from allworlds import CombinatorialMap, Estimate, Move\n\n\n"
        "def far(first):\n    for _ in range(8):\n        yield Move(0)\n"
        "    return Estimate(CombinatorialMap((0, 2, 1, 3), (1, 0, 3, 2)), 0)\n"
    )
    report = check(f"{file}:far", edges=2, map_class="planar", bound="m", max_findings=30)
    found = [finding for finding in report.findings if finding.law == "bound"]
    assert len(found) == 1
    for finding in (*found, Finding.from_json(found[0].to_json())):
        assert again_of(finding, cli)["law"] == "bound"


@pytest.mark.parametrize(
    ("explorer", "words"),
    [
        ("exec:python3 'a b.py' -x", ["--exec", "python3 'a b.py' -x"]),
        ("native:./a b.so", ["--native", "./a b.so"]),
        ("it's.py:explore", ["it's.py:explore"]),
        ("module:explore", ["module:explore"]),
        ("algorithm1", ["algorithm1"]),
    ],
)
@pytest.mark.parametrize("seed", [None, 0, 7])
def test_explorer_world_and_hash_seed_stand_in_the_line(explorer, words, seed, wrong):
    finding = run(wrong("everywhere"), World(PATH, Directional(2), 2)).finding
    line = replace(finding, explorer=explorer, hash_seed=seed).reproduce
    before = [] if seed is None else [f"PYTHONHASHSEED={seed}"]
    told = shlex.split(line)
    assert told[:-1] == [*before, "allworlds", "run", *words]
    assert World.from_json(json.loads(told[-1])) == finding.world


@pytest.mark.parametrize("name", ["a:b.<locals>.mine", "__main__:mine", "a:<mine>"])
def test_a_function_that_no_command_can_name_is_run_by_a_line_of_python(name):
    finding = run(far, World(EDGE, Directional(0), 0)).finding
    assert replace(finding, explorer=name).reproduce.startswith("allworlds.run(mine, '{")


def test_a_line_of_python_gives_the_choices_again():
    def picks(_first, *, choices):
        yield Move(choices.pick((0, 1), of="edge"))
        choices.pick((0, 1, 2), of="path")

    finding = run(picks, World(PATH, Directional(1), 1), choices=[1, 2]).finding
    again = eval(finding.reproduce, {"picks": picks, "allworlds": allworlds}).finding
    assert again.choices == finding.choices == (1, 2)
    assert again.transcript == finding.transcript


@pytest.mark.parametrize(
    ("laws", "bound", "checked"),
    [
        (("map", "bound"), "7", (("map", "bound"), "7")),
        (("map", "bound"), "none", (("map",), "none")),
        (("map",), "7", (("map",), None)),
    ],
)
def test_a_bound_that_was_not_checked_is_left_out(laws, bound, checked):
    recorded = replace(Rules().recorded, laws=laws, bound=bound)
    rules = recorded.rules(World(EDGE, Directional(0)))
    assert (rules.laws, rules.bound and str(rules.bound)) == checked
