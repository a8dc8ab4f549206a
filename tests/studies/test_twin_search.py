import json
import os
import stat
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

import allworlds
from allworlds.engines.listeners import NOBODY
from allworlds.inputs.checks import InputError
from allworlds.maps import CombinatorialMap
from allworlds.studies.ambiguity import solvers, twin_search as searching
from allworlds.studies.ambiguity.question import Question, Size, Sizes
from allworlds.studies.ambiguity.twin_search import bisimulation
from allworlds.world import Directional, Position, World
from allworlds.world.bisimulation import flaw
from searches import question

needs_python_sat = pytest.mark.skipif(
    not solvers.python_sat_is_installed(), reason="python-sat is not installed: no certificates"
)


def sizes(result):
    return [(world.map.edge_count, world.map.vertex_count) for world in result.pair]


def test_sizes_without_any_world_are_left_out():
    sizes = [one for one, _ in question("position", "simple", 4, 7).sizes()]
    wanted = [(1, 2, 2), (2, 3, 3), (3, 3, 4), (4, 4, 4), (5, 4, 4), (6, 4, 4)]
    assert [(size.edges, size.fewest, size.most) for size in sizes] == wanted
    *_, (largest, _) = question("position", "planar-simple", 5, 10).sizes()  # K5 has ten edges
    assert (largest.edges, largest.fewest, largest.most) == (9, 5, 5)


@pytest.mark.parametrize(
    "bounds",
    [
        {"degree_marked": 9, "vertices": 3, "edges": 3},
        {"map_class": "simple", "vertices": 1, "edges": 3},
        # The one world with one edge has two vertices: the first step leads away from v0.
        {"degree_marked": 1, "degree_others": 1, "vertices": 2, "edges": 1}
        | {"motions": (0,), "percepts": ("1P",)},
        {"vertices": 2, "edges": 2, "motions": (0,), "percepts": ("5A",)},
    ],
)
def test_bounds_without_any_world_are_vacuous(tmp_path, bounds):
    result = allworlds.search(lighthouse="position", out=tmp_path, **bounds)
    assert (result.exit_code, result.vacuous, result.certificate) == (4, True, None)


def test_twins_fit_the_walk(tmp_path):
    bounds = {"vertices": 2, "edges": 3, "motions": (0,)}
    for percept, status in (("1A", "unsat"), ("6P", "sat")):
        found = allworlds.search(
            lighthouse="position", percepts=(percept,), out=tmp_path / status, **bounds
        )
        assert found.status == status


def test_when_the_time_is_over_the_answer_is_unknown_and_never_unsat(tmp_path):
    bounds = {"vertices": 9, "edges": 6, "out": tmp_path}
    result = allworlds.search(lighthouse="directional", time_limit=1e-6, **bounds)
    assert (result.status, result.exit_code, result.pair) == ("unknown", 3, None)
    assert "undecided" in result.notices[-1]


def test_without_python_sat_there_is_no_certificate_but_a_notice(tmp_path, monkeypatch):
    monkeypatch.setattr(searching, "python_sat_is_installed", lambda: False)
    result = allworlds.search(lighthouse="position", vertices=2, edges=1, out=tmp_path)
    assert (result.status, result.certificate) == ("unsat", None)
    assert ".[proofs]" in result.notices[0]


def test_what_is_missing_for_certificates_is_told_once(tmp_path, monkeypatch):
    monkeypatch.setattr(searching, "python_sat_is_installed", lambda: False)
    result = allworlds.search(lighthouse="directional", vertices=3, edges=2, out=tmp_path)
    assert len(result.levels) > 1
    (told,) = [notice for notice in result.notices if ".[proofs]" in notice]
    assert f"and {len(result.levels) - 1} more" in told


@needs_python_sat
def test_a_proof_beyond_the_stated_size_is_left_unchecked_with_a_notice(tmp_path, monkeypatch):
    monkeypatch.setattr(searching, "PROOF_LIMIT", 10)
    result = allworlds.search(lighthouse="position", vertices=2, edges=1, out=tmp_path)
    assert (result.status, result.certificate) == ("unsat", None)
    assert "the checker of this package accepts 10" in result.notices[0]


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (
            {"lighthouse": "gps"},
            "lighthouse 'gps' is not one of none, position, directional, compass",
        ),
        ({"map_class": "trees"}, "class 'trees'"),
        ({"edges": 0}, "edges = 0"),
        ({"vertices": 0}, "vertices = 0"),
        ({"degree_marked": 0}, "degree-marked = 0"),
        ({"degree_others": -1}, "degree-others = -1"),
        ({"motions": (1, 1), "percepts": ("3A",)}, "2 motions and 1 percepts"),
        ({"motions": (1,), "percepts": ("3PP",)}, "percept '3PP' is not of the form"),
        ({"motions": (1,), "percepts": ("3AP",)}, "percept '3AP'"),
        ({"motions": (1,), "percepts": ("A",)}, "percept 'A'"),
        ({"motions": (1,), "percepts": ("3",)}, "percept '3'"),
        ({"lighthouse": "none", "motions": (1,), "percepts": ("4P",)}, "4P needs a marked vertex"),
        ({"time_limit": 0}, "time-limit 0"),
        ({"solver": "/nowhere/cadical"}, "'/nowhere/cadical' cannot be run"),
        ({"solver": "/bin/true"}, "legal is CaDiCaL 2 or later"),
    ],
)
def test_bad_input_is_refused_in_one_line_that_names_it(tmp_path, options, message):
    asked = {"lighthouse": "position", "vertices": 3, "edges": 2, "out": tmp_path, **options}
    with pytest.raises(InputError) as refusal:
        allworlds.search(**asked)
    assert message in str(refusal.value)
    assert "\n" not in str(refusal.value)


