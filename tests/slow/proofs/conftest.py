"""The fixtures of the quick tests beside them."""

from proofs import conftest as quick

checkers = quick.checkers
checker_of = quick.checker_of
proofs = quick.proofs
