"""Studies: the questions that are asked of all worlds, one folder a verb.

A study imports no other study but ``check``.
"""
