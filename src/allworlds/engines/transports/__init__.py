"""Transports: the places of work for units; one a module.

The contract is :class:`~allworlds.engines.units.unit.Transport`; worker processes are a transport,
too, in ``isolation``.  The table of the engines says which engine takes which transport.
"""
