"""A lighthouse of the user's own, wherever worlds are made."""

import allworlds
from studies import test_own_lighthouse as quick
from studies.test_own_lighthouse import counts

folder = quick.folder


def test_the_workers_of_a_cluster_get_its_text(folder):
    one = allworlds.check("mine.py:explore", edges=2, lighthouse="parity.py:Parity", workers=1)
    asked = {"edges": 2, "lighthouse": "parity.py:Parity", "workers": 1}
    assert counts(allworlds.check("mine.py:explore", dask="local", **asked)) == counts(one)
