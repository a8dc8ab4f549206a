"""Checks what ``allworlds ambiguity sensors`` and ``weakest`` write, without the package.

    allworlds ambiguity sensors position word:12 --edges 4 -o twins.json
    python proofs/certificates/sensor_twins.py twins.json

Each two worlds must be different, starts included, and look alike: darts of one class sense the
same, and sigma and alpha lead from them to darts of one class.  What is sensed there is computed
here, from the name of the sensor (``sensed.py``), or for a finest one from those of its features.
With that all worlds with at most 4 edges are made (``sensor_worlds.py``), and every other word of
the document is compared with them: which sensors suffice, where they first fail, the numbers,
which are coarser, which are minimal.

What cannot be known here is not verified, and a line says so (``not checked: stated``): what a
sensor of a user's own shows, larger worlds, conditions on maps, how often the producer tried.
Prints a line for each row, and ``VERIFIED`` (exit code 0), which is said of all other words, or
``REFUSED: ...`` (1) with the row; 2: there is no such file.
"""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from itertools import permutations
from pathlib import Path
from typing import Any

from documents import integers, once
from lrat import Refused
from maps import Map, code, orbit, require_map
from sensed import FEATURES, Lighthouse, Percept, features_in, known
from sensor_worlds import (
    FinestWorlds,
    Letters,
    Scope,
    Worlds,
    follows,
    is_coarser,
    lower_neighbours,
    partitions,
    scope_of,
)

UNCHECKED = "not checked: stated"
MOST_FEATURES = 8
FORM = (ValueError, KeyError, IndexError, TypeError, AttributeError)
"""What happens where a document has not the form that is expected."""

Shows = Callable[[Any, Map, int], "tuple[list[Percept], Any] | None"]
"""What a sensor shows in a world of a document, and tells; None: it is not known here."""


@contextmanager
def naming(what: str) -> Iterator[None]:
    """Let every refusal name the part of the document of which it speaks."""
    try:
        yield
    except Refused as error:
        raise Refused(f"{what}: {error}") from None
    except FORM as error:
        raise Refused(f"{what}: not of the form that is expected: {error!r}") from None


def require_keys(value: Any, needed: str, more: str = "") -> None:
    """Raise Refused unless a value is an object with these keys, perhaps with more of those."""
    if not isinstance(value, dict):
        raise Refused(f"{value!r:.50} is no object")
    for name in needed.split():
        if name not in value:
            raise Refused(f"there is no {name}")
    if others := [*{*value} - {*needed.split(), *more.split()}]:
        raise Refused(f"{others[0]!r:.50} is no key that is known")


def require_lists(document: Any, names: str) -> None:
    """Raise Refused unless an object has lists under these keys."""
    for name in names.split():
        if not isinstance(document[name], list):
            raise Refused(f"{name} is {document[name]!r:.50}, not a list")


def require(what: str, said: Any, due: Any) -> None:
    """Raise Refused unless a value is the one that is due, and of its type."""
    if type(said) is not type(due) or said != due:
        raise Refused(f"{what} is {said!r:.100}, not {due!r:.100}")


def natural(value: Any, what: str, least: int = 0) -> int:
    """The value, if it is an integer from the least one on."""
    if type(value) is not int or value < least:
        raise Refused(f"{what} is {value!r:.50}, not an integer from {least} on")
    return value


# ---- Two worlds ----


