"""Reports in their rarer cases, whole: what a terminal, a page, a table and a test runner show.

``RENEW=1 pytest tests/reports/test_whole_texts.py`` writes the texts anew; what then differs is to
be meant, and told in the commit.
"""

import json
import re
import shutil
import tempfile
from contextlib import chdir, suppress
from pathlib import Path
from types import SimpleNamespace

import pytest

import allworlds
from allworlds import Ambiguous, Checkpoint, CombinatorialMap, Drop, Estimate, Move
from allworlds.documents.document import replace
from allworlds.inputs.checks import InputError
from allworlds.judging.findings.finding import Believed, CodeLines, EarlierRun, Finding
from allworlds.judging.laws.bounds import BOUNDS
from allworlds.maps import InvalidMap, named_map
from allworlds.maps.build import contracted, deleted
from allworlds.outcome import Completed, Disagreed, Interrupted, Stopped
from allworlds.reports import parts
from allworlds.reports.content.check import _cases as cases_of_check
from allworlds.reports.content.plain import plain_content
from allworlds.reports.content.team import (
    _rows_of as rows_of_team,
    finding_section as team_section,
    sequence_of,
)
from allworlds.reports.formats import content_of, csv_rows
from allworlds.reports.plain_text import content_text, on_terminal, text_of
from allworlds.studies.check.exhaustive import check
from allworlds.studies.check.time_estimate import Guess, TimeEstimate
from allworlds.studies.explain import explain
from allworlds.studies.ledger import CheckedClaim, LedgerReport
from allworlds.studies.merge import DoneOf, LargestCost, Standing
from allworlds.studies.run import WorldNames, replay, run
from allworlds.studies.team.finding_reports import TeamExplanation
from allworlds.world import Directional, Movable, World, world_named
from allworlds.world.named import own_corpus
from recorded_texts import Texts

TEXTS = Texts(Path(__file__).parent / "whole_texts")
case = TEXTS.case
WIDTH = 100

mine = SimpleNamespace()
"""The explorers, once they are in the file."""


def shown(content):
    """Everything that a report shows, but its pictures on a page."""
    yield f"## {content.done} {content.subject}, apart: {sorted(content.apart)}"
    yield content_text(content, WIDTH)
    for name, sections in (("whole", content.whole), ("more", [*content.more()])):
        if sections:
            yield f"# {name}\n{text_of(sections, WIDTH)}"
    if content.short:
        yield f"# short\n{on_terminal(content, WIDTH, whole=False)}"
        yield "\n".join(f"{name}: {said}" for name, said in content.short)
    if content.command:
        yield f"# command\n{content.command}"
    for each in content.cases() if content.cases else ():
        yield f"# case {each.result} {each.name} | {each.kind} | {each.message}"
        yield text_of(each.sections, WIDTH)
    yield f"# rows\n{csv_rows(content)}"
    for section in content.sections:
        for block in section.blocks:
            if isinstance(block, parts.Table):
                yield f"# table {block.caption}, by {block.keys}"
            if isinstance(block, parts.Curve | parts.MapPictures | parts.ShownWalk):
                yield drawn(block)


def drawn(block):
    """What a page draws, in words."""
    if isinstance(block, parts.Curve):
        return f"# curve {block.title}, {block.across}: {block.lines}"
    if isinstance(block, parts.MapPictures):
        entries = block.entries
        return "\n".join(f"# picture {title}: {scene}" for title, scene in entries)
    views = "\n".join(
        f"{view.name}, {view.title}, {view.note}, {[*view.trail]}, {view.known}, {view.still}, "
        f"{view.scene}"
        for view in block.views
    )
    return (
        f"# walk {block.title}, agree {block.agreement}, part {block.parting}, {block.tour}\n"
        f"{views}"
    )


