"""What the log leaves open, and how it is in truth, in sentences."""

from __future__ import annotations

from collections import Counter

from allworlds.explaining.story import Story
from allworlds.explaining.words import darts
from allworlds.judge import fold
from allworlds.maps.combinatorial import cycles


def tell_open_darts(story: Story) -> list[str]:
    """The darts that the folded log leaves open, and the vertices that it has several times.

    Nothing where it leaves none open, or where the lighthouse allows no folding.
    """
    if not story.world.lighthouse.folds:
        return []
    folded, map_ = fold(story.transcript), story.map
    image = {0: story.world.start}
    for x in (queue := [0]):
        for y, true in ((folded.sigma[x], map_.sigma), (folded.alpha[x], map_.alpha)):
            if y not in image:
                image[y] = true[image[x]]
                queue.append(y)
    unsettled = sorted({image[x] for x, y in enumerate(folded.alpha) if x == y})
    if not unsettled:
        return []
    at: dict[str, list[str]] = {}
    for dart in unsettled:
        at.setdefault(story.vertex(dart), []).append(str(dart))
    names = "; ".join(f"{vertex}: {darts(open_)}" for vertex, open_ in at.items())
    leads = [
        f"dart {d} to dart {map_.alpha[d]} of {story.vertex(map_.alpha[d])}" for d in unsettled
    ]
    sentences = [
        f"It was never settled where these darts lead: {names}.",
        f"In the world they lead as follows: {', '.join(leads)}.",
    ]
    copies = Counter(story.vertex(image[group[0]]) for group in cycles(folded.sigma))
    for vertex, count in sorted(copies.items()):
        if count > 1:
            sentences.append(
                f"The robot came to {vertex} in {count} ways of which the log does not tell that "
                "they lead to one vertex."
            )
    return sentences
