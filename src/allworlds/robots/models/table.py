"""**The** table of the models, and models by their names."""

from __future__ import annotations

import re
from dataclasses import fields
from typing import Any, Literal, get_args, get_origin, get_type_hints

from msgspec import Meta, Struct

from allworlds.inputs.checks import InputError, a_text, did_you_mean, integer_of, show
from allworlds.protocol import importing, user_code
from allworlds.robots.model import Model
from allworlds.robots.models.black_hole import BlackHole
from allworlds.robots.models.face_to_face import FaceToFace
from allworlds.robots.models.faults import Crash, Hidden, Wrapper
from allworlds.robots.models.lighthouse import LighthouseModel
from allworlds.robots.models.meeting import Meeting
from allworlds.robots.models.one_interval import OneInterval
from allworlds.robots.models.shared_whiteboard import SharedWhiteboard
from allworlds.robots.models.snapshot import Snapshot
from allworlds.robots.models.tokens import Tokens
from allworlds.world.lighthouses.composed import PLUS
from allworlds.world.lighthouses.kinds import lighthouse_kind
from allworlds.world.lighthouses.options import FieldOption, with_arguments

MODELS: dict[str, type[Model]] = {
    "meeting": Meeting,
    "snapshot": Snapshot,
    "one-interval": OneInterval,
    "shared-whiteboard": SharedWhiteboard,
    "face-to-face": FaceToFace,
    "tokens": Tokens,
    "black-hole": BlackHole,
}
"""The built-in models by their names."""

WRAPPERS: dict[str, type[Wrapper]] = {"crash": Crash, "hidden": Hidden}
"""The models that wrap another model, by their names, as in ``crash:1+black-hole``."""

LIGHTHOUSE = "lighthouse"
"""The name of the model with one robot and a lighthouse, as in ``lighthouse:KIND``."""

KNOWN = (*MODELS, f"{LIGHTHOUSE}:KIND", *(f"{name}:F+MODEL" for name in WRAPPERS))

MODEL = user_code.Role("model", "allworlds.models", known=KNOWN)

SHAPE = "a frozen dataclass with the base allworlds.Model"


class NamedModel(Struct, frozen=True):
    """A model with the name by which this and other processes can load the model.

    Attributes:
        name: the name of the model, with its options.
        model: the model.
        codes: the user's code that the model needs.
        here: whether the model exists in this process alone, and cannot be loaded by its name.
    """

    name: str
    model: Model
    codes: tuple[user_code.UserCode, ...] = ()
    here: bool = False

    def __str__(self) -> str:
        """The name of the model, with its options."""
        return self.name

    @property
    def digest(self) -> str:
        """The digest of the user's code; empty if the model needs no code of the user."""
        return "".join(code.digest for code in self.codes)

    def __reduce__(self) -> tuple[Any, ...]:
        """The values that pickle needs to make the model again: its name, and texts of user's code.

        If the model exists in this process alone, the model itself takes the place of the texts.
        """
        if self.here:
            return NamedModel, (self.name, self.model, (), True)
        return _named_again, (self.name, {code.plain: code.record for code in self.codes})


def named_model(text: object) -> NamedModel:
    """Load the model with this name, which may be any name that :func:`model_of` takes."""
    model, name = model_of(text)
    return NamedModel(name, model, codes_of(name))


def _named_again(name: str, texts: dict[str, str]) -> NamedModel:
    with user_code.as_recorded(texts):
        return named_model(name)


