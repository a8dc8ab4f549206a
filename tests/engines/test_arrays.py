"""The memory that a record takes, and the memory of a batch that a library plays."""

from array import array
from pathlib import Path
from types import SimpleNamespace

import pytest
from numpy import zeros

from allworlds import log
from allworlds.engines.kernel import arrays, library_player
from allworlds.engines.kernel.arrays import HEAD, JOB, WIDE, Stretch, new
from allworlds.engines.kernel.capabilities import POLICIES
from allworlds.engines.kernel.library_player import LONGEST_ENTRY, LibraryPlayer
from allworlds.engines.players import Logs


def resident():
    """The memory of this process, in bytes."""
    status = Path("/proc/self/status").read_text(encoding="ascii")
    (kilobytes,) = (line.split()[1] for line in status.splitlines() if line.startswith("VmRSS"))
    return 1024 * int(kilobytes)


def test_a_large_record_takes_memory_for_what_is_written_to_alone():
    new(JOB)  # an allocator keeps memory of this size, once it has been given back
    before = resident()
    records = [new(JOB) for _ in range(8)]
    del records[::2]
    records += [new(JOB) for _ in range(4)]
    assert not any(record.number for record in records)
    assert resident() - before < JOB.itemsize


@pytest.fixture
def small(monkeypatch):
    """The memory of a batch with room for logs of five bytes in all."""
    monkeypatch.setattr(arrays, "LOG_BYTES", 5)
    return Stretch.of(1)


def test_logs_stand_one_behind_the_other(small):
    assert small.put(Logs(b"before" + Logs.of([b"a", b"", b"bcde"]).message, 3, at=6)) == 5
    assert (small.logs.tobytes(), small.begins[:3].tolist()) == (b"abcde", [0, 1, 1])
    assert small.put(Logs.of([b"xy"])) == 2
    assert (small.logs.tobytes(), small.begins[:3].tolist()) == (b"xycde", [0, 1, 1])


def test_logs_without_room_are_not_written(small):
    assert small.put(Logs.of([b"abc", b"def"])) == -1
    assert not small.logs.any()
    assert not small.begins.any()


def test_a_batch_has_room_for_its_runs_and_512_bytes_for_each_log():
    memory = Stretch.of(3)
    runs = arrays.LONGEST_STRETCH + arrays.MOST_PLACES
    assert memory.heads.shape == (runs, HEAD)
    assert memory.worlds.shape == (runs, 6 * WIDE)
    assert len(memory.starts) == len(memory.begins) == runs + 1
    assert len(memory.logs) == len(memory.percepts) == 512 * arrays.LONGEST_STRETCH


def test_each_column_has_a_name():
    head = arrays.RUN_BUDGET, arrays.RUN_TOLD, arrays.RUN_NUMBER, arrays.RUN_PLACE
    assert [*head, arrays.RUN_MOTIONS] == [*range(HEAD)]
    dart = arrays.FIRST, arrays.PARTNER, arrays.DEGREE, arrays.MARKS, arrays.BEARING
    assert [*dart] == [*range(WIDE)]


# ---------------------------------------------------------------- a library


class Compiled:
    """In place of the compiled code by which a library plays: each log is the number of its run.

    A run of the number r has a log of r + 1 bytes.
    """

    def __init__(self):
        self.asked, self.size = [], None

    def __call__(self, handed, memory, order, again):
        at = 0
        for run in order:
            memory.begins[run] = at
            memory.logs[at : at + run + 1] = run
            at += run + 1
        self.asked.append((handed, memory, [*order], again))
        return at if self.size is None else self.size


@pytest.fixture
def library(monkeypatch):
    """A library that plays, the code that plays in its place, and its numbers of threads."""
    code, threads = Compiled(), [3]
    monkeypatch.setattr(library_player, "play", code)
    monkeypatch.setattr(library_player, "move", library_player.move.py_func)
    monkeypatch.setattr(library_player, "pick_address", lambda: 99)
    monkeypatch.setattr(library_player, "threads_now", lambda: threads[0])
    monkeypatch.setattr(library_player, "threads_left", lambda before: threads[0] - before)
    memory = [array("i", [number] * size) for number, size in enumerate((3, 2, 1, 8, 8), 10)]
    native = SimpleNamespace(
        library=SimpleNamespace(addresses=lambda: [1, 2, 3, 4]),
        state=lambda: 5,
        handed=lambda: memory,
    )
    return LibraryPlayer(native, array("q", [6, 7])), code, threads


