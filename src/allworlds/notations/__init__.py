"""Notations of embedded graphs: their readers and writers, and the table of the notations.

``table``
    **the** table of the notations, and files in any of them;
``entry``
    functions that the readers and writers share;
``objects``, ``worlds_as_json``, ``sage``
    worlds as objects, in JSON and as Python's literals;
``plantri``, ``edge_list``, ``graphs``
    plantri's binary notations; tables of edges; graphs with positions;
``given``
    worlds that users give instead of a class: from files, from embeddings of a graph, or as values
    in Python.
"""
