"""Skeletons of explorers in several languages: files that build and run, and are still wrong.

The files of a language lie in the folder of its name, each with ``.template`` after its own name.
A new language is a folder here, and an entry of ``LANGUAGES`` in ``languages``.
"""
