"""A run directory knows every argument on which a report depends."""

import inspect

import pytest

from allworlds import check
from allworlds.inputs.checks import InputError
from kept_jobs import EXPLORERS

PLAN = str(EXPLORERS.parent / "plan.json")
FIRST = {"explore": "algorithm1", "edges": 2, "engine": "python"}
# Of every such argument a value with which the report may be another one.
OTHERS = {
    "explore": f"{EXPLORERS / 'wrong.py'}:right",
    "edges": 3,
    "vertices": 2,
    "map_class": "planar",
    "where": "trees",
    "worlds": PLAN,
    "graph": "bouquet-2",
    "lighthouse": "none",
    "task": "cover",
    "schedules": "all",
    "policy": "lifo",
    "bound": "4*m",
    "laws": ["map"],
    "step_budget": 50,
    "shard": (0, 2),
    "max_findings": 2,
    "engine": "kernel",
    "answer_timeout": 20.0,
    "memory": 3000,
}
APART = {"workers", "start_timeout", "time_limit", "dask", "run", "corpus"}
APART |= {"listener"}
"""Where and how long it is done, and what is made of it."""
BESIDE = {
    "order": ({"worlds": PLAN}, "anticlockwise"),
    "embeddings": ({"graph": "bouquet-2"}, "genus:0"),
    "y": ({"worlds": PLAN}, None),  # that file has no positions
}
"""Such arguments that others need."""


def test_each_argument_makes_another_report_or_does_not():
    assert {*inspect.signature(check).parameters} == OTHERS.keys() | APART | BESIDE.keys()


@pytest.mark.usefixtures("compiled")
@pytest.mark.parametrize("name", OTHERS)
def test_who_asks_for_something_else_is_refused(name, tmp_path):
    check(**FIRST, run=tmp_path / "run")
    with pytest.raises(InputError, match="run directory"):
        check(**{**FIRST, name: OTHERS[name]}, run=tmp_path / "run")
    assert check(**FIRST, run=tmp_path / "run").exit_code == 0


@pytest.mark.parametrize("name", ["order", "embeddings"])
def test_so_is_who_asks_for_other_given_worlds(name, tmp_path):
    beside, value = BESIDE[name]
    options = {**FIRST, **beside, "run": tmp_path / "run"}
    check(**options)
    with pytest.raises(InputError, match="run directory"):
        check(**options, **{name: value})
    assert check(**options).exit_code == 0
