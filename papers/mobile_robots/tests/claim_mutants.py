"""Of every claim a mutation under which it must fail; ``test_claim_mutants.py`` runs the table.

A mutation changes a model or a program, never what is expected.
"""

from __future__ import annotations

from dataclasses import asdict, dataclass
from types import SimpleNamespace
from typing import Any

import black_holes
import companions
import delays
import exploring
import gathering_three
import holes
import lights
import moving_edges
import oblivious
import perpetual
import rendezvous
import rotor
import rotor_router
import shrink
import tokens
import two_mappers
from allworlds import Automaton, Do, End, Estimate, Wait
from paper_claims import Mutant
from worlds import named

# ---------------------------------------------------------------- models


@dataclass(frozen=True)
class Near(type(named("meeting"))):
    """Robots that shall be at one vertex or at two neighbours."""

    def over(self, map_, state):
        one, other = state.darts
        return shrink.distance(map_, one, other) <= 1


@dataclass(frozen=True)
class Static(type(named("one-interval"))):
    """No edge is ever missing."""

    def step(self, map_, state, acts):
        every = [*super().step(map_, state, acts)]
        return [each for each in every if "is missing" not in each[1]]


@dataclass(frozen=True)
class Harmless(type(named("black-hole"))):
    """The hole swallows nobody."""

    def sensed(self, map_, state, robot):
        return super().sensed(map_, state._replace(hole=None), robot)

    def bad(self, map_, state):
        return ""


def near(_text: str) -> Any:
    """Near, whatever is asked for."""
    return Near()


def static(text: str) -> Any:
    """The model of this name, without a missing edge."""
    return Static(**asdict(named(text)))


def harmless(_text: str) -> Any:
    """Harmless, whatever is asked for."""
    return Harmless()


def blind(_text: str) -> Any:
    """Robots that do not see how many are at a vertex."""
    return named("snapshot:multiplicity=none")


# ---------------------------------------------------------------- programs

right_word, right_round, right_next = shrink.by_word, tokens.round_once, two_mappers.next_action

still = Automaton(None, lambda memory, percept: (memory, Wait()))
first = Automaton(None, lambda memory, percept: (memory, Do("first")))


def mirrored(replies: Any) -> Any:
    """What dudek91 does, and at last the mirror image of its map."""
    action = right_next(replies)
    if not isinstance(action, End):
        return action
    return End(Estimate(action.answer.map.mirrored(), action.answer.here))


def not_turned(map_: Any, vertex: int, pointers: Any) -> Any:
    """A step after which the pointer is as before."""
    return map_.alpha[pointers[vertex]], pointers


def every_dart_alone(labelled: Any) -> Any:
    """A bisimulation in which no two darts are alike."""
    return SimpleNamespace(classes=labelled[0].darts)


FAR = {**lights.RULES, (lights.WHITE, lights.WHITE): (lights.BLACK, "1")}

MUTANTS = [
    Mutant("shrink-named", "no word of moves", ((shrink, "shrink_by_walk", lambda m, p: 1),)),
    Mutant("shrink-worlds", "no darts are alike", ((shrink, "project", every_dart_alone),)),
    Mutant(
        "shrink-zero",
        "a word without its last move",
        ((shrink, "by_word", lambda word: right_word(word[:-1])),),
    ),
    Mutant("shrink-positive", "neighbours are enough", ((shrink, "named", near),)),
    Mutant("delays", "neighbours are enough", ((delays, "named", near),)),
    Mutant("to-the-other", "neighbours are enough", ((companions, "named", near),)),
    Mutant("labels", "both walk on", ((rendezvous, "mommy", rendezvous.walk),), {"edges": 1}),
    Mutant("lights", "all the way if both are white", ((lights, "RULES", FAR),)),
    Mutant("tokens-one-way", "walk on", ((tokens, "round_once", lambda _robots: tokens.onward),)),
    Mutant("tokens-facing", "stay", ((tokens, "onward", still),)),
    Mutant(
        "tokens-more",
        "a gap less",
        ((tokens, "round_once", lambda robots: right_round(robots - 1)),),
    ),
    Mutant("dispersion", "stay", ((delays, "go", still),)),
    Mutant("rotor-worst", "pointers that stay", ((rotor, "pointed_way", not_turned),)),
    Mutant("rotor-model", "pointers that stay", ((rotor_router, "pointed_way", not_turned),)),
    Mutant("second-robot", "mirror images", ((two_mappers, "next_action", mirrored),)),
    Mutant(
        "hidden-once",
        "no failure",
        ((companions, "named", lambda _text: named("lighthouse:directional")),),
    ),
    Mutant(
        "lcm-counts",
        "naive",
        ((gathering_three, "odd", gathering_three.naive),),
        {"least": 4, "most": 7},
    ),
    Mutant("naive-two", "not naive", ((gathering_three, "naive", gathering_three.three),)),
    Mutant("naive-three", "not naive", ((gathering_three, "naive", gathering_three.three),)),
    Mutant("rule-sets-five", "no multiplicity", ((oblivious, "named", blind),)),
    Mutant("rule-sets-all", "no multiplicity", ((oblivious, "named", blind),)),
    Mutant("perpetual-old", "the new rules", ((perpetual, "old", perpetual.new),), slow=True),
    Mutant("perpetual-schedulers", "step ahead", ((perpetual, "old", first),)),
    Mutant("perpetual-new", "the old rules", ((perpetual, "new", perpetual.old),), slow=True),
    Mutant("perpetual-twelve", "stay", ((perpetual, "new", still),), slow=True),
    Mutant(
        "perpetual-none",
        "gathering",
        ((exploring, "EXPLORING", "snapshot"),),
        {"one": 4, "two": 4, "three": 4},
    ),
    Mutant("stopping", "nobody goes", ((exploring, "goes", still),)),
    Mutant("dynamic-one", "no edge is missing", ((moving_edges, "named", static),)),
    Mutant(
        "dynamic-two",
        "two on one port",
        ((moving_edges, "ANYWHERE", "one_face=true,apart=false,exclusive=false"),),
        {"vertices": 3},
    ),
    Mutant(
        "dynamic-facing", "no edge is missing", ((moving_edges, "named", static),), {"vertices": 3}
    ),
    Mutant("hole-one", "no hole", ((holes, "named", harmless),)),
    Mutant("hole-two", "careless", ((black_holes, "cautious", black_holes.careless),)),
    Mutant(
        "hole-lost-update",
        "one step",
        ((holes, "named", lambda _text: named("black-hole:at_once=true")),),
    ),
]
