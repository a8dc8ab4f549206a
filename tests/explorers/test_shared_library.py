"""Explorers in shared libraries: where they take part, and what they do to their process."""

import _ctypes
import ctypes
import errno
import json
import re

import pytest

import allworlds.explorers.shared_library as abi
from allworlds.engines.players import NATIVE_MEMORY
from allworlds.explorers import shared_library as libraries
from allworlds.explorers.loading import load
from allworlds.explorers.shared_library import (
    INTERFACE_VERSION,
    ROOM,
    CAction,
    CPercept,
    Library,
    NativeExplorer,
    guarded,
    header_text,
    threads_left,
)
from allworlds.inputs.checks import InputError
from allworlds.protocol.actions import Ambiguous, ExplorerFault, Percept
from allworlds.protocol.choices import KINDS, Choices
from allworlds.studies.check.exhaustive import check
from allworlds.studies.run import replay, run
from native_libraries import EXAMPLES, attack, example
from schedules import schedules

FIRST, BEHIND = Percept(1, 1, 0), Percept(1, 0, None)


def native(library):
    return f"native:{library}"


def rows(report):
    return report.to_json()["rows"]


# ---------------------------------------------------------------- the header


def test_the_header_says_the_numbers_that_we_go_by():
    text = header_text()
    defined = dict(re.findall(r"(ALLWORLDS_\w+) = (\d)", text))
    for name in ("MOVE", "DROP", "PICK", "CHECKPOINT", "ANSWER", "AMBIGUOUS"):
        assert int(defined[f"ALLWORLDS_{name}"]) == getattr(abi, name)
    for number, kind in enumerate(KINDS):
        assert int(defined[f"ALLWORLDS_{kind.upper()}"]) == number
    assert f"#define ALLWORLDS_VERSION {INTERFACE_VERSION}\n" in text
    assert f"`capacity` is at least {ROOM}" in text
    assert f"has {NATIVE_MEMORY // 1024} GB" in text
    for structure, names in ((CPercept, "percept"), (CAction, "action")):
        body = re.search(rf"struct allworlds_{names} {{(.*?)}}", text, re.DOTALL)[1]
        assert re.findall(r"int32_t (\w+);", body) == [name for name, _ in structure._fields_]


def test_the_header_is_printed_as_it_is(cli):
    code, out, _ = cli("init", "--header")
    assert (code, out) == (0, header_text())
    code, out, _ = cli("init", "--header", "--json")
    assert json.loads(out)["header"] == header_text()


def test_a_skeleton_or_the_header_is_asked_for_and_not_both(refused, tmp_path):
    assert "--header" in refused("init")
    assert "not both: directory given" in refused("init", tmp_path / "new", "--header")
    assert "not both: lang given" in refused("init", "--lang", "c", "--header")
    assert not (tmp_path / "new").exists()


# ---------------------------------------------------------------- wherever explorers take part


@pytest.mark.parametrize("source", ["c/algorithm1.c"])
@pytest.mark.parametrize("policy", ["fifo", "lifo", "nearest"])
def test_algorithm_1_in_another_language_walks_as_ours(source, policy):
    report = check(native(example(source)), edges=2, policy=policy, engine="python")
    assert report.exit_code == 0
    assert rows(report) == rows(check(edges=2, policy=policy, engine="python"))


def test_what_takes_choices_is_tried_with_every_schedule():
    report = check(native(example("c/algorithm1.c")), edges=2, schedules="all")
    assert report.exit_code == 0
    one = check(edges=2, engine="python")
    assert report.to_json()["traversals"] > one.to_json()["traversals"]


def test_a_wrong_one_is_refuted_shown_and_found_again(tmp_path, cli):
    library = example("c/hasty.c")
    report = check(native(library), edges=2)
    (finding,) = report.findings
    assert (finding.law, finding.confirmed, finding.minimal) == ("map", True, True)
    assert f"--native {library}" in finding.reproduce
    file = tmp_path / "finding.json"
    file.write_text(json.dumps(finding.to_json()))
    assert replay(finding).exit_code == 0
    assert cli("replay", file, "--native", example("c/algorithm1.c"))[0] == 5
    code, out, _ = cli("run", "--native", library, "edge")
    assert code == 1
    assert "the answer" in out


def test_it_is_told_what_the_lighthouse_tells():
    lighthouse = {"kind": "natural", "dart": 0}
    world = {"sigma": [0, 2, 3, 1], "alpha": [1, 0, 3, 2], "start": 0, "lighthouse": lighthouse}
    told = run(native(attack("if (told != 3) abort()")), json.dumps(world))
    assert told.outcome.violation.law == "map"


def test_where_several_numbers_are_told_it_is_refused(refused):
    library = native(attack("if (told != 1) abort()"))
    said = "is a library, which is told one number at most, and the lighthouse .* tells n, m"
    for kind in ("told:n,m", "compass+told:n,m"):
        assert re.search(said, refused("check", library, "--lighthouse", kind, "--edges", "1"))
    told = check(library, edges=1, lighthouse="told:m")
    assert not any(found.law == "crash" for found in told.findings)


