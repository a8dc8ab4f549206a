"""Words on the command line that mean nothing, or nothing together, or might mean two things."""

import json
import shlex

import pytest

from allworlds import check
from allworlds.cli.app import command_line
from recorded.record import LEAST, least

pytestmark = pytest.mark.usefixtures("without_workers")

EDGE = '{"sigma": [0, 1], "alpha": [1, 0]}'
ENOUGH = {verb: words.split() for verb, words in LEAST.items()}


def verbs():
    for name, command in command_line().commands.items():
        for sub, under in getattr(command, "commands", {}).items():
            yield f"{name} {sub}", under
        if not hasattr(command, "commands"):
            yield name, command


OPTIONS = [
    (verb, param)
    for verb, command in verbs()
    for param in command.params
    if param.param_type_name == "option" and not param.is_flag
]


def asked_of(param):
    """What the field of an option asks for: its callback reads a text by that."""
    return param.callback.asked


def one_a_type(options):
    """A verb and an option of it for each type of value that an option has."""
    found = {}
    for verb, param in options:
        found.setdefault((asked_of(param).parse, param.metavar), (verb, param.opts[0]))
    return [*found.values()]


@pytest.mark.parametrize(("verb", "command"), [*verbs()], ids=str)
def test_the_example_of_a_verb_is_a_whole_command(verb, command, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    first = command.help.splitlines()[0]
    begins = f"Example: allworlds {verb}"
    assert first.startswith(begins)
    command.make_context(verb, shlex.split(first.removeprefix(begins)))  # raises what is missing


@pytest.mark.parametrize(
    "words",
    [
        ["check", ""],
        ["run", "", "theta"],
        ["fuzz", "", "--runs", "1", "--edges", "3"],
        ["compare", ""],
    ],
)
def test_an_empty_explorer_is_not_the_default_one(refused, words):
    assert "explorer ''" in refused(*words)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("{", "file 'world': not JSON"),
        ('{"alpha": [1, 0]}', "file 'world': 'sigma' is missing; a map has 'sigma' and 'alpha'"),
        ("[]", "file 'world': there is no world in it"),
        ('{"law": "map"}', "file 'world': this is a report or a finding"),
    ],
)
def test_a_file_with_a_wrong_world_is_named(refused, text, said, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "world").write_text(text)
    assert said in refused("run", "algorithm1", "@world")


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ("run algorithm1 torus:0x3", "torus:0x3: R and C are at least 1"),
        ("run algorithm1 cubic:0", "cubic:0: N is even, and at least 2"),
        ("run", "run takes [EXPLORER] and a WORLD or --family, and nothing is given"),
        ("check --lighthouse none+none", "the lighthouse none stands there twice"),
        ("check --native .", "--native '.': it is a directory"),
        ("ambiguity twins k4 k4 --lighthouse movable", "legal are none, position, directional,"),
        (
            "ambiguity census --lighthouse movable --edges 1",
            "legal are none, position, directional,",
        ),
        ("check file.py?x=3", "'file.py?x=3' names no function; legal is file.py:FUNCTION?x=3"),
        ("check --where file.py:condition", "returns <function condition.<locals>.<lambda>>, not"),
        (
            "replay object.json",
            "file 'object.json': this is no finding and no report of one: it has no 'version'",
        ),
    ],
)
def test_a_refusal_says_what_would_be_legal(refused, words, said, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "object.json").write_text("{}")
    (tmp_path / "file.py").write_text("def condition(least):\n    return lambda map_: True\n")
    assert said in refused(*words.split())


OPEN = ("--dask", "--workers", "--graph")
"""Options that take other words than those of their metavar, too."""

FIXED = [(v, p) for v, p in OPTIONS if "|" in p.metavar and p.opts[0] not in OPEN]


@pytest.mark.parametrize(("verb", "option"), one_a_type(FIXED), ids=str)
def test_a_slip_in_a_word_of_a_fixed_set_is_told(refused, verb, option, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "a.json").write_text(EDGE)
    (param,) = (param for of, param in FIXED if of == verb and option in param.opts)
    word = max((word for word in param.metavar.split("|") if word.islower()), key=len)
    beside = {"--order": ["--graph", "a.json"], "--embeddings": ["--graph", "k4"]}
    given = beside.get(option, ["--worlds", "a.json"] if option == "--y" else [])
    err = refused(*least(verb, str(tmp_path)), *given, option, word[:-1])
    assert f"did you mean '{word}'?" in err


