"""The fixtures of the quick tests beside them."""

from studies import conftest as quick

planted = quick.planted
planted_file = quick.planted_file
