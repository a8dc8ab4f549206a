"""The fuzzer: worlds far beyond the exhaustive bound, and the way back to small ones.

``fuzz_request``
    what is asked for;
``sample``
    the worlds of a run, a function of its seed;
``drive``
    a run, from its options to its report;
``given``
    the same in maps that somebody has chosen;
``shrink``
    from a refuting world to one that no small change makes smaller.
"""
