import json

import pytest

pytestmark = pytest.mark.usefixtures("compiled")


def test_worst_prints_one_document(cli):
    code, out, _ = cli("worst", "--edges", 3, "--transit", "shortest", "--json", "-q")
    assert code == 0
    document = json.loads(out)
    assert document["scope"]["transit"] == "shortest"
    # The most expensive schedule over all worlds with 3 edges, by an independent program: 11.
    assert max(row["worst"] for row in document["rows"]) == 11
    assert all(row["replayed"] == row["worst"] for row in document["rows"])


def test_the_text_of_worst_has_its_gate(cli):
    _, out, _ = cli("worst", "--edges", 1)
    assert "gate " in out
    assert "the number equals an independent count" in out


@pytest.mark.parametrize(
    ("option", "value"),
    [("--transit", "fast"), ("--class", "round"), ("--edges", "0"), ("--workers", "none")],
)
def test_worst_refuses_by_name(refused, option, value):
    assert value in refused("worst", option, value)


def test_check_tells_the_engine(cli):
    code, out, _ = cli("check", "--edges", 2, "--engine", "kernel")
    assert code == 0
    assert "algorithm1, kernel engine" in out
    assert "symmetry" not in out


def test_check_refuses_what_the_kernel_cannot_do(refused):
    options = ["--engine", "kernel", "--policy", "random:1"]
    assert "'random:1'" in refused("check", "--edges", 3, *options)
