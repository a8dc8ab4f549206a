"""The shield: it makes right whatever is inside, at a constant times the cost of the better."""

import pytest

import allworlds
from allworlds import CombinatorialMap, Estimate, Move, Percept
from allworlds.corpus.explorers import EQUIVALENT_EXPLORERS, WRONG_EXPLORERS
from allworlds.explorers.builtin import folding as shield_module
from allworlds.explorers.builtin.algorithm1 import algorithm1
from allworlds.explorers.builtin.explorer_table import BUILT_IN
from allworlds.explorers.builtin.folding import FoldedLog, Shield, has_open_dart
from allworlds.explorers.loading import in_process_subject, load, named_on_command_line, own_bound
from allworlds.explorers.sources import content_digest, place_of_explorer, whole_name
from allworlds.inputs.checks import InputError
from allworlds.judging.laws.bounds import paper_bound
from allworlds.judging.rules import Rules
from allworlds.maps import rooted_maps
from allworlds.protocol.actions import Checkpoint, Drop, ExplorerFault
from interrupts import interrupted_at_its_close

NOT_MENDED = {"state-kept": "nondeterministic"}
"""The mutants that a shield cannot make right, and the law that they break all the same."""


def lazy(first):
    return Estimate(CombinatorialMap([0, 1], [1, 0]), 0)
    yield


def raising(first):
    yield Move(1)
    raise SystemExit


def spinning(first):
    while True:
        yield Move(1)


def zigzag(first):
    k = 0
    while True:
        k += 1
        yield Move(k * k % 7)


def chattering(first):
    while True:
        yield Checkpoint((), (), 0)


def dropping(first):
    yield Drop()


def turning_by_words(first):
    yield Move("left")


def bare(first):
    return iter([Move(1), Move(1)])


def not_to_be_closed(first):
    try:
        while True:
            yield Move(0)
    finally:
        raise RuntimeError


STRANGERS = [
    *(lazy, raising, spinning, zigzag, chattering, dropping, turning_by_words, bare),
    not_to_be_closed,
]


class Walk:
    """An explorer walks a map from dart 0, with the marker so many places clockwise of it."""

    def __init__(self, explore, world, bearing, most=10**6):
        pointed = world.turn(0, bearing)

        def sense(dart):
            if world.vertex_of[dart] != world.vertex_of[pointed]:
                return Percept(world.degree_at[dart])
            return Percept(world.degree_at[dart], 1, world.offset(dart, pointed))

        at, seen, self.cost, self.folded = 0, None, 0, None
        explorer = explore(sense(0))
        log, self.answer = FoldedLog(sense(0)), None
        here = log.turn(0, -bearing)
        while self.cost < most:
            try:
                message = explorer.send(seen)
            except StopIteration as stop:
                self.answer = stop.value
                break
            seen = None
            if isinstance(message, Move):
                at = world.alpha[world.turn(at, message.k)]
                seen = sense(at)
                here = log.arrive(log.turn(here, message.k), seen)
                self.cost += 1
                if self.folded is None and not has_open_dart(log):
                    self.folded = self.cost


def every_run(edges):
    """Each rooted map with at most so many edges, with each bearing."""
    for m in range(1, edges + 1):
        for world in rooted_maps(m):
            for bearing in range(world.degree_at[0]):
                yield world, bearing


def checked(explorer, edges):
    return allworlds.check(allworlds.shield(explorer), edges=edges)


# ---------------------------------------------------------------- it is right


@pytest.mark.parametrize("edges", [2])
@pytest.mark.parametrize("mutant", [*WRONG_EXPLORERS, *EQUIVALENT_EXPLORERS], ids=lambda m: m.name)
def test_every_wrong_explorer_is_made_right(mutant, edges):
    report = checked(mutant.explorer(), edges)
    assert {finding.law for finding in report.findings} == {
        *filter(None, [NOT_MENDED.get(mutant.name)])
    }
    if mutant.name not in NOT_MENDED:
        assert (report.verdict.value, report.runs) == ("holds", {2: 30, 3: 309, 4: 3684}[edges])


