"""A listener of a long job, for tests of what it is told."""

from allworlds.engines.listeners import Listener


class Hears(Listener):
    """A listener that notes each stage with its announced total, and adds up the work done.

    Attributes:
        stages: of each its name, its total, and of what.
        done: of each stage the work done.
        notices: in their order.
    """

    def __init__(self):
        self.stages, self.done, self.notices = [], [], []

    def level(self, edges, worlds):
        self.stage(edges, worlds, "worlds")

    def stage(self, name, total, of):
        self.stages.append((name, total, of))
        self.done.append(0)

    def progress(self, count):
        self.done[-1] += count

    def notice(self, text):
        self.notices.append(text)

    @property
    def heard(self):
        """Of each stage its name, its total, and the work done."""
        return [
            (name, total, done)
            for (name, total, _), done in zip(self.stages, self.done, strict=True)
        ]
