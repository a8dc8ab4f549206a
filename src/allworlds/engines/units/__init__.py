"""Units: the pieces into which a level is cut, and the one loop over them.

``unit``
    the words: a :class:`~allworlds.engines.units.unit.Unit` of work, an engine that does it, a
    transport that says where, the part of a result that comes back, and where it is kept;
``kept_form``
    how a result is kept as JSON: as the types of its fields say;
``levels``
    the units into which all maps with one number of edges are cut;
``shards``
    the units that one of several machines does;
``listing``
    the rows that are listed for programs: by size, world or run;
``effort``
    the limits of the effort: workers, and time;
``gather``
    **the** loop: the units of a level through an engine by a transport, added up.
"""