@pytest.mark.parametrize("edges", [2])
@pytest.mark.parametrize("stranger", STRANGERS, ids=lambda s: s.__name__)
def test_whatever_is_inside_the_map_is_right(stranger, edges):
    inside = Shield(stranger) if stranger is bare else allworlds.shield(stranger)
    for world, bearing in every_run(edges):
        walk = Walk(inside, world, bearing)
        found = walk.answer.map
        assert found == CombinatorialMap(found.sigma, found.alpha)
        assert walk.folded == walk.cost <= 9 * paper_bound(world.vertex_count, world.edge_count)
    if stranger is not bare:
        assert checked(stranger, edges).verdict.value == "holds"


@pytest.mark.parametrize("name", ["folding", "folding-oldest"])
def test_it_costs_less_than_nine_times_the_better(name):
    explore = BUILT_IN[name].explore
    for world, bearing in every_run(3):
        shielded = Walk(Shield(explore), world, bearing).cost
        alone = Walk(explore, world, bearing).folded
        other = Walk(algorithm1, world, bearing).folded
        assert shielded <= 9 * min(alone, other) - 6


def test_what_is_known_is_not_walked_again():
    """Three to six times Algorithm 1's traversals, where each turn begins at v0."""
    runs = [*every_run(3)]
    walked = [sum(Walk(e, *run).cost for run in runs) for e in (Shield(spinning), algorithm1)]
    assert walked == [1220, 1203]


# ---------------------------------------------------------------- mutants of the shield


def wrong_in_some_world(explore=spinning):
    for world, bearing in every_run(3):
        try:
            walk = Walk(Shield(explore), world, bearing, most=9 * 22)
        except (AssertionError, KeyError):
            return True
        if walk.answer is None:
            return True
    return False


def test_the_tests_notice_a_shield_without_turns(monkeypatch):
    assert not wrong_in_some_world()
    monkeypatch.setattr(shield_module, "count", lambda: iter([12]))
    with pytest.raises(AssertionError, match="no end"):
        Walk(Shield(lazy), CombinatorialMap((0, 1), (1, 0)), 0, most=9)
    assert wrong_in_some_world(not_to_be_closed)


def test_an_open_dart_is_not_taken_for_a_closed_one(monkeypatch):
    monkeypatch.setattr(shield_module, "has_open_dart", lambda log: False)
    assert wrong_in_some_world()


# ---------------------------------------------------------------- what it cannot mend

SILENT = """
import allworlds
from allworlds import Move


def explore(first):
    yield Move(1)
    while True:
        pass


def spinning(first):
    while True:
        yield Move(1)


shielded = allworlds.shield(spinning)
"""


@pytest.fixture
def mine(tmp_path):
    file = tmp_path / "mine.py"
    file.write_text(SILENT)
    return file


def test_the_machine_is_not_taken_for_the_explorer():
    def failing(error):
        def explore(first):
            raise error
            yield

        return Shield(explore)

    world = next(rooted_maps(2))
    for error in (
        MemoryError(),
        KeyboardInterrupt(),
        ExplorerFault("crash", "a signal", machine=True),
    ):
        with pytest.raises(type(error)):
            Walk(failing(error), world, 0)
    assert Walk(failing(ExplorerFault("crash", "exit code 1")), world, 0).answer


def test_an_interrupt_is_the_users_also_when_a_guest_is_dismissed():
    with pytest.raises(KeyboardInterrupt):
        Walk(Shield(interrupted_at_its_close), next(rooted_maps(2)), 0)


# ---------------------------------------------------------------- by name


@pytest.mark.parametrize("name", ["quotient", "{mine}:shielded"])
def test_it_is_asked_for_by_name(name, mine):
    report = allworlds.check(f"shield:{name.format(mine=mine)}", edges=3, workers=2)
    assert (report.verdict.value, report.runs, report.scope.bound) == ("holds", 309, "9*paper")


