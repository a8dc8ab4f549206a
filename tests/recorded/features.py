"""A sensor that tells three kinds of darts apart."""

from dataclasses import dataclass

from allworlds import Lighthouse, Percept


@dataclass(frozen=True)
class Ends(Lighthouse):
    dart: int
    features = ("away", "behind", "door")

    @classmethod
    def places(cls, map_, start):
        for bearing in range(map_.degree_at[start]):
            yield cls(map_.turn(start, bearing))

    def sensed(self, map_, here):
        ends = (map_.alpha[self.dart], self.dart)
        return Percept(map_.degree_at[here], 1 + ends.index(here) if here in ends else 0)
