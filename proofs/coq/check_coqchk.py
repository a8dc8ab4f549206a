"""Checks the compiled files with coqchk; exit 1 unless it accepts them and reports no axiom.

Usage: check_coqchk.py FILE.v ...   (in the folder of the compiled files; files of another folder
that _CoqProject names may be among them)
"""

import pathlib
import subprocess
import sys

from check_assumptions import libraries

MUST_BE_NONE = (
    "Axioms",
    "Constants/Inductives relying on type-in-type",
    "Constants/Inductives relying on unsafe (co)fixpoints",
    "Inductives whose positivity is assumed",
)


def main() -> int:
    """The exit code."""
    known = libraries()
    paths = map(pathlib.Path, sys.argv[1:])
    modules = [f"{known[str(path.parent)]}.{path.stem}" for path in paths]
    folders = [word for pair in known.items() for word in ("-Q", *pair)]
    # PlanarMinimality.v needs the virtual machine, which coqc has used too.
    options = ["-silent", "-o", "-bytecode-compiler", "yes", *folders]
    command = ["coqchk", *options, *modules]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    report = run.stdout + run.stderr
    print(report.strip())
    lines = [line.strip() for line in report.split("\n")]
    missing = [what for what in MUST_BE_NONE if f"* {what}: <none>" not in lines]
    if run.returncode or missing:
        print(f"coqchk: exit {run.returncode}; not none: {', '.join(missing) or '-'}")
        return 1
    print(f"coqchk: {len(modules)} files accepted, no axiom")
    return 0


if __name__ == "__main__":
    sys.exit(main())
