"""What all tests share: drawn examples are the same every time, on every machine."""

from hypothesis import settings

settings.register_profile(
    "same-every-time", derandomize=True, database=None, deadline=None, max_examples=60
)
settings.load_profile("same-every-time")
