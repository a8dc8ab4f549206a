"""The likely causes of each kind of fault."""

import re

from allworlds.explorers.loading import is_library, is_program
from allworlds.judging.findings.finding import Finding

MEMORY = re.compile(r"\(signal (7|8|11)\)")
"""The words for the end of a process by SIGBUS, SIGFPE or SIGSEGV."""

SANITIZER = (
    "Mostly the cause is an access outside of an array, or to memory that was freed, perhaps long "
    "before: compile with -g -fsanitize=address,undefined to see the line."
)
"""The advice for a process that a signal of :data:`MEMORY` has ended."""

STDOUT = (
    "The program's stdout is for its actions alone: output for debugging goes to stderr. If the "
    "line is {}, was a value undefined: a return that was forgotten, or an ended generator?"
)
"""The advice for a program that prints something else, or prints outside its turn."""

NO_LINE = (
    (
        r"\\x00",
        "The line is text in UTF-16: a program must set its stdout to UTF-8.",
    ),
    (
        r"no JSON: '\s*(\\[nrt]|\s)*'$",
        "That is a blank line: each message is one line, and nothing stands between two.",
    ),
    (
        r"no JSON: '\s*[{\[][^}]*'$",
        "That is the beginning of an object: each message is one line, without a break in it.",
    ),
)
"""The advice for a program that has printed a line which is no message: for each pattern in the
observation, a sentence."""

FLUSH = (
    "Does every line of the program end in a newline, and does the program flush its output after "
    "every line? Until then the line is not read."
)
"""The advice for a program that is silent."""

KEPT = (
    "Does it keep something from an earlier run: a global or static variable, or a field that is "
    "not reset when an episode begins? Does it depend on chance, on time or on addresses?"
)
"""The questions about an explorer whose plays differ."""


UNWRITTEN = (
    "Does it read memory that was never written? To find the line, compile it with -g, write "
    "'valgrind -q --trace-children=yes --track-origins=yes' before the command below, and "
    "'--start-timeout 600 --answer-timeout 600' after it. To find a read of freed memory sooner, "
    "compile it with -fsanitize=address,undefined and set "
    "LD_PRELOAD=$(gcc -print-file-name=libasan.so)."
)
"""A further question about a shared library, which tells how to find the line."""


def advice(finding: Finding) -> list[str]:
    """The likely causes of this fault, each in a sentence; an empty list if none is known."""
    seen = str(finding.seen)
    if finding.law == "crash" and MEMORY.search(seen):
        return [SANITIZER]
    if is_program(finding.explorer):
        if finding.law == "timeout":
            return [FLUSH]
        if finding.law in ("illegal-action", "nondeterministic") and re.search(
            "(a|the) line", seen
        ):
            known = (said for looks, said in NO_LINE if re.search(looks, seen))
            return [next(known, STDOUT)]
    if finding.law != "nondeterministic":
        return []
    return [KEPT, UNWRITTEN] if is_library(finding.explorer) else [KEPT]