def model_of(text: object) -> tuple[Model, str]:
    """The model with this name, and its canonical name.

    A name is ``NAME[:key=value,...]``, ``path/to/file.py:Class[:key=value,...]`` or
    ``lighthouse:KIND``.  Before a name ``crash:F+`` or ``hidden:F+`` may stand; F is the largest
    number of faults.

    Raises:
        InputError: for an unknown model or option, or an illegal value; the error names it.
    """
    name = a_text("model", text)
    plain, _, rest = name.partition(":")
    if plain in WRAPPERS:
        return _wrapped(plain, rest, name)
    if plain == LIGHTHOUSE:
        kind = lighthouse_kind(rest or "directional").name
        return LighthouseModel(kind), f"{LIGHTHOUSE}:{kind}"
    if plain in MODELS:
        return _made(MODELS[plain], plain, rest, name)
    code, options = _own(name)
    return _made(_class_of(code), code.name, options, name)


def codes_of(text: str) -> tuple[user_code.UserCode, ...]:
    """The user's code that the model with this name needs."""
    while text.partition(":")[0] in WRAPPERS:
        text = text.partition(PLUS)[2]
    plain, _, rest = text.partition(":")
    if plain == LIGHTHOUSE:
        return lighthouse_kind(rest or "directional").codes
    return () if plain in MODELS else (_own(text)[0],)


def _wrapped(plain: str, rest: str, name: str) -> tuple[Model, str]:
    number, plus, inside = rest.partition(PLUS)
    if not plus or not re.fullmatch("[1-9][0-9]{0,2}", number):
        raise InputError(f"model {show(name)} is not of the form {plain}:F+MODEL, with F from 1 on")
    model, called = model_of(inside)
    return WRAPPERS[plain](model, integer_of(number)), f"{plain}:{number}{PLUS}{called}"


def _own(name: str) -> tuple[user_code.UserCode, str]:
    """The user's code in a model's name ``FILE.py:Class:key=value,...``, and the options' text."""
    parts = re.fullmatch(r"(.+)[:?]([^:?=]+=.*)", name)
    plain, options = (parts[1], parts[2]) if parts else (name, "")
    return MODEL.find(plain), options


def _class_of(code: user_code.UserCode) -> type[Model]:
    made = code.load()
    if not isinstance(made, type) or not issubclass(made, Model):
        raise InputError(f"{show(code.name)} is no model, but {show(made)}; one is {SHAPE}")
    shape = vars(made).get("__dataclass_params__")
    if shape is None or not shape.frozen:
        raise InputError(f"{show(code.name)} is no frozen dataclass; write @dataclass(frozen=True)")
    return made


def _made(kind: Any, plain: str, text: str, name: str) -> tuple[Model, str]:
    """A model of the class ``kind``, and its canonical name.

    The canonical name is ``plain``, with those options whose values are not the defaults.

    Args:
        kind: the class of the model.
        plain: the name of the class, without options.
        text: the options, as ``key=value,...``; may be empty.
        name: the name with options as the user has given it, for the words of errors.
    """
    legal = options_of(kind)
    given = {}
    for key, value in importing.pairs_in(name, text) if text else []:
        if key not in legal:
            known = f"legal: {', '.join(legal)}" if legal else "it has none"
            hint = did_you_mean(key, legal)
            raise InputError(f"the model {show(plain)} has no option {show(key)}; {known}{hint}")
        given[key] = legal[key].of_text(f"option {key} of the model {show(plain)}", value)
    unusual = {key: given[key] for key in legal if given.get(key) not in (None, legal[key].default)}
    model = importing.attempted(f"the model {show(plain)} raises", lambda: kind(**given))
    return model, with_arguments(plain, unusual, ":")


def options_of(kind: Any) -> dict[str, FieldOption]:
    """The options of a class of models by their names, in the order of the fields of the class."""
    hints = get_type_hints(kind, include_extras=True) if kind in MODELS.values() else {}
    found = {}
    for each in fields(kind):
        default: Any = each.default
        if type(default) not in (int, str, bool):
            continue
        hint = hints.get(each.name)
        limits = [note for note in getattr(hint, "__metadata__", ()) if isinstance(note, Meta)]
        words = get_args(hint) if get_origin(hint) is Literal else ()
        found[each.name] = FieldOption(default, next(iter(limits), None), words)
    return found