@pytest.mark.parametrize(
    ("words", "meant"),
    [
        ("check --class planer", "planar"),
        ("check --where cubik", "cubic"),
        ("check --where girt:4", "girth:4"),
        ("check --laws mapp,pose", "map"),
        ("check --policy randm:3", "random:3"),
        ("check --bound papr", "paper"),
        ("check --lighthouse labls", "labels"),
        ("check --task hom", "home"),
        ("check -o x.sarf", ".sarif"),
        ("check -o junt:x", "junit"),
        ("chek", "check"),
        ("run grid:3x3", "lattice:3x3"),
        ("run grid", "lattice:RxC"),
        ("run weel:5", "wheel:5"),
        ("run --family lattice:3", "lattice:RxC"),
        ("compare algorithm1 --family gird --to 20", "lattice"),
        ("init new --lang pyton", "python"),
        ("init new --lang js", "javascript"),
        ("fuzz --edges 3 --mix planr", "planar"),
        ("ambiguity search --vertices 2 --edges 2 --lighthouse positon", "position"),
    ],
)
def test_a_slip_in_a_name_is_told(refused, words, meant):
    assert f"id you mean '{meant}'?" in refused(*words.split())


@pytest.mark.parametrize(
    ("verb", "option"),
    [(verb, param.opts[0]) for verb, param in OPTIONS if not asked_of(param).repeated],
)
def test_an_option_of_one_value_is_given_once(refused, verb, option):
    twice = refused(*verb.split(), option, "one", f"{option}=two" if option[1] == "-" else "-otwo")
    assert twice == f"allworlds: {option} is 'one' and 'two'; give it once\n"


def test_an_option_that_may_be_repeated_or_says_nothing_more_is_taken_twice(cli, tmp_path):
    files = [word for name in ("a.csv", "b.csv") for word in ("-o", tmp_path / name)]
    assert cli("count", "--edges", 2, "-q", "--quiet", *files)[0] == 0
    assert len([*tmp_path.iterdir()]) == 2


@pytest.mark.parametrize(("verb", "option"), one_a_type(OPTIONS), ids=str)
def test_an_empty_text_is_no_value_of_any_option(refused, verb, option, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    command = least(verb, str(tmp_path))
    before = [*tmp_path.iterdir()]
    refused(*command, option, "")
    assert [*tmp_path.iterdir()] == before


NUMBERS = [(verb, param) for verb, param in OPTIONS if param.metavar in ("M", "N", "S", "MB", "R")]


@pytest.mark.parametrize(("verb", "option"), one_a_type(NUMBERS), ids=str)
@pytest.mark.parametrize("value", ["1_0", " 1", "١"])  # noqa: RUF001  # an Arabic digit
def test_a_number_is_written_with_ascii_digits_alone(refused, verb, option, value):
    assert repr(value) in refused(*least(verb, "out"), option, value)


@pytest.mark.parametrize("verb", ["explain", "replay"])
def test_a_file_of_findings_that_is_no_json_is_named(refused, verb, tmp_path):
    page = tmp_path / "page.html"
    page.write_text("<html>", encoding="utf-8")
    assert f"file '{page}' is not JSON" in refused(verb, page)


def test_an_explorer_without_the_bearing_that_it_needs_says_so(cli):
    code, out, _ = cli("check", "dfs", "--lighthouse", "none", "--edges", 1)
    assert code == 1
    assert "this explorer needs a bearing here" in out


@pytest.mark.parametrize("verb", ENOUGH)
def test_an_empty_argument_is_refused(refused, verb):
    arguments = [word for word in ENOUGH[verb] if not word.startswith("-")]
    if verb in ("run", "replay", "explain", "twins", "ambiguity class"):
        refused(*verb.split(), *["" for _ in arguments])


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["check", "--edges", "1", "--bound", "2", "--laws", "map"], "bound '2' has no effect"),
        (["check", "--edges", "1", "--bound", "none", "--laws", "bound"], "law 'bound' has no"),
        (["fuzz", "--edges", "1", "--runs", "1", "--bound", "m", "--laws", "map"], "bound 'm' has"),
        (["run", "theta", "--bound", "n", "--laws", "map"], "bound 'n' has no effect"),
        (["check", "--edges", "1", "--laws", "map,pose,map"], "'map' is named twice"),
        (
            ["run", "theta", "--holes", "10%"],
            "holes 10% has no effect on world 'theta', which is no family",
        ),
        *(
            (["check", "--edges", "1", "--estimate", option, *value], f"{said}has")
            for option, value, said in (
                ("-o", ["out.html"], "-o 'out.html' "),
                ("--corpus", ["out"], "corpus 'out' "),
                ("--run", ["out"], "run 'out' "),
            )
        ),
    ],
)
def test_an_option_without_effect_is_refused(refused, arguments, said):
    assert said in refused(*arguments)