def check_pair(pair: Any, shows: Shows, scope: Scope) -> tuple[str, int]:
    """Verify two worlds, and return their sizes in words, and the larger number of edges.

    Raises:
        Refused: saying what is wrong.
    """
    require_keys(pair, "worlds sensed bisimulation")
    columns = [pair[name] for name in ("worlds", "sensed", "bisimulation")]
    if any(len(column) != 2 for column in columns):
        raise Refused("not two worlds with what is sensed in them and their classes")
    facts: dict[int, Any] = {}
    codes, starts, sizes, heard = [], [], [], []
    for world, percepts, classes in zip(*columns, strict=True):
        require_keys(world, "sigma alpha start lighthouse")
        map_ = integers(world["sigma"], "sigma"), integers(world["alpha"], "alpha")
        sigma, alpha = map_
        require_map(sigma, alpha)
        scope.require(map_)
        start = natural(world["start"], "the start")
        seen = [percept_of(one) for one in percepts]
        if not len(seen) == len(integers(classes, "the classes")) == len(sigma) > start:
            raise Refused("a world has not one class and percept for each dart, or no start")
        shown = shows(world["lighthouse"], map_, start)
        if shown is not None and shown[0] != seen:
            raise Refused("the sensor shows something else than what is sensed")
        heard.append(shown and shown[1])
        for dart, percept in enumerate(seen):
            if percept[0] != len(orbit(sigma, dart)):
                raise Refused(f"dart {dart} has not the degree {percept[0]}")
            fact = (percept, classes[sigma[dart]], classes[alpha[dart]])
            if facts.setdefault(classes[dart], fact) != fact:
                raise Refused(f"dart {dart} does not behave as its class {classes[dart]}")
        codes.append(code(sigma, alpha, start))
        starts.append(classes[start])
        sizes.append(len(sigma) // 2)
    if starts[0] != starts[1]:
        raise Refused("the starts are in different classes")
    if codes[0] == codes[1]:
        raise Refused("the two worlds are the same, start included")
    if heard[0] != heard[1]:
        raise Refused("the robot is told something else in each")
    return f"alike: m = {sizes[0]} and m = {sizes[1]}", max(sizes)


def percept_of(value: Any) -> Percept:
    """The percept at a dart, as a document has it."""
    require_keys(value, "degree marks bearing")
    bearing = value["bearing"]
    sensed = natural(value["degree"], "a degree", 1), natural(value["marks"], "the marks")
    return (*sensed, None if bearing is None else natural(bearing, "a bearing"))


def shown_by(lighthouse: Lighthouse) -> Shows:
    """The percepts of a lighthouse that is known here, at a place where it may stand."""

    def shows(document: Any, map_: Map, start: int) -> tuple[list[Percept], Any]:
        place = lighthouse.place_in(document)
        legal = lighthouse.places(map_, start)
        names = [sorted(part) for part in place]
        if not any(names == [sorted(part) for part in each] for each in legal):
            raise Refused("a lighthouse has not the place that its kind has")
        for part in place:
            for where in part.values():
                darts = integers(where if isinstance(where, list) else [where], "a place")
                if any(not 0 <= dart < len(map_[0]) for dart in darts):
                    raise Refused(f"a lighthouse stands at {where}, which is no dart")
        shown = lighthouse.shown(map_, place)
        if shown not in [lighthouse.shown(map_, each) for each in legal]:
            raise Refused(f"the lighthouse cannot stand at {place} where the start is {start}")
        return shown

    return shows


@dataclass
class OwnSensors:
    """Sensors of a user's own, of which the name, the options and one text of the code are known.

    Attributes:
        digests: by their kinds.
    """

    digests: dict[str, Any] = field(default_factory=dict)

    def require(self, document: Any, name: str) -> None:
        """Raise Refused unless the lighthouse of a world is the one of that name."""
        plain, _, asked = name.partition("?")
        if "+" in name:  # its parts are not looked at
            kinds = [
                re.split("[?:]" if known(each) else "[?]", each)[0] for each in name.split("+")
            ]
            require("the kind of a lighthouse", document["kind"], "+".join(kinds))
            return
        require("the kind of a lighthouse", document["kind"], plain)
        for item in filter(None, asked.split(",")):
            key, _, value = item.partition("=")
            said = document["options"][key]
            written = str(said).lower() if isinstance(said, bool) else str(said)
            require(f"the option {key} of a lighthouse", written, value)
        first = self.digests.setdefault(plain, document.get("digest"))
        require(f"the digest of {plain}", document.get("digest"), first)

    def shown_by(self, name: str) -> Shows:
        """Return a function that knows nothing of the sensor of that name, and refuses others.

        Raises:
            Refused: if none can have it.
        """
        for part in name.split("+"):
            if not known(part) and not re.fullmatch(r"[^:?]+:[^\W\d]\w*(\?.*)?", part):
                raise Refused(f"{part!r:.50} is no kind that is known, nor FILE.py:Class")

        def shows(document: Any, map_: Map, start: int) -> None:  # noqa: ARG001  # not known
            self.require(document, name)

        return shows


# ---- Sensors side by side ----


class Compared:
    """The report of ``ambiguity sensors``."""

    def __init__(self, document: Any) -> None:
        with naming("the document"):
            require_keys(
                document, "schema scope rows dominates coarser minimal exit_code", "made_by"
            )
            require_lists(document, "rows dominates coarser minimal")
        with naming("scope"):
            self.scope = scope_of(document["scope"])
        self.document, self.own = document, OwnSensors()
        self.rows: list[Any] = document["rows"]
        self.worlds: dict[int, Worlds] = {}

    def lines(self) -> list[str]:
        """Verify all, and return a line for each row, and one for all of them together."""
        found = []
        for i, row in enumerate(self.rows):
            name = row.get("lighthouse") if isinstance(row, dict) else None
            with naming(f"row {i}, {name}" if isinstance(name, str) else f"row {i}"):
                found.append(f"{name}: {self._row(i, row)}")
        made = self.worlds and self.scope.furthest
        if not made and not any(row["sufficient"] is False for row in self.rows):
            raise Refused("there are no two worlds that look alike, so there is nothing to verify")
        return [*found, self._beside()]

    def _row(self, i: int, row: Any) -> str:
        need = "lighthouse sufficient first ambiguous worlds places"
        require_keys(row, need, "twins tried")
        name = row["lighthouse"]
        if name in [each["lighthouse"] for each in self.rows[:i]]:
            raise Refused("the sensor has a row before")
        self._numbers(i, row)
        said = []
        lighthouse = known(name)
        shows = shown_by(lighthouse) if lighthouse else self.own.shown_by(name)
        if row["sufficient"] is False:
            words, edges = check_pair(row["twins"], shows, self.scope)
            require("first, by the two worlds,", row["first"], edges)
            said.append(words if lighthouse else f"{words}, sensed as the file says")
        unknown = self._in_all_worlds(i, row, lighthouse) if lighthouse else ""
        if lighthouse is None:
            unknown = "what it shows and where it stands, so sufficient, first, ambiguous, worlds"
            unknown += ", places, tried"
        elif row["sufficient"] and self.scope.furthest:
            said.append(f"no two worlds with m <= {self.scope.furthest} are alike")
        if unknown:
            said.append(f"{UNCHECKED}: {unknown}")
        return "; ".join(said) or "it stands nowhere"

    def _numbers(self, i: int, row: Any) -> None:
        """Require that the numbers of a row go together."""
        worlds = natural(row["worlds"], "worlds")
        ambiguous, at = natural(row["ambiguous"], "ambiguous"), natural(row["places"], "places")
        due = None if worlds == 0 else ambiguous == 0
        if row["sufficient"] is not due:
            said = f"{worlds} worlds, and {ambiguous} rooted maps that look like another one"
            raise Refused(f"sufficient is {row['sufficient']!r:.50} with {said}")
        if (row["sufficient"] is False) != (row.get("twins") is not None):
            raise Refused("two worlds look alike just where it does not suffice")
        if due is False:
            natural(row["first"], "first", 1)
            if not 2 <= ambiguous <= worlds or row["first"] > self.scope.edges:
                raise Refused(f"ambiguous is {ambiguous} and first {row['first']}")
        else:
            require("first", row["first"], None)
        if at > i or self.rows[at]["places"] != at:
            raise Refused(f"places is {at}, which is not the first row with the same places")
        require(
            f"worlds, as those of row {at} with the same places,", worlds, self.rows[at]["worlds"]
        )

    def _in_all_worlds(self, i: int, row: Any, lighthouse: Lighthouse) -> str:
        """Compare a row with all worlds that are made, and return what they leave open."""
        scope = self.scope
        found = self.worlds[i] = Worlds.under(lighthouse, scope)
        first, ambiguous = found.alike()
        if first or scope.whole:
            require("first", row["first"], first)
            require("ambiguous", row["ambiguous"], ambiguous)
        elif row["first"] is not None and row["first"] <= scope.furthest:
            raise Refused(f"first is {row['first']}, but no two worlds of that size look alike")
        alike = [j for j, other in self.worlds.items() if other.places == found.places]
        if scope.whole:
            require("worlds", row["worlds"], len(found.places))
            first_of = self.rows[alike[0]]["places"]
            require("places", row["places"], first_of)
            if first_of in self.worlds and first_of not in alike:
                raise Refused(f"places is {first_of}, but those of that row are others")
            compass = "compass" in [part.kind for part in lighthouse.parts] and scope.edges > 3
            tried = TRIED_COMPASS if compass else None
            require("tried", row.get("tried"), tried)
            return "" if first_of in self.worlds else "places"
        if row["worlds"] < len(found.places):
            raise Refused(
                f"worlds is {row['worlds']}, but there are {len(found.places)} small ones"
            )
        beyond = f"worlds beyond m = {scope.furthest}" if scope.furthest else "all worlds"
        names = "worlds, places, tried" if first else "sufficient, first, ambiguous, worlds, places"
        return f"{names} of {beyond}"

    def _beside(self) -> str:
        """Compare the order of the sensors with all worlds, and return what that leaves open."""
        names = [row["lighthouse"] for row in self.rows]
        orders = {}
        beside = [
            (a, b)
            for a, b in permutations(range(len(names)), 2)
            if self.rows[a]["places"] == self.rows[b]["places"]
        ]
        for order in ("dominates", "coarser"):
            with naming(order):
                pairs = [tuple(names.index(name) for name in pair) for pair in self.document[order]]
                orders[order] = pairs
                for i, (a, b) in enumerate(pairs):
                    if (a, b) not in beside:
                        raise Refused(f"row {a} has not the places of row {b}")
                    if i and pairs[i - 1] >= (a, b):
                        raise Refused(f"row {a} with row {b}: not in the order of the rows")
                for a, b in beside:
                    self._require_order(order, (a, b), (a, b) in pairs)
        for a, b in orders["coarser"]:
            if (b, a) not in orders["dominates"]:
                raise Refused(f"dominates: row {b} with row {a}, which is coarser: it is not said")
        for a, b in orders["dominates"]:
            if self.rows[b]["sufficient"] and not self.rows[a]["sufficient"]:
                raise Refused(f"dominates: row {b} suffices, so row {a} does, which tells more")
        enough = [i for i, row in enumerate(self.rows) if row["sufficient"]]
        finer = {b for a, b in orders["coarser"] if a in enough and (b, a) not in orders["coarser"]}
        due = [names[i] for i in enough if i not in finer]
        require("minimal", self.document["minimal"], due)
        vacuous = not any(row["worlds"] for row in self.rows)
        require("exit_code", self.document["exit_code"], 4 if vacuous else 0)
        if self.scope.whole and len(self.worlds) == len(names):
            return "dominates, coarser, minimal: as in all these worlds"
        return f"dominates, coarser, minimal: {UNCHECKED}, but where both sensors are known here"

    def _require_order(self, order: str, pair: tuple[int, int], said: bool) -> None:
        """Raise Refused if the worlds that are made refute what is said of two known sensors."""
        if not {*pair} <= self.worlds.keys():
            return
        a, b = (self.worlds[i] for i in pair)
        holds = follows(b.looks, a.looks) if order == "dominates" else follows(a.sensed, b.sensed)
        if said and not holds:
            raise Refused(f"row {pair[0]} with row {pair[1]}: small worlds refute it")
        if holds and not said and self.scope.whole:
            raise Refused(f"row {pair[0]} with row {pair[1]}: so it is, and is not said")


TRIED_COMPASS = (
    "every place up to 3 edges; beyond, the compass at the smallest dart of each vertex alone"
)


# ---- Coarsenings ----


class Coarsened:
    """The report of ``ambiguity weakest``."""

    def __init__(self, document: Any) -> None:
        with naming("the document"):
            names = "schema scope features coarsenings sufficient tried minimal refuted exit_code"
            require_keys(document, names, "made_by")
            require_lists(document, "features minimal refuted")
        with naming("scope"):
            self.scope = scope_of(document["scope"], "finest")
            self.finest: str = document["scope"]["finest"]
            if type(self.finest) is not str:
                raise Refused(f"the finest sensor is {self.finest!r:.50}")
        with naming("features"):
            self.features: list[str] = document["features"]
            texts = all(type(name) is str for name in self.features)
            if not texts or not 0 < len({*self.features}) == len(self.features) <= MOST_FEATURES:
                raise Refused("not some different names")
        self.is_known = {*self.features} <= {*FEATURES}
        self.document, self.own = document, OwnSensors()

    def lines(self) -> list[str]:
        """Verify all, and return a line for each row, and for what is said of all together."""
        document, found = self.document, []
        refuted, minimal = list[Letters](), list[Letters]()
        for i, row in enumerate(document["refuted"]):
            with naming(_named("refuted", i, row)):
                require_keys(row, "letters edges twins")
                refuted.append(letters := self._letters(row))
                words, edges = check_pair(row["twins"], self._shown(letters), self.scope)
                require("edges", row["edges"], edges)
                if letters in refuted[:-1]:
                    raise Refused("it has a row before")
                stated = "" if self.is_known else ", sensed as the file says"
                found.append(f"{row['letters']}: {words}{stated}")
        for i, row in enumerate(document["minimal"]):
            with naming(_named("minimal", i, row)):
                require_keys(row, "letters below")
                minimal.append(letters := self._letters(row))
                for below in (lower := lower_neighbours(letters)):
                    if below not in refuted:
                        raise Refused(f"nothing refutes {self._blocks(below)}, which is coarser")
                require("below", row["below"], [refuted.index(below) for below in lower])
                if any(is_coarser(letters, other) for other in refuted):
                    raise Refused("a sensor that is no coarser does not suffice, so it does not")
                if minimal != sorted({*minimal}, key=lambda each: (max(each), each)):
                    raise Refused(f"not in its order after minimal {i - 1}: fewest letters first")
        if not found:
            raise Refused("there are no two worlds that look alike, so there is nothing to verify")
        return [*found, *self._together(minimal, refuted)]

    def _together(self, minimal: Sequence[Letters], refuted: Sequence[Letters]) -> list[str]:
        """Verify what is said of all coarsenings, and return lines about it."""
        document, every = self.document, partitions(len(self.features))
        below = [each for letters in minimal for each in lower_neighbours(letters)]
        with naming("refuted"):
            require("the list", [*refuted], [*dict.fromkeys(below)])
        enough = {each for each in every if any(is_coarser(one, each) for one in minimal)}
        require("exit_code", document["exit_code"], 0)
        require("coarsenings", document["coarsenings"], len(every))
        require("sufficient, by the minimal ones,", document["sufficient"], len(enough))
        tried = natural(document["tried"], "tried")
        if not len(minimal) <= tried <= len(every):
            raise Refused(f"tried is {tried} with {len(minimal)} minimal ones of {len(every)}")
        stated = ["tried"]
        if self.is_known and self.scope.furthest:
            self._sweep(every, minimal, enough)
        if not self.is_known:
            stated = ["what the finest sensor shows", "that the minimal ones suffice", *stated]
            stated.append("that no others do but those that are finer")
        elif not self.scope.whole:
            stated = [f"that those suffice with more than {self.scope.furthest} edges", *stated]
            stated.append("that no others do")
        known_ones = f"minimal: {len(minimal)}; sufficient: {len(enough)} of {len(every)}"
        return [known_ones, f"{UNCHECKED}: {', '.join(stated)}"]

    def _sweep(
        self, every: Sequence[Letters], minimal: Sequence[Letters], enough: set[Letters]
    ) -> None:
        """Compare with all worlds that are made: who suffices there, and who does not."""
        worlds = FinestWorlds(self.features, self.scope)
        refuted = [letters for one in minimal for letters in lower_neighbours(one)]
        for i, letters in enumerate(minimal):
            with naming(_named("minimal", i, self.document["minimal"][i])):
                if not worlds.suffices(letters):
                    raise Refused("it does not suffice")
        if not self.scope.whole:
            return
        for letters in every:
            lower = any(is_coarser(letters, other) for other in refuted)
            if letters not in enough and not lower and worlds.suffices(letters):
                raise Refused(f"minimal: {self._blocks(letters)} suffices, and is not there")

    def _letters(self, row: Any) -> Letters:
        """For each feature its letter, of a row with its blocks."""
        number = {name: i for i, block in enumerate(row["letters"]) for name in block}
        if {*number} != {*self.features}:
            raise Refused("not the letters of these features")
        letters = tuple(number[name] for name in self.features)
        require("letters", row["letters"], self._blocks(letters))
        if letters not in partitions(len(self.features)):
            raise Refused("letters are not numbered as they come")
        return letters

    def _blocks(self, letters: Letters) -> list[list[str]]:
        """The features, those of one letter together."""
        both = [*zip(letters, self.features, strict=True)]
        return [[name for of, name in both if of == i] for i in range(max(letters) + 1)]

    def _shown(self, letters: Letters) -> Shows:
        def shows(document: Any, map_: Map, start: int) -> tuple[list[Percept], Any] | None:
            self.own.require(document, self.finest)
            if not self.is_known:
                return None
            door = natural(document["dart"], "the door")
            if door not in orbit(map_[0], start):
                raise Refused(f"the door is dart {door}, which is not at v0, where the start is")
            degrees = [len(orbit(map_[0], dart)) for dart in range(len(map_[0]))]
            seen = features_in(map_, door, self.features)
            return [(d, letters[f], None) for d, f in zip(degrees, seen, strict=True)], None

        return shows


def _named(part: str, i: int, row: Any) -> str:
    letters = row.get("letters") if isinstance(row, dict) else None
    return f"{part} {i}, {letters!r:.200}"


# ---- The program ----


def check(document: Any) -> list[str]:
    """Verify a document, and return lines that say of what, and what is not checked.

    Raises:
        Refused: saying what is wrong, and in which row.
    """
    with naming("the document"):
        if not isinstance(document, dict) or ("rows" in document) == ("refuted" in document):
            raise Refused("neither one with rows nor one with refuted sensors")
    if "rows" in document:
        return Compared(document).lines()
    return Coarsened(document).lines()


def main(arguments: list[str]) -> int:
    """A line for each row, the answer, and the exit code."""
    if len(arguments) != 1:
        print("usage: sensor_twins.py TWINS.json", file=sys.stderr)
        return 2
    try:
        text = Path(arguments[0]).read_text(encoding="utf-8")
        print("\n".join(check(json.loads(text, object_pairs_hook=once))))
    except OSError as error:
        print(f"sensor_twins.py: {error.filename}: {error.strerror}", file=sys.stderr)
        return 2
    except Refused as error:
        print(f"REFUSED: {error}")
        return 1
    except (*FORM, RecursionError) as error:
        print(f"REFUSED: the file has not the form that is expected: {error!r}")
        return 1
    print("VERIFIED")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
