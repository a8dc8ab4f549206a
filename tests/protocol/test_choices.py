from itertools import product

import pytest
from hypothesis import given, strategies as st

from allworlds.inputs.checks import InputError
from allworlds.protocol.choices import KINDS, Choices, policy_named
from schedules import schedules

POLICIES = ["fifo", "lifo", "nearest", "random:0", "random:7"]
widths = st.lists(st.integers(1, 5), max_size=12)


def answers(policy, asked, run=""):
    """The record of a run that asks for an edge among so many, again and again."""
    choices = Choices(policy_named(policy, run))
    for width in asked:
        choices.pick(range(width), of="edge")
    return choices.record


# ---------------------------------------------------------------- the policies


@pytest.mark.parametrize("kind", KINDS)
def test_fifo_takes_the_first_of_every_kind(kind):
    assert Choices(policy_named("fifo")).pick("abc", of=kind, cost=[3, 2, 1]) == "a"


@pytest.mark.parametrize("kind", KINDS)
def test_lifo_takes_the_last_edge_and_the_first_of_all_else(kind):
    picked = Choices(policy_named("lifo")).pick("abc", of=kind, cost=[3, 2, 1])
    assert picked == ("c" if kind == "edge" else "a")


@pytest.mark.parametrize("kind", KINDS)
def test_nearest_takes_the_first_of_the_cheapest_edges_and_the_first_of_all_else(kind):
    picked = Choices(policy_named("nearest")).pick("abcd", of=kind, cost=[3, 1, 2, 1])
    assert picked == ("b" if kind == "edge" else "a")


@pytest.mark.parametrize("nearest", range(4))
def test_the_nearest_edge_may_be_any_of_them(nearest):
    cost = [5 - (i == nearest) for i in range(4)]
    picked = Choices(policy_named("nearest")).pick(range(4), of="edge", cost=cost)
    assert picked == nearest


@pytest.mark.parametrize("cost", [None, ()])
def test_nearest_takes_the_first_where_no_cost_is_known(cost):
    assert Choices(policy_named("nearest")).pick("abc", of="edge", cost=cost) == "a"


@pytest.mark.parametrize("kind", KINDS)
def test_random_reaches_every_option_of_every_kind_and_nothing_else(kind):
    choices = Choices(policy_named("random:1"))
    assert {choices.pick("abc", of=kind) for _ in range(200)} == set("abc")


@given(widths)
def test_a_random_policy_is_fixed_by_its_seed_and_the_name_of_the_run(asked):
    assert answers("random:5", asked, "run") == answers("random:5", asked, "run")
    assert answers("random:5", asked) == answers("random:005", asked)


def test_seeds_and_runs_draw_anew():
    asked = [10] * 30
    drawn = {
        tuple(answers(policy, asked, run))
        for policy in ("random:0", "random:1", "random:10")
        for run in ("", "1", "10")
    }
    assert len(drawn) == 9


def test_a_random_draw_is_the_same_on_every_machine():
    # Python promises that Random(str).randrange keeps its sequence.
    assert answers("random:0", [100] * 3, "run") == answers("random:0", [100] * 3, "run")


def test_a_policy_is_fresh_for_every_run():
    assert policy_named("random:3") is not policy_named("random:3")


@pytest.mark.parametrize(
    "name",
    [
        "",
        "FIFO",
        "fifo ",
        "fifo:1",
        "random",
        "random:",
        "random:-1",
        "random:x",
        "random:1.5",
        "random:\N{SUPERSCRIPT TWO}",
        "random:\N{ARABIC-INDIC DIGIT ONE}",
        "best",
    ],
)
def test_a_name_that_is_no_policy_is_refused_with_the_legal_ones(name):
    with pytest.raises(InputError) as refusal:
        policy_named(name)
    assert repr(name) in str(refusal.value)
    for legal in ("fifo", "lifo", "nearest", "random:SEED"):
        assert legal in str(refusal.value)
    assert isinstance(refusal.value, InputError)


