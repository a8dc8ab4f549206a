"""The numbers of rooted maps: the count gate, computed without making a single map.

An enumeration is exhaustive if its counts equal counts from an independent source.  The
sources here are generating functions, recurrences and sums from the literature.
They share no code with the enumeration of maps, nor with the maps themselves.

All functions return exact integers by number of vertices (or genus) for one number of edges
``m >= 1``.  A connected map with m edges has ``1..m+1`` vertices: these are the keys.

============================  ===========================================================
all maps                      pairs of permutations
planar maps                   the recurrence of Carrell and Chapuy at genus 0
simple maps                   degree sequences
simple planar maps            substitution into planar maps
trees (one class in all)      Catalan numbers
cubic, regular, eulerian      the same log-series, and in the plane the recurrence of Walsh and
                              Lehman, at these degrees; in simple maps their degree sequences
triangulation, quadrangu-     the recurrence at the degrees of the dual maps; simple planar
lation                        triangulations by Tutte's formula
============================  ===========================================================

The tests compare each of them with another one.

A polynomial is a tuple of integer coefficients, lowest power first.  In the comments z marks
edges and x vertices.

``sources``
    **the** tables of the sources, by the class of maps, and by a condition besides; degree
    sequences, and substitution;
``any_genus``
    polynomials, generating functions and recurrences.
"""