def batch_of(runs, *, again, seed=1, edges=2, policy="nearest"):
    """A message that asks for so many runs, whose bytes are all different from zero."""
    heads = zeros((runs, HEAD), "int32") + 1
    more = {"percepts": b"abcdef", "starts": array("i", [*range(runs), 6])}
    if not again:
        more = {"worlds": (zeros((runs, WIDE * 2 * edges), "uint8") + 9).tobytes()}
    asked = {"edges": edges, "runs": runs, "seed": seed, "policy": policy, "again": again}
    return asked | {"heads": heads.tobytes()} | more


def logs_of(answer):
    lengths, logs = answer
    return [*Logs(lengths + logs.tobytes(), len(lengths) // 4)]


LOGS = [bytes([run] * (run + 1)) for run in range(5)]


def test_a_library_plays_in_any_order_and_its_logs_come_in_theirs(library):
    player, code, _ = library
    orders = set()
    for seed in range(4):
        assert logs_of(player.play(batch_of(5, again=False, seed=seed))) == LOGS
        orders.add(tuple(code.asked[-1][2]))
    assert len(orders) > 1
    assert {tuple(sorted(order)) for order in orders} == {(0, 1, 2, 3, 4)}


def test_a_library_finds_its_runs_in_memory(library):
    player, code, _ = library
    player.play(batch_of(5, again=False))
    player.play(batch_of(3, again=True))
    (_, memory, _, first), (_, same, _, second) = code.asked
    assert memory is same
    assert (first, second) == (False, True)
    assert memory.heads[:6].any(1).tolist() == [True] * 5 + [False]
    assert memory.worlds[:6].all(1).tolist() == [True] * 5 + [False]
    assert memory.percepts[:7].tobytes() == b"abcdef\0"
    assert memory.starts[:4].tolist() == [0, 1, 2, 0]
    player.play(batch_of(3, again=True, edges=4))
    assert code.asked[-1][1] is not memory


def test_a_library_is_handed_over_with_its_memory(library):
    player, code, _ = library
    player.play(batch_of(1, again=False))
    handed = code.asked[0][0]
    own = handed.library
    assert [own[name] for name in ("start", "step", "answer", "choose", "state")] == [1, 2, 3, 4, 5]
    assert (own.pick, own.room, own.policy) == (99, 8, POLICIES["nearest"])
    assert [each[0] for each in handed[1:4]] == [10, 11, 12]
    assert own.percept == handed.percept.ctypes.data
    assert own.action == handed.action.ctypes.data
    assert own.here == handed.here.ctypes.data
    assert own.alpha - own.sigma != 0
    assert handed.beat.tolist() == [6, 7]


def test_logs_of_a_library_without_room_are_none(library):
    player, code, _ = library
    code.size = -1
    assert player.play(batch_of(5, again=False)) is None


def test_threads_that_a_library_leaves_are_seen_once(library):
    player, _, threads = library
    threads[0] += 2
    assert player.play(batch_of(5, again=False)) is None
    assert logs_of(player.play(batch_of(5, again=False))) == LOGS
    threads[0] += 1
    assert player.play(batch_of(5, again=False)) is None
    assert logs_of(player.play(batch_of(5, again=True))) == LOGS


def test_a_library_is_asked_only_if_there_is_room_for_the_longest_entry():
    longest = log.shown([0] * log.MOST_DARTS, [0] * log.MOST_DARTS, 0)
    assert longest[0] == log.SHOWN
    assert len(longest) == LONGEST_ENTRY


def test_the_code_of_libraries_is_loaded_without_a_run(library, monkeypatch):
    _, code, _ = library
    moved = []
    monkeypatch.setattr(library_player, "move", lambda *each: moved.append([*map(len, each[:2])]))
    library_player.load_player()
    ((handed, memory, order, again),) = code.asked
    assert (order, again) == ([], False)
    assert [len(each) for each in handed[1:]] == [3, 2, 1, 2]
    assert memory.worlds.shape[1] == 2 * WIDE
    assert moved == [[len(memory.begins), 0]]
