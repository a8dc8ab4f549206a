"""``fuzz``: random worlds, larger than a check can exhaust, and the way back to small ones.

``sample_sweep``
    the request, the verb, and the sweep through the random worlds and the worlds bred from them;
``sampling``
    the draws: the random worlds of a sample;
``breeding``
    worlds that are bred from random worlds, to run lines of the explorer that run in few worlds;
``shrinking``
    the way from a refuting world to a small one;
``given_maps``
    runs in maps that another program, such as Hypothesis, draws; and the smallest finding.
"""
