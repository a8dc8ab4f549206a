"""Listeners to the progress of a job."""


class Listener:
    """A listener to the progress of a job; by default each event is ignored."""

    def level(self, edges: int, worlds: int) -> None:
        """Hear that a level begins, with ``worlds`` worlds of ``edges`` edges each.

        In a study of random or chosen worlds ``edges`` is the largest number of edges.  If the job
        does only a shard, ``worlds`` is an estimate: the number of worlds of the level in this
        shard.
        """

    def stage(self, name: str, total: int, of: str) -> None:
        """Hear that a stage of the job begins, if the stage is not a level of worlds.

        The stage is called ``name``, and has ``total`` items; ``of`` says what the items are, such
        as ``claims``.
        """

    def progress(self, count: int) -> None:
        """Hear that ``count`` further worlds, or items of the stage, are done.

        A negative number is for a unit that is begun anew: its worlds are no longer done.
        """

    def walk(self, turns: int, budget: int) -> None:
        """Hear that a run goes on, in which the explorer has had ``turns`` turns so far.

        ``budget`` is the largest legal number of traversals in the run.
        """

    def notice(self, text: str) -> None:
        """Hear a message to the user."""


NOBODY = Listener()
"""The default listener, and the listener of every report, so that equal reports compare equal."""
