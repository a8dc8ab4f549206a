"""Compares the rooted maps enumerated in Coq with those of the Python enumerator, map by map.

    make -C proofs/coq Enumeration.vo
    PYTHONPATH=src python proofs/coq/compare_enumeration.py [M]
    PYTHONPATH=src python proofs/coq/compare_enumeration.py M --list FILE

For m = 1..M (default 5) Coq computes ``rooted_maps m`` of Enumeration.v, where it is proved
complete and free of repeats.  Its members are the canonical codes (sigma, alpha), root 0.  The
Python side is ``allworlds.maps.enumeration.rooted_maps``, each map as its ``rooted_code``.  Both
must hold the same codes, each once.  With ``--list`` the file holds what Coq printed for M.

Ends with status 1, and names a code that only one side has, if they differ; with 2 if the
package is not there.
"""

from __future__ import annotations

import importlib.util
import re
import subprocess
import sys
import tempfile
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

HERE = Path(__file__).resolve().parent

Code = tuple[tuple[int, ...], tuple[int, ...]]

PRINT = """From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Enumeration.
Set Printing Depth 10000000.
Set Printing Width 10000000.
Eval vm_compute in [seq (sigma_list M, alpha_list M) | M <- rooted_maps {edges}].
"""

PAIR = re.compile(r"\(\[::([^\]]*)\],\s*\[::([^\]]*)\]\)")

PYTHON = """
import sys
from allworlds.maps.combinatorial import rooted_code
from allworlds.maps.enumeration import rooted_maps
for found in rooted_maps(int(sys.argv[1])):
    sigma, alpha = rooted_code(found.sigma, found.alpha, 0)
    print(*sigma, ";", *alpha)
"""


def printed_by_coq(edges: int) -> str:
    """The output of Coq for ``rooted_maps edges``.

    Raises:
        subprocess.CalledProcessError: if Coq refuses; Enumeration.vo must have been built.
    """
    with tempfile.TemporaryDirectory() as folder:
        source = Path(folder) / "printed.v"
        source.write_text(PRINT.format(edges=edges))
        flags = ["-w", "-notation-overridden", "-Q", str(HERE), "Allworlds"]
        command = [str(HERE / "limit"), "300", "coqc", *flags, str(source)]
        return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def coq_codes(text: str, edges: int) -> Iterator[Code]:
    """The codes in what Coq printed.

    Raises:
        ValueError: if the text holds anything but a list of codes of ``edges`` edges.
    """
    value = text.rpartition("\n     : ")[0]
    rest = PAIR.sub("", value).replace("= [::", "").strip(" ;\n]")
    if not value or rest:
        raise ValueError(f"not a list of codes: {(rest or text)[:80]!r}")
    for sigma, alpha in PAIR.findall(value):
        code = (_numbers(sigma, ";"), _numbers(alpha, ";"))
        if any(len(part) != 2 * edges for part in code):
            raise ValueError(f"not a code of a map with {edges} edges: {code}")
        yield code


def python_codes(edges: int) -> Iterator[Code]:
    """The codes of the Python enumerator, computed in a process of its own."""
    command = [sys.executable, "-c", PYTHON, str(edges)]
    text = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout
    for line in text.splitlines():
        sigma, alpha = line.split(";")
        yield _numbers(sigma, None), _numbers(alpha, None)


def difference(edges: int, coq: Counter[Code], python: Counter[Code]) -> str | None:
    """A sentence that names one code on which the two lists differ, or None."""
    for name, one, other in (("Coq", coq, python), ("Python", python, coq)):
        for code, times in one.items():
            if times != 1:
                return f"m = {edges}: {name} lists {code} {times} times"
            if code not in other:
                return f"m = {edges}: only {name} lists {code}"
    return None


def _numbers(text: str, separator: str | None) -> tuple[int, ...]:
    return tuple(int(number) for number in text.split(separator))


def main(arguments: list[str]) -> int:
    """Compares, and prints one line for each number of edges.  Returns the exit status."""
    if importlib.util.find_spec("allworlds") is None:
        print(f"{sys.executable} lacks the package allworlds: make enumeration PYTHON=...")
        return 2
    listed = None
    if "--list" in arguments:
        at = arguments.index("--list")
        listed = Path(arguments[at + 1]).read_text()
        arguments = arguments[:at] + arguments[at + 2 :]
    most = int(arguments[0]) if arguments else 5
    for edges in [most] if listed is not None else range(1, most + 1):
        text = printed_by_coq(edges) if listed is None else listed
        coq = Counter(coq_codes(text, edges))
        python = Counter(python_codes(edges))
        differs = difference(edges, coq, python)
        if differs or not coq:
            print(differs or f"m = {edges}: Coq lists no map")
            return 1
        print(f"m = {edges}: {len(coq)} rooted maps, the same in Coq and in Python")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
