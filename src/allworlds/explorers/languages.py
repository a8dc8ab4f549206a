"""The languages of the skeletons: the files of each skeleton, and the commands that try them.

A *skeleton* is a set of files with an explorer that builds and runs, but gives wrong answers.  The
files for a language are in the folder of the language's name in ``skeletons``; their names end in
``.template``.
"""

from pathlib import Path

from msgspec import Struct

SKELETONS = Path(__file__).with_name("skeletons")
SUFFIX = ".template"


class Language(Struct, frozen=True):
    """A programming language, with the commands that try an explorer in the explorer's folder.

    Attributes:
        explorer: the name of the file with the explorer.
        check: the command that builds the explorer, if necessary, and checks the explorer.
        test: the command that runs the explorer's test.
        needs: the programs that these commands need besides ``allworlds``.
    """

    explorer: str
    check: str
    test: str
    needs: tuple[str, ...] = ()


LANGUAGES = {
    "python": Language(
        "explorer.py", "allworlds check explorer.py:explore --edges 4", "python -m pytest"
    ),
    "javascript": Language(
        "explorer.js", "allworlds check --exec 'node explorer.js' --edges 4", "npm test", ("node",)
    ),
    "c": Language(
        "explorer.c",
        "make && allworlds check --native ./explorer.so --edges 4",
        "make test",
        ("cc", "make"),
    ),
    "rust": Language(
        "explorer.rs",
        "make && allworlds check --native ./explorer.so --edges 4",
        "make test",
        ("rustc", "make"),
    ),
}
"""The languages with a skeleton, by their names on the command line."""


def templates(folder: Path) -> dict[str, str]:
    """The text of each file of the skeleton in ``folder``, by the file's path in it, sorted.

    The paths are those of the files to write, without ``.template``.
    """
    return {
        file.relative_to(folder).as_posix().removesuffix(SUFFIX): file.read_text(encoding="utf-8")
        for file in sorted(folder.rglob(f"*{SUFFIX}"))
    }
