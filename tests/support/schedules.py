"""Every schedule of an explorer in one world, in lexicographic order."""

from collections.abc import Iterator

from allworlds.protocol.choices import Choices, ScheduledChoices, next_script


def schedules() -> Iterator[Choices]:
    """Yield the choices of one run after the other; the next ones follow from those made."""
    script: tuple[int, ...] | None = ()
    while script is not None:
        choices = ScheduledChoices(script)
        yield choices
        script = next_script(script, choices.record, choices.widths)