def whole(make):
    """The text of a case."""
    with tempfile.TemporaryDirectory() as made, chdir(made), pytest.MonkeyPatch.context() as patch:
        patch.syspath_prepend(made)  # elsewhere, too, there may be a mine.py
        shutil.copy(Path(__file__).with_name("whole_explorers.py"), "mine.py")
        file = Path("mine.py").resolve()
        names = {"__name__": "mine"}
        exec(compile(file.read_text(encoding="utf-8"), file, "exec"), names)
        vars(mine).update(names)
        texts = [
            result if isinstance(result, str) else "\n".join(shown(content_of(result)))
            for result in make()
        ]
        text = "\n\n".join(texts).replace(str(Path(made).resolve()), "{here}")
    text = text.replace(allworlds.__version__, "{version}")
    text = re.sub(r"object at 0x[0-9a-f]+", "object", text)
    return "\n".join(line.rstrip() for line in text.splitlines()) + "\n"


# ---------------------------------------------------------------- explorers


EDGE, LOOP = CombinatorialMap([0, 1], [1, 0]), CombinatorialMap([1, 0], [1, 0])
PATH = CombinatorialMap([0, 2, 1, 3], [1, 0, 3, 2])
LASSO = CombinatorialMap([1, 2, 0, 3], [1, 0, 3, 2])


def moves(*turns):
    return [Move(k) for k in turns]


def told(finding):
    """What is told of a finding, and what its section shows."""
    explanation = explain(finding)
    head = f"law {explanation.law}, step {explanation.step}, slip {explanation.slip!r}"
    return "\n".join([head, *explanation.sentences])


def found(explore, world, **options):
    """The finding of a run in a world that has a name, or is one."""
    if isinstance(world, str):
        world = world_named(world, options.pop("lighthouse", "directional"))
    if isinstance(world, CombinatorialMap):
        world = World(world, Directional(0))
    return run(explore, world, **options).finding


# ---------------------------------------------------------------- explanations


@case
def corpus_explained():
    for file in sorted((own_corpus().directory / "findings").glob("*.json")):
        yield explain(Finding.from_json(json.loads(file.read_text(encoding="utf-8"))))


WORLDS = ("edge", "loop", "path-3", "star-4", "cycle-3", "theta", "theta-torus", "k4", "dipole-4")


@case
def wrong_answers_told():
    """Answers that are wrong in one thing, each after a walk through some or all of the world."""
    said = {}
    for name in WORLDS:
        map_ = named_map(name)
        truth = run("algorithm1", world_named(name, "directional"))
        actions = [each for each in truth.walk.actions if isinstance(each, Move)]
        right = truth.outcome.episode.ending.answer
        for answer in spoiled(right):
            for walked in (actions, actions[:5]):
                finding = found(mine.walking(*walked, answer=answer), map_)
                if finding:
                    said.setdefault(told(finding), f"{name}, {answer.map.sigma} {answer.map.alpha}")
    yield from (f"{which} {sentences}" for sentences, which in said.items())


def spoiled(right):
    map_, here = right.map, right.here
    yield Estimate(map_.mirrored(), here)
    yield Estimate(map_, map_.sigma[here])
    yield Estimate(map_, map_.alpha[here])
    yield Estimate(map_, map_.alpha[map_.sigma[here]])
    n = len(map_.darts)
    # one leaf more, at the robot's vertex
    sigma = [*map_.sigma, map_.sigma[here], n + 1]
    sigma[here] = n
    yield Estimate(CombinatorialMap(sigma, [*map_.alpha, n + 1, n]), here)
    # one loop more
    sigma = [*map_.sigma, n + 1, map_.sigma[here]]
    sigma[here] = n
    yield Estimate(CombinatorialMap(sigma, [*map_.alpha, n + 1, n]), here)
    for dart, _ in map_.edges[:3]:
        for smaller in (deleted(map_, dart), contracted(map_, dart)):
            if smaller is not None:
                yield Estimate(smaller, 0)
    for a, b in map_.edges[:3]:
        for c, d in map_.edges[-2:]:
            alpha = [*map_.alpha]
            if a != c:
                alpha[a], alpha[c], alpha[b], alpha[d] = c, a, d, b
                with suppress(InvalidMap):  # it is not connected
                    yield Estimate(CombinatorialMap(map_.sigma, alpha), here)
    yield Estimate(EDGE, 0)
    yield Estimate(LOOP, 1)
    yield Estimate(named_map("theta"), 3)