# ---------------------------------------------------------------- what it may do to its process


# ---------------------------------------------------------------- what is refused


@pytest.mark.parametrize(
    ("path", "said"),
    [("", "empty"), ("nowhere.so", "no such file"), (".", "it is a directory")],
)
def test_what_is_no_file_is_refused(refused, path, said):
    assert said in refused("check", "--native", path)


def test_what_is_no_library_is_refused(refused):
    assert "no library that loads" in refused("check", "--native", EXAMPLES / "README.md")


def test_a_library_without_the_functions_is_refused(refused):
    library = _ctypes.__file__
    said = refused("check", "--native", library)
    assert "has no function allworlds_version; needed are allworlds_version, " in said
    assert "allworlds_choose" not in said


def test_another_version_is_refused(refused):
    said = refused("check", "--native", attack("", VERSION="1"))
    assert "with version 1 of allworlds.h; legal is 2: build it again with" in said


def test_one_explorer_at_a_time(refused):
    said = refused("check", "algorithm1", "--native", "x.so")
    assert "EXPLORER 'algorithm1' or --native 'x.so', not both" in said


# ---------------------------------------------------------------- from inside


def episode(library, choices=None, told=None, answers=(BEHIND,)):
    """The messages of a library in one episode in this process, and its answer."""
    explorer = NativeExplorer(Library(library))
    said, replies = [], iter(answers)
    going = explorer.explore(FIRST, choices=choices, told=told)
    try:
        message = next(going)
        while True:
            said.append(message)
            message = going.send(next(replies, None))
    except StopIteration as end:
        said.append(end.value)
    finally:
        explorer.close()
    return said


def test_an_episode_in_this_process():
    move, estimate = episode(attack(""))
    assert move.k == 0
    assert (estimate.map.sigma, estimate.map.alpha, estimate.here) == ((0, 1), (1, 0), 1)


def test_markers_and_checkpoints_are_said_as_they_are_meant():
    drop, _ = episode(attack("kind = ALLWORLDS_DROP"))
    pick, _ = episode(attack("kind = ALLWORLDS_PICK"))
    shown, _ = episode(attack("kind = ALLWORLDS_CHECKPOINT"))
    assert [type(message).__name__ for message in (drop, pick, shown)] == [
        *("Drop", "Pick", "Checkpoint")
    ]
    assert (shown.sigma, shown.alpha, shown.here) == ((0, 1), (1, 0), 1)


@pytest.mark.parametrize(
    ("code", "law", "seen"),
    [
        ("kind = 9", "illegal-action", "kind 9"),
        ("kind = ALLWORLDS_CHECKPOINT; count = 1 << 20", "illegal-action", "1048576 darts"),
        ("count = 1000000", "no-estimate", "1000000 darts"),
        ("count = 3", "no-estimate", "no map"),
    ],
)
def test_what_breaks_a_law_is_said_so(code, law, seen):
    with pytest.raises(ExplorerFault, match=seen) as error:
        episode(attack(code))
    assert error.value.law == law


def test_a_library_without_a_state_is_a_crash():
    with pytest.raises(ExplorerFault, match="NULL"):
        episode(attack("", NEW="0"))


def test_choices_are_asked_with_their_costs():
    class Noted(Choices):
        def pick(self, options, of, cost=None):
            noted.append((len(options), of, cost))
            return super().pick(options, of, cost)

    noted = []
    episode(example("c/algorithm1.c"), choices=Noted())
    assert noted == [(1, "edge", [0])]


@pytest.mark.parametrize(("of", "options"), [(0, 0), (0, -1), (9, 1)])
def test_a_choice_that_is_none_is_a_crash(of, options):
    asks = attack(f"pick(0, {of}, {options}, 0)", CHOOSES="1")
    with pytest.raises(ExplorerFault, match="a choice that is none"):
        episode(asks)


def test_every_schedule_of_a_library_is_one_sequence_of_answers():
    asks = attack("pick(0, 1, 3, 0); pick(0, 2, 2, 0)", CHOOSES="1")
    tried = []
    for choices in schedules():
        episode(asks, choices=choices)
        tried.append(tuple(choices.record))
    assert tried == [(i, j) for i in range(3) for j in range(2)]


def test_threads_that_are_joined_are_not_left_behind(monkeypatch):
    counts = iter([4, 4, 3])  # one is joined, and is listed a little longer
    monkeypatch.setattr(libraries, "threads_now", lambda: next(counts, 3))
    assert threads_left(3) == 0
    monkeypatch.setattr(libraries, "THREADS_END", 0.01)
    assert threads_left(2) == 1


def test_guarded_memory_is_zero_and_as_long_as_it_was_asked_for():
    kept = guarded(ctypes.c_int32 * 3)
    assert list(kept) == [0, 0, 0]
    kept[2] = 5
    assert kept[2] == 5


