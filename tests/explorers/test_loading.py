import functools
import sys

import pytest

from allworlds.explorers.builtin.algorithm1 import algorithm1
from allworlds.explorers.loading import in_process_subject, load, own_bound
from allworlds.explorers.program import Program
from allworlds.inputs.checks import InputError
from allworlds.protocol.actions import Percept
from allworlds.protocol.choices import Choices


def explore(first):
    yield


class Callable:
    def __call__(self, first, **more):
        yield more


def test_a_built_in_explorer_is_ours():
    assert load("algorithm1") == in_process_subject(algorithm1)
    assert not load("algorithm1").from_user


def test_a_function_of_a_module_is_found_by_its_name(tmp_path, monkeypatch):
    (tmp_path / "my_explorer.py").write_text("class A:\n    def b(first, *, told):\n        yield")
    monkeypatch.syspath_prepend(str(tmp_path))
    subject = load("my_explorer:A.b")
    assert (subject.keywords, subject.from_user, subject.takes_choices) == ({"told"}, True, False)
    assert load(f"{tmp_path}/my_explorer.py:A.b").keywords == {"told"}
    with pytest.raises(InputError, match="'my_explorer' has no 'c'"):
        load("my_explorer:c")


def test_a_file_of_a_package_is_named_as_a_module(tmp_path, monkeypatch):
    inner = tmp_path / "robots" / "walks"
    inner.mkdir(parents=True)
    for folder in (inner, inner.parent):
        (folder / "__init__.py").touch()
    (inner / "near.py").write_text("from ..far import go\n\ndef explore(first):\n    yield go\n")
    (inner.parent / "far.py").write_text("go = 1\n")
    remedy = f"name robots.walks.near:FUNCTION, with PYTHONPATH={tmp_path}"
    with pytest.raises(InputError, match=f"relative import.*; it is part of a package: {remedy}"):
        load(f"{inner / 'near.py'}:explore")
    monkeypatch.syspath_prepend(str(tmp_path))
    assert load("robots.walks.near:explore").from_user


def test_a_file_does_not_take_the_place_of_a_module(tmp_path):
    (tmp_path / "json.py").write_text("def explore(first):\n    yield")
    before = sys.modules["json"]
    assert load(f"{tmp_path}/json.py:explore").explore.__module__ != "json"
    assert sys.modules["json"] is before


def test_keywords_are_offered_to_those_who_take_them():
    subject = in_process_subject(Callable())
    assert subject.takes_choices
    assert not subject.importable
    play = subject.player()
    choices = Choices()
    assert next(play(Percept(1), choices, 7)) == {"choices": choices, "told": 7}


@pytest.mark.parametrize(
    ("value", "why"),
    [
        (3, ": an explorer is def explore"),
        (None, ": an explorer is def explore"),
        (print, ", and a call of it returns None, which has no send: an explorer is def explore"),
        (int, ", and a call of it raises TypeError: int"),
        (lambda first: 1, ", and a call of it returns 1, which has no send"),
    ],
)
def test_what_gives_no_walk_is_no_explorer(value, why):
    with pytest.raises(InputError, match=f"is no generator function{why}"):
        in_process_subject(value)


def test_what_a_call_returns_decides():
    def explore(first, *, told):
        yield told

    @functools.wraps(explore)
    def inner(*given, **words):
        return explore(*given, **words)

    subject = in_process_subject(inner)
    assert subject.keywords == {"told"}
    assert next(subject.player()(Percept(1), Choices(), 7)) == 7


def test_a_decorator_that_hides_its_function_passes_on_what_that_takes():
    def taking_told(first, *, told):
        yield told

    def taking_none(first):
        yield first

    def hidden(function):
        def inner(*given, **words):
            return function(*given, **words)

        return inner

    assert in_process_subject(hidden(taking_told)).keywords == {"told"}
    assert in_process_subject(hidden(taking_none)).keywords == frozenset()


def test_the_walk_of_the_trial_call_is_closed():
    calls = []

    class Walk:
        def __init__(self, first):
            calls.append(first)

        def send(self, reply):
            raise AssertionError

        def close(self):
            calls.append("closed")

    assert in_process_subject(Walk).keywords == frozenset()
    assert calls == [Percept(1, 1, 0), "closed"]


def test_a_lambda_is_not_found_by_its_name():
    assert not in_process_subject(lambda first: (yield)).importable


def test_an_entry_point_that_does_not_load_is_bad_input(monkeypatch):
    from importlib.metadata import EntryPoint, EntryPoints

    points = EntryPoints(
        [
            EntryPoint("mine", "no_such_module:x", "allworlds.explorers"),
            EntryPoint(
                "ours", "allworlds.explorers.builtin.algorithm1:algorithm1", "allworlds.explorers"
            ),
        ]
    )
    monkeypatch.setattr("importlib.metadata.entry_points", lambda group: points)
    with pytest.raises(InputError, match="'mine' does not import"):
        load("mine")
    assert load("ours").from_user
    with pytest.raises(InputError, match="mine, ours"):
        load("nobody")


@pytest.mark.parametrize("command", ["", "  ", "'", "no-such-program-anywhere -x"])
def test_a_command_that_is_none_is_bad_input(command):
    with pytest.raises(ValueError, match="--exec"):
        Program(command, 1.0)


def test_built_in_explorers_take_what_they_need_and_bring_what_they_keep():
    assert load("algorithm1").keywords == {"choices", "notice"}
    assert load("algorithm1-natural").keywords == {"choices", "notice", "told"}
    assert load("algorithm1-natural").lighthouse == "natural"
    assert in_process_subject(explore).lighthouse == load("algorithm1").lighthouse == "directional"
    assert own_bound("algorithm1-cluster", "cluster") == "two-vertices"
    assert own_bound("algorithm1-cluster", "cluster:single=true") == "two-vertices"
    assert own_bound("algorithm1-cluster", "natural") is None
    assert own_bound("algorithm1", "directional") is own_bound("a:b", "directional") is None


UNPRINTABLE = {
    "raises": "class Odd(Exception):\n    def __str__(self): raise RuntimeError\nraise Odd",
    "raises itself": "class Odd(BaseException):\n    def __str__(self): raise Odd\nraise Odd",
    "is no text": "class Odd(Exception):\n    def __str__(self): return 3\nraise Odd",
    "is huge": "raise ValueError('x' * 10**6)",
    "is an order to a terminal": "raise ValueError('\\x1b[31m\\u2028\\r\\n' * 999)",
    "has a huge name": "raise type('Odd' * 9999, (BaseException,), {})",
    "is no error": "raise SystemExit(0)",
    "is no text in any language": "raise ValueError('\\ud800')",
}


@pytest.mark.parametrize("text", UNPRINTABLE.values(), ids=UNPRINTABLE)
def test_an_import_error_is_told_in_one_line_whatever_it_says(refused, tmp_path, text):
    file = tmp_path / "odd.py"
    file.write_text(text + "\n\ndef explore(first):\n    yield\n")
    line = refused("check", f"{file}:explore", "--edges", "1")
    assert "does not import" in line
    assert len(line) <= 301
