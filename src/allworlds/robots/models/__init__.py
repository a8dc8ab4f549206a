"""The built-in models of worlds that change, each in a module; ``table`` has their names."""
