"""Names that are nearly those of an explorer."""

import inspect

import pytest

from allworlds.explorers.sources import explorers_in, short_names, whole_name
from allworlds.inputs.checks import InputError
from allworlds.studies.check.exhaustive import check

TEXT = """
from allworlds.explorers.builtin.algorithm1 import algorithm1
def explore(first):
    return (yield from algorithm1(first))
def helper(x):
    def within():
        yield x
    return [lambda: (yield), within]
class Other:
    def method(self):
        yield
"""


@pytest.fixture
def file(tmp_path):
    place = tmp_path / "mine.py"
    place.write_text(TEXT)
    return place


def test_the_explorers_in_are_those_that_python_sees():
    text = TEXT + "def second():\n    if 0:\n        x = yield\n"
    module = {}
    exec(text, module)
    truth = [name for name, value in module.items() if inspect.isgeneratorfunction(value)]
    code = compile(text, "mine.py", "exec")
    assert explorers_in(code) == [name for name in truth if name != "algorithm1"]


def test_a_file_with_one_generator_function_is_its_name(file):
    assert whole_name(str(file)) == f"{file}:explore"
    report = check(str(file), edges=1)
    assert (report.explorer, report.exit_code) == (f"{file}:explore", 0)


@pytest.mark.parametrize(
    ("more", "words"),
    [
        ("def second():\n    yield\n", "has several explorers; legal are "),
        (None, "has no generator function"),
    ],
)
def test_a_file_with_several_or_none_is_refused(file, more, words):
    file.write_text(TEXT + more if more else "x = 1")
    with pytest.raises(InputError, match=words):
        check(str(file), edges=1)


@pytest.mark.parametrize("name", ["algorithm1", "there_is_none", "a.py:explore"])
def test_other_names_stay_as_they_are(name):
    assert whole_name(name) == name


def test_a_file_that_is_not_there_is_no_name():
    with pytest.raises(InputError, match=r"there is no file 'there_is_none\.py'"):
        whole_name("there_is_none.py")


@pytest.mark.parametrize(
    ("names", "short"),
    [
        (["algorithm1", "folding"], ["algorithm1", "folding"]),
        (["a.py:explore", "b.py:other"], ["explore", "other"]),
        (["a.py:explore", "b.py:explore"], ["a.py:explore", "b.py:explore"]),
        (["x/a.py:explore", "y/a.py:explore"], ["x/a.py:explore", "y/a.py:explore"]),
        (["/x/a.py:explore", "/x/b.py:explore", "c:go"], ["a.py:explore", "b.py:explore", "go"]),
        (["exec:python3 the/longest/path", "folding"], ["exec:python3 the/lon", "folding"]),
        (["exec:python3 the/long/a", "exec:python3 the/long/b"],) * 2,
        (["folding", "folding"], ["folding", "folding"]),
    ],
)
def test_the_shortest_ends_tell_names_apart(names, short):
    assert short_names(names) == short
