"""Code of the user's: found by its name, by an entry point, or in a record."""

import hashlib
import sys
from importlib.metadata import EntryPoint
from pathlib import Path

import pytest

from allworlds.inputs.checks import InputError
from allworlds.protocol import importing
from allworlds.protocol.importing import called
from allworlds.protocol.user_code import LocalCode, Role, as_recorded

TASK = Role("task", "allworlds.tasks", "a function")
MODULE = "def says(word):\n    return lambda *_: word\n\n\nlegal = 3\n"
NAME = "a_module_of_user_code"


@pytest.fixture
def module(tmp_path, monkeypatch):
    """The file of a module that can be imported."""
    file = tmp_path / f"{NAME}.py"
    file.write_text(MODULE)
    monkeypatch.syspath_prepend(str(tmp_path))
    yield file
    sys.modules.pop(NAME, None)


def digest(text):
    return hashlib.sha256(text.encode()).hexdigest()


def test_an_entry_point_is_found_with_its_text_and_loaded(module, monkeypatch):
    point = EntryPoint("my-word", f"{NAME}:says", "allworlds.tasks")
    monkeypatch.setattr(importing, "points_of", lambda group: {"my-word": point})
    code = TASK.find("my-word?word=here")
    assert (code.name, code.source, code.digest) == ("my-word?word=here", None, digest(MODULE))
    assert code.file == module.resolve()
    assert NAME not in sys.modules
    assert code.load() is sys.modules[NAME].says
    assert code.function(1, 2) == "here"


def test_a_module_with_another_text_than_it_was_found_with_is_not_loaded(module):
    code = TASK.find(f"{NAME}:says")
    module.write_text(f"{MODULE}\n")
    with pytest.raises(InputError, match=rf"^'{NAME}:says' has another text here$"):
        code.load()
    assert NAME not in sys.modules


def test_a_record_of_a_module_is_its_digest_and_of_a_file_its_text():
    with as_recorded({"some.module:says": "abc", "a/file.py:says": MODULE}):
        of_module, of_file = TASK.find("some.module:says"), TASK.find("a/file.py:says?word=here")
        assert of_module.recorded
        assert of_file.recorded
    assert (of_module.source, of_module.digest, of_module.record) == (None, "abc", "abc")
    assert (of_file.digest, of_file.record) == (digest(MODULE), MODULE)
    assert of_file.file == Path("a/file.py").absolute()
    assert not of_file.recorded


def test_a_function_of_this_process_is_called_and_named_where_it_raises():
    def inverse(number):
        return 1 / number

    code = LocalCode(TASK, inverse)
    assert code.name == "inverse"
    assert code(4) == 0.25
    with pytest.raises(InputError, match=r"^task 'inverse' raises ZeroDivisionError"):
        code(0)


def test_a_callable_without_a_name_is_shown():
    class Legal:
        def __call__(self):
            return 5

        def __repr__(self):
            return "<legal>"

    code = LocalCode(TASK, Legal())
    assert (code.name, code()) == ("<legal>", 5)


def test_what_takes_no_arguments_has_none_in_its_name():
    assert called("file.py:legal", 3, {}) == 3
    assert called("file.py:pair?b=2", lambda a=1, b=0: (a, b), {"b": 2}) == (1, 2)
    with pytest.raises(InputError, match=r"^'m:legal\?a=1': what takes arguments is a function th"):
        called("m:legal?a=1", 3, {"a": 1})
    with pytest.raises(InputError, match=r"unexpected keyword argument 'c'; legal is \(a=1\)$"):
        called("file.py:pair?c=2", lambda a=1: a, {"c": 2})
