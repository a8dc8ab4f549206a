"""The sizes from which on a check is done in another way; no compiled code is loaded here."""

from __future__ import annotations

COMPILED_FROM = 5
"""The least m of a check that is worth the compiling; smaller ones end before it would."""

WORTH_LOADING = 2000
"""The number of worlds of a level from which on the compiled judge of users' explorers pays: they
have some 10,000 runs."""

WALKED_FROM = 6
"""The least m whose maps are walked once for every bearing, where that can be done.  Up to
there every bearing is walked."""

COMPILER = "numba", "fast"
"""The package without which there is no compiled engine, and the extra that brings it."""
