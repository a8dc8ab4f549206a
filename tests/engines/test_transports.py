"""Work piece by piece: every transport brings what every engine makes of every unit."""

import inspect
import re
import threading
from collections import Counter
from concurrent import futures
from inspect import getsource

import pytest

from allworlds.engines import dask, engine_table
from allworlds.engines.engine_table import ThisThread, Threads
from allworlds.engines.kept_units import NOTHING_KEPT, KeptUnits
from allworlds.engines.limits import TimeIsUp
from allworlds.engines.listeners import NOBODY
from allworlds.engines.sweep import gather
from allworlds.engines.units import PartialResult
from allworlds.maps.classes import Extent, MapClass
from clusters import cluster_here

pytestmark = [
    pytest.mark.processes,
    pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning"),
]


def transports():
    """Every class of these modules that is a context and has units done."""
    for module in (dask, engine_table):
        for name, found in inspect.getmembers(module, inspect.isclass):
            ours = found.__module__ == module.__name__ and not getattr(found, "_is_protocol", False)
            if ours and hasattr(found, "map") and hasattr(found, "__enter__"):
                yield name, found


TRANSPORTS = dict(transports())


@pytest.fixture(scope="module")
def scheduler():
    """The address of a Dask scheduler, whose workers are threads of this process."""
    distributed = pytest.importorskip("distributed")
    with cluster_here(distributed) as address:
        yield address


@pytest.fixture
def made(request):
    def make(name, deadline=None):
        address = request.getfixturevalue("scheduler") if name == "Dask" else None
        return made_of(name, deadline, address)

    return make


def made_of(name, deadline, address):
    known = {"workers": 2, "batch": 3, "deadline": deadline, "address": address}
    known |= {"inside": ThisThread, "probe": str, "order": iter}
    known |= {"soon": bool, "near": ThisThread(deadline), "far": Threads(2, deadline)}
    taken = inspect.signature(TRANSPORTS[name]).parameters
    return TRANSPORTS[name](**{key: known[key] for key in taken})


class Number(int):
    """A unit."""

    @property
    def key(self):
        return str(int(self))


class Digits:
    """An engine: of a number its digits, one a part."""

    def parts(self, unit):
        yield from map(Some, str(unit))

    def halt(self):
        pass


class Some(Counter):
    """A sum."""

    @property
    def worlds(self):
        return self.total()

    def add(self, other):
        self.update(other)


def test_every_transport_is_made_where_engines_are_made_ready():
    assert {"Dask", "ThisThread", "Threads"} <= set(TRANSPORTS)
    told = getsource(engine_table)
    assert all(name in told for name in set(TRANSPORTS) - {"ThisThread"}), (
        "no engine of the table goes into one thread"
    )


@pytest.mark.parametrize("name", TRANSPORTS)
@pytest.mark.parametrize("units", [[], [7], [1, 22, 345, 678, *range(100, 140)]], ids=len)
def test_a_transport_brings_every_unit_once(name, units, made):
    units = [Number(unit) for unit in units]
    with made(name) as transport:
        parts = list(transport.map(Digits(), units))
    assert Counter(part.unit for part in parts if part.last) == Counter(units)
    total = Some()
    with made(name) as transport:
        gather(transport, Digits(), units, total, NOBODY)
    assert total == Counter("".join(map(str, units)))


@pytest.mark.parametrize("name", TRANSPORTS)
def test_a_transport_ends_when_the_time_is_up(name, made):
    with made(name, deadline=0.0) as transport, pytest.raises(TimeIsUp):
        list(transport.map(Digits(), map(Number, range(9))))


class Slow(Number):
    """A unit of which so many worlds are to be tried."""

    def weight(self, _extent):
        return 1000


class Ending:
    """A transport that brings so many digits of its last unit before the time is up."""

    def __init__(self, digits):
        self.digits = digits

    def map(self, engine, units):
        for unit in units:
            parts = [*engine.parts(unit)][: self.digits]
            yield from (PartialResult(unit, part, last=False) for part in parts)
        raise TimeIsUp


@pytest.mark.parametrize(
    ("kept", "added", "digits", "said"),
    [
        (
            KeptUnits(),
            0,
            2,
            "no unit was finished, .* comes no further: a unit takes about [0-9]+ s$",
        ),
        (KeptUnits(), 0, 0, "no unit was finished, so that the same again comes no further$"),
        (KeptUnits(), 1, 2, "^$"),
        (NOTHING_KEPT, 0, 2, "^$"),
    ],
)
def test_a_time_limit_in_which_no_unit_can_be_kept_is_told(kept, added, digits, said):
    if kept:
        kept.added = added
    extent = Extent(MapClass.MAPS, 3)
    with pytest.raises(TimeIsUp) as up:
        gather(Ending(digits), Digits(), [Slow(3456)], Some(), NOBODY, kept, extent)
    assert re.search(said, str(up.value))


class Wrong(Exception):
    """An error that an engine raises."""


def test_of_several_errors_the_one_in_the_first_unit_is_raised_whichever_comes_first(monkeypatch):
    last_is_known = threading.Event()

    def waits(*told):
        result = futures.wait(*told)
        if result.done:
            last_is_known.set()
        return result

    class Failing(Digits):
        def parts(self, unit):
            if unit < 3:
                assert last_is_known.wait(60)
                yield Some()
                if unit < 2:
                    return
            raise Wrong(str(unit))

    monkeypatch.setattr("allworlds.engines.engine_table.wait", waits)

    seen = []
    with Threads(4) as threads, pytest.raises(Wrong, match=r"^2$"):
        seen.extend(part.unit for part in threads.map(Failing(), map(Number, [0, 1, 2, 3])))
    assert seen == [0, 1]


@pytest.mark.parametrize("error", [Wrong, TimeIsUp, KeyboardInterrupt])
def test_after_an_error_the_unit_at_work_is_waited_for_unless_there_is_no_time(error, monkeypatch):
    at_work, halted, on, left = (threading.Event() for _ in range(4))
    begun, patient = [], []
    shutdown = futures.ThreadPoolExecutor.shutdown

    def notes(pool, wait, **more):
        patient.append(wait)
        shutdown(pool, wait, **more)

    monkeypatch.setattr(futures.ThreadPoolExecutor, "shutdown", notes)

    class Slow(Digits):
        def parts(self, unit):
            begun.append(unit)
            at_work.set()
            assert halted.wait(60)
            if error is not Wrong:
                assert on.wait(60)
            left.set()
            yield Some()

        def halt(self):
            halted.set()

    def fail():
        with Threads(1, batch=3) as threads:
            parts = threads.map(Slow(), map(Number, [1, 2, 3]))
            threading.Thread(target=next, args=(parts, None), daemon=True).start()
            assert at_work.wait(60)
            raise error

    with pytest.raises(error):
        fail()
    assert patient == [error is Wrong]
    assert left.is_set() == (error is Wrong)
    on.set()
    assert left.wait(60)
    assert begun == [1]
