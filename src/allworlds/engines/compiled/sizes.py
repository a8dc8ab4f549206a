"""The sizes from which on a check is done in another way; here nothing compiled is loaded."""

from __future__ import annotations

COMPILED_FROM = 5
"""Checks of so many edges are worth the compiling; smaller ones are done before it would begin."""

WALKED_FROM = 6
"""The least m whose maps are walked once for every bearing, where that can be done.  Up to
there every bearing is walked."""
