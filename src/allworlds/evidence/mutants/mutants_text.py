"""The text of ``mutants``."""

from __future__ import annotations

from allworlds.evidence.mutants.matrix import Kill, KillMatrix
from allworlds.reports import entry, interruption, table
from allworlds.words import plural


def mutants_text(matrix: KillMatrix, width: int) -> str:
    """The kill matrix, the equivalent mutants with their reasons, and the survivors."""
    lines = []
    for kind in ("explorer", "judge", "enumerator"):
        rows = [
            _row(kill) for kill in matrix.kill_matrix if kill.kind == kind and not kill.equivalent
        ]
        lines += table([f"{kind}s", "killed by", "m", "n", "world"], rows, "llrr", width)
        lines.append("")
    equivalent = [kill for kill in matrix.kill_matrix if kill.equivalent]
    for kill in equivalent:
        lines += entry("EQUIVALENT", f"{kill.mutant}: {kill.breaks} {kill.equivalent}", width)
    killed = sum(bool(kill.killed_by) for kill in matrix.kill_matrix)
    text = f"{plural(matrix.mutants, 'mutant')}, {killed} killed, "
    text += f"{len(equivalent)} equivalent, worlds with at most {plural(matrix.edges, 'edge')}"
    lines += ["", *interruption(complete=matrix.complete, width=width)]
    lines += entry(_verdict(matrix), text, width)
    lines += [f"  {name}" for name in matrix.survivors]
    return "\n".join(lines)


def _verdict(matrix: KillMatrix) -> str:
    if matrix.survivors:
        return "SURVIVORS"
    return "ALL KILLED" if matrix.complete else "TRIED"


def _row(kill: Kill) -> list[str]:
    by = kill.killed_by or "-"
    if kill.world is None:
        return [kill.mutant, by, "", "", ""]
    map_ = kill.world.map
    rotation = "".join(f"({' '.join(map(str, vertex))})" for vertex in map_.vertices)
    edges = " ".join(f"{a}-{b}" for a, b in map_.edges)
    size = [str(map_.edge_count), str(map_.vertex_count)]
    return [kill.mutant, by, *size, f"{rotation} {edges}"]
