"""What the robot senses."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from allworlds import documents


@dataclass(frozen=True, slots=True)
class Percept:
    """All that is sensed at a vertex.

    Attributes:
        degree: the number of darts of the vertex, at least 1.
        marks: how many markers lie here.
        bearing: the offset from the dart arrived by to the pointed dart, clockwise, in
            ``0..degree-1``; None where no direction is sensed.
    """

    degree: int
    marks: int = 0
    bearing: int | None = None

    def marked(self, markers: int) -> Percept:
        """The same with so many markers more."""
        return Percept(self.degree, self.marks + markers, self.bearing) if markers else self

    def __reduce__(self) -> tuple[type[Percept], tuple[int, int, int | None]]:
        """Pickled so several times faster than a frozen dataclass is by itself."""
        return Percept, (self.degree, self.marks, self.bearing)

    def __str__(self) -> str:
        """For example ``degree 3, marked, bearing 2``."""
        marks = {0: "", 1: ", marked"}.get(self.marks, f", {self.marks} marks")
        bearing = "" if self.bearing is None else f", bearing {self.bearing}"
        return f"degree {self.degree}{marks}{bearing}"

    def to_json(self) -> documents.PerceptDocument:
        """``{"degree", "marks", "bearing"}``."""
        return {"degree": self.degree, "marks": self.marks, "bearing": self.bearing}
