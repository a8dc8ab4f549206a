"""Notations of embedded graphs: readers and writers, found by a table.

``table``
    **the** table of the notations, and files in any of them;
``entry``
    one world of a file, and what readers share;
``objects``, ``worlds_as_json``, ``sage``
    worlds as objects, in JSON and as Python's literals;
``plantri``, ``edge_list``, ``graphs``
    binary codes, tables of edges, graphs with positions;
``given``
    worlds that users give in place of a class: of files, of a graph's embeddings, or made here.
"""
