import json

import pytest

pytestmark = pytest.mark.usefixtures("compiled")


def test_worst_prints_a_table(cli):
    code, out, _ = cli("worst", "--edges", 2, "--class", "simple", "--workers", 1)
    assert code == 0
    assert out.startswith("WORST ")
    header = ["edges", "vertices", "worlds", "best", "worst", "bound", "worst/bound"]
    assert header in [line.split() for line in out.splitlines()]


@pytest.mark.slowest
def test_check_tells_the_engine_and_its_symmetry(cli):
    code, out, _ = cli("check", "--edges", 6, "--json", "-q")
    assert code == 0
    document = json.loads(out)
    assert document["engine"] == "kernel"
    assert "every bearing" in document["scope"]["symmetry"]