def test_a_player_knows_its_library():
    subject = load(native(attack("")))
    assert subject.keywords == {"told"}
    with subject.running():
        assert subject.from_user


def test_a_path_that_cannot_be_read_is_refused():
    with pytest.raises(InputError, match="no path"):
        libraries.library_path("x\0y")
    with pytest.raises(InputError, match="cannot be read"):
        libraries.library_path("x" * 300)


def test_where_threads_cannot_be_counted_there_are_none(monkeypatch):
    assert abi.threads_now() > 0
    monkeypatch.setattr("os.listdir", lambda _: (_ for _ in ()).throw(OSError()))
    assert abi.threads_now() == 0


class Fake:
    """A library in Python, without choices, whose actions are of these kinds."""

    choose = None

    def __init__(self, *kinds, quotient=None):
        self.kinds, self.quotient, self.rooms = list(kinds), quotient, []

    def new(self):
        return 1

    def start(self, state, here, told, there):
        CAction.from_address(there).kind = self.kinds.pop(0)

    def step(self, state, here, there):
        self.start(state, here, None, there)

    def answer(self, state, capacity, sigma, alpha, here):
        self.rooms.append(capacity)
        for address, numbers in ((sigma, (0, 1)), (alpha, (1, 0)), (here, (1,))):
            (ctypes.c_int32 * len(numbers)).from_address(address)[:] = numbers
        return 2


def answer_of(library, *answers, first=FIRST):
    going = NativeExplorer(library).explore(first)
    *before, last = (None, *answers)
    for each in before:
        going.send(each)
    with pytest.raises(StopIteration) as end:
        going.send(last)
    return end.value.value


def one_dart(state, capacity, sigma, alpha, degree, marks, here):
    for number, address in enumerate((sigma, alpha, degree, marks, here)):
        ctypes.c_int32.from_address(address).value = number if number in (2, 3) else 0
    return 1


def test_a_quotient_is_what_the_library_says():
    answer = answer_of(Fake(abi.AMBIGUOUS, quotient=one_dart))
    assert answer == Ambiguous((0,), (0,), (2,), (3,), 0)
    with pytest.raises(
        ExplorerFault, match=f"{ROOM + 1} darts, where there is room for {ROOM}$"
    ) as e:
        answer_of(Fake(abi.AMBIGUOUS, quotient=lambda *_: ROOM + 1))
    assert e.value.law == "no-estimate"


def test_a_quotient_of_a_library_without_the_function_is_illegal():
    with pytest.raises(ExplorerFault) as error:
        answer_of(Fake(abi.AMBIGUOUS))
    assert error.value.law == "illegal-action"
    assert error.value.seen == "an action of kind 6, but no function allworlds_quotient"


@pytest.mark.parametrize(("left", "words"), [(1, "a thread"), (2, "2 threads")])
def test_threads_that_are_left_behind_are_a_crash(left, words, monkeypatch):
    monkeypatch.setattr(libraries, "threads_left", lambda before: left)
    with pytest.raises(ExplorerFault) as error:
        answer_of(Fake(abi.ANSWER))
    assert (error.value.law, error.value.seen) == ("crash", f"{words} left behind")


@pytest.mark.parametrize(("degree", "room"), [(3, 4), (4, 10)])
def test_there_is_room_for_all_darts_that_were_sensed(degree, room, monkeypatch):
    """The capacity is at least the least one, and the sum of all degrees."""
    monkeypatch.setattr(libraries, "ROOM", 4)
    library = Fake(abi.MOVE, abi.ANSWER)
    answer = answer_of(library, Percept(degree))
    assert (answer.map.sigma, answer.map.alpha, answer.here) == ((0, 1), (1, 0), 1)
    assert library.rooms == [room]
    assert answer_of(Fake(abi.MOVE, abi.AMBIGUOUS, quotient=one_dart), Percept(degree)).marks == (
        3,
    )


def test_what_is_handed_to_compiled_code_has_its_lengths():
    handed = NativeExplorer(Fake()).handed()
    assert [*map(len, handed)] == [3, 2, 1, ROOM, ROOM]
    assert {each._type_ for each in handed} == {ctypes.c_int32}


def test_the_addresses_of_a_library_are_those_of_its_functions():
    path = attack("")
    loaded = ctypes.CDLL(path)
    found = [
        ctypes.cast(getattr(loaded, f"allworlds_{name}"), ctypes.c_void_p).value
        for name in ("start", "step", "answer")
    ]
    assert Library(path).addresses() == [*found, 0]


def test_memory_that_cannot_be_guarded_is_an_error(monkeypatch):
    monkeypatch.setattr(libraries, "_NO_ACCESS", 1 << 16)
    with pytest.raises(OSError, match="a page cannot be protected") as error:
        guarded(ctypes.c_int32)
    assert error.value.errno == errno.EINVAL
