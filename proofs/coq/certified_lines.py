"""Compare how the extracted checker and ``allworlds check`` read what a program writes.

    python proofs/coq/certified_lines.py [NAME ...]

has both judge every program of ``odd_program.py``: the verdict must be the one that
stands there, with the law that is broken, from both.  Where the extracted checker reads more
strictly than Python does, that stands there, too.  Exit code 1: another verdict; 2: there is no
program of a name; 3: undecided.
"""

from __future__ import annotations

import shlex
import subprocess
import sys
from collections.abc import Mapping
from functools import partial
from pathlib import Path
from typing import Any

from certified_checker import LAWS, asked, check, outcome
from odd_program import ODD, Odd

HERE = Path(__file__).resolve().parent
PROGRAM = HERE / "odd_program.py"
SECONDS = 5.0
"""How long an answer may take, also where it is long."""


def command(name: str) -> list[str]:
    """The command that serves an odd program."""
    return [sys.executable, "-S", "-E", str(PROGRAM), name]


def by_the_package(name: str, seconds: float) -> str:
    """The law that ``allworlds check`` finds broken; '' if it holds."""
    subject = f"exec:{shlex.join(command(name))}"
    report = check(subject, edges=1, laws=LAWS, workers=1, answer_timeout=seconds)
    found = report.uninterrupted()
    return found.findings[0].law if found.findings else ""


def by_the_certified(name: str, seconds: float) -> str:
    """The law that the certified checker finds broken; '' if it holds."""
    explorer = ["--exec", *command(name)]
    answer: dict[str, Any] = asked(1, explorer, subprocess.DEVNULL, timeout=seconds)
    if answer["verdict"] != "refuted":
        return "" if answer["verdict"] == "holds" else str(answer["verdict"])
    worst = answer["refutations"][0]
    return str(worst.get("fault", worst["finding"]))


def laws_of(name: str, odd: Odd) -> tuple[str, str]:
    """The laws that the package and the certified checker find broken by an odd program."""
    seconds = 0.5 if odd.silent == "waits" else SECONDS
    return by_the_package(name, seconds), by_the_certified(name, seconds)


def lines_agree(odd_programs: Mapping[str, Odd]) -> bool:
    """Whether both say of every odd program what is to be said of it."""
    apart = []
    for name, odd in odd_programs.items():
        if (found := laws_of(name, odd)) != odd.laws:
            apart.append(name)
            print(f"  {name}: {found}, not {odd.laws}")
    stricter = sum(odd.law == "" and odd.certified is not None for odd in odd_programs.values())
    print(
        f"certified checker, {len(odd_programs)} odd programs: {len(apart)} judged otherwise than "
        f"they should; {stricter} are read more strictly than by Python"
    )
    return bool(odd_programs) and not apart


def main() -> int:
    """Compare the programs that are named, or all."""
    names = sys.argv[1:] or list(ODD)
    if unknown := [name for name in names if name not in ODD]:
        print(f"there is no odd program {unknown[0]!r}", file=sys.stderr)
        return 2
    return outcome(partial(lines_agree, {name: ODD[name] for name in names}))


if __name__ == "__main__":
    sys.exit(main())
