"""What studies draw, try, find and tell of their progress, whole.

With ``RENEW`` set the texts are written anew; what then differs is to be meant.
"""

import os

import pytest

from studies.whole_studies import CASES, FILES, whole

pytestmark = pytest.mark.usefixtures("compiled", "without_workers")


def test_every_text_has_its_case():
    assert sorted(path.stem for path in FILES.iterdir()) == sorted(CASES)


@pytest.mark.parametrize("name", sorted(CASES))
def test_a_study_finds_what_it_found(name):
    text = whole(name)
    recorded = FILES / f"{name}.txt"
    if "RENEW" in os.environ:
        recorded.parent.mkdir(exist_ok=True)
        recorded.write_text(text, encoding="utf-8")
    assert text == recorded.read_text(encoding="utf-8")
