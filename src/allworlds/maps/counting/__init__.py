"""The numbers of rooted maps: the count gate, computed without making a single map.

An enumeration is exhaustive if its counts equal counts from an independent source.  The
sources here are generating functions, recurrences and sums over graphs from the literature.
They share no code with the enumeration of maps, nor with the maps themselves.

All functions return exact integers by number of vertices (or genus) for one number of edges
``m >= 1``.  A connected map with m edges has ``1..m+1`` vertices; a key in that range with
value 0 says that there is no such map, a missing key that the source does not know.

============================  ===========================================================
all maps                      pairs of permutations, the recurrences of Carrell and Chapuy
                              and of Walsh and Lehman
planar maps                   the same two recurrences at genus 0
simple maps                   degree sequences; for up to 7 vertices the graph atlas
simple planar maps            substitution into planar maps; for up to 7 vertices and few
                              rotations the graph atlas
trees (one class in all)      Catalan numbers
cubic, regular, eulerian      the same log-series and recurrence at these degrees; in simple
                              maps their degree sequences
triangulation, quadrangu-     the recurrence at the degrees of the dual maps; simple planar
lation                        triangulations by Tutte's formula
============================  ===========================================================

A polynomial is a tuple of integer coefficients, lowest power first.  In the comments z marks
edges and x vertices.

``sources``
    **the** tables of the sources, by the class of maps, and by a condition besides; degree
    sequences, and substitution;
``any_genus``, ``atlas``
    polynomials, generating functions and recurrences; the graph atlas.
"""
