"""Transports: where units are done; one a module.

The contract is :class:`~allworlds.engines.units.unit.Transport`; worker processes are a transport,
too, in ``isolation``.  Which engine takes which is said in the table of the engines.
"""
