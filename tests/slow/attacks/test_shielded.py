"""The other attacks with a shield."""

from itertools import filterfalse

import pytest

from attacks import test_shielded as quick

scene = quick.scene


@pytest.mark.long
@pytest.mark.early
@pytest.mark.parametrize(("attack", "function"), [*filterfalse(quick.is_quick, quick.tried())])
def test_an_attack_is_made_right_as_far_as_its_process_lives(attack, function, scene):
    quick.test_an_attack_is_made_right_as_far_as_its_process_lives(attack, function, scene)
