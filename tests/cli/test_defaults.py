"""The default of each option, written down a second time."""

import inspect

import pytest

import allworlds
from allworlds import ambiguity
from allworlds.engines.effort import Limits
from allworlds.judging.findings.rules import Rules

PATIENCE = {"answer_timeout": 10.0, "start_timeout": 60.0}
CLUSTER = {"dask_timeout": 60.0}
RULES = {"task": "map", "policy": "fifo", **PATIENCE}
MANY = {**RULES, **CLUSTER, "map_class": "maps", "workers": 1}

# All that are not None, where None says that something else decides.
DEFAULTS = {
    allworlds.check: {
        **MANY,
        "explore": "algorithm1",
        "schedules": "one",
        "engine": "auto",
        "max_findings": 1,
    },
    allworlds.fuzz: {**MANY, "explore": "algorithm1", "min_edges": 1, "seed": 0},
    allworlds.run: {**RULES, "choices": ()},
    allworlds.compare: MANY,
    allworlds.replay: PATIENCE,
    allworlds.ledger: {"workers": 1, "only": (), "require": (), "budget": "quick"},
    allworlds.count: {"map_class": "maps", **CLUSTER},
    allworlds.worst: {
        "explore": "algorithm1",
        "map_class": "maps",
        "edges": 5,
        "transit": "simple",
        "workers": 1,
        **CLUSTER,
    },
    allworlds.worlds: {"map_class": "maps", "lighthouse": "directional", "places": "first"},
    allworlds.twins: {"lighthouse": "position"},
    allworlds.search: {"map_class": "maps", "motions": (), "percepts": ()},
    ambiguity.census: {"map_class": "maps", "lighthouse": "position", **CLUSTER},
    ambiguity.class_of: {"limit": 1000, "map_class": "maps", "lighthouse": "position"},
    Limits: {"workers": 1, **PATIENCE},
    Rules: {"lighthouse": "directional", "task": "map", "policy": "fifo"}
    | {"promised": False, "shared_file": ""},
}


@pytest.mark.parametrize("function", DEFAULTS, ids=lambda function: function.__name__)
def test_an_option_left_out_means_what_it_always_meant(function):
    parameters = inspect.signature(function).parameters.values()
    found = {p.name: p.default for p in parameters if p.default not in (p.empty, None)}
    assert found == DEFAULTS[function]
