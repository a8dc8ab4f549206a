"""Findings: a refuting run as a value, and how to read it.

``rules``
    how a run is played and judged; a finding records it;
``finding``
    a world, an explorer, what it did there, and the law that it broke;
``walks``
    the walk of a log in the world, and the same walk in a wrong answer;
``divergence``
    the first step at which these two part;
``belief``
    both together, from where in the answer they go along for longest;
``directory``
    a directory of findings, which outlives the checks that made them.
"""