@case
def endings_told():
    star, theta = named_map("star-5"), named_map("theta")
    every = named_map("k4")
    for name, finding in {
        "nothing": found(mine.walking(), PATH),
        "crash": found(mine.crashes, PATH),
        "end after steps": found(mine.walking(*moves(0, 1)), PATH),
        "north": found(mine.walking("north"), PATH),
        "drop": found(mine.walking(Drop()), PATH),
        "cover": found(mine.walking(*moves(0), answer=1), star, task="cover"),
        "cover most": found(
            mine.walking(*moves(0, 0, 1, 0, 1, 0, 1, 0), answer=1), star, task="cover"
        ),
        "stop": found(mine.walking(*moves(0, 0, 1), answer=1), star, task="stop"),
        "home": found(mine.walking(*moves(0, 1), answer=1), PATH, task="home"),
        "home left": found(mine.walking(*moves(0), answer=1), PATH, task="home"),
        "edges": found(mine.walking(*moves(0, 1), answer=1), every, task="cover:edges"),
        "edges most": found(mine.walking(*moves(0, 1, 1), answer=1), theta, task="cover:edges"),
        "budget": found(mine.walking(then=Move(1)), every),
        "budget of the user": found(mine.walking(then=Move(0)), theta, step_budget=7),
        "budget of many lines": found(mine.goes_round, theta),
        "budget of one": found(mine.walking(then=Move(0)), theta, step_budget=1),
        "budget of a bound": found(
            mine.walking(then=Move(0)), "theta", lighthouse="compass", bound="m-2"
        ),
        "budget with all walked": found(mine.walking(then=Move(1)), named_map("cycle-3")),
        "budget of long rounds": found(mine.walking(then=Move(1)), named_map("theta-torus")),
        "budget, checkpoints": found(
            mine.walking(Move(0), then=Checkpoint((1, 0), (1, 0), 0)), LOOP
        ),
        "budget, no move": found(
            mine.walking(then=Drop()), World(PATH, Movable(), 0), step_budget=9
        ),
        "budget, cover": found(mine.walking(then=Move(0)), star, task="cover"),
        "budget, edges": found(mine.walking(then=Move(0)), star, task="cover:edges"),
        "bound": found(
            mine.walking(*moves(0, 0, 0, 0, 0), answer=Estimate(EDGE, 1)), EDGE, bound=2
        ),
        "two doors": found(mine.walking(*moves(0, 0, 1, 0, 2, 0)), star),
        "two doors of loops": found(
            mine.walking(*moves(1, 0, 3, 0, 3, 0)),
            CombinatorialMap((1, 2, 3, 4, 0, 5, 6, 7), (5, 2, 1, 6, 7, 0, 3, 4)),
        ),
        "quotient": found(mine.walking(answer=Ambiguous((0,), (0,), 0, (1,), (0,))), PATH),
    }.items():
        yield f"{name}: {told(finding) if finding else 'no finding'}"


