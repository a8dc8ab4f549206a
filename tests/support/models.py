"""Texts of lighthouses of one's own, for tests that put them into files."""

PARITY = '''
from dataclasses import dataclass

from allworlds import Lighthouse, Percept


@dataclass(frozen=True)
class Parity(Lighthouse):
    dart: int
    modulus: int = 2

    @classmethod
    def places(cls, map_, start):
        for bearing in range(map_.degree_at[start]):
            yield cls(map_.turn(start, bearing))

    def sensed(self, map_, here):
        if map_.vertex_of[here] != map_.vertex_of[self.dart]:
            return Percept(map_.degree_at[here])
        return Percept(map_.degree_at[here], 1, map_.offset(here, self.dart) % self.modulus)


def parity(modulus):
    return type("Other", (Parity,), {"modulus": modulus, "__annotations__": {"modulus": int}})


def forgets(modulus):
    return type("Other", (Parity,), {"modulus": modulus})


@dataclass(frozen=True)
class Copy(Lighthouse):
    """Position, written once more."""

    dart: int
    gives_bearings = False
    leaves_open = True

    @classmethod
    def places(cls, map_, start):
        yield cls(start)

    def check(self, map_, start):
        pass

    def sensed(self, map_, here):
        return Percept(map_.degree_at[here], int(map_.vertex_of[here] == map_.vertex_of[self.dart]))
'''