SENSORS = Path(__file__).parents[2] / "papers" / "minimal_information" / "sensors.py"


@pytest.mark.parametrize("sensor", ["Bit?of=behind", "Glow", "Face", "Features"])
def test_a_sensor_that_looks_further_is_refused_in_one_line(sensor):
    with pytest.raises(InputError, match="does not show marks at v0 alone") as refusal:
        question(f"{SENSORS}:{sensor}", "maps", 3, 2)
    assert "\n" not in str(refusal.value)


def test_letters_are_those_of_a_star():
    assert question("door", "maps", 3, 2).words == {
        1: (1,),
        2: (1, 0),
        3: (1, 0, 0),
        4: (1, 0, 0, 0),
    }
    assert question("word:12", "maps", 3, 2).words[3] == (1, 2, 1)
    assert question(f"{SENSORS}:Half", "maps", 3, 2).words[3] == (1, 1, 2)
    assert question("position", "maps", 3, 2).words == {}


def script(path, body):
    """A program that says it is CaDiCaL 2, and then does as it likes."""
    version = "if '--version' in sys.argv:\n    print('2.1.3')\n    sys.exit()"
    path.write_text(f"#!{sys.executable}\nimport sys\n{version}\n{body}\n")
    path.chmod(path.stat().st_mode | stat.S_IXUSR)
    return str(path)


def test_an_external_solver_whose_proof_is_wrong_is_not_believed(tmp_path):
    body = "open(sys.argv[-1], 'w').write('9999 0 1 0\\n')\nprint('s UNSATISFIABLE')"
    solver = script(tmp_path / "liar", body)
    bounds = {"vertices": 3, "edges": 2, "solver": solver, "out": tmp_path / "out"}
    result = allworlds.search(lighthouse="position", **bounds)
    assert (result.status, result.exit_code, result.certificate) == ("unknown", 3, None)
    assert "line 1 of the LRAT proof" in result.notices[0]


def test_an_external_solver_whose_model_is_wrong_is_an_internal_error(tmp_path):
    # Variables 1.. are sigma and alpha: all true is no map at all.
    body = "print('s SATISFIABLE')\nprint('v', *range(1, 200), 0)\nsys.exit(10)"
    solver = script(tmp_path / "liar", body)
    with pytest.raises(RuntimeError, match="no pair of worlds"):
        allworlds.search(lighthouse="position", vertices=2, edges=1, solver=solver, out=tmp_path)


@pytest.mark.parametrize("body", ["print('c UNKNOWN')", "import time; time.sleep(600)"])
def test_an_external_solver_that_does_not_know_gives_no_answer(tmp_path, body):
    solver = script(tmp_path / "idle", body)
    bounds = {"vertices": 3, "edges": 2, "out": tmp_path / "out", "time_limit": 1}
    result = allworlds.search(lighthouse="position", solver=solver, **bounds)
    assert (result.status, result.exit_code) == ("unknown", 3)


def test_an_external_solver_is_found_where_its_relative_path_leads(tmp_path, monkeypatch):
    script(tmp_path / "idle", "print('c UNKNOWN')")
    monkeypatch.chdir(tmp_path)
    found = allworlds.search(
        lighthouse="position", vertices=3, edges=2, solver="./idle", out=tmp_path / "out"
    )
    assert found.status == "unknown"


def test_an_external_solver_without_a_verdict_is_an_internal_error(tmp_path):
    solver = script(tmp_path / "mute", "print('hello')")
    with pytest.raises(RuntimeError, match="no verdict: hello"):
        allworlds.search(lighthouse="position", vertices=2, edges=1, solver=solver, out=tmp_path)