@case
def changed_findings_told():
    """Endings that a recorded finding tells otherwise."""
    base = found(mine.crashes, PATH)
    program = replace(base, explorer="exec:./mine")
    library = replace(base, explorer="native:./mine.so")
    for law, finding, changes in (
        (
            "crash",
            program,
            {"seen": "the end of its process (signal 11)", "detail": "", "output": "a\nb"},
        ),
        (
            "crash",
            program,
            {"seen": "the end of its process (signal 6)", "detail": "", "output": "a\nb"},
        ),
        ("crash", program, {"seen": "the end", "detail": "x\nTypeError: y\nat z\n"}),
        ("timeout", program, {"seen": "silent", "detail": ""}),
        ("timeout", base, {"seen": "silent", "detail": "", "output": STACK}),
        ("illegal-action", program, {"seen": "a line that is no JSON: 'x'", "detail": ""}),
        ("illegal-action", program, {"seen": "a line that is no JSON: ''", "detail": ""}),
        ("illegal-action", program, {"seen": "a line that is no JSON: '{\"a\":1'", "detail": ""}),
        ("illegal-action", program, {"seen": "a line that is no JSON: '\\\\x00a'", "detail": ""}),
        ("illegal-action", program, {"seen": "the line 1: it has none of the keys", "detail": ""}),
        ("illegal-action", program, {"seen": "the line {}: it has none of the keys", "detail": ""}),
        ("illegal-action", program, {"seen": "a Drop", "detail": ""}),
        ("nondeterministic", base, {"seen": "the second answer differs", "detail": "a\nb"}),
        ("nondeterministic", program, {"seen": "a line before it was asked", "detail": "a\nb"}),
        ("nondeterministic", library, {"seen": "the second answer differs", "detail": ""}),
        ("nondeterministic", base, {"after": (EarlierRun(world=World(EDGE, Directional(0), 0)),)}),
        (
            "nondeterministic",
            base,
            {
                "after": (
                    EarlierRun(world=World(EDGE, Directional(0), 0)),
                    EarlierRun(world=World(PATH, Directional(1), 1)),
                )
            },
        ),
        ("no-such-law", base, {}),
        ("budget", base, {"tried": "--max-time 9"}),
        ("crash", base, {"confirmed": True, "minimal": True, "choices": tuple(range(70))}),
        ("crash", base, {"choices": (1, 0)}),
        (
            "crash",
            base,
            {"code": code(alone=("a.py:1", "a.py:2"), busy=("a.py:3", "a.py:1", "a.py:2"))},
        ),
        (
            "crash",
            base,
            {"code": code(alone=("a.py:1", "a.py:2", "b.py:3", "a.py:4", "a.py:5"), right=1)},
        ),
        ("crash", base, {"code": code(steps=("a.py:1", "b.py:3"), alone=())}),
        (
            "crash",
            base,
            {
                "step": 1,
                "wrong_checkpoint": "S is wrong",
                "code": code(checkpoints=("a.py:1", "a.py:2")),
                "believed": Believed(number=1, step=1, sigma=(0, 2, 1), alpha=(1, 0, 2), here=1),
            },
        ),
        (
            "crash",
            base,
            {
                "step": 0,
                "code": code(checkpoints=("a.py:1",)),
                "believed": Believed(number=1, step=0, sigma=(0,), alpha=(0,), here=0),
            },
        ),
        (
            "invariant-1",
            base,
            {
                "step": 1,
                "expected": "a",
                "seen": "b",
                "believed": Believed(number=0, step=1, sigma=(1, 1), alpha=(0, 1), here=0),
            },
        ),
        (
            "invariant-2",
            base,
            {"step": 1, "believed": Believed(number=0, step=1, sigma=(0, 1), alpha=(1, 0), here=9)},
        ),
        ("variant", base, {"step": 1}),
        ("variant", base, {"step": None}),
        ("task", base, {"expected": 3, "seen": 4}),
        ("bound", base, {"expected": 1, "seen": 2}),
    ):
        try:
            changed = replace(finding, law=law, **changes)
            yield f"{law} {changes}: {told(changed)}"
            yield explain(changed)
        except (InputError, TypeError) as error:
            yield f"{law} {changes}: {type(error).__name__} {error}"


STACK = """Timeout (0:00:01)!
Thread 0x00007f (most recent call first):
  File "{here}/mine.py", line 5 in search
  File "/usr/lib/python3/threading.py", line 9 in run
  File "mine.py", line 11 in explore
"""


def code(*, steps=("a.py:1", "a.py:2"), checkpoints=(), alone=(), right=20, busy=()):
    sources = ("a.py:1: first = 1", "a.py:2: second = 2", "b.py:3: third = 3")
    return CodeLines(
        steps=steps, checkpoints=checkpoints, alone=alone, right=right, busy=busy, sources=sources
    )


# ---------------------------------------------------------------- single runs


@case
def runs():
    yield run("algorithm1", world_named("theta", "directional"))
    yield run("algorithm1", world_named("theta-torus", "directional"), laws=("map", "pose"))
    yield run("folding", world_named("k4", "directional"), bound="none")
    yield run(mine.first_edge, World(EDGE, Directional(0)))
    yield run(mine.first_edge, World(PATH, Directional(0)))
    yield run(mine.crashes, World(PATH, Directional(0)))
    yield run(mine.walking(Move(0), answer=4), World(EDGE, Directional(0)), task="cover")
    yield run(mine.walking(*moves(0, 0), answer=[1, 2]), World(EDGE, Directional(0)), task="home")
    yield run(
        mine.walking(answer=Ambiguous((0,), (0,), (1,), (0,), 0)), world_named("cycle-3", "none")
    )
    yield run("algorithm1-cluster", world_named("k4", "cluster"))
    yield run(mine.stays, World(EDGE, Directional(0)), laws=("invariant-1", "variant"))


