"""All that happens to one run: it is played, judged, perhaps kept as a finding, and explained.

``episode``
    a run of an explorer in a world, and the ways in which a run can end;
``walk``
    the walk of a run in its world, which all other modules read;
``belief``
    the same walk in the map of the answer, and the first step at which the walks in the answer and
    in the world diverge;
``rules``
    the rules by which a run is played and judged; a finding records these rules;
``referee``
    the judgement of one run by the laws: its outcome, and its finding if it breaks a law;
``differences``
    the difference of two plays of one run, and when this difference replaces the outcome;
``tasks``
    the tasks, which define when a run has done its work;
``laws``
    the laws, each of which compares an answer and a log with the truth;
``findings``
    findings: runs that break a law, each with all data to play it again;
``explanations``
    a finding in plain words.
"""
