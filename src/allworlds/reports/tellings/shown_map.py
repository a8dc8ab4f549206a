"""The growing map of an explorer: the S that it shows in its checkpoints."""

from __future__ import annotations

from allworlds.engines import SingleRun
from allworlds.judging import true_trail
from allworlds.reports.telling import ShownMap
from allworlds.studies.run import embedded


def known(run: SingleRun) -> ShownMap | None:
    """The map from a run's checkpoints; None if there is none, or if S is not embedded."""
    episode, world = run.outcome.episode, run.world
    if not episode.checkpoints:
        return None
    trail = true_trail(world, episode.transcript)
    seen = ShownMap({}, {})
    for step, checkpoint in episode.checkpoints:
        place = embedded(checkpoint, world, trail[step])
        if place is None:
            return None
        for dart, other in enumerate(checkpoint.alpha):
            seen.darts.setdefault(place[dart], step)
            if other != dart:
                seen.edges.setdefault(place[dart], step)
    return seen
