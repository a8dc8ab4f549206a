"""``map`` and ``pose``: the answer is wrong."""

from __future__ import annotations

from allworlds.explaining.belief import Belief
from allworlds.explaining.parting import tell_parting
from allworlds.explaining.story import Story
from allworlds.explaining.telling import Telling
from allworlds.explaining.words import count, size
from allworlds.inputs import InputError
from allworlds.maps.canonical import carries, numbering
from allworlds.maps.combinatorial import Dart


def tell_map(story: Story) -> Telling:
    """How large both maps are, and where the walks in them part."""
    belief = Belief(story)
    sizes = (
        f"The world has {size(story.map)}; the answer has {size(belief.answer.map)} and is "
        "another map."
    )
    return Telling([sizes, *tell_parting(belief)], belief.step, belief.answer)


def tell_pose(story: Story) -> Telling:
    """Where the robot is and where it believes to be, and where the walks to there part."""
    belief = Belief(story)
    images = _images(belief)
    alike = len(images) - 1
    symmetry = f"The map is symmetric: {count(alike, 'other dart')} would do as well."
    sentences = [
        "The map is right, but the robot is not where the answer says.",
        _say_where(story, images),
        *([symmetry] if alike else []),
        *tell_parting(belief),
    ]
    return Telling(sentences, belief.step, belief.answer)


def _images(belief: Belief) -> list[Dart]:
    """The darts of the world that ``here`` can stand for: one, or more by symmetry."""
    answer, map_ = belief.answer, belief.story.map
    sigma, alpha = answer.map.sigma, answer.map.alpha
    order = numbering(sigma, alpha, answer.here)
    images = [d for d in map_.darts if carries(sigma, alpha, order, map_.sigma, map_.alpha, d)]
    if not images:
        raise InputError("the finding's answer is not the map of its world, so its law is not pose")
    return images


def _say_where(story: Story, images: list[Dart]) -> str:
    map_, robot = story.map, story.walked[-1]
    stands = f"The robot stands at {story.place(robot)}; it believes to stand at "
    near = [d for d in images if map_.vertex_of[d] == map_.vertex_of[robot]]
    if not near:
        return f"{stands}{story.place(images[0])}, which is another vertex."
    believed = min(near, key=lambda d: map_.offset(d, robot))
    turned, degree = map_.offset(believed, robot), map_.degree_at[robot]
    return (
        f"{stands}dart {believed} of the same vertex: in truth it is turned further by {turned} of "
        f"{degree} darts clockwise."
    )
