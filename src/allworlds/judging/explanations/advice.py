"""The likely causes of faults.

Patterns are searched in the ``seen`` of a finding: the text that says what the explorer did.
"""

import re

from allworlds.explorers.loading import is_library, is_program
from allworlds.judging.findings.finding import Finding

MEMORY = re.compile(r"\(signal (7|8|11)\)")
"""The pattern for the end of a process by SIGBUS, SIGFPE or SIGSEGV."""

SANITIZER = (
    "The usual cause is an access outside an array, or to freed memory, perhaps long before the "
    "end. To see the line, compile with -g -fsanitize=address,undefined."
)
"""The advice for a process that a signal of :data:`MEMORY` has ended."""

STDOUT = "The program's stdout is for its actions alone: print output for debugging to stderr."
"""The advice for a program that prints something else, or prints outside its turn."""

NO_LINE = (
    (r"\\x00", "The line is text in UTF-16: a program must set its stdout to UTF-8."),
    (
        r"no JSON: '\s*(\\[nrt]|\s)*'$",
        "That is a blank line: print one line for each message, and no line between messages.",
    ),
    (
        r"no JSON: '\s*[{\[][^}]*'$",
        "That is only the beginning of an object: print each message without a line break in it.",
    ),
    (r"the line \{\}", "Was the value undefined: is a 'return' missing, or has a generator ended?"),
)
"""The advice for a program that has printed a line which is no message: pairs of a pattern in the
finding's ``seen``, and a sentence."""

FLUSH = (
    "Does the program print a newline after every line, and then flush its output? A line is read "
    "only after both."
)
"""The advice for a program that is silent."""

KEPT = (
    "Does the explorer keep something from an earlier run: a global or static variable, or a field "
    "that is not reset when an episode begins? Does it depend on chance, on time or on addresses?"
)
"""The questions about an explorer whose plays differ."""


UNWRITTEN = (
    "Does the library read memory that was never written? To find the line, compile the library "
    "with -g; write 'valgrind -q --trace-children=yes --track-origins=yes' before the command "
    "below, and '--start-timeout 600 --answer-timeout 600' after the command. To find a read of "
    "freed memory sooner, compile the library with -fsanitize=address,undefined and set "
    "LD_PRELOAD=$(gcc -print-file-name=libasan.so)."
)
"""A further question about a shared library, which tells how to find the line."""


def advice(finding: Finding) -> list[str]:
    """The likely causes of the fault in a finding; an empty list if none is known.

    The causes of one fault are told in one text of a few sentences, or in two such texts.
    """
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
