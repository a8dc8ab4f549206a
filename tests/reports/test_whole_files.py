"""The whole files that reports are written to, in every form.

With ``RENEW`` set they are written anew; what then differs is to be meant.
"""

import pytest

from reports.pictures import alike
from reports.whole import whole
from reports.whole_files import FILES

pytestmark = pytest.mark.usefixtures("compiled", "without_workers")


def test_every_text_has_its_case():
    assert FILES.files() == sorted(FILES.cases)


@pytest.mark.parametrize("name", sorted(FILES.cases))
def test_a_file_is_what_it_was(name):
    text = whole(FILES.cases[name])
    assert alike(text, FILES.recorded(name, text))
