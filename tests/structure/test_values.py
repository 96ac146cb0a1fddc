"""The pure parts: typed values, fragments under edit, marks, clipboard, preferences, commands."""

import pytest
from hypothesis import given
from hypothesis import strategies as st
from scripted_engine import Writer, cut_in, run_facts, trajectories
from textual.widgets import Input, TextArea

from c2s_engine.require import evaluate, require
from c2s_engine.structure.diagnostics import Diagnostic, TextEdit
from c2s_engine.structure.edits import AddObject, EditError, SetField, apply
from c2s_engine.structure.program import assemble
from c2s_engine.structure.regenerate import regenerate
from c2s_engine.structure.specs import SPEC_OF, ObjectSpec
from c2s_engine.structure.values import fields, parse, show
from c2s_tui import prefs
from c2s_tui.clipboard import copy, osc52
from c2s_tui.code.fragments import changed_lines, moved_findings, moved_spans
from c2s_tui.code.highlight import Blocks, lexer, stale
from c2s_tui.commands import bindings, commands, function_keys, split
from c2s_tui.desk import Desk
from c2s_tui.look.kinds import mentions
from c2s_tui.sheet.rows import rows

PROGRAM = assemble(regenerate(cut_in(), (), Writer())[0])


def by_path(cid: str) -> dict:
    return {f.path: f for f in fields(cut_in()[cid].spec)}


@pytest.mark.parametrize(
    ("cid", "path", "typed", "value"),
    [
        ("E", "speed", "50", 13.8889), ("E", "speed", "50 km/h", 13.8889), ("E", "speed", "10 m/s", 10.0),
        ("E", "speed", "30 mph", 13.4112),
        ("O1", "speed", "35-40", [9.7222, 11.1111]),
        ("O1", "placement.gap", "5 to 8 m", [5.0, 8.0]),
        ("O1", "type", "motor", "motorcycle"), ("O1", "count", "3", 3), ("G", "weather", "fog, wind", ["fog", "wind"]),
        ("R", "oncoming", "yes", True), ("R", "lanes", "", None), ("E", "hard", "no", False),
    ],
)  # fmt: skip
def test_typed_text_becomes_a_value(cid, path, typed, value):
    field = by_path(cid)[path]
    assert parse(field, typed) == value
    if value is not None:
        apply(cut_in(), SetField(component=cid, path=path, value=value))  # and the spec takes it


@pytest.mark.parametrize(
    ("cid", "path", "typed"), [("O1", "type", "submarine"), ("E", "speed", "fast"), ("E", "speed", "5 kg")]
)
def test_what_cannot_stand_there_is_refused_with_what_could(cid, path, typed):
    with pytest.raises(EditError) as refused:
        parse(by_path(cid)[path], typed)
    assert len(str(refused.value)) > 20


def test_what_is_shown_can_be_typed_back():
    for component in cut_in().components:
        for field in fields(component.spec):
            if field.leaf and field.set and not isinstance(field.value, dict):
                assert parse(field, show(field)) == pytest.approx(field.value, rel=1e-3) if field.unit else True


def test_every_spec_can_be_shown():
    for spec in SPEC_OF.values():
        assert {f.path.split(".")[0] for f in fields(spec())} == set(spec.model_fields) - {"component"}


@given(st.data())
def test_fragments_keep_their_borders_under_any_edit_inside_one(data):
    span = data.draw(st.sampled_from(PROGRAM.spans))
    lines = PROGRAM.text.split("\n")
    first = data.draw(st.integers(span.first, span.last - 1))
    last = data.draw(st.integers(first, span.last - 1))
    new = data.draw(st.lists(st.text("abc =()#", max_size=12), max_size=5))
    text = "\n".join(lines[:first] + new + lines[last:])
    moved = moved_spans(PROGRAM, text)
    assert [s.component for s in moved] == [s.component for s in PROGRAM.spans]
    assert all(a.last + 1 == b.first for a, b in zip(moved, moved[1:], strict=False))


