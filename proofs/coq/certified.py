"""Ask Coq's kernel, and programs extracted from proofs, about an explorer; or compare programs.

    python proofs/coq/certified.py --verify FILE.v EXPLORER [--edges 4] [--against EXPLORER]

has ``coqc`` judge a certificate that someone else has written; it needs no package
(``certificate_file.py``).

    python proofs/coq/certified.py --certificate FILE.v (EXPLORER | --exec 'COMMAND') [--edges 4]

writes what an explorer does into a file that Coq's kernel checks; ``--check FILE.v`` has ``coqc``
check a file that was written so (``certified_trees.py``).

    python proofs/coq/certified.py --exec 'COMMAND' [--edges 4] [--limit paper] [--universe all]

asks the certified checker whether a program is right (``certified_checker.py``).

    python proofs/coq/certified.py [--edges 4] ...

compares the extracted programs with the package, in every world (``certified_programs.py``), and

    python proofs/coq/certified.py --sample [RUNS] [--units 51] [--seed 0]

in a sample of larger ones (``certified_sample.py``).  The last three need the programs that
``make -C proofs/coq explorer`` builds.  ``--help`` behind any of these words says more.  Exit code
1: refused, or different; 2: bad arguments, or something is missing; 3: it could not be decided, and
a line says why.
"""

from __future__ import annotations

import sys


def main() -> int:
    """Do what the first of the options asks for."""
    arguments = sys.argv[1:]
    asked = {word.split("=")[0] for word in arguments}
    if "--verify" in asked:
        from certificate_file import verify

        return verify(arguments)
    if asked & {"--certificate", "--check"}:
        from certified_trees import write_certificate

        return write_certificate(arguments)
    import certified_programs

    if "--sample" in asked:
        from certified_sample import compare_sample

        return 2 if certified_programs.missing() else compare_sample(arguments)
    if "--exec" in asked:
        from certified_checker import judge_program

        return 2 if certified_programs.missing() else judge_program(arguments)
    return certified_programs.main()


if __name__ == "__main__":
    sys.exit(main())
