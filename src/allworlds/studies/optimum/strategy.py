"""Strategies: a motion for every percept, and an answer at the end."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated

from allworlds.document import Document, Natural, Some, about
from allworlds.protocol import Estimate, Percept


class Branch(Document):
    """The next node after a percept."""

    percept: Annotated[Percept, about("the percept")]
    node: Annotated[Natural, about("the node to go on with, by its place in `nodes`")]


class StrategyStep(Document):
    """A node of a strategy: a motion."""

    move: Annotated[Natural, about("by how many darts clockwise the robot turns before it leaves")]
    then: Annotated[Some[Branch], about("the next node, by the percept")]


class StrategyLeaf(Document):
    """A node of a strategy: the end."""

    answer: Annotated[Estimate, about("the map, and the robot's dart in it")]


class Strategy(Document):
    """A strategy. Several branches may lead to one node."""

    start: Annotated[Some[Branch], about("the first node, by the first percept")]
    nodes: Annotated[Some[StrategyStep | StrategyLeaf], about("the motions and answers")]


def node_after(percept: Percept, branches: Sequence[Branch]) -> int | None:
    """The number of the node to go on with; None where there is none."""
    return next((branch.node for branch in branches if branch.percept == percept), None)