@needs_python_sat
def test_two_solvers_that_disagree_are_an_internal_error(tmp_path, monkeypatch):
    monkeypatch.setattr(searching, "solve_with_z3", lambda *_: solvers.SolverAnswer("unsat"))
    monkeypatch.setattr(searching._TwinsSearch, "_some_world_exists", lambda _: True)
    with pytest.raises(RuntimeError, match="disagree"):
        allworlds.search(lighthouse="position", vertices=3, edges=2, out=tmp_path)


def test_a_directory_that_cannot_be_made_is_bad_input(tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(InputError, match="cannot be made"):
        allworlds.search(lighthouse="none", vertices=2, edges=1, out=tmp_path / "file" / "x")


@pytest.mark.skipif("CADICAL" not in os.environ, reason="CADICAL does not name a CaDiCaL 2")
def test_an_external_cadical_gives_the_same_answers_with_proofs(tmp_path):
    asked = {"vertices": 9, "solver": os.environ["CADICAL"]}
    none = allworlds.search(lighthouse="directional", edges=5, out=tmp_path / "none", **asked)
    assert (none.status, none.certificate) == ("unsat", tmp_path / "none")
    one = allworlds.search(lighthouse="position", edges=2, out=tmp_path / "one", **asked)
    assert (one.status, sizes(one)) == ("sat", [(2, 1), (2, 1)])


def test_the_document_holds_the_pair_its_bisimulation_and_its_files(tmp_path):
    result = allworlds.search(lighthouse="position", vertices=3, edges=2, out=tmp_path)
    document = json.loads(json.dumps(result.to_json()))
    assert document["schema"] == 2
    assert document["status"] == "sat"
    a, b = (World.from_json(world) for world in document["pair"])
    assert [list(classes) for classes in bisimulation(a, b)] == document["bisimulation"]
    assert flaw((a, b), document["bisimulation"]) is None
    certificate = json.loads((tmp_path / "pair.json").read_text())
    assert certificate == {key: document[key] for key in ("pair", "bisimulation")}
    assert document["certificate"] == str(tmp_path / "pair.json")


def test_a_pair_that_can_be_told_apart_has_no_bisimulation():
    theta = CombinatorialMap([2, 3, 4, 5, 0, 1], [1, 0, 3, 2, 5, 4])
    other = CombinatorialMap([2, 5, 4, 1, 0, 3], [1, 0, 3, 2, 5, 4])
    pointed = [World(map_, Directional(0)) for map_ in (theta, other)]
    assert "differ in sense" in flaw(pointed, bisimulation(*pointed))
    # With the position alone nothing tells three parallel edges in the plane and on the torus.
    marked = [World(map_, Position(0)) for map_ in (theta, other)]
    assert flaw(marked, bisimulation(*marked)) is None


def test_twins_agree_that_the_pairs_found_look_alike(tmp_path):
    for lighthouse in ("position", "none", "compass"):
        result = allworlds.search(
            lighthouse=lighthouse, vertices=3, edges=2, out=tmp_path / lighthouse
        )
        assert not allworlds.twins(*result.pair).distinguishable


@pytest.mark.parametrize("error", [RuntimeError, InputError])
def test_a_search_without_a_result_leaves_no_temporary_directory(tmp_path, monkeypatch, error):
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))

    def stop(*_):
        assert [found.name[:17] for found in tmp_path.iterdir()] == ["allworlds-search-"]
        raise error

    monkeypatch.setattr("allworlds.studies.ambiguity.formulas.pair_formula", stop)
    with pytest.raises(error):
        allworlds.search(lighthouse="position", vertices=2, edges=2)
    assert [*tmp_path.iterdir()] == []


class Fewer(searching._TwinsSearch):
    """A search that finds pairs with ever fewer vertices, down to 3 and 2."""

    def _decide(self, sizes):
        most = [size.most for size in sizes]
        return SimpleNamespace(twins=pair_of(*most) if min(most) > 1 else None, status="unsat")


def pair_of(*counts):
    """Two worlds with so many vertices."""
    worlds = (SimpleNamespace(map=SimpleNamespace(vertex_count=count)) for count in counts)
    return SimpleNamespace(pair=[*worlds], counts=counts)


def test_a_pair_is_made_smaller_until_none_has_fewer_vertices():
    search = Fewer(question("position", "maps", 5, 4), None, Path(), None, None)
    both = Sizes(Size(4, 1, 5), Size(4, 1, 5))
    assert search._fewer_vertices(both, pair_of(5, 4)).counts == (3, 2)


class Undecided(searching._TwinsSearch):
    """A search in which no pair with fewer vertices is found in time."""

    def _decide(self, sizes):
        return SimpleNamespace(twins=None, status="unknown")


