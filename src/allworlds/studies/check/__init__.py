"""The check: every world of a class, one explorer, a verdict with its scope.

``requests``
    what ``check`` and its like are asked for, as values;
``exhaustive``
    level by level to a report;
``time_estimate``
    how long it will take;
``shielding``
    any explorer, made right;
``given_worlds``
    worlds of the user's own, in place of all;
``gate``
    what a complete check must have met: every world, and certain events;
``tally_sweep``
    what it shares with other studies of one explorer in many worlds;
``run_identity``
    explorers and rules as a run directory knows them;
``known_findings``
    findings of earlier checks, which are tried first;
``confirmation``
    findings, played again in fresh processes;
``report``
    the verdict with its scope;
``shared_files``
    files that hold an explorer, and code that judges it;
``most_expensive``
    the most expensive run of every size, played again.
"""
