"""The polygon with glued sides, read back from the picture as a reader would."""

import re
from cmath import phase
from itertools import pairwise
from math import pi
from xml.etree import ElementTree as ET

import numpy as np
import pytest

from allworlds.maps import CombinatorialMap, family, isomorphism, named_map
from allworlds.reports.drawing.polygon import polygon
from allworlds.reports.drawing.polygon_svg import has_polygon, polygon_picture
from allworlds.reports.drawing.scene import Scene
from curves import crossings, flat, points
from small import LOOP, slow, unrooted_maps

NS = "{http://www.w3.org/2000/svg}"


def picture_of(map_, **shown):
    return ET.fromstring(ET.tostring(polygon_picture(Scene(map_, 0, 0, **shown), "p", "a map")))


def place_of(group):
    return points(group.get("transform"))[0]


def corner_groups(svg):
    """The corners counterclockwise, which is by falling angle, for y grows downwards."""
    groups = [g for g in svg.iter(f"{NS}g") if "data-vertex" in g.attrib]
    return sorted(groups, key=lambda g: -phase(place_of(g)) % (2 * pi))


def letters_round(svg):
    """Between two corners each: the letter that is written, and whether its arrow goes our way."""
    corners = [place_of(g) for g in corner_groups(svg)]
    for start, end in zip(corners, [*corners[1:], corners[0]], strict=True):
        (sign,) = (
            g
            for g in svg.iter(f"{NS}g")
            if (g.get("class") or "").startswith("glue")
            and abs(place_of(g) - (start + end) / 2) < 0.3
        )
        (letter,) = (text.text for text in sign.iter(f"{NS}text"))
        (arrow,) = (path for path in sign.iter(f"{NS}path"))
        turn = float(re.findall(r"-?[0-9.]+", arrow.get("transform"))[0]) * pi / 180
        off = abs(phase((end - start) * complex(np.cos(-turn), np.sin(-turn))))
        assert off < 0.01 or off > pi - 0.01
        yield letter, off < 1


def numbers_at(group):
    """The numbers at a corner, clockwise from the side that ends there to that which begins."""
    around = {
        place_of(g): "".join(g.itertext()).strip()
        for g in group.iter(f"{NS}g")
        if (g.get("class") or "").startswith("dart")
    }
    # Outwards there is no number: clockwise from there each has its turn.
    outwards = place_of(group)
    turns = {at: phase(at / outwards) % (2 * pi) for at in around}
    return [int(around[at]) for at in sorted(around, key=turns.__getitem__)]


def edges_inside(svg):
    """The numbers at both ends of each curve inside, found by where it begins and ends."""
    stubs = {
        int(p.get("data-stub")): points(p.get("d"))
        for p in svg.iter(f"{NS}path")
        if p.get("class") == "stub"
    }
    for path in svg.iter(f"{NS}path"):
        way = points(path.get("d"))
        if "data-darts" in path.attrib and len(way) > 2:
            yield tuple(
                next(d for d, stub in stubs.items() if abs(stub[1] - p) + abs(stub[0] - q) < 0.3)
                for p, q in ((way[1], way[0]), (way[-2], way[-1]))
            )


def read_back(svg):
    """The map by the rule on the page, from numbers, letters, arrows and curves alone."""
    groups, word = corner_groups(svg), [*letters_round(svg)]
    numbers = [numbers_at(group) for group in groups]
    begins = [at[-1] for at in numbers]  # the dart by which each side begins
    partner, alpha = {}, {}
    for i, (letter, ours) in enumerate(word):
        (j,) = (k for k, (other, _) in enumerate(word) if other == letter and k != i)
        assert word[j][1] is not ours  # the surface has two sides
        partner[i] = j
        alpha[begins[i]] = begins[j]
    for a, b in edges_inside(svg):
        alpha[a], alpha[b] = b, a
    sigma = {}
    for i, at in enumerate(numbers):
        # What ends here is the side before, and its other end is where its twin begins.
        darts = [begins[partner[(i - 1) % len(word)]], *at]
        sigma.update(pairwise(darts))
    size = len(sigma)
    return CombinatorialMap([sigma[d] for d in range(size)], [alpha[d] for d in range(size)])


def curved(edges):
    """Those of genus above 0."""
    return [map_ for map_ in unrooted_maps(edges) if map_.genus]


