"""The owner of the bound, or of the step budget, that a walk has exceeded, and the way out."""

from __future__ import annotations

from allworlds.judging.episode import default_step_budget
from allworlds.judging.findings.finding import Finding
from allworlds.judging.laws.bounds import paper_terms
from allworlds.words import listed, plural, size


def tell_whose_bound(finding: Finding) -> list[str]:
    """Tell that the answer is right, whose bound it is, and how to check without it."""
    others = [law for law in finding.rules.applying if law != "bound"]
    rest = f"every other law that was checked holds: {listed(others)}" if others else ""
    if {"map", "pose"} <= {*others}:
        right = "The map and the pose are right; the walk is longer than the bound allows."
    else:
        right = f"The walk is longer than the bound allows{'; ' if rest else ''}{rest}."
    other = "4*m" if finding.rules.the_bound.name == "2*m" else "2*m"
    without = (
        "The option --bound none checks the other laws alone; --bound EXPR checks another cost, "
        f"such as --bound '{other}'."
    )
    return [right, _whose(finding), without]


def tell_whose_budget(finding: Finding) -> str:
    """Tell where the step budget comes from, and how to get another one."""
    rules, map_ = finding.rules, finding.world.map
    if rules.step_budget is not None:
        return f"The budget is that of --step-budget: {plural(rules.step_budget, 'traversal')}."
    value = rules.budget(map_)
    new, closing = paper_terms(map_.vertex_count, map_.edge_count)
    world = size(map_.edge_count, map_.vertex_count)
    told = "the bound that the explorer names"
    if value == default_step_budget(new + closing):
        told = f"8 times the paper's bound, and 100 more: 8 x ({new} + {closing}) + 100"
    return (
        f"In a world with {world} the budget is {plural(value, 'traversal')}, {told}. An explorer "
        "that is right and walks more needs a larger budget: --step-budget N."
    )


def _whose(finding: Finding) -> str:
    rules, map_ = finding.rules, finding.world.map
    name, value = rules.the_bound.name, finding.expected
    world = size(map_.edge_count, map_.vertex_count)
    new, closing = paper_terms(map_.vertex_count, map_.edge_count)
    paper = (
        "what the paper proves for its Algorithm 1 in Section VI: the sum of (1), the passes that "
        "find a new vertex, and (2), the passes that close an edge between known ones"
    )
    sums = f"In a world with {world} that is {new} + {closing}"
    if name == "paper":
        return f"The bound 'paper' is {paper}. {sums} = {value}."
    if name == "two-vertices":
        return (
            f"The bound 'two-vertices' is {paper}; with two traversals for each test of a "
            f"hypothesis, and the search among the darts of the start. {sums}, with those {value}."
        )
    own = rules.the_bound == rules.own_bound
    owner = "the explorer's own" if own else "the one that was asked for"
    return f"The bound is {owner}: {name}, which is {value} in a world with {world}."