def test_a_seed_with_thousands_of_digits_is_a_seed_or_refused_as_a_policy():
    try:
        policy = policy_named("random:" + "1" * 5000)
    except InputError:
        return
    assert policy.choose("edge", "a", None) == 0


# ---------------------------------------------------------------- the record


@pytest.mark.parametrize("policy", POLICIES)
@given(asked=widths)
def test_the_record_holds_one_legal_index_a_choice_and_replays_the_run(policy, asked):
    record = answers(policy, asked)
    assert len(record) == len(asked)
    assert all(0 <= index < width for index, width in zip(record, asked, strict=True))
    replay = Choices(script=record)
    assert [replay.pick(range(width), of="path") for width in asked] == record
    assert replay.record == record


def test_the_element_picked_is_the_one_at_the_recorded_index():
    choices = Choices(script=(2, 0, 1))
    assert [choices.pick("abc", of="hypothesis") for _ in range(3)] == ["c", "a", "b"]
    assert choices.record == [2, 0, 1]


def test_after_the_script_the_policy_goes_on():
    choices = Choices(policy_named("lifo"), script=[0, 1])
    assert [choices.pick("abc", of="edge") for _ in range(4)] == ["a", "b", "c", "c"]
    assert choices.record == [0, 1, 2, 2]


def test_without_a_policy_the_first_is_picked():
    assert [Choices().pick("abc", of=kind) for kind in KINDS] == ["a"] * 4


class Told:
    """A policy that remembers what it was told."""

    def __init__(self):
        self.seen = []

    def choose(self, kind, options, cost):
        self.seen.append((kind, len(options), cost))
        return 1


def test_a_policy_is_told_the_kind_the_number_and_the_costs():
    policy = Told()
    Choices(policy).pick("ab", of="transit", cost=[4, 5])
    Choices(policy).pick("abc", of="path")
    assert policy.seen == [("transit", 2, [4, 5]), ("path", 3, None)]


@pytest.mark.parametrize("kind", ["", "Edge", "vertex", None])
def test_a_kind_that_is_none_is_refused_by_name_and_not_recorded(kind):
    choices = Choices()
    with pytest.raises(ValueError, match="edge, hypothesis, path, transit") as refusal:
        choices.pick("abc", of=kind)
    assert repr(kind) in str(refusal.value)
    assert choices.record == []


@pytest.mark.parametrize("index", [-1, 3, 99])
def test_where_the_script_does_not_fit_the_policy_answers(index):
    choices = Choices(policy_named("lifo"), script=[1, index])
    assert choices.pick("abc", of="edge") == "b"
    assert choices.pick("abc", of="edge") == "c"
    assert choices.record == [1, 2]


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("policy", POLICIES)
def test_a_choice_among_nothing_is_a_value_error_and_not_recorded(policy, kind):
    choices = Choices(policy_named(policy))
    with pytest.raises(ValueError):  # noqa: PT011  # every policy says it in its own words
        choices.pick([], of=kind, cost=[])
    assert choices.record == []


def test_a_scripted_choice_among_nothing_is_a_value_error():
    with pytest.raises(ValueError, match="nothing to choose from: no option of edge"):
        Choices(script=[0]).pick([], of="edge")


# ---------------------------------------------------------------- every schedule

# A toy explorer is a tree: at each node it picks one of the branches; a leaf is its end.
trees = st.recursive(
    st.just(()), lambda inner: st.lists(inner, min_size=1, max_size=3), max_leaves=25
)


def walk(tree, choices):
    while tree:
        tree = choices.pick(tree, of="edge")
    return list(choices.record)


def leaves(tree):
    if not tree:
        yield []
    for i, branch in enumerate(tree):
        for rest in leaves(branch):
            yield [i, *rest]


@given(trees)
def test_schedules_are_all_sequences_of_answers_in_lexicographic_order(tree):
    walked = [walk(tree, choices) for choices in schedules()]
    assert walked == list(leaves(tree))
    assert walked == sorted(walked)


@given(st.lists(st.integers(1, 4), max_size=5))
def test_schedules_of_fixed_widths_are_the_product_of_their_ranges(asked):
    found = []
    for choices in schedules():
        found.append(tuple(choices.pick(range(width), of="transit") for width in asked))
        assert tuple(choices.record) == found[-1]
    assert found == list(product(*map(range, asked)))


