"""The whole texts of reports in their rarer cases.

With ``RENEW`` set they are written anew; what then differs is to be meant.
"""

import pytest

from reports.whole import TEXTS, whole

pytestmark = pytest.mark.usefixtures("compiled")


def test_every_text_has_its_case():
    assert TEXTS.files() == sorted(TEXTS.cases)


@pytest.mark.parametrize("name", sorted(TEXTS.cases))
def test_a_report_is_what_it_was(name):
    text = whole(TEXTS.cases[name])
    assert text == TEXTS.recorded(name, text)
