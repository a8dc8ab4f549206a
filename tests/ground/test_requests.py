"""A request is a value: frozen, checked where it is made, and the one home of a verb's options."""

import inspect
from dataclasses import FrozenInstanceError
from functools import cached_property
from pkgutil import resolve_name

import pytest

import allworlds
from allworlds.documents.document import replace
from allworlds.engines.listeners import Listener
from allworlds.engines.units import Shard
from allworlds.inputs.checks import InputError
from allworlds.inputs.requests import Option, Request, answer, fields_of, meant, remembered
from allworlds.maps import MapClass
from allworlds.studies.check.report import CheckRequest
from allworlds.verbs import VERBS

GIVEN = {"map_class": "simple", "shard": (0, 2), "laws": ["map", "pose"], "bound": 7}


def test_what_users_give_becomes_values_and_stays_so():
    request = CheckRequest("folding", **GIVEN)
    assert request.map_class is MapClass.SIMPLE
    assert request.shard == Shard(0, 2)
    assert (request.laws, str(request.bound)) == (("map", "pose"), "7")
    assert isinstance(request.listener, Listener)
    changed = replace(request, edges=3)
    assert (changed.edges, changed.shard) == (3, Shard(0, 2))
    with pytest.raises(FrozenInstanceError):
        request.edges = 4


@pytest.mark.parametrize(
    ("name", "value"),
    [("map_class", "planr"), ("shard", (2, 2)), ("laws", ["mpa"]), ("max_findings", 0)],
)
def test_a_request_of_bad_input_is_none(name, value):
    with pytest.raises(InputError):
        CheckRequest(**{name: value})


def test_what_is_meant_makes_the_same_request_again():
    request = CheckRequest(**{**GIVEN, "shard": None}, workers=3, time_limit=9.0)
    told = meant(request)
    assert (told["class"], told["laws"]) == ("simple", ["map", "pose"])
    assert not {"workers", "time_limit", "shard", "run", "explore", "listener"} & told.keys()
    again = CheckRequest(**remembered(CheckRequest, told))
    assert meant(again) == told


@pytest.mark.parametrize("kind", [property, cached_property])
def test_a_field_that_has_the_name_of_a_property_of_another_part_is_refused(kind):
    class Sized(Request):
        size = kind(lambda _: 3)

    class Bounded(Request):
        size: int = 4

    said = "field size of Both has the name of a property of Sized"
    with pytest.raises(TypeError, match=said):
        type("Both", (Bounded, Sized), {})
    with pytest.raises(TypeError, match=said):
        type("Both", (Sized, Bounded), {})


def test_a_function_takes_its_request_ready_or_in_keywords():
    told = allworlds.count(edges=2)
    request = inspect.get_annotations(inspect.unwrap(allworlds.count), eval_str=True)["request"]
    assert answer(allworlds.count, request(edges=2)) == told
    with pytest.raises(TypeError, match=r"^count\(\) got an unexpected keyword argument 'edgs'$"):
        allworlds.count(edgs=2)


def test_each_option_of_a_request_has_its_line_in_the_docstring():
    functions = [resolve_name(verb.path) for verb in VERBS]
    asked = [function for function in functions if hasattr(function, "request")]
    assert len(asked) >= 11
    for function in asked:
        for field in fields_of(function.request):
            assert f"\n    {field.name}: " in function.__doc__
            assert not isinstance(field.asked, Option) or field.asked.help
