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

HEARD = '''
from dataclasses import dataclass

from allworlds import Lighthouse, Percept


@dataclass(frozen=True)
class Words(Lighthouse):
    """The start's vertex is marked; places differ in the word that is told alone."""

    dart: int
    word: int
    gives_bearings = False

    @classmethod
    def places(cls, map_, start):
        for word in range(2):
            yield cls(start, word)

    def sensed(self, map_, here):
        return Percept(map_.degree_at[here], int(map_.vertex_of[here] == map_.vertex_of[self.dart]))

    def told(self, map_):
        return self.word


@dataclass(frozen=True)
class Told(Lighthouse):
    """Nothing is marked; places differ in what is told alone."""

    word: int

    @classmethod
    def places(cls, map_, start):
        yield cls(0)
        yield cls(1)

    def told(self, map_):
        return self.word


@dataclass(frozen=True)
class Neighbour(Lighthouse):
    """Nothing is marked; the degree of a neighbour of the start is told."""

    dart: int

    @classmethod
    def places(cls, map_, start):
        for bearing in range(map_.degree_at[start]):
            yield cls(map_.turn(start, bearing))

    def told(self, map_):
        return {"degree": map_.degree_at[map_.alpha[self.dart]]}


@dataclass(frozen=True)
class Six(Lighthouse):
    """A marked vertex of degree 6, with two of degree 1; the mark stands at the start's dart."""

    dart: int
    gives_bearings = False

    @classmethod
    def places(cls, map_, start):
        if sorted(map_.degrees) == [1, 1, 6] and map_.degree_at[start] == 6:
            yield cls(start)

    def sensed(self, map_, here):
        return Percept(map_.degree_at[here], int(map_.vertex_of[here] == map_.vertex_of[self.dart]))
'''