def test_findings_stay_at_their_lines_and_go_with_them():
    here = Diagnostic(stage="compile", message="x", line=3, edit=TextEdit(first=3, last=3, text="C", reason="r"))
    whole = Diagnostic(stage="sample", message="y")
    found = (here, whole)
    assert moved_findings(found, "a\nb\nc\nd", "a\nb\nc\nd") == found
    below, _ = moved_findings(found, "a\nb\nc\nd", "# new\na\nb\nc\nd")
    assert (below.line, below.edit.first, below.edit.last) == (4, 4, 4)
    assert moved_findings(found, "a\nb\nc\nd", "a\nb\nC\nd") == (whole,), "a line that was mended has no finding"
    assert moved_findings(found, "a\nb\nc\nd", "a\nb\nd") == (whole,)


def test_changed_lines():
    assert changed_lines("a\nb\nc", "a\nx\nc\nd") == {2, 4}
    assert changed_lines("a", "a") == frozenset()


def shown_rows(structure, facts):
    """The fields of the sheet that are judged, and whether they were seen."""
    requirements = tuple(r for r in require(structure) if r.kind == "phase")
    results = evaluate(requirements, facts, trajectories()) if facts else ()
    desk = Desk(structure=structure, facts=(facts,) if facts else (), requirements=requirements, results=results)
    return {row.key: row.seen for row in rows(desk) if row.judged}


@pytest.mark.parametrize(("facts", "shown"), [
    (run_facts(True), {"O1:phases.0": True}), (run_facts(False), {"O1:phases.0": False}), (None, {}),
])  # fmt: skip
def test_a_phase_is_marked_by_what_it_requires(facts, shown):
    assert shown_rows(cut_in(), facts) == shown


@pytest.mark.parametrize(("target", "seen"), [(None, True), ("ego", True), ("O2", False)])
def test_an_action_is_seen_towards_the_one_it_was_said_about(target, seen):
    structure = apply(cut_in(), AddObject(spec=ObjectSpec(name="bus", type="bus")))
    structure = apply(structure, SetField(component="O1", path="phases.0.target", value=target))
    facts = run_facts(True)
    bus = facts.objects[1].model_copy(update={"name": "bus", "component": "O2", "events": ()})
    facts = facts.model_copy(update={"objects": (*facts.objects, bus)})
    assert shown_rows(structure, facts) == {"O1:phases.0": seen}


def test_highlighting_is_scenics_own_and_imports_no_scenic():
    import subprocess
    import sys

    assert type(lexer()).__name__ == "ScenicLexer"
    row = Blocks(["ego = new Car at 3 @ 4"])[0]
    assert (6, 9, "Keyword") in row or (6, 9, "Operator.Word") in row
    code = "import sys; from c2s_tui.code.highlight import lexer; lexer(); import c2s_tui.workbench; " \
           "print([m for m in ('scenic', 'torch', 'lancedb', 'langgraph') if m in sys.modules])"  # fmt: skip
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True).stdout.strip() == "[]"


@given(st.text("ab'\"#:\n é", max_size=60))
def test_highlights_lie_within_their_lines(text):
    lines = text.split("\n")
    blocks = Blocks(lines)
    for row, line in enumerate(lines):
        assert all(0 <= a < b <= len(line.encode()) for a, b, _ in blocks[row])


PIECES = st.sampled_from(
    ['"""', "'''", "x = 1", "    do B()", "", "behavior B():", "# it", "    '''", ") + 2", 'é = "s"']
)


@given(st.lists(PIECES, max_size=14), st.data())
def test_what_is_not_stale_looks_as_before(lines, data):
    first = data.draw(st.integers(0, len(lines)))
    after = data.draw(st.integers(first, len(lines)))
    changed = lines[:first] + data.draw(st.lists(PIECES, max_size=4)) + lines[after:]
    before, now = Blocks(lines or [""]), Blocks(changed or [""])
    begin, end = stale(before, now)
    for row in range(min(len(before), len(now))):
        if not begin <= row < end:
            assert before.lines[row] == now.lines[row] and before[row] == now[row], (row, begin, end)


