"""Findings: a refuting run as a value, and its interpretation.

``rules``
    the rules by which a run is played and judged; a finding records them;
``finding``
    a world, an explorer, its run there, and the law that it broke;
``asked_finding``
    the choice of a finding of a file;
``walks``
    the walk of a log in the world, and the same walk in a wrong answer;
``divergence``
    the first step at which these two diverge;
``belief``
    both together, from the dart of the answer from which they agree for longest;
``directory``
    a directory of findings, which outlives the checks that made them.
"""