def glued_again(map_):
    svg = picture_of(map_)
    again = read_back(svg)
    assert again == map_
    assert isomorphism(again, map_)
    names = [group.get("data-vertex") for group in corner_groups(svg)]
    assert {*map(int, names)} == {*range(map_.vertex_count)}
    assert len(names) == 2 * (map_.vertex_count - 1 + 2 * map_.genus)


def nothing_crosses(map_):
    svg, ways = picture_of(map_), []
    for path in svg.iter(f"{NS}path"):
        if "data-darts" in path.attrib:
            ways.append(flat(points(path.get("d"))))
    assert [*crossings(ways)] == []


def test_the_glued_polygon_is_the_map():
    for map_ in [*curved(3), named_map("k4-torus"), named_map("theta-torus")]:
        glued_again(map_)
        nothing_crosses(map_)


@pytest.mark.slow
def test_so_it_is_of_every_map_with_four_edges():
    maps = curved(4)
    assert len(maps) == (2 + 5 + 20 + 107) - (2 + 4 + 14 + 57)
    for map_ in maps:
        glued_again(map_)
        nothing_crosses(map_)


@pytest.mark.parametrize("seed", [0, *(slow(s) for s in range(1, 12))])
def test_and_of_larger_maps(seed):
    map_ = family(f"random:{5 + seed % 10}", holes=0, seed=seed)
    if map_.genus:
        glued_again(map_)
        nothing_crosses(map_)


def test_a_letter_exchanged_or_an_arrow_turned_would_be_seen():
    map_ = named_map("k4-torus")
    svg = picture_of(map_)
    signs = [g for g in svg.iter(f"{NS}g") if (g.get("class") or "").startswith("glue")]
    texts = [next(g.iter(f"{NS}text")) for g in signs]
    one = texts[0]
    other = next(text for text in texts if text.text != one.text)
    one.text, other.text = other.text, one.text
    with pytest.raises(AssertionError):
        assert read_back(svg) == map_
    svg = picture_of(map_)
    arrow = next(p for p in svg.iter(f"{NS}path") if "rotate" in (p.get("transform") or ""))
    arrow.set("transform", "rotate(180) " + arrow.get("transform"))
    turn = float(re.findall(r"-?[0-9.]+", arrow.get("transform"))[1])
    arrow.set("transform", f"rotate({turn + 180})")
    with pytest.raises(AssertionError):
        read_back(svg)


def test_the_same_rooted_map_is_cut_open_alike():
    map_ = family("random:6", holes=0, seed=3)
    size = len(map_.sigma)
    names = [(5 * d + 3) % size for d in map_.darts]
    sigma, alpha = [0] * size, [0] * size
    for d in map_.darts:
        sigma[names[d]], alpha[names[d]] = names[map_.sigma[d]], names[map_.alpha[d]]
    ours, theirs = polygon(map_, 2), polygon(CombinatorialMap(sigma, alpha), names[2])
    assert [names[d] for d in ours.sides] == [*theirs.sides]
    assert ours.corners == theirs.corners
    assert {names[d]: way for d, way in ours.ways.items()} == theirs.ways


def test_what_is_to_be_seen_stands_at_its_dart():
    map_ = named_map("theta-torus")
    svg = picture_of(map_, marks={0: 2}, pointed=[1], walked=[0], labels=[*"aabbab"])
    seats = {g.get("data-dart"): g for g in svg.iter(f"{NS}g") if "data-dart" in g.attrib}
    assert {*map(int, seats)} == {*map_.darts}
    assert "here" in seats["0"].get("class")
    walked = [p.get("data-darts") for p in svg.iter(f"{NS}path") if p.get("class") == "edge walked"]
    assert len(walked) == 2
    assert {*walked[0].split()} == {*walked[1].split()} == {"0", str(map_.alpha[0])}
    assert len([p for p in svg.iter(f"{NS}path") if p.get("class") == "flag"]) == 1
    assert not [g for g in svg.iter(f"{NS}g") if (g.get("class") or "").startswith("glue class")]
    words = next(svg.iter(f"{NS}desc")).text
    assert words.startswith("Counterclockwise round the polygon its sides are: A ")
    assert words.count("backwards") == 3


def test_a_sphere_has_none_and_neither_has_what_nobody_could_read():
    assert not has_polygon(Scene(LOOP))
    assert has_polygon(Scene(named_map("theta-torus")))
    large = CombinatorialMap([*range(1, 124), 0], [(d + 62) % 124 for d in range(124)])
    assert large.genus > 0
    assert not has_polygon(Scene(large))
    with pytest.raises(ValueError, match="no edge"):
        polygon(LOOP, 0)
