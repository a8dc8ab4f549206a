"""Findings: runs that break a law, as values.

``finding``
    the class of findings, each with the world, the explorer, the run, and the broken law; the
    content of a finding's file.
"""
