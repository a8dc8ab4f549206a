"""Studies: the questions that are asked of all worlds, a file for a verb or two, or a folder.

A study imports no other study but ``check``.
"""
