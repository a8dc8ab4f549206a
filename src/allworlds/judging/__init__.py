"""One run: played, judged, kept as a finding, explained.

``episode``
    the one place where a world and an explorer meet, and the ways in which a run can end;
``walk``
    the walk of a run in its world, at which all others look;
``belief``
    the walk as an answer has it, and the step at which the two part;
``rules``
    the rules by which a run is played and judged; a finding records them;
``referee``
    one run by the laws: an outcome, and the finding of one that refutes;
``differences``
    two plays of one run: where they differ, and what that overrules;
``tasks``
    what counts as done;
``laws``
    the judge: an answer and a log against the truth, law by law;
``findings``
    a refuting run as a value that can be run again;
``explanations``
    a finding in plain words.
"""
