"""One run: played, judged, kept as a finding, explained.

``episode``
    the one place where a world and an explorer meet, and the ways in which a run can end;
``tasks``
    what counts as done, and the log that decides it;
``laws``
    the judge: an answer and a log against the truth, law by law;
``findings``
    a refuting run as a value that can be run again;
``explanations``
    a finding in plain words.
"""