@case
def replays():
    wrong = found(mine.first_edge, PATH)
    yield replay(wrong, mine.first_edge)
    yield replay(wrong, "algorithm1")
    yield replay(wrong, mine.crashes)
    yield replay(wrong, mine.stays)
    crash = found(mine.crashes, PATH)
    yield replay(crash, "folding")
    yield replay(crash, mine.crashes)


# ---------------------------------------------------------------- checks


@case
def checks():
    held = check("algorithm1", edges=2, engine="python")
    yield held
    yield check("algorithm1", edges=2, schedules="all", engine="python")
    yield check("algorithm1", edges=2, shard=(0, 2), engine="python")
    yield check("algorithm1", edges=1, shard=(7, 9), engine="python")
    yield check("algorithm1", edges=2, laws=("map", "pose"), engine="python")
    yield check("algorithm1", edges=2, bound="none", policy="lifo", where="cubic", engine="python")
    yield check("algorithm1", edges=3, where="eulerian", engine="python")
    yield check("algorithm1", edges=2, laws=("invariant-1", "variant"), engine="python")
    yield check(mine.walking(answer=1), edges=2, task="cover", max_findings=2)
    yield check("algorithm1", map_class="simple", vertices=3, engine="python")
    yield check("algorithm1", worlds=plantri("tri5.pl"), engine="python")
    yield check(mine.first_edge, worlds=plantri("tri5.pl"), max_findings=9)
    cells = [replace(each, counted=each.counted + 1) for each in held.cells]
    wrong = Disagreed("a fault of allworlds: the maps are wrong, as the gate says")
    yield replace(held, cells=(held.cells[0], *cells[1:]), ending=wrong)
    other = replace(held.cells[0], listed="abc")
    yield replace(held, cells=(other, *held.cells[1:]), ending=wrong)
    for ending in (
        Stopped("the time is over"),
        Stopped("ended after 2 findings", final=True),
        Interrupted(),
        Disagreed("two engines disagree about one world"),
    ):
        yield replace(held, ending=ending, levels=(1,), cells=held.cells[:2])
    yield replace(held, ending=Stopped("the time is over"), levels=(), cells=())


def plantri(name):
    """A file of worlds in the current folder, so that its name is the same everywhere."""
    data = Path(__file__).parents[1] / "support" / "data" / "plantri"
    shutil.copy(data / name, name)
    return name


@case
def refuted_checks():
    yield check(mine.first_edge, edges=2, max_findings=5)
    yield check(mine.crashes, edges=3, max_findings=1)
    refuted = check(mine.first_edge, edges=2, max_findings=2)
    past = SimpleNamespace(
        holds=lambda finding: finding == refuted.findings[0],
        directory="kept",
        summary="two files",
    )
    known = cases_of_check(replace(refuted, past=past))
    yield "\n".join(f"{each.name} {each.result}\n{text_of(each.sections, WIDTH)}" for each in known)
    disagreed = replace(refuted, ending=Disagreed("two numbers"))
    yield "\n".join(f"{each.name} {each.message}" for each in cases_of_check(disagreed))


@case
def samples():
    yield allworlds.fuzz("algorithm1", edges=5, runs=6)
    yield allworlds.fuzz(
        "algorithm1", edges=5, min_edges=3, runs=6, seed=2, mix=("sparse", "dense")
    )
    held = allworlds.fuzz("algorithm1", edges=4, runs=4, mix=("sparse",))
    yield replace(held, offspring=3)
    yield replace(held, ending=Stopped("the time is over"))
    yield allworlds.fuzz(mine.first_edge, edges=5, runs=9, seed=2)
    yield allworlds.fuzz("algorithm1", edges=4, runs=9, shard=(0, 2))


