"""Whole pictures: every line, number and letter that is drawn.

With ``RENEW`` set they are written anew; what then differs is to be meant.
"""

import pytest

from reports.pictures import PICTURES, alike, whole


def test_every_file_has_its_case():
    assert PICTURES.files() == sorted(PICTURES.cases)


@pytest.mark.parametrize("name", sorted(PICTURES.cases))
def test_a_picture_is_what_it_was(name):
    made = whole(name)
    assert alike(made, PICTURES.recorded(name, made))


def test_only_the_last_digit_may_differ():
    assert alike("M1.0 -2.5 L3", "M1.1 -2.6 L3")
    assert not alike("M1.0 -2.5 L3", "M1.2 -2.5 L3")
    assert not alike("M1.0 -2.5 L3", "M1.0 2.5 L3")
    assert not alike("M1.0 -2.5 L3", "M1.0 -2.5 L4")
