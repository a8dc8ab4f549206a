"""Listeners to the progress of a job."""


class Listener:
    """A listener to the progress of a job; by default each event is ignored."""

    def level(self, edges: int, worlds: int) -> None:
        """Hear that a level with so many worlds begins, or a shard of it with about so many."""

    def stage(self, name: str, total: int, of: str) -> None:
        """Hear that a stage that is no level begins, with the number and the name of its items."""

    def progress(self, count: int) -> None:
        """Hear how many more worlds, or other units of the stage, are done."""

    def walk(self, turns: int, budget: int) -> None:
        """Hear that a run goes on: the explorer's turns in it so far, and its step budget."""

    def notice(self, text: str) -> None:
        """Hear a message to the user."""


NOBODY = Listener()
"""The default listener, and the listener of every report, so that equal reports compare equal."""
