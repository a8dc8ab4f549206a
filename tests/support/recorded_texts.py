"""Texts that are made anew and compared with a file each.

``RENEW=1 pytest FILE`` writes the files of these tests anew; what then differs is to be meant, and
told in the commit.
"""

import os


class Texts:
    """The files of a folder, and the functions that make their texts.

    Attributes:
        folder: where the files are, each with the name of its function.
        cases: the functions by their names.
    """

    def __init__(self, folder):
        self.folder, self.cases = folder, {}

    def case(self, make):
        """A function of that name makes the parts of the text of a file, one after another."""
        self.cases[make.__name__] = make
        return make

    def files(self):
        """The names of the files, sorted."""
        return sorted(path.stem for path in self.folder.iterdir())

    def recorded(self, name, made):
        """The text in the file of a case; with ``RENEW`` set, first ``made`` is written there."""
        file = self.folder / f"{name}.txt"
        if "RENEW" in os.environ:
            self.folder.mkdir(exist_ok=True)
            file.write_text(made, encoding="utf-8")
        return file.read_text(encoding="utf-8")
