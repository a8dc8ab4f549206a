"""The whole texts of reports in their rarer cases.

With ``RENEW`` set they are written anew; what then differs is to be meant.
"""

import os

import pytest

from reports.whole import CASES, TEXTS, whole

pytestmark = pytest.mark.usefixtures("compiled")


def test_every_text_has_its_case():
    assert sorted(path.stem for path in TEXTS.iterdir()) == sorted(CASES)


@pytest.mark.parametrize("name", sorted(CASES))
def test_a_report_is_what_it_was(name):
    text = whole(name)
    recorded = TEXTS / f"{name}.txt"
    if "RENEW" in os.environ:
        recorded.parent.mkdir(exist_ok=True)
        recorded.write_text(text, encoding="utf-8")
    assert text == recorded.read_text(encoding="utf-8")
