"""Certificates for Coq's kernel: what is written of a program, and that it is what it does."""

import re
import subprocess
import sys
from functools import partial
from pathlib import Path

import pytest

from allworlds.explorers.builtin.algorithm1 import algorithm1
from allworlds.explorers.loading import built_in, in_process_subject
from allworlds.protocol.choices import Choices, policy_named
from allworlds.world import worlds

COQ = Path(__file__).parents[2] / "proofs" / "coq"
SERVER = COQ / "explorer_server.py"
TREE_LINE = re.compile(
    r" *\(\(\d+, (None|Some \d+)\), (Node \d+ \[::|"
    r"Leaf \(NumberedMap \[::[\d; ]*\] \[::[\d; ]*\] \d+\))[]);.]*"
)
ONE_EDGE = """Definition tree : branches :=
[::
((1, Some 0), Node 0 [::
 ((1, None), Leaf (NumberedMap [:: 0; 1] [:: 1; 0] 1))]);
((2, Some 0), Node 0 [::
 ((2, Some 1), Leaf (NumberedMap [:: 1; 0] [:: 1; 0] 1))]);
((2, Some 1), Node 0 [::
 ((2, Some 0), Leaf (NumberedMap [:: 1; 0] [:: 1; 0] 1))])].
"""


@pytest.fixture
def trees(checkers):
    return checkers("certified_trees")


@pytest.fixture
def written(trees, tmp_path, capsys):
    """The exit code, the text of the file, and what is said, for some arguments."""

    def write(*arguments, name="mine.v"):
        file = tmp_path / name
        code = trees.write_certificate(["--certificate", str(file), *arguments])
        said = capsys.readouterr()
        return code, file.read_text() if file.exists() else None, said.out + said.err

    return write


def test_the_tree_of_algorithm_1_for_one_edge_is_the_example_in_coq(written):
    code, text, said = written("algorithm1", "--edges", "1")
    assert code == 0
    assert ONE_EDGE in text
    assert ": 3 runs, 6 motions and answers, " in said
    example = (COQ / "DecisionTrees.v").read_text().partition("Definition one_edge_tree : ")[2]
    in_coq = "".join(example.partition("].\n\n")[0].split())
    assert in_coq + "]." == "".join(ONE_EDGE.partition(" : ")[2].split())


def test_every_run_is_in_the_tree_and_nothing_else(trees):
    tree, runs, unanswered = trees.tree_of(built_in("algorithm1"), 3)
    assert (runs, unanswered.total()) == (sum(1 for _ in worlds(edges=3, places="all")), 0)
    visited = set()
    for world in worlds(edges=3, places="all"):
        state, percept = world.initial, world.first
        branches, way = tree, ()
        while True:
            way = (*way, trees.sensed(percept))
            visited.add(way)
            branch = branches[way[-1]]
            if isinstance(branch, trees.Leaf):
                break
            state, percept = world.step(state, trees.Move(branch.k))
            branches = branch.after
        assert branch.sigma
    assert len(visited) == trees.size_of(tree)


def test_the_file_is_the_same_behind_a_pipe_and_in_another_order_of_worlds(
    trees, written, monkeypatch
):
    _, text, _ = written("algorithm1", "--edges", "2")
    served = f"{sys.executable} {SERVER} algorithm1"
    code, piped, _ = written("--exec", served, "--edges", "2", name="piped.v")
    assert code == 0
    assert without_who(piped) == without_who(text)
    backwards = lambda **options: reversed(list(worlds(**options)))  # noqa: E731
    monkeypatch.setattr(trees, "worlds", backwards)
    assert written("algorithm1", "--edges", "2", name="other.v")[1] == text


def without_who(text):
    return text.partition("*)")[2]


def test_of_a_file_all_lines_but_those_of_the_tree_are_to_be_read_and_they_are_few(written):
    for edges, limit in ((3, "paper"), (2, "2*m*n")):
        _, text, _ = written("algorithm1", "--edges", str(edges), "--limit", limit)
        rest = [line for line in text.splitlines() if not TREE_LINE.fullmatch(line)]
        assert 22 <= len(rest) <= 26
        assert rest[:4] == text.splitlines()[:4]
        assert "Definition tree : branches :=" in rest
        assert rest[-1] == "Print Assumptions right_in_every_world."


