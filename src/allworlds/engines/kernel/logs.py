"""The log of a run in bytes: each motion, the published maps, and the ending.

The player writes the log (:mod:`allworlds.engines.kernel.native`); here it is followed through the
world, and the percepts on the way are noted for the second play.
"""

from __future__ import annotations

from numpy import int64

from allworlds import log as codes
from allworlds.engines.kernel.calls import address_of, byte_of, entry_of, put_entry
from allworlds.engines.kernel.compiling import inlined, inner
from allworlds.engines.kernel.law_numbers import BUDGET, ILLEGAL_ACTION
from allworlds.engines.kernel.names import LANES
from allworlds.engines.kernel.published import look_at
from allworlds.engines.kernel.records import DARTS, NONE
from allworlds.engines.kernel.worlds import arrival

LONGEST_ENTRY = 4 + 2 * codes.MOST_DARTS + LANES
"""The largest number of bytes that are written in one step."""

SLACK = DARTS
"""The number of bytes behind a log that may be read; their values have no meaning."""


span = inlined(codes.span)


@inner
def follow(world, reader, budget, log, judged):
    """Follow the next log through the world; see :func:`allworlds.engines.kernel.runs.play`.

    Bytes that are no log are counted as strange, in addition to the result here.
    """
    logs, size, published = reader.logs, reader.size, log.published
    run, noted = reader.run, reader.noted
    reader.run = run + 1
    put_entry(reader.starts, run, noted)
    at = entry_of(reader.begins, run)
    if at < 0:
        at = size
    cost = shown = walked = 0
    dart, law = 0, NONE
    _note(reader, noted, world, dart)
    while law == NONE:
        code = byte_of(logs, at) if at < size else int64(codes.BEYOND)
        at += 1
        if code < world.degree[dart] and cost < budget:
            dart = arrival(world, dart, code)
            noted += 3
            _note(reader, noted, world, dart)
            log.arrived[cost] = dart
            cost += 1
            walked |= 1 << dart | 1 << world.alpha[dart]
        elif code == codes.SHOWN and shown <= budget and _find_map(reader, at, published):
            at += 2 + span(published.darts)
            shown += 1
            if log.watched:
                look_at(judged, published, world, dart, walked)
        elif code == codes.ANSWERED and _find_map(reader, at, published):
            at += 2 + span(published.darts)
            law = 0
        elif code == codes.CHOICE:
            at += 2
        elif (code == codes.OVER_BUDGET and cost == budget) or (
            code == codes.SHOWN_TOO_OFTEN and shown > budget
        ):
            law = BUDGET
        else:
            law = ILLEGAL_ACTION
            reader.strange += code != codes.FAULT
    put_entry(reader.ends, run, at)
    log.cost, log.checkpoints, log.dart, log.walked = cost, shown, dart, walked
    reader.noted = noted + 3
    return law


@inlined
def _note(reader, at, world, dart):
    """Note the percept on arriving by the dart: three bytes, and one without meaning."""
    if at + 4 > reader.room:
        reader.strange += 1
    else:
        put_entry(reader.percepts + at, 0, percept_of(world, dart))


@inlined
def percept_of(world, dart):
    """The percept on arriving by the dart, in three bytes."""
    return world.degree[dart] | world.marks[dart] << 8 | (world.bearing[dart] + 1) << 16


@inlined
def _find_map(reader, at, published):
    """Whether there is a published map in the log."""
    darts = 0
    if at + 2 <= reader.size:
        darts = byte_of(reader.logs, at)
        published.darts, published.here = darts, byte_of(reader.logs, at + 1)
    published.bytes = reader.logs + at + 2
    published.sigma, published.alpha = address_of(reader.sigma), address_of(reader.alpha)
    return 1 <= darts <= codes.MOST_DARTS and at + 2 + span(darts) <= reader.size
