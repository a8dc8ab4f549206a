"""Calls of models: what they may not do to the process in which they are called."""

import os

import pytest

from allworlds.inputs.checks import InputError
from allworlds.protocol.importing import tried


def test_a_model_cannot_end_the_process_and_a_process_that_it_has_forked_can_end():
    def forks():
        child = os.fork()
        if not child:
            os._exit(3)
        return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])

    leave = os._exit
    assert tried("the model", forks) == 3
    with pytest.raises(InputError, match=r"^the model raises SystemExit: os._exit\(0\) would end"):
        tried("the model", lambda: os._exit(0))
    assert os._exit is leave


def test_what_a_model_has_kept_of_its_calls_is_harmless_outside_of_them():
    kept = tried("the model", lambda: os._exit)
    child = os.fork()
    if not child:
        kept(4)
    assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 4
