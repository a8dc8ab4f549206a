"""The models that are built in, each in a module of its own; ``table`` has their names."""
