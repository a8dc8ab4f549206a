"""Telling of ``mutants``: survivors, kills and equivalent mutants."""

from __future__ import annotations

from allworlds.evidence.mutants.matrix import Kill, KillMatrix
from allworlds.reports import (
    Block,
    Cell,
    CsvRows,
    Headline,
    Section,
    ToldFacts,
    ToldResult,
    ToldTable,
    Value,
    so_far,
)
from allworlds.words import plural
from allworlds.world import code_of


def mutants_telling(matrix: KillMatrix) -> ToldResult:
    """The survivors, the kill matrix, and the equivalent mutants with their reasons."""
    equivalent = [kill for kill in matrix.kill_matrix if kill.equivalent]
    killed = sum(bool(kill.killed_by) for kill in matrix.kill_matrix)
    text = f"{plural(matrix.mutants, 'mutant')}, {killed} killed, "
    text += f"{len(equivalent)} equivalent, worlds with at most {plural(matrix.edges, 'edge')}"
    facts = [("survivor", name) for name in matrix.survivors]
    blocks: list[Block] = [ToldFacts(facts)] if facts else []
    for kind in ("explorer", "judge", "enumerator"):
        kills = [k for k in matrix.kill_matrix if k.kind == kind and not k.equivalent]
        header = [f"{kind}s", "killed by", "m", "n", "world"]
        blocks.append(ToldTable(header, [_row(kill) for kill in kills], f"Wrong {kind}s"))
    whys = [
        ("EQUIVALENT", f"{kill.mutant}: {kill.breaks} {kill.equivalent}") for kill in equivalent
    ]
    blocks += [ToldFacts(whys)] if whys else []
    return ToldResult(
        "allworlds self mutants",
        "this program",
        matrix,
        _headline(matrix, text),
        [Section("seen", "", blocks)],
        rows=lambda: _rows(matrix),
    )


def _rows(matrix: KillMatrix) -> CsvRows:
    """A row for each mutant, with the smallest world that kills it."""
    columns = {"kind": str, "mutant": str, "killed_by": str, "edges": int, "vertices": int}
    rows = []
    for kill in matrix.kill_matrix:
        world: list[Value] = [None, None, None]
        if kill.world is not None:
            map_ = kill.world.map
            world = [map_.edge_count, map_.vertex_count, code_of(map_, kill.world.start)]
        rows.append([kill.kind, kill.mutant, kill.killed_by, *world])
    return CsvRows({**columns, "code": str}, rows)


def _headline(matrix: KillMatrix, text: str) -> Headline | None:
    told = Headline("ALL KILLED", text, "holds")
    if matrix.survivors:
        told = Headline("SURVIVORS", text, "refuted")
    return so_far(matrix, told if matrix.kill_matrix else None)


def _row(kill: Kill) -> list[Cell]:
    by = kill.killed_by or "-"
    if kill.world is None:
        return [kill.mutant, by, None, None, ""]
    map_ = kill.world.map
    rotation = "".join(f"({' '.join(map(str, vertex))})" for vertex in map_.vertices)
    edges = " ".join(f"{a}-{b}" for a, b in map_.edges)
    return [kill.mutant, by, map_.edge_count, map_.vertex_count, f"{rotation} {edges}"]
