"""What studies draw, try, find and tell of their progress, whole.

With ``RENEW`` set the texts are written anew; what then differs is to be meant.
"""

import pytest

from studies.whole_studies import STUDIES, whole

pytestmark = pytest.mark.usefixtures("compiled", "without_workers")


def test_every_text_has_its_case():
    assert STUDIES.files() == sorted(STUDIES.cases)


@pytest.mark.parametrize("name", sorted(STUDIES.cases))
def test_a_study_finds_what_it_found(name):
    text = whole(name)
    assert text == STUDIES.recorded(name, text)
