"""What the prompts tell of Scenic is true of the installed Scenic: examples, operators, mistakes, names."""

import re

import pytest

from c2s_engine.write.prompted import blocks, knowledge
from c2s_engine.write.prompted.examples import examples

HEADER = (
    "param map = localPath('town.xodr')\nparam carla_map = None\nmodel scenic.simulators.carla.model\n"
    "lane = Uniform(*filter(lambda l: l.centerline.length > 120, network.lanes))\n"
    "spot = new OrientedPoint on lane.centerline\nego = new Car at spot\n"
)


def errors(report) -> list[str]:
    return [d.message for s in report.stages for d in s.diagnostics if d.severity == "error"]


def mostly_full(values, kept: int) -> list:
    """The first of some parameters in every run, the others in the full one."""
    return [v if i < kept else pytest.param(*v if isinstance(v, tuple) else [v], marks=pytest.mark.full)
            for i, v in enumerate(values)]  # fmt: skip


@pytest.mark.parametrize("number", mostly_full(examples(), 3))
def test_the_example_programs_compile_and_sample(checker, number):
    report = checker.check(examples()[number].text)
    assert report.ok, errors(report)
    assert report.stages[-1].name == "sample"


def test_the_examples_have_all_components():
    assert len(examples()) == 12
    for example in examples().values():
        ids = [f.id for f in example.fragments]
        assert ids[:3] == ["G", "R", "E"] and ids[-1] == "T" and ids[3] == "O1"
        assert all(f.sentence.endswith(".") and f.code for f in example.fragments)


def test_all_operators_compile(checker):
    rows = [row["example"].replace("x = ", f"x{i} = ") for i, row in enumerate(blocks.operators())]
    report = checker.check(HEADER + "\n".join(rows) + "\n", upto="compile")
    assert report.ok, errors(report)
    assert len(rows) == 15


PAIRS = [(kind, i) for kind, pairs in blocks.example_table()["pairs"].items() for i in range(len(pairs))]


@pytest.mark.parametrize(("kind", "index"), mostly_full(PAIRS, 3))
def test_corrections_are_right_and_mistakes_are_wrong(checker, kind, index):
    pair = blocks.example_table()["pairs"][kind][index]
    before = ""
    if pair["after"]:
        parts = {f.id: f.code for f in examples()[pair["after"]].fragments}
        wanted = {"R": "G", "E": "GR", "O": "GRE", "T": "GRE"}[kind]
        before = "\n\n".join(parts[k] for k in wanted) + "\n\n"
    right = checker.check(before + pair["right"], upto="sample")
    wrong = checker.check(before + pair["wrong"], upto="sample")
    assert right.ok, errors(right)
    assert not wrong.ok, "this is no mistake"


def test_names_that_are_told_exist(checker):
    """Each class, behaviour, action and function of the CP blocks is known to the model: a use of it compiles."""
    lines = [f"known{i} = {name}" for i, name in enumerate(sorted(knowledge.names()))]
    report = checker.check(HEADER + "\n".join(lines) + "\n", upto="compile")
    assert report.ok, errors(report)
    assert len(lines) > 40


def test_the_blocks_are_made_from_the_tables():
    place, ego, thing = blocks.contextual("R"), blocks.contextual("E"), blocks.contextual("O")
    assert "NetworkElement -> {LinearElement -> {Road," in place and "laneToLeft" in place
    assert "FollowLaneBehavior(target_speed" in ego and "SetBrakeAction(brake)" in ego
    assert "VendingMachine" in thing and "VendingMachine" not in ego
    assert knowledge.version() in place
    for kind in "GREOT":
        assert not re.search(r"\$\w", blocks.contextual(kind) + blocks.fixed_examples(kind) + blocks.thinking(kind))


@pytest.mark.parametrize("kind", "REOT")
def test_examples_use_only_names_that_the_prompt_lists_or_they_define(kind):
    """ "Use only the names that stand in this prompt": the examples must not teach others than the lists explain."""
    shown = blocks.fixed_examples(kind)
    lists = blocks.contextual(kind) + " ".join(sorted(knowledge.names()))
    called = set(re.findall(r"(?<![.\w'])([A-Za-z_]\w*)(?=\()", shown))
    members = set(re.findall(r"(?<![\d'.])\.([a-z]\w*)", re.sub(r"'[^']*'|scenic\.[\w.]+", "", shown)))
    defined = set(re.findall(r"(?:behavior|monitor|def) (\w+)", shown)) | {"localPath", "len", "simulation"}
    known = set(re.findall(r"\w+", lists)) | defined
    told = knowledge.road_elements()
    known |= {a.split("(")[0] for attributes in told.values() for a in attributes}
    assert called <= known, called - known
    assert members <= known, members - known


def test_headers_define_what_egos_use():
    for example in examples().values():
        parts = {f.id: f.code for f in example.fragments}
        assert "EGO_MODEL = 'vehicle." in parts["G"] and "with blueprint EGO_MODEL" in parts["E"], example.number
