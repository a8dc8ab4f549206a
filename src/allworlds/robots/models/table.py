"""**The** table of the models that are built in, and the model of a name."""

from msgspec import Struct

from allworlds.inputs.checks import not_one_of
from allworlds.protocol.user_code import UserCode
from allworlds.robots.model import Model
from allworlds.robots.models.meeting import Meeting

MODELS: dict[str, type[Model]] = {"meeting": Meeting}
"""Every built-in model by its name."""


class NamedModel(Struct, frozen=True):
    """A model with the name by which it is found again.

    Attributes:
        name: with its options.
        model: itself.
        code: of a model of the user's.
    """

    name: str
    model: Model
    code: UserCode | None = None

    def __str__(self) -> str:
        """The name."""
        return self.name

    @property
    def codes(self) -> tuple[UserCode, ...]:
        """The code of the user's that it needs."""
        return (self.code,) if self.code else ()


def model_of(text: str) -> NamedModel:
    """The model of a name."""
    name, _, options = text.partition(":")
    if name not in MODELS:
        raise not_one_of("model", text, MODELS)
    given = dict(pair.split("=") for pair in options.split(",") if pair)
    values = {key: {"true": True, "false": False}.get(value, value) for key, value in given.items()}
    return NamedModel(text, MODELS[name](**values))
