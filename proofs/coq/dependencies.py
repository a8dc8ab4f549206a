"""Draws which file needs which: html/dependencies.svg and html/index.html.

Usage: dependencies.py DEPEND FOLDER   (DEPEND as coqdep writes it; FOLDER holds coqdoc's pages)

An arrow that follows from others is left out.  A file stands one row below the lowest of those
that it needs; within a row the files are ordered by where their needs stand.
"""

import html
import pathlib
import re
import sys

WIDE, HIGH, GAP_X, GAP_Y, MARGIN = 138, 26, 14, 46, 20

STYLE = """<style>
path { stroke: #99a; fill: none }
rect { fill: #eef; stroke: #446 }
text { font: 12px sans-serif; text-anchor: middle }
</style>"""

PAGE = """<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>{title}</title>
<style>
body {{ font-family: sans-serif; margin: 2em }}
td {{ padding: 0 1em 0.3em 0 }}
</style></head>
<body><h1>{title}</h1>
<p>Read <a href="Allworlds.Model.html">Model</a> and <a href="Allworlds.Main.html">Main</a> first.
<a href="toc.html">Contents</a>, <a href="names.html">all names</a>.</p>
<table>{rows}</table>
<h2>Which file needs which</h2>
{picture}
</body></html>
"""


def needs(depend: str) -> dict[str, set[str]]:
    """For each file the files that it requires directly, in the order of the text.

    Raises ValueError if the text is not what coqdep writes.
    """
    found = {}
    for line in depend.splitlines():
        if match := re.match(r"(\w+)\.vo .*: \w+\.v(.*)", line):
            found[match[1]] = set(re.findall(r"(\w+)\.vo\b", match[2]))
    if not found or not set().union(*found.values()) <= set(found):
        raise ValueError("not the dependencies of a folder")
    return found


def reduced(direct: dict[str, set[str]]) -> dict[str, set[str]]:
    """Without the needs that follow from others.

    Raises ValueError if they go round in a circle.
    """
    below: dict[str, set[str]] = {}
    todo = dict(direct)
    while todo:
        ready = [name for name, those in todo.items() if those <= set(below)]
        if not ready:
            raise ValueError(f"a circle among {', '.join(sorted(todo))}")
        for name in ready:
            below[name] = todo.pop(name).union(*(below[other] for other in direct[name]))
    return {
        name: {one for one in those if not any(one in below[other] for other in those)}
        for name, those in direct.items()
    }


def rows(arrows: dict[str, set[str]]) -> list[list[str]]:
    """The files row by row."""
    depth: dict[str, int] = {}

    def row_of(name: str) -> int:
        if name not in depth:
            depth[name] = 1 + max((row_of(other) for other in arrows[name]), default=-1)
        return depth[name]

    placed: list[list[str]] = [[] for _ in range(1 + max(map(row_of, arrows)))]
    for name in arrows:
        placed[depth[name]].append(name)
    where: dict[str, float] = {}
    for row in placed:
        mean = {n: sum(where[o] for o in arrows[n]) / max(1, len(arrows[n])) for n in row}
        row.sort(key=lambda name: mean[name])
        where.update((name, (i + 0.5) / len(row)) for i, name in enumerate(row))
    return placed


def picture(arrows: dict[str, set[str]]) -> str:
    """The SVG text."""
    placed = rows(arrows)
    width = 2 * MARGIN + max(map(len, placed)) * (WIDE + GAP_X) - GAP_X
    height = 2 * MARGIN + len(placed) * (HIGH + GAP_Y) - GAP_Y
    at = {}
    for j, row in enumerate(placed):
        left = (width - len(row) * (WIDE + GAP_X) + GAP_X) / 2
        for i, name in enumerate(row):
            at[name] = (left + i * (WIDE + GAP_X), MARGIN + j * (HIGH + GAP_Y))
    lines = [
        f'<path d="M{at[a][0] + WIDE / 2:.0f} {at[a][1]:.0f}'
        f' L{at[b][0] + WIDE / 2:.0f} {at[b][1] + HIGH:.0f}"/>'
        for a in arrows
        for b in sorted(arrows[a])
    ]
    boxes = [
        f'<a href="Allworlds.{name}.html"><rect x="{x:.0f}" y="{y:.0f}" width="{WIDE}" '
        f'height="{HIGH}" rx="4"/><text x="{x + WIDE / 2:.0f}" y="{y + 17:.0f}">{name}</text></a>'
        for name, (x, y) in at.items()
    ]
    return "\n".join(
        [
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0f} {height:.0f}">',
            STYLE,
            *lines,
            *boxes,
            "</svg>",
        ]
    )


def subject(source: pathlib.Path) -> str:
    """The first line of the comment at the head of a file, without the paper's sections."""
    line = source.read_text(encoding="utf-8").splitlines()[1].strip()
    return re.split(r"\s{3,}", line)[0]


def main() -> int:
    """The exit code."""
    depend, folder = map(pathlib.Path, sys.argv[1:])
    try:
        arrows = reduced(needs(depend.read_text(encoding="utf-8")))
    except ValueError as error:
        print(f"{depend}: {error}", file=sys.stderr)
        return 1
    drawn = picture(arrows)
    (folder / "dependencies.svg").write_text(drawn, encoding="utf-8")
    listed = "".join(
        f'<tr><td><a href="Allworlds.{name}.html">{name}</a></td>'
        f"<td>{html.escape(subject(depend.parent / f'{name}.v'))}</td></tr>"
        for name in arrows
    )
    title = "Exploring topological worlds with minimal information"
    page = PAGE.format(title=title, rows=listed, picture=drawn)
    (folder / "index.html").write_text(page, encoding="utf-8")
    print(f"{folder / 'index.html'}: {len(arrows)} files")
    return 0


if __name__ == "__main__":
    sys.exit(main())
