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

from __future__ import annotations

from typing import TYPE_CHECKING

from allworlds.lazy import open_door

if TYPE_CHECKING:
    from msgspec import UNSET as UNSET, Meta as Meta, UnsetType as UnsetType

    from allworlds.document.reading import taken as taken
    from allworlds.document.report import (
        SCHEMA as SCHEMA,
        Host as Host,
        MadeBy as MadeBy,
        Paged as Paged,
        Pictured as Pictured,
        Report as Report,
    )
    from allworlds.document.struct import (
        ASIDE as ASIDE,
        EXIT_CODE as EXIT_CODE,
        IF_ANY as IF_ANY,
        AllRows as AllRows,
        Aside as Aside,
        Bounded as Bounded,
        Different as Different,
        Document as Document,
        Edges as Edges,
        Entries as Entries,
        ExitCode as ExitCode,
        Figure as Figure,
        FromJson as FromJson,
        IfAny as IfAny,
        Natural as Natural,
        Pair as Pair,
        Permutation as Permutation,
        Positive as Positive,
        Seconds as Seconds,
        ShardText as ShardText,
        Some as Some,
        Text as Text,
        Vertices as Vertices,
        WhichShard as WhichShard,
        Why as Why,
        WrittenByFields as WrittenByFields,
        about as about,
        computed as computed,
        key as key,
        keys_of as keys_of,
        names_of as names_of,
        narrowed as narrowed,
        one_of as one_of,
        plain as plain,
        plain_at_once as plain_at_once,
        read_by as read_by,
        replace as replace,
    )

open_door(__name__)
