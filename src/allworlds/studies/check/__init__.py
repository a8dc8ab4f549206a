"""The check: every world of a class, one explorer, a verdict with its scope.

``exhaustive``
    level by level to a report;
``time_estimate``
    how long it will take;
``tally_sweep``
    what it shares with other studies of one explorer in many worlds: run directories, findings
    that are confirmed, and those of earlier checks, which are tried first;
``covered``
    what the worlds of a sample were like: sizes, degrees, how many darts look alike;
``hints``
    what more plays of a refuted explorer show: an option that helps, and lines of its code;
``report``
    what ``check`` and its like are asked for, as values; the verdict with its scope, and
    what a complete check must have met.
"""