def test_an_explorer_that_asks_nothing_has_one_schedule():
    assert [choices.record for choices in schedules()] == [[]]


def test_the_record_of_a_finished_run_stays_when_the_next_run_begins():
    runs = []
    for choices in schedules():
        walk([(), [(), ()]], choices)
        runs.append(choices)
    assert [choices.record for choices in runs] == [[0], [1, 0], [1, 1]]


# ---------------------------------------------------------------- what cannot be chosen from


@pytest.mark.parametrize("policy", POLICIES)
@pytest.mark.parametrize("script", [(), (1,)])
def test_costs_are_one_for_each_option(policy, script):
    choices = Choices(policy_named(policy), script)
    with pytest.raises(ValueError, match="2 costs for 3 options"):
        choices.pick([1, 2, 3], of="edge", cost=[1, 2])
    assert choices.record == []


def test_costs_of_a_type_of_its_own_are_counted_when_they_are_looked_at():
    with pytest.raises(ValueError, match="2 costs for 3 options"):
        Choices(policy_named("nearest")).pick([1, 2, 3], of="edge", cost=range(2))


@pytest.mark.parametrize("given", [{1, 2}, frozenset({1}), {0: "a"}, iter("ab")])
def test_what_is_no_sequence_is_refused_by_the_name_of_its_type(given):
    kind = type(given).__name__
    with pytest.raises(ValueError, match=f"options of the type {kind} is no sequence"):
        Choices().pick(given, of="edge")
    with pytest.raises(ValueError, match=f"cost of the type {kind} is no sequence"):
        Choices().pick("ab", of="edge", cost=given)


class Lenless:
    def __getitem__(self, index):
        return index


class Lying(list):
    """One longer each time that it is asked for its length."""

    asked = 0

    def __len__(self):
        self.asked += 1
        return self.asked


@pytest.mark.parametrize("make", [Choices, lambda: next(schedules())])
def test_options_without_a_length_are_no_sequence_and_not_recorded(make):
    choices = make()
    with pytest.raises(ValueError, match="options of the type Lenless is no sequence"):
        choices.pick(Lenless(), of="edge")
    assert choices.record == []


def test_every_schedule_asks_options_for_their_length_once():
    options = Lying("abc")
    choices = next(schedules())
    assert choices.pick(options, of="edge") == "a"
    assert (options.asked, choices.widths) == (1, [1])


def test_who_takes_the_first_option_does_not_ask_how_many_there_are():
    options = Lying("abc")
    assert Choices().pick(options, of="edge") == "a"
    assert options.asked == 0


def test_options_that_claim_more_than_they_hold_are_refused_and_not_recorded():
    options = Lying()
    options.asked = 3
    choices = Choices(script=[2])
    with pytest.raises(ValueError, match="there is nothing to choose from"):
        choices.pick(options, of="edge")
    assert choices.record == []


@pytest.mark.parametrize("broken", [TypeError, IndexError, KeyError])
def test_a_choice_that_was_refused_leaves_the_schedules_as_they_are(broken):
    class Raising(list):
        def __getitem__(self, index):
            raise broken

    found = []
    for choices in schedules():
        with pytest.raises((ValueError, broken)):
            choices.pick(Raising("ab"), of="edge")
        found.append(choices.pick("ab", of="edge"))
    assert found == ["a", "b"]


def test_options_that_choose_when_they_are_looked_at_are_refused():
    choices = next(schedules())

    class Choosing(list):
        def __getitem__(self, index):
            return choices.pick("abc", of="path")

    with pytest.raises(ValueError, match="a choice of its own"):
        choices.pick(Choosing("ab"), of="edge")


@pytest.mark.parametrize("change", [lambda record: record.extend([7, 7]), list.clear])
def test_a_run_that_did_not_make_the_choices_that_were_due_is_the_last(change):
    runs = 0
    for choices in schedules():
        choices.pick("ab", of="edge")
        change(choices.record)
        runs += 1
    assert runs == 1
