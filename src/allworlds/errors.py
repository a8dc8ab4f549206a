"""The one kind of error that is the user's to mend."""


class InputError(ValueError):
    """Bad input: one line that names the offending value and what would be legal."""
