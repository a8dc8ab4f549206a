"""The sample of larger worlds: how it is drawn, and that whatever differs in it is seen."""

import json
from collections import Counter
from itertools import islice
from random import Random

import pytest

from allworlds.documents.document import replace
from allworlds.engines.units import LevelUnit
from allworlds.explorers.loading import load
from allworlds.maps import MapClass, rooted_maps
from allworlds.maps.classes import Extent
from allworlds.world import World
from allworlds.world.lighthouses.marked import Directional


@pytest.fixture
def samples(checkers):
    return checkers("certified_sample")


@pytest.fixture
def kernels(samples, checkers):
    """The wrong kernels, which need the sample."""
    return checkers("kernels")


def drawn(draw, edges, times, seed=3):
    random = Random(seed)
    maps = [draw(edges, random) for _ in range(times)]
    return Counter((map_.sigma, map_.alpha) for map_ in maps), maps


@pytest.mark.parametrize(
    ("name", "edges", "count", "holds"),
    [
        ("uniform", 2, 10, lambda _: True),
        ("trees", 3, 5, lambda map_: map_.vertex_count == 4),
        ("one vertex", 2, 3, lambda map_: map_.vertex_count == 1),
        ("highest genus", 2, 1, lambda map_: map_.genus == 1),
    ],
)
def test_each_map_of_its_kind_is_drawn_equally_often(samples, name, edges, count, holds):
    every = {(map_.sigma, map_.alpha) for map_ in rooted_maps(edges) if holds(map_)}
    assert len(every) == count
    times = 100 * count
    codes, _ = drawn(samples.KINDS[name], edges, times)
    assert {samples.rooted_code(*code, 0) for code in codes} == {
        samples.rooted_code(*code, 0) for code in every
    }
    assert all(60 <= often <= 140 for often in codes.values())


def test_behind_a_path_the_robot_starts_at_its_end(samples):
    _, maps = drawn(samples.KINDS["behind a path"], 7, 30)
    assert {map_.degree_at[0] for map_ in maps} == {1}
    assert {map_.edge_count for map_ in maps} == {7}
    assert len({map_.vertex_count for map_ in maps}) > 3


ALGORITHM1 = load("algorithm1").player()


def honest(samples, program, lines, policy="fifo"):
    """The answers of the extracted programs, as the package would give them."""
    answers = []
    for each in map(json.loads, lines):
        if program.name == "judge":
            answers.append(json.dumps({"verdict": verdict_of(samples, each)}))
            continue
        map_ = samples.CombinatorialMap(each["sigma"], each["alpha"])
        world = World(map_, Directional(map_.turn(0, each["place"])))
        log, case = samples.log_of("it", world, ALGORITHM1, policy)
        within = len(case.walk) <= each["limit"]
        answers.append(f'{log},"finding":"{"right" if within else "none"}"}}')
    return answers


def verdict_of(samples, asked):
    """The verdict by isomorphisms: the judge's, from a walk that ends where it is said to."""
    codes = [
        samples.rooted_code(samples_of["sigma"], samples_of["alpha"], dart)
        for samples_of, dart in (
            (asked["estimate"], asked["estimate"]["here"]),
            (asked["world"], asked["end"]),
        )
    ]
    if codes[0] == codes[1]:
        return "right"
    everywhere = (
        samples.rooted_code(asked["world"]["sigma"], asked["world"]["alpha"], dart)
        for dart in range(len(asked["world"]["sigma"]))
        if len(codes[0][0]) == len(asked["world"]["sigma"])
    )
    return "pose" if codes[0] in everywhere else "map"


def one_motion(answer):
    return answer.replace('"steps":[[0,', '"steps":[[1,', 1)


CHANGES = {
    "motion": ("runs", one_motion, "has another log"),
    "answer": ("runs", lambda a: a.replace('"here":', '"here":1', 1), "has another log"),
    "verdict": ("runs", lambda a: a.replace("right", "pose"), "or another verdict"),
    "cost": ("runs", lambda a: a.replace("none", "right"), "right within one motion less"),
    "judge": ("judge", lambda a: a.replace("right", "map"), "the judge says right"),
}


