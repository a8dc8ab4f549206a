"""A strategy: what to do after whatever is sensed, and what to answer in the end."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeAlias, assert_never

from allworlds.protocol import Estimate, Percept

if TYPE_CHECKING:
    from allworlds import documents


@dataclass(frozen=True, slots=True)
class Leaf:
    """The robot knows its world, and answers."""

    answer: Estimate


@dataclass(frozen=True, slots=True)
class Step:
    """The robot makes motion ``k``, and goes on at the node of what it senses then."""

    k: int
    then: Mapping[Percept, int]


Node: TypeAlias = Leaf | Step


@dataclass(frozen=True, slots=True)
class Strategy:
    """Nodes by number, each of which may be come to in several ways.

    Attributes:
        start: for each first percept the node to begin at.
        nodes: what to do.
    """

    start: Mapping[Percept, int]
    nodes: tuple[Node, ...]

    def to_json(self) -> documents.StrategyDocument:
        """``{"start": [BRANCH], "nodes": [NODE]}``."""
        return {"start": _branches(self.start), "nodes": [_node(node) for node in self.nodes]}


def _branches(then: Mapping[Percept, int]) -> list[documents.Branch]:
    return [{"percept": percept.to_json(), "node": node} for percept, node in then.items()]


def _node(node: Node) -> documents.StrategyStep | documents.StrategyLeaf:
    match node:
        case Leaf(answer):
            return {"answer": answer.to_json()}
        case Step(k, then):
            return {"move": k, "then": _branches(then)}
        case _:
            assert_never(node)