def test_a_pair_stays_as_it_is_when_the_time_is_over_and_that_is_told():
    search = Undecided(question("none", "maps", 5, 4), None, Path(), None, None)
    both = Sizes(Size(4, 1, 5), Size(4, 1, 5))
    assert search._fewer_vertices(both, pair_of(5, 4)).counts == (5, 4)
    assert search.notices == ["the time was over before fewer vertices were tried"]


def test_a_right_proof_of_an_external_solver_is_accepted(tmp_path):
    (tmp_path / "x.lrat").write_text("3 0 1 2 0\n")
    search = searching._TwinsSearch(question("none", "maps", 1, 1), None, tmp_path, None, None)
    formula = SimpleNamespace(clauses=[(1,), (-1,)])
    assert search._accepts(formula, tmp_path / "x.lrat") is True
    assert search._accepts(formula, tmp_path / "none.lrat") is False
    (refused,) = search.notices
    assert refused.startswith(f"the solver's proof {tmp_path}/none.lrat is refused: ")


def test_without_time_for_a_proof_there_is_no_certificate(tmp_path, monkeypatch):
    monkeypatch.setattr(searching, "python_sat_is_installed", lambda: True)
    monkeypatch.setattr(searching, "solve_with_python_sat", lambda *_: solvers.UNKNOWN)
    result = allworlds.search(lighthouse="position", vertices=2, edges=1, out=tmp_path)
    assert (result.status, result.certificate) == ("unsat", None)
    assert result.notices == ("no certificate for m1n1to2.cnf: the time was over",)


class OneWorld(searching._TwinsSearch):
    """A search that meets in each formula a pair that is one world with two starts."""

    def _decide(self, sizes):
        found = searching.Searched(
            sizes=sizes, status="unsat", formula=Path(), proof=None, seconds=0.0, same_map=(None,)
        )
        self.done.append(found)
        return found

    def _some_world_exists(self):
        return True

    def _prove(self):
        return False


def test_pairs_that_are_one_world_are_counted_and_told():
    search = OneWorld(question("position", "maps", 2, 2), None, Path(), None, NOBODY)
    assert len(search.done) == 0
    assert search._searched().status == "unsat"
    assert len(search.done) == 2
    (told,) = search.notices
    assert told == (
        "2 pairs were met that are one world with two starts which look alike: "
        "the map can be told, the robot's place in it cannot"
    )


@pytest.mark.parametrize(
    ("degrees", "wanted"),
    [
        # The start's vertex has a dart at least: 2 m > 3 (n - 1).
        ({"degree_others": 3}, [(1, 1, 1), (2, 1, 2), (3, 1, 2), (4, 1, 3)]),
        # n - 1 edges at least leave the others a dart each: 4 <= 2 m - (n - 1).
        ({"degree_marked": 4}, [(2, 1, 1), (3, 1, 3), (4, 1, 5)]),
        # 2 m = 2 + 3 (n - 1)
        ({"degree_marked": 2, "degree_others": 3}, [(1, 1, 1), (4, 3, 3)]),
    ],
)
def test_sizes_that_no_degrees_can_have_are_left_out(degrees, wanted):
    sizes = [one for one, _ in question("position", "maps", 5, 4, **degrees).sizes()]
    assert [(size.edges, size.fewest, size.most) for size in sizes] == wanted


@pytest.mark.parametrize("name", ["vertices", "edges"])
def test_a_question_is_of_maps_up_to_a_size(name, monkeypatch):
    monkeypatch.setattr(Question, "words", {})  # stars of each degree, made one by one
    for legal in (1, 100_000):
        asked = {"vertices": 1, "edges": 1, name: legal}
        assert getattr(question("position", "maps", **asked), name) == legal
    for wrong, told in (
        (0, f"{name} = 0, but a map has at least 1"),
        (100_001, f"{name} = 100001 is too big; at most 100,000 is legal"),
    ):
        with pytest.raises(InputError, match=told):
            question("position", "maps", **{"vertices": 1, "edges": 1, name: wrong})


@pytest.mark.parametrize("name", ["degree_marked", "degree_others"])
def test_a_vertex_of_a_question_has_a_dart_at_least(name):
    assert getattr(question("position", "maps", 2, 1, **{name: 1}), name) == 1
    told = f"{name.replace('_', '-')} = 0, but every vertex has at least 1 dart"
    with pytest.raises(InputError, match=told):
        question("position", "maps", 2, 1, **{name: 0})


def test_solvers_are_waited_for_at_most_a_million_seconds(tmp_path):
    asked = {"lighthouse": "position", "vertices": 1, "edges": 1, "out": tmp_path}
    with pytest.raises(InputError, match="time-limit = 1000001 is too big; at most 1,000,000 is"):
        allworlds.search(time_limit=1_000_001, **asked)
    assert allworlds.search(time_limit=1_000_000, **asked).status == "unsat"