@case
def estimates():
    given = {"explorer": "mine", "edges": 5, "engine": "python"}
    larger = (
        Guess(edges=6, engine="kernel", worlds=12345678, sampled=0, rate=2000.4),
        Guess(edges=7, engine="kernel", worlds=10**15, sampled=5, rate=None),
        Guess(edges=8, engine="python", worlds=10**18, sampled=5, rate=3.0),
    )
    yield TimeEstimate(**given, worlds=123456, sampled=200, rate=17.36, larger=larger)
    yield TimeEstimate(**given, worlds=1, sampled=1, rate=1.0, larger=())
    yield TimeEstimate(**given, worlds=90, sampled=1, rate=1.0, larger=larger, counted=False)
    yield TimeEstimate(**given, worlds=90, sampled=0, rate=None, larger=larger)


# ---------------------------------------------------------------- numbers by size


@case
def counts():
    counted = allworlds.count(edges=3)
    yield counted
    yield allworlds.count(map_class="simple", vertices=3)
    yield allworlds.count(edges=2, shard=(0, 2))
    yield allworlds.count(edges=3, where="cubic")
    yield allworlds.count(edges=1, where="cubic")
    yield replace(counted, ending=Stopped("the time is over"), rows=counted.rows[:2])
    yield replace(counted, ending=Interrupted(), rows=())
    wrong = replace(counted.rows[1], counted={1: 3})
    yield replace(counted, rows=(counted.rows[0], wrong))


@case
def worst_costs():
    worst = allworlds.worst(edges=2)
    yield worst
    yield allworlds.worst(edges=2, transit="shortest", shard=(0, 2))
    yield replace(worst, ending=Stopped("the time is over"))
    yield replace(worst, ending=Interrupted(), rows=())
    yield replace(worst, rows=())
    yield replace(worst, disagreement="two ways, two numbers")
    for changes in ({"replayed": 1}, {"counted": 77}, {"counted": None}, {"replayed": None}):
        yield replace(worst, rows=(replace(worst.rows[0], **changes), *worst.rows[1:]))
    yield replace(worst, rows=(replace(worst.rows[0], wrong_tests=2, tests=9), *worst.rows[1:]))
    yield replace(worst, rows=(replace(worst.rows[0], bound=None), worst.rows[1]))


# ---------------------------------------------------------------- comparisons


@case
def comparisons():
    compared = allworlds.compare("algorithm1", "folding", edges=2)
    yield compared
    yield allworlds.compare("algorithm1", "folding", edges=2, by="world")
    yield allworlds.compare("algorithm1", "folding", edges=2, by="run", shard=(0, 2))
    yield allworlds.compare("folding", "algorithm1", family="prism:3")
    yield allworlds.compare("algorithm1", mine.first_edge, edges=2)
    yield replace(compared, ending=Stopped("the time is over"), rows=compared.rows[:1])
    yield replace(compared, ending=Interrupted(), rows=())
    yield replace(compared, rows=())


@case
def growths():
    grown = allworlds.compare(
        "algorithm1", "folding", family="strip,prism", to=20, draws=2, places=2
    )
    yield grown
    yield allworlds.compare("algorithm1", family="dense", to=40, draws=3, places=1, by="size")
    yield allworlds.compare("algorithm1", "folding", family="cubic", to=14, draws=2, by="world")
    yield replace(grown, ending=Stopped("the time is over"))
    yield replace(grown, left_out=3)


# ---------------------------------------------------------------- worlds that look alike


@case
def ambiguities():
    yield allworlds.twins("k4", "wheel-4")
    yield allworlds.twins("fig1-left", "fig1-right")
    yield allworlds.twins("cycle-3", "cycle-4", lighthouse="none")
    yield allworlds.twins("cycle-4", "cycle-4", lighthouse="position")
    yield allworlds.ambiguity.class_of("wheel-4")
    yield allworlds.ambiguity.class_of("k4", map_class="simple", limit=9)
    yield allworlds.ambiguity.class_of("edge")


@case
def censuses():
    census = allworlds.ambiguity.census(edges=3)
    yield census
    yield allworlds.ambiguity.census(edges=2, lighthouse="none")
    yield allworlds.ambiguity.census(edges=3, where="cubic")
    yield allworlds.ambiguity.census(edges=2, shard=(0, 2))
    yield replace(census, ending=Stopped("the time is over"), rows=census.rows[:1])
    yield replace(census, ending=Interrupted(), rows=(), by_vertices=())


