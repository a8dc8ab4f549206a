"""Models by their names: options, wrappers, those of the user; each error is one clear line."""

import pickle

import pytest

from allworlds.inputs.checks import InputError
from allworlds.robots.models.faults import Crash, Hidden
from allworlds.robots.models.lighthouse import LighthouseModel
from allworlds.robots.models.meeting import Meeting
from allworlds.robots.models.one_interval import OneInterval
from allworlds.robots.models.table import MODELS, NamedModel, codes_of, model_of, named_model

OWN = '''
from dataclasses import dataclass
from allworlds import Model

@dataclass(frozen=True)
class Own(Model):
    faults: int = 1
    loud: bool = False

@dataclass(frozen=True)
class Without(Model):
    number: int

@dataclass
class Melting(Model):
    faults: int = 1

class Plain(Model):
    """No dataclass."""

class Other:
    """No model."""

@dataclass(frozen=True)
class Picky(Model):
    faults: int = 1

    def __post_init__(self):
        if self.faults > 3:
            raise ValueError("too many faults")
'''


@pytest.fixture
def own(tmp_path, monkeypatch):
    (tmp_path / "own.py").write_text(OWN)
    monkeypatch.chdir(tmp_path)


@pytest.mark.parametrize(
    ("text", "model", "name"),
    [
        ("meeting", Meeting(), "meeting"),
        ("meeting:labels=true", Meeting(labels=True), "meeting:labels=true"),
        ("meeting:apart=true", Meeting(), "meeting"),
        (
            "meeting:multiplicity=weak,apart=false",
            Meeting(multiplicity="weak", apart=False),
            "meeting:apart=false,multiplicity=weak",
        ),
        ("crash:2+meeting", Crash(Meeting(), 2), "crash:2+meeting"),
        (
            "hidden:1+lighthouse:compass+whiteboard:states=4",
            Hidden(LighthouseModel("compass+whiteboard:states=4"), 1),
            "hidden:1+lighthouse:compass+whiteboard:states=4",
        ),
        ("lighthouse", LighthouseModel(), "lighthouse:directional"),
        (
            "crash:1+one-interval:exclusive=false",
            Crash(OneInterval(exclusive=False), 1),
            "crash:1+one-interval:exclusive=false",
        ),
    ],
)
def test_a_name_stands_for_a_model_and_is_written_in_one_way(text, model, name):
    assert model_of(text) == (model, name)
    assert model_of(name) == (model, name)
    assert codes_of(text) == ()


@pytest.mark.parametrize("name", MODELS)
def test_every_model_has_a_name(name):
    model, called = model_of(name)
    assert (type(model), called) == (MODELS[name], name)
    hash(model)


def test_a_model_of_the_users_has_options(own):
    model, name = model_of("own.py:Own:faults=3,loud=true")
    assert (model.faults, model.loud, name) == (3, True, "own.py:Own:faults=3,loud=true")
    assert model_of("own.py:Own?faults=3,loud=true") == (model, name)
    assert model_of("own.py:Own:faults=1")[1] == "own.py:Own"
    wrapped, called = model_of("crash:1+own.py:Own:faults=2")
    assert (wrapped.inside.faults, called) == (2, "crash:1+own.py:Own:faults=2")
    (code,) = codes_of("crash:1+own.py:Own:faults=2")
    assert code.name == "own.py:Own"


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("meting", "model 'meting' is not one of meeting, .*did you mean 'meeting'"),
        ("meeting:label=true", "'meeting' has no option 'label'; legal: .*did you mean 'labels'"),
        ("meeting:labels=yes", "labels of the model 'meeting' = 'yes' is neither true nor false"),
        ("meeting:multiplicity=some", "= 'some'; legal are none and weak and strong"),
        ("meeting:labels", "'labels' in 'meeting:labels' is not of the form key=value"),
        ("tokens:tokens=-1", "tokens of the model 'tokens' = -1 is less than 0"),
        ("tokens:tokens=many", "= 'many' is not an integer"),
        ("crash:1", "is not of the form crash:F\\+MODEL"),
        ("crash:0+meeting", "with F from 1 on"),
        ("hidden:x+meeting", "is not of the form hidden:F\\+MODEL"),
        ("crash:1+meting", "model 'meting'"),
        ("lighthouse:compas", "lighthouse 'compas'"),
        ("own.py:Nothing", "'own.py' has no 'Nothing'"),
        ("nothing.py:Own", "nothing.py"),
        ("own.py:Other", "'own.py:Other' is no model, but .*; one is a frozen dataclass"),
        ("own.py:Plain", "is no frozen dataclass; write @dataclass\\(frozen=True\\)"),
        ("own.py:Melting", "is no frozen dataclass"),
        ("own.py:Without", "'own.py:Without' raises TypeError"),
        ("own.py:Own:fault=1", "has no option 'fault'; legal: faults, loud"),
        ("own.py:Picky:faults=4", "'own.py:Picky' raises ValueError: too many faults"),
        (7, "model = 7"),
    ],
)
def test_a_wrong_name_is_refused_in_one_line(own, text, told):
    with pytest.raises(InputError, match=told) as refused:
        model_of(text)
    assert "\n" not in str(refused.value)


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("tokens:tokens=0", "tokens:tokens=0"),
        ("crash:1+meeting", "crash:1+meeting"),
        ("crash:999+meeting", "crash:999+meeting"),
        ("crash:1000+meeting", None),
        ("crash:01+meeting", None),
    ],
)
def test_the_bounds_of_options_are_legal(text, told):
    if told is None:
        with pytest.raises(InputError, match="with F from 1 on"):
            model_of(text)
    else:
        assert model_of(text)[1] == told


def test_a_model_is_sent_by_its_name_and_with_the_text_of_its_code(own, tmp_path):
    plain, mine = named_model("meeting:labels=true"), named_model("own.py:Own:faults=2")
    assert pickle.loads(pickle.dumps(plain)) == plain
    sent = pickle.dumps(mine)
    (tmp_path / "own.py").write_text(OWN.replace("loud", "quiet"))
    again = pickle.loads(sent)
    assert (again.name, again.digest) == (mine.name, mine.digest)
    assert again.model.loud is False


def test_a_model_of_this_process_is_sent_as_it_is():
    here = NamedModel("Meeting", Meeting(labels=True), here=True)
    assert pickle.loads(pickle.dumps(here)) == here
