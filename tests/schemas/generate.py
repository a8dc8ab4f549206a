"""Write what is made from tables.

``python tests/schemas/generate.py`` writes the names of the verbs in the package's
``__init__.py`` anew; ``test_generated.py`` compares.
"""

from __future__ import annotations

from pathlib import Path

from allworlds.verbs import VERBS

ROOT = Path(__file__).parents[2]
PACKAGE = ROOT / "src" / "allworlds" / "__init__.py"


def package_text(source: str) -> str:
    """The package's door, with the function of every verb that it does not name yet."""
    lines = source.splitlines(keepends=True)
    for verb in VERBS:
        module, _, name = verb.function.partition(":")
        if verb.python.count(".") == 1 and f" {name} as {name}" not in source:
            begin = lines.index("if TYPE_CHECKING:\n") + 1
            line = f"    from allworlds.{module} import {name} as {name}\n"
            tails = (
                i for i in range(begin, len(lines)) if lines[i] > line or lines[i] == "else:\n"
            )
            lines.insert(next(tails), line)
    return "".join(lines)


def main() -> None:
    """Write everything anew."""
    PACKAGE.write_text(package_text(PACKAGE.read_text("utf-8")), "utf-8")


if __name__ == "__main__":
    main()