def test_the_hook_of_the_text_area_is_there():
    assert {"_build_highlight_map", "_set_document"} <= set(TextArea.__dict__) and "_line_cache" in vars(TextArea("x"))


def test_no_key_of_the_app_is_taken_by_a_text_area_or_an_input():
    taken = {key for w in (TextArea, Input) for b in w.BINDINGS for key in b.key.split(",")}
    taken -= set(function_keys())  # the app's areas leave these to it: test_results.py presses F6 in one
    ours = {key for b in bindings() for key in b.key.split(",")}
    assert not ours & taken
    assert not ours & {"ctrl+a", "ctrl+b", "ctrl+i", "ctrl+m", "ctrl+h"}


def test_commands_have_a_method_and_unambiguous_beginnings_will_do():
    from c2s_tui.backend import Backend
    from c2s_tui.workbench import Workbench

    backend = Backend()
    assert set(Workbench(backend, None, None).does) == set(commands())
    backend.thread.stop()
    assert split("/the c2s-light") == ("theme", "c2s-light")
    assert split("/m") == ("m", "") and split("hello") is None


def test_copying_is_wrapped_for_the_multiplexer():
    plain = "\x1b]52;c;w6k=\x07"
    assert osc52("é", {}) == plain
    wrapped = osc52("é", {"TMUX": "x"})
    assert wrapped.startswith("\x1bPtmux;\x1b\x1b]52;c;w6k=") and wrapped.endswith(plain)
    assert osc52("x" * 1000, {"TERM": "screen"}).count("\x1bP") > 4


@pytest.mark.parametrize(("code", "written"), [(0, 0), (1, 1)])
def test_tmux_itself_is_asked_to_copy_and_where_it_cannot_the_sequence_is_sent(tmp_path, monkeypatch, code, written):
    tmux = tmp_path / "tmux"
    tmux.write_text(f'#!/bin/sh\necho "$@" > {tmp_path}/asked\ncat > {tmp_path}/copied\nexit {code}\n')
    tmux.chmod(0o755)
    monkeypatch.setenv("PATH", f"{tmp_path}:/usr/bin:/bin")
    sent = []
    copy("é\n", sent.append, {"TMUX": "x"})
    assert (tmp_path / "asked").read_text() == "load-buffer -w -\n" and (tmp_path / "copied").read_text() == "é\n"
    assert len(sent) == written


def test_preferences_come_back_and_a_broken_file_is_reported(tmp_path):
    file = tmp_path / "app.toml"
    prefs.save(prefs.Prefs(theme="c2s-light", keys={"app.run": "f6"}), file)
    assert prefs.load(file) == prefs.Prefs(theme="c2s-light", keys={"app.run": "f6"})
    file.write_text("theme = 3\n[")
    assert "Correct or remove" in prefs.load(file).trouble
    file.write_text("theme = 3\n")
    assert "theme" in prefs.load(file).trouble


def test_mentions_are_coloured_and_nothing_is_markup():
    content = mentions("[red]O1[/red] cuts in; E brakes at a T-junction")
    assert content.plain == "[red]O1[/red] cuts in; E brakes at a T-junction"
    assert [(s.start, s.end) for s in content.spans] == [(5, 7), (23, 24)]


def test_the_first_frame_is_painted_before_anything_is_imported(monkeypatch):
    import subprocess
    import sys

    from c2s_tui import early

    code = "import sys, c2s_tui.entry; print([m for m in ('textual', 'asyncio', 'rich', 'typer', 'pydantic') " \
           "if m in sys.modules])"  # fmt: skip
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True).stdout.strip() == "[]"
    assert early.asked(["app"]) is None  # no terminal here
    monkeypatch.setattr("sys.stdin", type("Tty", (), {"isatty": lambda self: True})())
    monkeypatch.setattr("sys.stdout", type("Tty", (), {"isatty": lambda self: True})())
    assert early.asked(["app"]) == (None, None) and early.asked(["app", "work"]) == ("work", None)
    assert early.asked(["app", "-f", "a.scenic"]) == (None, "a.scenic")
    assert early.asked(["app", "--help"]) is None and early.asked(["check", "a"]) is None
