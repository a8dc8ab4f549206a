"""The fixtures of the quick tests beside them."""

from reports import conftest as quick

line = quick.line
refuted = quick.refuted