@pytest.mark.parametrize(
    "arguments",
    [
        ["run", "lattice:3x3"],
        ["run", "--family", "random:4", "--seed", "3"],
        ["run", "--family", "dense:5", "--seed", "3"],
        ["run", "theta", "--seed", "3"],
        ["run", "theta", "--bound", "paper", "--laws", "map"],
        ["check", "--edges", "1", "--bound", "none", "--laws", "map"],
        ["check", "--edges", "1", "--schedules", "all", "--policy", "lifo"],
    ],
)
def test_what_may_be_named_in_every_run_is_legal_where_it_changes_nothing(arguments, cli):
    """A seed, a policy, the bound that is the default: scripts pass them always."""
    assert cli(*arguments)[0] == 0


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["run", "algorithm1"], "WORLD is missing: 'algorithm1' is an explorer"),
        (["run", "mine.py:explore"], "WORLD is missing: 'mine.py:explore' is an explorer"),
        (["run", "my.module:Class.explore"], "WORLD is missing"),
        (["run", "theta", "algorithm1"], "EXPLORER comes first"),
        (["run", EDGE, "mine.py:explore"], "EXPLORER comes first"),
        (["check", ":x"], "legal are module:attribute"),
        (["check", "mine.py:"], "legal are module:attribute"),
    ],
)
def test_a_word_in_the_place_of_another_is_told(refused, arguments, said):
    assert said in refused(*arguments)


@pytest.mark.parametrize(
    ("world", "said"),
    [
        ("cycle-999999", "cycle-N needs an integer N >= 1, and at most 10000"),
        ("path-1", "path-N needs an integer N >= 2"),
        ("wheel-2", "wheel-N needs an integer N >= 3"),
        ("bouquet-0", "bouquet-N needs an integer N >= 1"),
        ("thetta", "did you mean 'theta'?"),
        ("Theta", "did you mean 'theta'?"),
        ("w.json", "write '@w.json'"),
        ("[]", "or cycles of vertices and edges, not []"),
        ("7", "world '7' is neither JSON, nor @file, nor a name"),
        (EDGE.replace("}", ', "strat": 1}'), "'strat' is no key of a world"),
        (EDGE.replace("}", ', "alpha": [1, 0]}'), "'alpha' stands twice"),
    ],
)
def test_a_world_that_is_none_is_refused_with_what_may_be_meant(refused, world, said):
    assert said in refused("run", world)


def test_a_report_is_no_world_and_a_world_no_finding(refused, tmp_path):
    report = check(lambda _: (yield), edges=1).to_json()
    for name, document in (("report", report), ("finding", report["findings"][0])):
        file = tmp_path / name
        file.write_text(json.dumps(document))
        assert "a report or a finding, not a world" in refused("run", f"@{file}")
    file.write_text(EDGE)
    for verb in ("replay", "explain"):
        assert "a world or a map, not a finding" in refused(verb, file)


@pytest.mark.parametrize(
    ("shard", "said"),
    [
        ("0/99999999999999999999999", "N is at most 999999999"),
        ("9" * 5000 + "/1", "K/N"),
        ("1_0/20", "K/N"),
    ],
)
def test_a_shard_that_is_none_is_refused(refused, shard, said):
    assert said in refused("check", "--edges", "1", "--shard", shard)


def test_a_choice_that_was_not_asked_for_is_counted_rightly(refused, tmp_path):
    file = tmp_path / "asks.py"
    file.write_text(
        "def explore(first, *, choices):\n    for _ in range(first.degree - 1):\n"
        "        choices.pick('ab', of='edge')\n    return None\n    yield\n"
    )
    for family, said in (("path-2", "none was"), ("path-3", "none was"), ("loop", "only 1 was")):
        assert f"{said} asked for" in refused("run", f"{file}:explore", family, "--choices", "0,0")
    assert "only 2 were asked for" in refused("run", f"{file}:explore", "theta", "--choices=0,0,0")


def test_the_scope_says_no_bound_where_none_was_checked(cli):
    for verb in (["check"], ["fuzz", "--runs", "3"]):
        code, out, _ = cli(*verb, "--edges", "2", "--laws", "map,pose", "--json")
        assert code == 0
        document = json.loads(out)
        assert document["scope"]["bound"] == "none"
        assert {row["bound"] for row in document["rows"]} == {None}
    code, out, _ = cli("check", "--edges", "2", "--bound", "none", "--json")
    assert code == 0
    assert "bound" not in json.loads(out)["scope"]["laws"]


def test_a_current_directory_that_is_no_more_is_told_of(refused, tmp_path, monkeypatch):
    gone = tmp_path / "gone"
    gone.mkdir()
    monkeypatch.chdir(gone)
    gone.rmdir()
    said = refused("check", "--exec", "cat", "--edges", 1)
    assert "the current directory has been removed" in said


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (
            "run --exec ./robot theta --pdb",
            "--pdb is for Python; a compiled explorer: gdb -ex ",
        ),
        ("run --native ./robot.so theta --pdb", "-ex run --args python -m allworlds run ..."),
        ("run theta --pdb", "--pdb stops in an explorer of yours alone, not in algorithm1"),
        ("run shield:robot.py theta --pdb", "alone, not in shield:robot.py"),
        ("run robot.py theta --step 3", "--step 3 is where --pdb stops; give both"),
        ("run robot.py theta --step x --pdb", "'x' is not an integer"),
    ],
)
def test_the_debugger_is_for_explorers_of_the_users_in_python(refused, words, said):
    assert said in refused(*words.split())
