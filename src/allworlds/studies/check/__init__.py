"""The check: every world of a class, one explorer, a verdict with its scope.

``exhaustive``
    the check, level by level, and its report;
``time_estimate``
    an estimate of a check's duration;
``tally_sweep``
    the part that a check shares with other studies of one explorer in many worlds: run directories,
    the confirmation of findings, and findings of earlier checks, which are tried first;
``covered``
    features of the worlds in a sample: sizes, degrees, numbers of darts that look alike;
``hints``
    hints for a finding, from more plays of its explorer: options with which no law is broken, and
    lines of the explorer's code;
``report``
    the requests of ``check`` and similar verbs; the verdict with its scope, and the witnesses
    that a complete check must have.
"""
