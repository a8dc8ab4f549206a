"""Families that grow, and the worlds of each size that are drawn from them."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable

from msgspec import Struct

from allworlds.inputs.checks import InputError, show
from allworlds.maps.canonical import Code, rooted_code
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.maps.families import edges_of
from allworlds.world.named import map_of_family

LEAST, SIZES = 12, 6
"""No size has fewer edges, and there are no more sizes."""

HOLES = "10%"
"""Of a dense map, which else would have one member of each size."""


class Growing(Struct, frozen=True):
    """A family by its name on the command line, with its members numbered by size.

    Attributes:
        form: how it is written; ``:D`` stands for a degree.
        member: the text of a member, from its number and the degree.
        degree: the degree where none is named; None where a name has none.
        holes: the share of edges to be removed.
    """

    form: str
    member: Callable[[int, int], str]
    degree: int | None = None
    holes: str | None = None


GROWING = {
    growing.form.partition(":")[0]: growing
    for growing in (
        Growing("lattice", lambda p, _: f"lattice:{p + 1}x{p + 1}"),
        Growing("torus", lambda p, _: f"torus:{p}x{p}"),
        Growing("strip", lambda p, _: f"strip:{p}"),
        Growing("dense", lambda p, _: f"dense:{p + 1}", holes=HOLES),
        Growing("cubic", lambda p, _: f"cubic:{2 * p}"),
        Growing("regular:D", lambda p, d: f"regular:{d}x{p if d % 2 == 0 else 2 * p}", 6),
        Growing("random", lambda p, _: f"random:{p}x{2 * p}"),
        Growing("bouquet", lambda p, _: f"bouquet:{p}"),
        Growing("lollipop:D", lambda p, d: f"lollipop:{d}x{p}", 4),
        Growing("prism", lambda p, _: f"prism:{p + 2}"),
        Growing("thick:D", lambda p, d: f"thick:{d}x{p}", 6),
        Growing("cover", lambda p, _: f"cover:{p}"),
        Growing("corridor", lambda p, _: f"corridor:{p}"),
    )
}
"""Every family that grows, by its name."""

FORMS = ", ".join(growing.form for growing in GROWING.values())


class Member(Struct, frozen=True):
    """One world of a family, with the words that name it on the command line."""

    text: str
    holes: str | None
    seed: int

    @property
    def name(self) -> str:
        """Words that name the world: ``torus:6x6 --seed 1``."""
        holes = f" --holes {self.holes}" if self.holes else ""
        return f"{self.text}{holes} --seed {self.seed}"

    @property
    def told(self) -> str:
        """Words for a reader: ``torus:6x6, seed 1``."""
        return f"{self.text}{f' with holes {self.holes}' if self.holes else ''}, seed {self.seed}"

    def map(self) -> CombinatorialMap:
        """The map; a robot starts at dart 0."""
        return map_of_family(self.text, self.holes, self.seed)


def member_named(name: str) -> Member:
    """The member of :attr:`Member.name`."""
    words, _, seed = name.partition(" --seed ")
    text, _, holes = words.partition(" --holes ")
    return Member(text, holes or None, int(seed))


def distinct(members: Iterable[Member]) -> dict[Member, CombinatorialMap]:
    """The members with their maps; of those that are isomorphic as rooted maps the first."""
    seen: dict[Code, Member] = {}
    maps = {member: member.map() for member in members}
    for member, map_ in maps.items():
        seen.setdefault(rooted_code(map_.sigma, map_.alpha, 0), member)
    return {member: maps[member] for member in seen.values()}


def form_of(family: str) -> tuple[Growing, int] | None:
    """The growing family that the text names, and the degree; None if there is none."""
    name, colon, degree = family.partition(":")
    growing = GROWING.get(name)
    if growing is None or (colon and growing.degree is None):
        return None
    if not colon:
        return growing, growing.degree or 0
    return (growing, int(degree)) if re.fullmatch(r"\d{1,4}", degree, re.ASCII) else None


def members_of(family: str, to: int, worlds: int, seed: int) -> list[list[Member]]:
    """The members of a family, ascending, grouped by size.

    The sizes are the largest members with at most ``to``, ``to / 2``, ``to / 4``, ... edges.

    Raises:
        InputError: for a text that is none of the families.
    """
    known = form_of(family)
    if known is None:
        raise InputError(f"family {show(family)} is not one of {FORMS}")
    growing, number = known
    ladder = []
    for text in dict.fromkeys(_largest(growing, number, to >> k) for k in reversed(range(SIZES))):
        if text:
            ladder.append([Member(text, growing.holes, seed + i) for i in range(worlds)])
            # A degree that no member can have is told before anything is walked.
            ladder[-1][0].map()
    return ladder


def _largest(growing: Growing, degree: int, edges: int) -> str:
    """The largest member with at most ``edges`` edges before holes are made; empty if too small."""
    number = 1
    while edges_of(growing.member(number + 1, degree)) <= edges:
        number += 1
    text = growing.member(number, degree)
    return text if LEAST <= edges_of(text) <= edges else ""