@pytest.fixture
def few(samples, monkeypatch):
    """Eight runs in uniform worlds, and what differs in them if answers are changed so."""
    monkeypatch.setattr(samples, "kernels_apart", lambda *_: [])
    random = Random(5)
    maps = [samples.uniform(5, random) for _ in range(8)]
    every = [("uniform", World(map_, Directional(0))) for map_ in maps]

    def compared(changed="", change=str, players=(ALGORITHM1, ALGORITHM1)):
        def answered_by(program, lines, *policy):
            answers = honest(samples, program, lines, *policy)
            return [change(a) for a in answers] if program.name == changed else answers

        monkeypatch.setattr(samples, "answered_by", answered_by)
        return samples.runs_agree(every, "fifo", players, Random(1))

    return compared


def test_programs_that_say_the_same_do_not_differ(few):
    apart, said = few()
    assert apart == []
    assert set(said) == {"right", "pose", "map"}


@pytest.mark.parametrize("change", CHANGES)
def test_whatever_a_program_says_otherwise_is_seen(few, change):
    program, changed, said = CHANGES[change]
    apart, _ = few(program, changed)
    assert apart
    assert all(said in each for each in apart)


def test_another_explorer_behind_the_pipe_is_seen(few):
    def last_first(first, choices, told):
        return ALGORITHM1(first, type(choices)(few_policy), told)

    from allworlds.protocol.choices import policy_named

    few_policy = policy_named("lifo")
    apart, _ = few(players=(ALGORITHM1, last_first))
    assert any("walks or answers otherwise" in each for each in apart)


def test_of_a_program_that_is_lost_nothing_is_decided(samples, checkers, tmp_path):
    lost = checkers("certificate_file").NoVerdict
    program = tmp_path / "runs"
    program.write_text("#!/bin/sh\nread line; echo $line; echo why >&2; exit 3\n")
    program.chmod(0o755)
    with pytest.raises(lost, match="1 answers to 2 lines, exit code 3; why"):
        samples.answered_by(program, ["a\n", "b\n"])

    def crashes(_first, _choices, _told):
        raise MemoryError
        yield

    world = World(samples.uniform(5, Random(1)), Directional(0))
    with pytest.raises(lost, match="it: crash: "):
        samples.log_of("it", world, crashes, "fifo")


DECIDED = {
    "eight-darts-new": (5, 2, (-1,)),
    "one-step-undecided": (6, 4, (-1, -3, -3)),
}
"""Edges, most vertices and prefix of a unit in which a wrong kernel decides a dart wrongly."""


@pytest.mark.usefixtures("compiled")
@pytest.mark.parametrize("name", DECIDED)
def test_a_kernel_that_decides_wrongly_is_seen_in_a_unit_though_not_in_its_worlds(
    samples, kernels, name
):
    edges, limit, prefix = DECIDED[name]
    piece = samples.Piece(LevelUnit(edges, prefix), Extent(MapClass.MAPS, edges, limit))
    (wrong,) = [each for each in kernels.WRONG_KERNELS if each.name == name]
    assert samples.piece_apart(piece, wrong.policy, right_walk(kernels)) == []
    assert kernels.seen_in(wrong, [piece])
    alone = map(samples.piece_of, piece.unit.maps(piece.extent))
    assert kernels.seen_in(wrong, alone) is None


@pytest.mark.usefixtures("compiled")
def test_the_kernel_without_numba_says_what_the_compiled_one_does(samples, checkers):
    without = checkers("interpreted")
    engines, told = without.interpreted(), Counter()
    for question in islice(without.small_questions("nearest"), 0, None, 3):
        if question.level.edges < 4:
            about = question.level, question.prefix
            expected = samples.judge(*about, keep=question.keep)
            rows = question.answered(engines)
            if question.engine == "judge":
                assert rows == expected
            elif question.level.budgets[-1] > 20:
                assert rows.counts == expected.counts
            told[question.engine] += 1
    assert min(told["judge"], told["walk"]) > 10


