"""The extracted checker reads strict JSON, and says in a line how each program has ended."""

import json
import shutil
import subprocess
import sys

import pytest

from proofs import test_odd_programs as quick
from proofs.test_odd_programs import COQ, ODD
from small import every

checker = quick.checker
lines = quick.lines

needs_checker = pytest.mark.skipif(
    not (COQ / "checker").exists(), reason="not built: make -C proofs/coq explorer"
)


needs_ocaml = pytest.mark.skipif(
    shutil.which("ocamlopt") is None or not (COQ / "ocaml" / "certified.cmx").exists(),
    reason="OCaml is not installed, or not built: make -C proofs/coq explorer",
)


@needs_checker
@pytest.mark.parametrize("name", every(20, ODD))
def test_both_checkers_say_of_an_odd_program_what_is_to_be_said(lines, name):
    assert lines.laws_of(name, ODD[name]) == ODD[name].laws


def checked(*arguments, stack=8192):
    """Ask the extracted checker about worlds with one edge, with this many KiB of stack."""
    command = ["sh", "-c", f'ulimit -s {stack} && exec "$@"', "sh", str(COQ / "checker"), "1"]
    command += arguments
    return subprocess.run(command, capture_output=True, text=True, check=False, timeout=300)


@needs_checker
def test_a_program_that_never_stops_has_no_answer_however_high_the_limit(tmp_path):
    """In a stack that ten thousand calls, each inside the one before, would not fit into."""
    program = tmp_path / "endless.py"
    program.write_text("import sys\nfor _ in sys.stdin: print('{\"move\":0}', flush=True)\n")
    run = checked("--limit", "10000", "--exec", sys.executable, "-S", str(program), stack=256)
    assert run.returncode == 0, run.stderr
    answer = json.loads(run.stdout)
    assert answer["verdict"] == "refuted"
    assert {r["finding"] for r in answer["refutations"]} == {"no answer within the limit"}


@needs_checker
@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--exec", "no-such-program"], "no-such-program: No such file or directory"),
        (["--limit", '{"2 1 1": 1, "2 1 1": 2}', "--policy", "fifo"], "stands twice"),
        (["--limit", '{"2 1 1": 1}', "--policy", "fifo"], "no limit for n = 1, m = 1, d0 = 2"),
        (["--limit", "1_0", "--policy", "fifo"], "--limit: column 2: the end of the line"),
        (["--limit", "-1", "--policy", "fifo"], "usage: checker EDGES"),
        (["--timeout", "inf", "--policy", "fifo"], "usage: checker EDGES"),
    ],
)
def test_a_question_that_is_none_is_said(arguments, said):
    run = checked(*arguments)
    assert (run.returncode, run.stdout) == (2, "")
    assert run.stderr.startswith("checker: ")
    assert said in run.stderr


# Each with the odd program that tells it from the right one.
MUTANTS = [
    ("json.ml", "if not !integer then", "if false then", "fraction"),
    ("json.ml", "if peek () = '0' then incr at else digits ()", "digits ()", "leading zero"),
    ("json.ml", "if Hashtbl.mem seen key then", "if false then", "key twice in the answer"),
    ("json.ml", "if depth > deepest then", "if false then", "five million brackets"),
    ("json.ml", "String.length whole > longest", "false", "4301 digits"),
    ("json.ml", "String.length whole > 18", "false", "large"),
    ("json.ml", "c when c < ' ' -> fail", "c when c < '\\000' -> fail", "control character"),
    ("json.ml", "let n = width line !at in", "let n = max 1 (width line !at) in", "no UTF-8"),
    ("json.ml", "else if first < 0xC2 then 0", "else if first < 0xC0 then 0", "UTF-8 too long"),
    ("json.ml", '| _ -> fail "an escape"', "| _ -> incr at", "bad escape"),
    ("json.ml", "with ' ' | '\\t'", "with ' ' | '\\012' | '\\t'", "form feed"),
    (
        "json.ml",
        'if !at < length then fail "the end of the line"',
        "if false then ()",
        "words after",
    ),
    ("pipe.ml", '"estimate"; "ambiguous"]', '"estimate"]', "motion and ambiguous"),
    ("pipe.ml", "when Buffer.length p.buffer > 0", "when false", "motion after the answer"),
    ("pipe.ml", "if whole c then None", "if true then None", "checkpoint of nothing"),
    ("pipe.ml", "when checkpoints = t.most_checkpoints", "when false", "110 checkpoints first"),
]


def mutated(folder, file, old, new):
    """The checker with one word of a driver replaced."""
    ocaml = shutil.copytree(COQ / "ocaml", folder / "ocaml")
    text = (ocaml / file).read_text()
    assert text.count(old) == 1
    (ocaml / file).write_text(text.replace(old, new))
    sources = ["unix.cmxa", "json.ml", "tail.cmx", "certified.cmx", "pipe.ml", "checker.ml"]
    build = ["ocamlopt", "-w", "-a", "-I", ".", "-o", "checker", *sources]
    subprocess.run(build, cwd=ocaml, check=True, timeout=120)
    return ocaml / "checker"


def refuted(program, command, edges="1"):
    """The worlds in which a checker refutes a command, each with the law that is broken."""
    run = [str(program), edges, "--timeout", "1", "--exec", *command]
    said = subprocess.run(run, capture_output=True, text=True, check=False, timeout=120).stdout
    try:
        found = json.loads(said).get("refutations", [])
    except ValueError:
        return "no verdict"
    return [(r["sigma"], r["alpha"], r["place"], r.get("fault", r["finding"])) for r in found]


