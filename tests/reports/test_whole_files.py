"""The whole files that reports are written to, in every form.

With ``RENEW`` set they are written anew; what then differs is to be meant.
"""

import os

import pytest

from reports.pictures import alike
from reports.whole import whole
from reports.whole_files import CASES, FILES

pytestmark = pytest.mark.usefixtures("compiled", "without_workers")


def test_every_text_has_its_case():
    assert sorted(path.stem for path in FILES.iterdir()) == sorted(CASES)


@pytest.mark.parametrize("name", sorted(CASES))
def test_a_file_is_what_it_was(name):
    text = whole(name, CASES)
    recorded = FILES / f"{name}.txt"
    if "RENEW" in os.environ:
        recorded.parent.mkdir(exist_ok=True)
        recorded.write_text(text, encoding="utf-8")
    assert alike(text, recorded.read_text(encoding="utf-8"))