@case
def sensors():
    yield allworlds.ambiguity.sensors("position", "door", "directional", "none", edges=3)
    yield allworlds.ambiguity.sensors("door", "word:1", "word:12", edges=2, map_class="simple")
    yield allworlds.ambiguity.sensors("compass", "position", edges=1)


# ---------------------------------------------------------------- plain facts


@case
def standings():
    given = {
        "verb": "check",
        "version": "1",
        "explorer": "mine",
        "shard": "0/1",
        "parameters": {"class": "maps", "edges": 3, "where": None, "family": ["a", "b"]},
    }
    begun = {
        "state": "running",
        "units": DoneOf(done=1, all=1200),
        "rate": 1234.4,
        "left_s": 7200.0,
        "worlds": DoneOf(done=1000, all=20000),
        "findings": 1000,
        "worst": LargestCost(edges=3, vertices=1, cost=1001),
    }
    ended = {**begun, "state": "finished", "rate": None, "left_s": None}
    for each in (
        {**given, **begun},
        {**given, **begun, "counted": False, "shard": "1/3", "options": ("--policy", "lifo")},
        {**given, **ended},
        {**given, **ended, "shard": "1/3", "findings": 0, "worst": None},
        {**given, **begun, "verb": "count", "explorer": "", "parameters": {"task": "map"}},
        {**given, **begun, "parameters": {"task": "cover", "vertices": 2}, "left_s": 0.0},
    ):
        yield Standing(**each)


@case
def beginnings():
    yield allworlds.init("made/python")
    yield allworlds.init("made/c", lang="c")
    yield allworlds.init(header=True)
    yield WorldNames(maps=("edge", "loop"), families=("prism:N",), corpus=())


@case
def unknown_results():
    given = {"rows": [{"a": 1, "b": None}, {"a": 2, "b": "x"}], "more": [{"c": 1.5}], "n": 5}
    yield text_of_plain({**given, "verdict": "holds", "left": None, "flag": True})
    yield text_of_plain({"cells": [{"a": 1, "b": 1}, {"a": "y", "b": 2}], "schema": 1})
    yield text_of_plain({"list": [], "words": ["a", "b"]})


def text_of_plain(document):
    """A result without a content of its own."""

    class Result:
        verdict = document.get("verdict", "")

        def to_json(self):
            return document

    return "\n".join(shown(plain_content(Result())))


@case
def conversions():
    yield allworlds.convert(plantri("tri5.pl"))
    yield allworlds.convert(plantri("tri6.pl"))


# ---------------------------------------------------------------- ledgers


SENTENCE = {"section": "IV", "method": "exhaustive", "scope": "few", "source": "a table"}


def claim(name, **given):
    found = {
        **SENTENCE,
        "id": name,
        "statement": f"All is {name}.",
        "expected": "holds",
        "witnesses": {"loops": 1200},
        "expected_witnesses": {"loops": 1200},
        "figures": {},
        "expected_figures": {},
        "told": "",
        "worlds": (),
        "captions": (),
        "truth": "holds",
        "disagreement": "",
        "error": "",
        "seconds": 1.5,
    }
    return CheckedClaim(**{**found, **given})


def claims_found():
    world = World(PATH, Directional(0))
    yield claim("good", worlds=(world, world), captions=("the path", "once more"))
    yield claim("false", expected="refuted", truth="refuted", section="Proofs", told="by a loop")
    yield claim("other", truth="refuted", figures={"n": [1, 2], "m": 5000, "t": "x"})
    yield claim("unmet", witnesses={"loops": 0})
    yield claim("dear", truth=None, told="the budget is too small")
    yield claim("dearer", truth=None, told="the budget is too small")
    yield claim("external", truth=None, told="there is no prover", section="3.1")
    yield claim("broken", error="ValueError", truth=None)
    yield claim("torn", disagreement="two numbers")


