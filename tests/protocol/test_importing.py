"""What is said of an exception that a user's module raises."""

import pytest

from allworlds.protocol.importing import said


class Odd(Exception):
    def __str__(self):
        raise ZeroDivisionError


@pytest.mark.parametrize(
    ("error", "words"),
    [
        (ValueError("a\nb"), "ValueError: a"),
        (ValueError(), "ValueError"),
        (Odd(), "Odd, which cannot be shown"),
    ],
)
def test_it_is_one_line_whatever_it_says(error, words):
    assert said(error) == words
