"""Attacks as their files tell of them: what they are, and what must come of them.

The docstring of an attack, or the first comment of one in C, ends with lines ``key: value``, which
are read without running it:

``verdict``
    what ``check`` must say: ``holds``, ``refuted LAW`` (or ``LAW or LAW``, where it is drawn
    which of its runs is met first), ``inconclusive``, ``refused`` (exit code 2, nothing on
    stdout), or ``internal`` (exit code 70).  ``verdict of NAME`` is that of one function of
    several; else the function is ``explore``.  In C it is called as ``ATTACK``.
``as``
    ``exec``: it is a program behind ``--exec``.
``options``
    of ``check``; without them ``--edges 2``.
``beside``
    names of modules that lie beside it and in the current directory, and must not be loaded.
``signal``
    is sent to the process that checks as soon as the attack has written the file ``ready``; the
    verdict is then the exit code.
``says``
    a part of what stands on stderr.
``quick``
    with so many workers it is tried in the quick run, too.
"""

import ast
import re
from dataclasses import dataclass, field
from pathlib import Path

ATTACKS = Path(__file__).parent
KINDS = sorted(path for path in ATTACKS.iterdir() if path.is_dir() and path.name[0] != "_")


@dataclass(frozen=True)
class Attack:
    """One attack: a file, and what must come of it.

    Attributes:
        file: with the code.
        verdicts: by the name of the function; "" where the file is a program.
        options, beside, signal, says, quick: see above.
    """

    file: Path
    verdicts: dict[str, str]
    options: list[str]
    beside: list[str] = field(default_factory=list)
    signal: str = ""
    says: str = ""
    quick: int = 0

    @property
    def name(self):
        return f"{self.file.parent.name}/{self.file.stem}"


def attack_of(file):
    """The attack that a file describes."""
    said = _said(file.read_text(encoding="utf-8"), in_c=file.suffix == ".c")
    *_, last = said.split("\n\n")
    lines = dict(re.fullmatch(r"([\w. ]+): (.*)", line).groups() for line in last.splitlines())
    verdicts = {}
    for key in [key for key in lines if key.startswith("verdict")]:
        function = key.removeprefix("verdict").removeprefix(" of ") or "explore"
        verdicts[function] = lines.pop(key)
    if lines.pop("as", "") == "exec":
        verdicts = {"": verdicts.pop("explore")}
    options = lines.pop("options", "--edges 2").split()
    beside = lines.pop("beside", "").split()
    quick = int(lines.pop("quick", 0))
    return Attack(file, verdicts, options, beside, quick=quick, **lines)


def _said(text, *, in_c):
    if not in_c:
        return ast.get_docstring(ast.parse(text))
    comment = text.partition("/*")[2].partition("*/")[0]
    return "\n".join(re.sub(r"^ \* ?", "", line).strip() for line in comment.strip().splitlines())


def attacks():
    """Every attack."""
    files = [file for kind in KINDS for file in sorted([*kind.glob("*.py"), *kind.glob("*.c")])]
    return [attack_of(file) for file in files]