@pytest.mark.usefixtures("compiled")
def test_a_mistake_in_the_judge_is_seen_where_a_robot_breaks_a_law(checkers):
    without = checkers("interpreted")
    source = without.FOLDER.joinpath("laws.py").read_text(encoding="utf-8")
    right, wrong = "if judged.shown and t >= judged.t:", "if judged.shown and t > judged.t:"
    assert source.count(right) == 1
    found = without.seen({"laws": source.replace(right, wrong)}, ["fifo"])
    assert "wrong robot" in found


def right_walk(kernels):
    return kernels.WrongKernel("right", "", "_FEW = 0xFF", "_FEW = 0xFF").walk()


@pytest.fixture
def a_unit(samples, kernels, monkeypatch):
    """What differs in a unit, if the answers of the extracted programs, or rows, are changed so."""
    piece = samples.Piece(LevelUnit(5, (-2, -3)), Extent(MapClass.MAPS, 5, 4))
    honest_walk = right_walk(kernels)

    def compared(change=lambda answers: answers, of_rows=lambda rows: rows):
        def answered_by(program, lines, policy):
            return change(honest(samples, program, lines, policy))

        def walked(*question, **options):
            return of_rows(honest_walk(*question, **options))

        monkeypatch.setattr(samples, "answered_by", answered_by)
        return samples.extracted_apart(piece, "fifo", walked)

    return compared


def test_in_a_unit_that_is_right_nothing_differs(a_unit):
    apart, worlds = a_unit()
    assert apart == []
    assert worlds == 60


def one_pose(answers):
    return [answers[0].replace('"right"', '"pose"'), *answers[1:]]


def one_step_more(answers):
    return [answers[0].replace('"steps":[', '"steps":[[0,[1,null]],'), *answers[1:]]


def two_exchanged(answers):
    """The costs of two worlds of one size: the sum and the largest stay."""
    steps = [len(json.loads(each)["steps"]) for each in answers]
    first, *_, last = sorted(range(len(answers)), key=lambda i: steps[i])
    changed = list(answers)
    changed[first], changed[last] = answers[last], answers[first]
    return changed


def another_world(rows):
    counts = tuple(replace(each, fingerprint=each.fingerprint ^ 1) for each in rows.counts)
    return replace(rows, counts=counts)


def none_broken(rows):
    return replace(rows, broken=())


def one_broken(rows):
    return replace(rows, broken=rows.broken or rows.most_expensive)


WRONG_UNITS = [
    ({"change": one_pose}, "pose in"),
    ({"change": one_step_more}, "extracted"),
    ({"change": two_exchanged}, "other worlds cost more"),
    ({"of_rows": another_world}, "extracted"),
    ({"of_rows": none_broken}, "other worlds cost more"),
    ({"of_rows": one_broken}, "finds a world broken"),
]


@pytest.mark.parametrize(("change", "said"), WRONG_UNITS)
def test_whatever_differs_in_a_unit_is_seen(a_unit, change, said):
    apart, _ = a_unit(**change)
    assert any(said in each for each in apart), apart


def test_units_are_drawn_of_all_sizes_with_worlds_in_them(samples):
    some = [piece for piece, _ in zip(samples.units_drawn(0, "fifo", 9), range(30), strict=False)]
    assert {piece.unit.edges for piece in some} == {5, 6, 7, 8, 9}
    sizes = [piece.unit.weight(piece.extent) for piece in some]
    assert all(1 <= size <= samples.LARGE for size in sizes)
    assert max(sizes) > samples.SMALL
    again = [piece for piece, _ in zip(samples.units_drawn(0, "fifo", 9), range(3), strict=False)]
    assert again == some[:3]
