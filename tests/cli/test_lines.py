"""Lines on stderr: one for each message, never too long, and a notice before a long job."""

import io
import sys

import pytest

from allworlds.cli.output import LONGEST, complain
from allworlds.engines.listeners import Listener
from allworlds.engines.units import tell_of_size
from allworlds.inputs.checks import InputError, show
from allworlds.maps import MapClass
from allworlds.maps.classes import Extent
from allworlds.studies.count import count

LONG = "y" * 5000


@pytest.mark.parametrize(
    "arguments",
    [
        ["check", "--policy", LONG],
        ["check", "--engine", LONG],
        ["check", "--lighthouse", LONG],
        ["check", "--lighthouse", f"cluster:{LONG}={LONG}"],
        ["check", "--schedules", LONG],
        ["check", "--class", LONG],
        ["check", "--laws", LONG],
        ["check", "--bound", LONG],
        ["check", "--bound", f"n+{LONG}"],
        ["check", "--edges", LONG],
        ["check", "--corpus", LONG],
        ["check", "-o", LONG],
        ["check", "--exec", LONG],
        ["check", f"--{LONG}"],
        ["check", f"--{LONG}=3"],
        ["check", LONG],
        ["check", f"{LONG}.py:explore"],
        ["check", "algorithm1", LONG],
        ["run", LONG],
        ["run", "--family", LONG],
        ["run", "algorithm1", LONG, LONG],
        ["replay", LONG],
        ["worst", "--transit", LONG],
        ["ambiguity", "search", "--lighthouse", LONG, "--edges", "1", "--vertices", "1"],
        [LONG],
        ["ambiguity", LONG],
    ],
    ids=lambda arguments: " ".join(arguments).replace(LONG, "LONG"),
)
def test_a_line_is_never_too_long(refused, arguments):
    assert len(refused(*arguments)) <= LONGEST + 1


def test_of_a_line_that_is_too_long_both_ends_are_kept(refused):
    line = refused("check", "--policy", LONG)
    assert line.startswith("allworlds: policy 'yyy")
    assert line.endswith("is not one of fifo, lifo, nearest, random:SEED (SEED = 0, 1, 2, ...)\n")
    line = refused("check", "--bound", f"n+{LONG}+n")
    assert line.endswith("+ - * // **, min(,), max(,) and parentheses\n")


@pytest.mark.parametrize("encoding", ["ascii", "latin-1", "utf-8"])
@pytest.mark.parametrize("text", ["\N{SNOWMAN}" * 290, "\ud800" * 290, "\x1b" * 290, "a\n\u2028b"])
def test_a_line_is_as_long_as_it_is_shown(monkeypatch, encoding, text):
    stream = io.TextIOWrapper(io.BytesIO(), encoding=encoding)
    monkeypatch.setattr(sys, "stderr", stream)
    complain(text)
    stream.flush()
    shown = stream.buffer.getvalue().decode(encoding)
    assert len(shown.splitlines()) == 1
    assert len(shown) <= LONGEST + 1


@pytest.mark.parametrize(("more", "cut"), [(0, False), (1, True)])
def test_a_line_that_is_just_not_too_long_is_shown_whole(capsys, more, cut):
    text = "x" * (LONGEST - len("allworlds: ") + more)
    complain(text)
    assert (f"allworlds: {text}\n" != capsys.readouterr().err) is cut


class Heard(Listener):
    def __init__(self):
        self.told = []

    def notice(self, text):
        self.told.append(text)


@pytest.mark.parametrize(
    ("map_class", "edges", "vertices", "said"),
    [
        # 29,752,066 worlds have 8 edges, 1,708,394 have 7: https://oeis.org/A000698
        ("maps", 8, None, "over 10,000,000 worlds with up to 8 edges, and 8 are asked for"),
        ("maps", 92, None, "over 10,000,000 worlds with up to 8 edges, and 92 are asked for"),
        ("planar", 72, None, "worlds with up to 9 edges, and 72 are asked for"),
        ("simple", None, 100_000, "are asked for"),
        ("simple", 100_000, 3, "all levels up to 100000 edges are asked for"),
    ],
)
def test_who_asks_for_more_than_can_soon_be_done_is_told_so_first(map_class, edges, vertices, said):
    heard = Heard()
    tell_of_size(Extent(MapClass(map_class), edges, vertices), heard)
    assert len(heard.told) == 1
    assert said in heard.told[0]


def test_who_asks_for_little_is_told_nothing():
    for extent in (Extent(MapClass.MAPS, 7), Extent(MapClass.SIMPLE, None, 5)):
        heard = Heard()
        tell_of_size(extent, heard)
        tell_of_size(Extent(MapClass.MAPS, 8), heard, 1000)
        assert heard.told == []


class Enough(Exception):
    """The exception that ends a job as soon as it gives its notice."""


class NoticeOnce(Listener):
    def notice(self, text):
        raise Enough


def test_every_verb_of_levels_tells_it_before_it_begins():
    import allworlds

    for verb in (allworlds.check, allworlds.ambiguity.census, count):
        with pytest.raises(Enough):
            verb(edges=92, listener=NoticeOnce())


@pytest.mark.parametrize("edges", [100_001, 10**13, 10**4000, 10**5000], ids=show)
def test_what_cannot_be_counted_is_refused(edges):
    import allworlds

    for verb in (allworlds.check, allworlds.ambiguity.census, count):
        with pytest.raises(InputError, match=r"edges = .* is too big; at most 100,000 is legal"):
            verb(edges=edges)
        with pytest.raises(InputError, match=r"vertices = .* is too big"):
            verb(map_class="simple", vertices=edges)
    with pytest.raises(InputError, match="is too big"):
        allworlds.fuzz(edges=edges, runs=1)
    with pytest.raises(InputError, match="is too big"):
        allworlds.search(lighthouse="position", edges=edges, vertices=1)
