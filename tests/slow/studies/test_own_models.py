"""A lighthouse, a task and a class of the user's own at once, in every way to run a check."""

import allworlds
from studies import test_own_models as quick
from studies.test_own_models import WRONG, counts

folder = quick.folder


def test_a_cluster_changes_nothing(folder):
    one = allworlds.check("mine.py:walks", workers=1, **WRONG)
    assert counts(allworlds.check("mine.py:walks", dask="local", workers=1, **WRONG)) == counts(one)
