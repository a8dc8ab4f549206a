import pytest

pytestmark = pytest.mark.usefixtures("compiled")


def test_worst_prints_a_table(cli):
    code, out, _ = cli("worst", "--edges", 2, "--class", "simple", "--workers", 1)
    assert code == 0
    assert out.startswith("WORST ")
    header = ["edges", "vertices", "worlds", "best", "worst", "bound", "worst/bound"]
    assert header in [line.split() for line in out.splitlines()]