def test_an_explorer_that_has_one_brings_its_bound(mine):
    report = allworlds.check(f"{mine}:shielded", edges=3)
    assert (report.explorer, report.scope.bound) == (f"shield:{mine}:shielded", "9*paper")


def test_its_budget_is_no_less_than_its_bound():
    rules = Rules(own_bound=own_bound("shield:algorithm1", "directional"))
    assert rules.budget_by_size(4, 7) == 9 * paper_bound(4, 7) > 8 * paper_bound(4, 7) + 100


@pytest.mark.parametrize("lighthouse", ["cluster", "position", "none"])
def test_another_lighthouse_is_refused(lighthouse):
    with pytest.raises(InputError, match="a shield needs the directional lighthouse"):
        allworlds.check("shield:algorithm1", edges=2, lighthouse=lighthouse)


def test_it_is_known_by_the_content_of_what_is_inside(mine):
    inside, shielded = (load(f"{prefix}{mine}:spinning") for prefix in ("", "shield:"))
    assert content_digest(shielded) == content_digest(inside)
    assert place_of_explorer(shielded.name) == place_of_explorer(inside.name)
    assert named_on_command_line(shielded.name) == [shielded.name]
    assert content_digest(load("shield:dfs")) == "built-in"


def test_a_run_directory_goes_on_with_it_and_not_with_another_text(mine, tmp_path):
    name, run = f"shield:{mine}:spinning", str(tmp_path / "run")
    first = allworlds.check(name, edges=3, run=run)
    assert allworlds.check(name, edges=3, run=run).to_json() == first.to_json()
    mine.write_text(SILENT.replace("Move(1)", "Move(2)"))
    with pytest.raises(InputError, match="another text"):
        allworlds.check(name, edges=3, run=run)


def test_one_shield_is_enough(mine):
    twice = allworlds.shield(allworlds.shield(spinning))
    assert in_process_subject(twice).name == in_process_subject(allworlds.shield(spinning)).name
    assert allworlds.check(f"shield:shield:{mine}:spinning", edges=2).verdict.value == "holds"


def test_it_takes_what_the_explorer_takes():
    assert in_process_subject(Shield(algorithm1)).keywords == {"choices"}
    report = allworlds.check("shield:algorithm1", edges=2, schedules="all")
    assert (report.verdict.value, report.runs) == ("holds", 30)


@pytest.mark.parametrize("prefix", ["", "shield:", "elsewhere:"])
def test_an_explorer_whose_signature_nobody_can_tell_is_given_the_percept_alone(prefix, mine):
    mine.write_text(f'{SILENT}\nspinning.__signature__ = "none"\n')
    report = allworlds.check(
        f"{prefix}{mine}:spinning", edges=1, answer_timeout=0.5, step_budget=50
    )
    assert report.verdict.value == ("holds" if prefix == "shield:" else "refuted")


def test_a_file_with_one_explorer_is_enough(tmp_path):
    file = tmp_path / "one.py"
    file.write_text("def explore(first):\n    yield\n")
    assert whole_name(f"shield:{file}") == f"shield:{file}:explore"


def test_what_is_neither_name_nor_function_has_none():
    with pytest.raises(InputError, match="neither a name nor a function"):
        allworlds.shield(3)


@pytest.mark.parametrize(("published", "legal"), [(1000, True), (1001, False)])
def test_a_guest_publishes_at_most_a_thousand_checkpoints_between_two_motions(published, legal):
    def publishes(first):
        for _ in range(published):
            yield Checkpoint((1, 0), (1, 0), 0)
        yield Move(0)

    log, here = shield_module.begun(Percept(2, 1, 0))
    guest = shield_module._Guest(log, here, publishes)
    if legal:
        assert guest.next_dart() == log.turn(log.canonical(here), 0)
    else:
        with pytest.raises(ValueError, match=r"^1001 checkpoints between two motions$"):
            guest.next_dart()
