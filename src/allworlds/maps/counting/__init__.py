"""How many rooted maps there are: the count gate, computed without making a single map.

An enumeration is exhaustive if its counts equal counts from somewhere else.  Here is the
somewhere else: generating functions, recurrences and sums over graphs from the literature.
Nothing is shared with the code that enumerates maps, nor with that of the maps themselves.

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
============================  ===========================================================

A polynomial is a tuple of integer coefficients, lowest power first.  In the comments z marks
edges and x vertices.

``sources``
    **the** table of the sources, by the class of maps;
``any_genus``, ``degrees``, ``substitution``, ``atlas``
    generating functions and recurrences, degree sequences, substitution, and the graph atlas;
``arithmetic``
    integers and polynomials.
"""
