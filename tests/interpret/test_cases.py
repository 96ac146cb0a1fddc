"""Texts, turns upon them, and what S must say then: the one runner of cases/*.yaml.

An entry: `text` and `says`, what S holds then, by path (`objects`, `ids`: how many, which; `E.phases.0.action`; a list
of parts: how many). Or `text` and `upon`, what is typed upon its S: `say`, wordings of one change, each typed alone, or
`turns`, each done before the next; of the last one `kind`, `reply` and `changes`: all that it changes in S, and nothing
else (a component that is new, whole; null: gone).
"""

from functools import cache
from pathlib import Path
from typing import Any

import pytest
import yaml
from pydantic import BaseModel

from c2s_engine.interpret import EmbeddedInterpreter
from c2s_engine.interpret.turn import Turn, route
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.edits import apply

ENTRIES = [
    (path.stem, entry)
    for path in sorted((Path(__file__).parent / "cases").glob("*.yaml"))
    for entry in yaml.load(path.read_text("utf-8"), yaml.CSafeLoader)
]
CASES = [
    (name, {"text": entry["text"], **outcome, "turns": turns})
    for name, entry in ENTRIES
    for outcome in entry.get("upon", (entry,))
    for turns in ([[words] for words in outcome["say"]] if "say" in outcome else [outcome.get("turns", [])])
]


@pytest.mark.parametrize(("name", "case"), CASES, ids=lambda value: value if isinstance(value, str) else "")
def test_case(name: str, case: dict[str, Any]) -> None:
    structure, turn, before = _read(case["text"]), None, None
    for words in case["turns"]:
        turn, before = route(words, structure), structure
        structure = _after(turn, structure)
    said = {path: _at(structure, path) for path in case.get("says", ())}
    assert said == case.get("says", {}), case["text"]
    if turn is not None and before is not None:
        assert (turn.kind, turn.reply) == (case.get("kind", turn.kind), case.get("reply", turn.reply))
        assert "changes" not in case or _changes(before, structure) == case["changes"], case["turns"]


@cache
def _read(text: str) -> Structure:
    return EmbeddedInterpreter().interpret(text).structure


def _after(turn: Turn, structure: Structure) -> Structure:
    for edit in turn.edits:
        structure = apply(structure, edit)
    return structure


def _at(structure: Structure, path: str) -> Any:
    """The value at a path: a number where it is a list of parts, as in JSON and without defaults where it is a part."""
    value: Any = structure
    for step in path.split("."):
        if isinstance(value, Structure):
            value = value[step] if step in value else getattr(value, step)
        elif isinstance(value, Component):
            value = getattr(value if step in Component.model_fields else value.spec, step)
        else:
            value = value[int(step)] if step.isdigit() else getattr(value, step)
    parts = isinstance(value, tuple | list) and (
        step in ("objects", "phases") or any(isinstance(v, BaseModel) for v in value)
    )
    return len(value) if parts else _plain(value)


def _plain(value: Any) -> Any:
    if isinstance(value, Component):
        value = value.spec
    if isinstance(value, BaseModel):
        return value.model_dump(mode="json", exclude_defaults=True)
    return [_plain(v) for v in value] if isinstance(value, tuple | list) else value


def _changes(before: Structure, after: Structure) -> dict[str, Any]:
    """What differs between two S: fields by component and name, with the value of the second."""
    old, new = ({c.id: _plain(c) for c in s.components} for s in (before, after))
    fields = {
        f"{cid}.{key}": new[cid].get(key)
        for cid in old.keys() & new.keys()
        for key in old[cid].keys() | new[cid].keys()
        if old[cid].get(key) != new[cid].get(key)
    }
    whole = {cid: new.get(cid) for cid in old.keys() ^ new.keys()}
    return fields | whole
