"""Messages of players: foreign bytes are read as integers and texts, or not at all."""

import pickle

import pytest
from msgspec import convert, msgpack, to_builtins

from allworlds.engines.isolation.messages import (
    ExplorerDescription,
    Failure,
    RecordLogs,
    Refusal,
    RunLogs,
    StretchResult,
    TraceEvent,
    read_message,
    write_message,
)
from allworlds.judging import Fault, Log, LostRun, UncheckedAmbiguous, UncheckedAnswer
from allworlds.judging.episode import ADAPTERS_LAWS
from allworlds.protocol import Percept

HUGE = 10**5000  # more digits than Python turns into text
ANSWER = UncheckedAnswer((0, 1), (1, 0), 1)
LOG = Log((0, -1), ((1, (0,), (0,), 0),), ANSWER, (2,), (3,))

MESSAGES = {
    "a description": ExplorerDescription(frozenset({"told", "choices"}), "0f"),
    "logs of runs": RunLogs([(3, LOG)], [3]),
    "logs of records": RecordLogs(
        [LOG, LOG._replace(ending=Fault("crash", "a", "b", "c", machine=True))]
    ),
    "a quotient": RecordLogs([Log((), (), UncheckedAmbiguous((0,), (0,), 0, (1,), (2,)))]),
    "a stretch": StretchResult(-1, 0),
    "a schedule": TraceEvent(None),
    "a choice": TraceEvent(4),
    "a step": TraceEvent((0, Percept(3, 1, None))),
    "a refusal": Refusal("no such file"),
    "a failure": Failure("Traceback"),
    "long integers": RecordLogs(
        [Log((HUGE,), (), UncheckedAnswer((2**63, -(2**63) - 1), (), 2**64))]
    ),
    "lone surrogates": RecordLogs([Log((1,), (), Fault("crash", "\udcff", "\u00e9", "\ud800"))]),
}


@pytest.mark.parametrize("name", MESSAGES)
def test_a_message_is_read_as_it_was_written(name):
    assert read_message(write_message(MESSAGES[name])) == MESSAGES[name]


def bytes_of(value):
    return msgpack.encode(value)


def logs_of(actions=(), ending=("answer", (), (), 0), choices=(), widths=()):
    return bytes_of(["RecordLogs", [[actions, (), ending, choices, widths]]])


FOREIGN = {
    "a boolean for an integer": logs_of([True]),
    "a number that is no integer": logs_of([1.0]),
    "a text for an integer": logs_of(["1"]),
    "nothing for an integer": logs_of([None]),
    "an integer for a boolean": logs_of(ending=("fault", "crash", "", "", "", 1)),
    "an integer for a text": logs_of(ending=("fault", "crash", "", 1, "", False)),
    "a law of the judge": logs_of(ending=("fault", "map", "", "", "", False)),
    "a law and a line": logs_of(ending=("fault", "crash\n", "", "", "", False)),
    "a lost run": logs_of(ending=("lost", "crash", "", "", "", False)),
    "an ending of no kind": logs_of(ending=("holds",)),
    "a field too many": bytes_of(["StretchResult", 1, 2, 3]),
    "a message of no kind": bytes_of(["Trust me", 1]),
    "a message that is none": bytes_of(5),
    "nothing": b"",
    "two messages": bytes_of(["TraceEvent", 1]) * 2,
    "an extension of no kind": bytes_of(["TraceEvent", msgpack.Ext(7, b"")]),
    "a text that is an integer": bytes_of(["Refusal", msgpack.Ext(1, b"\1")]),
    "an integer that is a text": bytes_of(["TraceEvent", msgpack.Ext(2, b"1")]),
    "an array without end": bytes_of(["RunLogs"])[:-1] + b"\xdd\xff\xff\xff\xff",
    "an array in an array": b"\x91" * 10**6,
    "a pickle": pickle.dumps(["TraceEvent", 1]),
}


@pytest.mark.parametrize("name", FOREIGN)
def test_bytes_that_are_no_message_are_refused(name):
    assert read_message(logs_of())
    with pytest.raises(ValueError, match="is none of its messages"):
        read_message(FOREIGN[name])


@pytest.mark.parametrize("law", [*ADAPTERS_LAWS, "budget"])
def test_every_law_that_a_player_can_find_broken_is_read(law):
    assert read_message(logs_of(ending=("fault", law, "", "", "", False)))


class Odd:
    """An object of an explorer."""


@pytest.mark.parametrize("choice", [Odd(), {1: Odd()}, 0.5, "1", None])
def test_an_object_of_an_explorer_makes_the_message_unreadable(choice):
    for actions in ((), (HUGE,)):
        message = RecordLogs([Log(actions, (), ANSWER, (choice,))])
        with pytest.raises(ValueError, match="is none of its messages"):
            read_message(write_message(message))


def test_the_referee_alone_says_that_a_run_is_lost():
    lost = LostRun("crash", "", "")
    assert lost != Fault("crash", "", "")
    assert convert(to_builtins(lost), LostRun) == lost
    with pytest.raises(ValueError, match="is none of its messages"):
        read_message(write_message(RecordLogs([Log((), (), lost)])))
