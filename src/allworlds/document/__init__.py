"""A document, described once: the class of a result names its keys, their types and meanings.

A result is a frozen :class:`Document`: its fields are the keys of its JSON object, in their order,
each annotated with its type and, by :func:`about`, with one line of meaning.  From the same class
come the JSON (:meth:`Document.to_json`), the strict reading (:func:`taken`), the JSON Schemas and
the reference of keys.

The keys of a class may be those of a request's options (``class Scope(Document, of=Request)``),
whose types and meanings stand beside the options.

Three things are said beside a type:

``key: T = computed(function)``
    follows from the fields, and is made when it is asked for;
``key: T | UnsetType = UNSET``
    may be missing in the object;
``key: IfAny[T]``
    is missing while it is None or empty;
``name: Aside[T]``
    belongs to the result in Python, and is no key.
"""
