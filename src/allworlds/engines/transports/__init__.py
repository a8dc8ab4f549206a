"""Transports: the places of work for units; one a module.

The contract is :class:`~allworlds.engines.units.unit.Transport`; lanes are a transport, too, in
``engines.lanes``.  The table of the engines says which engine takes which transport.

``inline``, ``threads``
    this thread, and several, for engines that release the interpreter's lock;
``dask``
    the workers of a cluster;
``split``
    small levels here, all others there.
"""