@needs_ocaml
@pytest.mark.parametrize(("file", "old", "new", "name"), MUTANTS)
def test_a_reader_that_is_wrong_is_noticed(lines, tmp_path, file, old, new, name):
    right = refuted(COQ / "checker", lines.command(name))
    assert (right == []) == (ODD[name].laws[1] == "")
    assert refuted(mutated(tmp_path, file, old, new), lines.command(name)) != right


LARGE = """
import json, subprocess, sys
told = subprocess.Popen([sys.argv[1]], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
sign = 1
for line in sys.stdin:
    print(line, end="", file=told.stdin, flush=True)
    said = json.loads(told.stdout.readline())
    if "move" in said:
        said["move"] += sign * json.loads(line)["percept"]["degree"] * 10**25
        sign = -sign
    print(json.dumps(said), flush=True)
"""
"""Algorithm 1, each motion some turns more, or fewer, than it should be: the motion is the same."""


@needs_ocaml
@pytest.mark.parametrize(
    ("old", "new", "holds"),
    [
        ("", "", True),
        ("then (n - rest) mod n else rest", "then rest else rest", False),
        ("(10 * r + ", "(r + ", False),
    ],
)
def test_motions_by_large_integers_are_those_modulo_the_degree(tmp_path, old, new, holds):
    path = tmp_path / "large.py"
    path.write_text(LARGE)
    command = [sys.executable, "-S", str(path), str(COQ / "explorer")]
    program = mutated(tmp_path, "json.ml", old, new) if old else COQ / "checker"
    assert (refuted(program, command, edges="2") == []) == holds


SEQ = """
(* as MathComp's seq.v has them *)
let rec cat s1 s2 = match s1 with [] -> s2 | x :: s -> x :: cat s s2
let rec rcons s z = match s with [] -> [z] | x :: s -> x :: rcons s z
let rec map f = function [] -> [] | x :: s -> let y = f x in y :: map f s
let rec filter a = function [] -> [] | x :: s -> if a x then x :: filter a s else filter a s
let rec pmap f = function
  | [] -> [] | x :: s -> match f x with Some y -> y :: pmap f s | None -> pmap f s
let rec foldr f z = function [] -> z | x :: s -> f x (foldr f z s)
let rec iota m n = if n = 0 then [] else m :: iota (m + 1) (n - 1)
let rec lists n = if n = 0 then [[]] else
  [] :: List.concat_map (fun s -> List.map (fun x -> x :: s) [0; 1; 2]) (lists (n - 1))
let require what holds = if not holds then (prerr_endline what; exit 1)
let half x = if x > 0 then Some (x / 2) else None
let () =
  let told = ref [] in
  let tell x = told := x :: !told; x > 0 in
  let telling f s = told := []; let found = f tell s in (found, !told) in
  List.iter (fun s ->
    require "map" (Tail.map succ s = map succ s);
    require "filter" (telling Tail.filter s = telling filter s);
    require "pmap" (Tail.pmap half s = pmap half s);
    require "foldr" (Tail.foldr (fun x z -> x - 2 * z) 7 s = foldr (fun x z -> x - 2 * z) 7 s);
    require "rcons" (Tail.rcons s 5 = rcons s 5);
    List.iter (fun t -> require "cat" (Tail.cat s t = cat s t)) (lists 2)) (lists 6);
  for m = 0 to 4 do for n = 0 to 4 do require "iota" (Tail.iota m n = iota m n) done done;
  let many = Tail.iota 0 3_000_000 in
  let more = Tail.cat (Tail.rcons (Tail.filter (fun _ -> true) (Tail.map succ many)) 0) many in
  require "long" (Tail.foldr (+) 0 (Tail.pmap half more) > 0)
"""


@needs_ocaml
@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("", "", ""),
        ("List.rev (List.rev_map f s)", "List.rev_map f s", "map\n"),
        ("if a x then", "if not (a x) then", "filter\n"),
        ("z (List.rev s)", "z s", "foldr\n"),
        ("(List.rev s1) s2", "s1 s2", "cat\n"),
        ("from (m + n) []", "from n []", "iota\n"),
        ("(List.rev s) [x]", "s [x]", "rcons\n"),
        ("Some y -> y :: kept", "Some y -> kept", "pmap\n"),
        (
            "let map f s = List.rev (List.rev_map f s)",
            "let map f s = List.fold_right (fun x s -> f x :: s) s []",
            "Stack",
        ),
    ],
)
def test_lists_without_stack_are_those_of_mathcomp(tmp_path, old, new, said):
    text = (COQ / "ocaml" / "tail.ml").read_text()
    assert text.count(old) == 1 or not old
    (tmp_path / "tail.ml").write_text(text.replace(old, new) if old else text)
    (tmp_path / "seq.ml").write_text(SEQ)
    build = ["ocamlopt", "-w", "-a", "-o", "seq", "tail.ml", "seq.ml"]
    subprocess.run(build, cwd=tmp_path, check=True, timeout=120)
    run = subprocess.run([tmp_path / "seq"], capture_output=True, text=True, check=False)
    assert (run.returncode == 0) == (said == "")
    assert said in run.stderr or run.returncode < 0
