"""The explanation of the law ``pose``: a right map, and a wrong ``here``."""

from __future__ import annotations

from allworlds.inputs import InputError
from allworlds.judging.explanations.parting import tell_parting
from allworlds.judging.explanations.slips import bearings_anticlockwise, mirror_image
from allworlds.judging.explanations.story import Belief, Story, Telling
from allworlds.maps import Dart, carries, numbering
from allworlds.words import plural

TURNED, ELSEWHERE = "off by a turn", "another vertex"
"""The names of a wrong ``here``, at the robot's vertex and at another one."""

HERE, BOTH = "'here' is wrong", "This world is its own mirror image"


def tell_pose(story: Story) -> Telling:
    """Tell where the robot is, where the answer says that it is, and where the walks diverge.

    If the answer is also right as a mirror image, another world may have decided.
    """
    belief = Belief(story)
    images = _images(belief)
    alike = len(images) - 1
    symmetry = f" (for this symmetric map {plural(alike, 'other dart')} would be right, too)"
    where = f"{_say_where(belief, images)}{symmetry if alike else ''}"
    turned = story.map.vertex_of[story.walked[-1]] in {story.map.vertex_of[d] for d in images}
    name = TURNED if turned else ELSEWHERE
    mirrored, bearings = mirror_image(belief), bearings_anticlockwise(belief)
    shown = story.finding.chirality
    decided = not mirrored or (shown is not None and shown.rotations != "unknown")
    if not decided:
        causes = [HERE, "the rotations are anticlockwise"]
        causes += ["the bearings are counted anticlockwise"] if bearings else []
        reason = "'allworlds explain' plays the explorer in another one"
        if shown:
            reason = f"no other one decides: {shown.where}"
        told = [
            f"Either {', or '.join(causes)}: {where}.",
            f"{BOTH} and does not show which; {reason}.",
        ]
    elif mirrored and shown and shown.rotations == "anticlockwise":
        name = mirrored.name
        told = [
            mirrored.sentence,
            f"{BOTH}, but in {shown.where}, the explorer's map is the mirror image, too.",
            f"Therefore {HERE}: {where}.",
        ]
    elif bearings and not story.finding.misreading:  # which says so before
        name = bearings.name
        told = [f"The map is right, but {HERE}: {where}.", f"Or: {bearings.sentence}"]
    else:
        told = [f"The map is right, but {HERE}: {where}."]
        if mirrored and shown:
            told.append(
                f"The rotations are clockwise, as they should be: in {shown.where}, the "
                "explorer's map is right."
            )
    return Telling([*told, *tell_parting(belief)], belief.step, belief.answer, slip=name)


def _images(belief: Belief) -> list[Dart]:
    """The darts of the world that ``here`` can stand for: one, or more by symmetry."""
    answer, map_ = belief.answer, belief.story.map
    sigma, alpha = answer.map.sigma, answer.map.alpha
    order = numbering(sigma, alpha, answer.here)
    images = [d for d in map_.darts if carries(sigma, alpha, order, map_.sigma, map_.alpha, d)]
    if not images:
        raise InputError("the finding's answer is not the map of its world, so its law is not pose")
    return images


def _say_where(belief: Belief, images: list[Dart]) -> str:
    """Tell where the robot stands, and where the answer says that it stands."""
    story = belief.story
    map_, robot = story.map, story.walked[-1]
    stands = f"the robot stands at {story.place(robot)}, and the answer says"
    parting = belief.parting
    meant = parting.taken_for if parting and parting.step == len(story.walked) - 1 else None
    near = [d for d in images if map_.vertex_of[d] == map_.vertex_of[robot]]
    if not near:
        said = map_.alpha[robot] if map_.alpha[robot] in images else images[0]
        told = f"{stands} {story.place(said)}, which is another vertex"
    else:
        said = meant if meant in near else min(near, key=lambda d: map_.offset(d, robot))
        turned, degree = map_.offset(said, robot), map_.degree_at[robot]
        back = degree - turned
        darts, way = (turned, "anticlockwise") if turned < back else (back, "clockwise")
        told = f"{stands} dart {said} of the same vertex, {plural(darts, 'dart')} too far {way}"
    if said != map_.alpha[robot] or len(story.walked) == 1:
        return told
    return f"{told}; dart {said} is the other end of the edge by which the robot came"
