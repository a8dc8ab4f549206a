"""Files of very many worlds, every planar map with 6 vertices, and every garbled byte."""

import pytest

from allworlds.maps import MapClass, automorphisms, rooted_maps, unrooted_code
from allworlds.world.world import Entry
from world.test_notations import (
    GRAPHS,
    STREAMS,
    WRITTEN,
    file_of,
    garbled,
    growth,
    read,
    tried,
    valid,
)

pytestmark = pytest.mark.slowest


@pytest.mark.parametrize("notation", STREAMS)
def test_memory_does_not_grow_with_a_hundred_thousand_worlds(notation, tmp_path):
    assert growth(notation, tmp_path, 1000, 100_000, 500) < 0.02


@pytest.mark.parametrize("notation", ["planar_code", "sage"])
def test_every_simple_planar_map_with_4_to_6_vertices_is_read_back(notation, tmp_path):
    found = {}
    for edges in range(3, 13):
        for map_ in rooted_maps(edges, MapClass.PLANAR_SIMPLE, 6):
            if map_.vertex_count >= 4:
                found.setdefault(unrooted_code(map_), map_)
    again = read(file_of(tmp_path, notation, *map(Entry, found.values())))
    assert [unrooted_code(entry.map) for entry in again] == [*found]
    with_4 = [map_ for map_ in found.values() if map_.vertex_count == 4]
    # "allworlds count --class planar-simple --vertices 4", column 4.
    assert sum(2 * map_.edge_count // automorphisms(map_) for map_ in with_4) == 20


@pytest.mark.parametrize("notation", [*WRITTEN, *GRAPHS])
def test_every_prefix_and_every_garbled_byte_is_read_or_refused(notation):
    content = valid(notation)
    others = (None, *b'\0"<7\xff') if notation in GRAPHS else (None, *range(256))
    for place in range(len(content)):
        for byte in others:
            tried(notation, garbled(content, place, byte))
