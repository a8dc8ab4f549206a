"""Whole pictures: every line, number and letter that is drawn.

With ``RENEW`` set they are written anew; what then differs is to be meant.
"""

import os

import pytest

from reports.pictures import CASES, FILES, alike, whole


def test_every_file_has_its_case():
    assert sorted(path.stem for path in FILES.iterdir()) == sorted(CASES)


@pytest.mark.parametrize("name", sorted(CASES))
def test_a_picture_is_what_it_was(name):
    made = whole(name)
    recorded = FILES / f"{name}.txt"
    if "RENEW" in os.environ:
        recorded.parent.mkdir(exist_ok=True)
        recorded.write_text(made, encoding="utf-8")
    assert alike(made, recorded.read_text(encoding="utf-8"))


def test_only_the_last_digit_may_differ():
    assert alike("M1.0 -2.5 L3", "M1.1 -2.6 L3")
    assert not alike("M1.0 -2.5 L3", "M1.2 -2.5 L3")
    assert not alike("M1.0 -2.5 L3", "M1.0 2.5 L3")
    assert not alike("M1.0 -2.5 L3", "M1.0 -2.5 L4")
