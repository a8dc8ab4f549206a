"""Count the words of the pages that are written by hand.

``python docsite/words.py [FOLDER]`` prints a line for each page of the project in FOLDER: all its
words, and those beside blocks of code.  A word is a text between blanks that has a letter or a
digit; so the bars of tables are none.  Not counted are decisions, and parts of pages that a program
writes, between ``<!-- NAME: written by PROGRAM -->`` and ``<!-- end of NAME -->``.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path

APART = ("decisions",)
PART = re.compile(r"<!-- ([\w ]+): written by .*?<!-- end of \1 -->", re.DOTALL)
BLOCK = re.compile(r"^```.*?^```$", re.DOTALL | re.MULTILINE)


def by_hand(root: Path) -> list[Path]:
    """The pages that are written by hand, in the order of their names."""
    pages = sorted((root / "docs").rglob("*.md"))
    return [
        root / "README.md",
        *(p for p in pages if p.parent.name not in APART),
    ]


def words(text: str) -> int:
    """The number of words of a page that were written by hand."""
    return sum(any(map(str.isalnum, word)) for word in PART.sub("", text).split())


def prose(text: str) -> int:
    """The number of words written by hand, without those in blocks of code."""
    return words(BLOCK.sub("", text))


if __name__ == "__main__":
    folder = Path(sys.argv[1] if sys.argv[1:] else ".")
    counted = []
    for page in by_hand(folder):
        content = page.read_text(encoding="utf-8")
        counted.append((words(content), prose(content)))
        name = page.relative_to(folder).as_posix()
        print(f"{counted[-1][0]:6,} {counted[-1][1]:6,}  {name}")
    total, beside = (sum(column) for column in zip(*counted, strict=True))
    print(f"{total:6,} words on {len(counted)} pages; {beside:,} beside blocks of code")
