"""The most expensive runs: cost against bound, and each of them to be stepped through."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from allworlds.engines import SingleRun
from allworlds.reports.telling import Costs, Section, SizeCost
from allworlds.reports.tellings.single_run import cost_words, run_section
from allworlds.words import size


def most_expensive_sections(
    cells: Sequence[SizeCost], runs: Iterable[SingleRun]
) -> Iterator[Section]:
    """Cost against bound, then the runs; empty if there are no cells."""
    if not cells:
        return
    yield Section("costs", "Cost against bound", [Costs(cells)])
    sections = []
    for number, run in enumerate(runs, 1):
        map_ = run.world.map
        title = f"{size(map_.edge_count, map_.vertex_count)}: {cost_words(run)}"
        sections.append(run_section(run, f"most-expensive-{number}", title))
    if sections:
        yield Section("most-expensive", "The most expensive run of each size", [], sections)
