"""One run: played, judged, kept as a finding, explained.

``episode``
    a run of an explorer in a world, and the ways in which it can end;
``walk``
    the walk of a run in its world, which all other modules read;
``belief``
    the same walk in an answer, and the first step at which the two walks diverge;
``rules``
    the rules by which a run is played and judged; a finding records them;
``referee``
    the judgement of one run by the laws: its outcome, and its finding if it breaks a law;
``differences``
    the difference of two plays of one run, and the outcomes that it overrules;
``tasks``
    the tasks, which define when a run has done its work;
``laws``
    the judge: an answer and a log against the truth, law by law;
``findings``
    a refuting run as a value that can be run again;
``explanations``
    a finding in plain words.
"""