@case
def ledgers():
    claims = [*claims_found()]
    made = LedgerReport(
        budget="quick", required=(), claims=tuple(claims), directory="here", ending=Completed()
    )
    yield made
    for each in claims:
        yield replace(made, claims=(each,))
    yield replace(made, claims=(), ending=Interrupted())
    yield replace(made, claims=tuple(claims[:1]), ending=Stopped("the time is over"))
    yield replace(made, required=("dear",))
    yield replace(made, claims=(claims[0], claims[0], claims[1]))


# ---------------------------------------------------------------- teams


def team(*names, model="meeting:apart=false", **options):
    """A search of programs of a file in the current folder."""
    shutil.copy(Path(__file__).parents[1] / "support" / "teams.py", "teams.py")
    return allworlds.team(*(f"teams.py:{name}" for name in names), model=model, **options)


@case
def teams():
    held = team("waits", "searches", edges=2)
    yield held
    yield team("other_end", model="meeting", edges=1)
    yield team("other_end", model="meeting", scheduler="async", edges=1)
    yield team("waits", "polls", edges=1, budget=4)
    yield team("waits", "polls", edges=1, configurations=2)
    yield team("waits", "polls", edges=1, where="cubic")
    yield team("waits", "polls", edges=1, within=4)
    yield team("waits", "polls", edges=2, budget=4, lead=2, scheduler="ssync")
    yield team("waits", "polls", edges=1, budget=4, start_delay=2)
    yield team("waits", "polls", edges=1, budget=4, lead=1, start_delay=1, scheduler="ssync")
    yield team("searches", "polls", edges=2, budget=3, lead=2, start_delay=2, scheduler="ssync")
    yield team("waits", world='{"sigma":[0,1],"alpha":[1,0]}', starts=(0, 1), budget=4)
    yield team("waits", "searches", edges=2, shard=(0, 2))
    yield replace(held, ending=Stopped("the time is over"), levels=(1,), cells=held.cells[:1])
    yield replace(held, ending=Interrupted(), levels=(), cells=())
    wrong = replace(held.cells[1], counted=9)
    ending = Disagreed("a fault of allworlds: the maps are wrong, as the gate says")
    yield replace(held, cells=(held.cells[0], wrong), ending=ending)


@case
def team_findings():
    found = team("other_end", model="meeting", edges=1).findings[0]
    yield TeamExplanation(finding=found, number=1, findings=2)
    yield allworlds.replay(found)
    yield sequence_of(found)
    long = replace(found, events=found.events * 40)
    yield sequence_of(replace(found, loop=0))
    yield text_of([team_section(long, 3)], WIDTH)
    yield text_of([team_section(replace(found, loop=0, detail="one\ntwo"), 3)], WIDTH)
    yield "\n".join(map(str, rows_of_team(found)))
    yield "\n".join(map(str, rows_of_team(replace(found, loop=1))))


@case
def bounds_told():
    for name in sorted({*BOUNDS} - {"none"}):
        for world in ("theta", "star-4", "k4"):
            right = run("algorithm1", world_named(world, "directional"))
            walked = [each for each in right.walk.actions if isinstance(each, Move)]
            answer = right.outcome.episode.ending.answer
            for more in (0, 20, 160):
                explore = mine.walking(*walked, *moves(*[0] * more), answer=answer)
                finding = found(explore, world, bound=name)
                yield f"{name}, {world}, {more}: {told(finding) if finding else 'no finding'}"


@case
def searches():
    for given in (
        {"lighthouse": "position", "vertices": 1, "edges": 2},
        {"lighthouse": "directional", "vertices": 2, "edges": 1},
        {"lighthouse": "none", "map_class": "simple", "vertices": 2, "edges": 1},
    ):
        found = allworlds.search(**given, out="out")
        levels = tuple(replace(each, seconds=0.25) for each in found.levels)
        yield replace(found, levels=levels)
        yield replace(found, levels=(), status="unknown")
        yield replace(found, levels=(), vacuous=True)
        yield replace(found, levels=levels, certificate=None)


@case
def other_lighthouses():
    yield check("algorithm1-cluster", edges=3)
    yield check(mine.stays, lighthouse="none", edges=1)
    yield check(mine.first_edge, lighthouse="position", edges=2, max_findings=2)
    yield check(mine.first_edge, lighthouse="compass", edges=2)