def test_a_name_cannot_end_the_comment_that_it_stands_in(trees):
    text = trees.certificate({}, 1, 'x *) Axiom wish : False. (* " é')
    assert text.count("(*") == text.count("*)") == 1
    assert text.count('"') == 2  # of a warning that is switched off
    assert text.isascii()


def test_a_program_that_remembers_the_last_run_has_no_certificate(written):
    code, text, said = written("--exec", f"{sys.executable} {SERVER} state-kept", "--edges", "2")
    assert code == 1
    assert text is None
    assert said.startswith("NO FUNCTION  after (")


def test_a_program_that_answers_once_and_then_crashes_has_none(trees):
    runs = []

    def explore(first):
        runs.append(first)
        if len(runs) > 3:
            raise ValueError
        return (yield from algorithm1(first, choices=Choices(policy_named("fifo"))))

    with pytest.raises(trees.NoFunction, match=r"Nothing\(law='crash'\)"):
        trees.tree_of(in_process_subject(explore), 2)


def test_a_program_without_an_answer_is_written_down_as_far_as_it_goes(written):
    code, text, said = written("--exec", f"{sys.executable} {SERVER} no-answer", "--edges", "1")
    assert code == 1
    assert "Leaf" not in text
    assert text.count("Node 0 [::") == 3
    assert "NO ANSWER  no-estimate in 3 runs: coqc will refuse the file" in said


def test_a_reader_that_has_gone_is_no_fault(tmp_path):
    program = COQ / "certified.py"
    arguments = ["--certificate", str(tmp_path / "mine.v"), "algorithm1", "--edges", "1"]
    command = ["sh", "-c", '"$@" | :', "sh", sys.executable, str(program), *arguments]
    assert subprocess.run(command, capture_output=True, check=True).stderr == b""


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ([], "one explorer expected"),
        (["algorithm1", "--exec", "true"], "one explorer expected"),
        (["algorithm1", "--edges", "0"], "--edges 0: at least 1"),
        (["no-such-explorer"], "no-such-explorer"),
        (["--exec", "no-such-program"], "no-such-program"),
        (["algorithm1", "--limit", "n+", "--edges", "1"], "'n+'"),
        (["algorithm1", "--limit", "D", "--edges", "1"], "limit D: an expression in n, m and d0"),
        (["algorithm1", "--limit", "10**9", "--edges", "1"], "is too large"),
    ],
)
def test_bad_arguments_are_said_in_a_line(written, arguments, said):
    code, text, told = written(*arguments)
    assert code == 2
    assert text is None
    assert said in told
    assert told.count("\n") == 1


def test_a_file_that_coq_could_not_name_is_refused(written):
    code, text, said = written("algorithm1", name="1-mine.v")
    assert (code, text) == (2, None)
    assert "a name of letters, digits and _ expected" in said


def test_a_coq_that_accepts_everything_is_noticed(trees, monkeypatch, capsys):
    monkeypatch.setattr(trees, "asked_of_coq", lambda _file: "accepted")
    assert not trees.certificates_agree(2, ["mirror-image"])
    assert "the same from allworlds check: NO" in capsys.readouterr().out
    monkeypatch.setattr(trees, "asked_of_coq", lambda _file: "refused")
    assert not trees.certificates_agree(1, [])
    monkeypatch.setattr(trees, "asked_of_coq", lambda _file: "accepted")
    with pytest.raises(trees.NoVerdict, match="nothing refused"):
        trees.certificates_agree(1, [])


def test_percepts_have_a_mark_exactly_where_they_have_a_bearing(trees):
    percepts = {p for world in worlds(edges=2, places="all") for p in world.percepts}
    assert len({trees.sensed(percept) for percept in percepts}) == len(percepts)
    with pytest.raises(AssertionError):
        trees.sensed(partial(trees.Percept, 2)(1))
