"""The reference of S in Markdown, from the specs, the vocabulary, the contradictions and the events themselves.

`python -m c2s_engine.write.typed.reference > docs/VOCABULARY.md` writes it anew, and with `terms` docs/TERMS.md, how
the field's terms are said; tests hold that both are up to date.
"""

import json
import sys
import typing
from typing import Any

import yaml
from pydantic import BaseModel

from c2s_engine.paths import shipped
from c2s_engine.structure import specs
from c2s_engine.write.typed.contradictions import contradictions

SPECS = (
    specs.SettingsSpec, specs.PlaceSpec, specs.EgoSpec, specs.ObjectSpec, specs.Placement, specs.Phase, specs.Trigger,
    specs.RestrictionsSpec, specs.Condition, specs.Limit,
)  # fmt: skip


def markdown() -> str:
    """The whole page."""
    meanings = yaml.safe_load(shipped("vocabulary.yaml").read_text(encoding="utf-8"))
    parts = [
        "# What S can say",
        "Generated from the code and the data files: `python -m c2s_engine.write.typed.reference`.",
        "## Specs",
        *(_spec(model) for model in SPECS),
        "## Vocabulary",
        *(_terms(kind, rows) for kind, rows in meanings.items()),
        "## What contradicts",
        _table(("places", "positions", "actions", "why"), [_row(c) for c in contradictions()]),
        "## Events",
        "What the dry run sees, and the benchmark scores by.",
        _events(yaml.safe_load(shipped("events.yaml").read_text(encoding="utf-8"))),
    ]
    return "\n\n".join(parts) + "\n"


def _spec(model: type[BaseModel]) -> str:
    rows = [(f"`{name}`", field.description or "") for name, field in model.model_fields.items() if name != "component"]
    return f"### {model.__name__}\n\n{(model.__doc__ or '').strip()}\n\n" + _table(("field", "what it says"), rows)


def _terms(kind: str, rows: dict[str, Any]) -> str:
    body = [(f"`{name}`", _meaning(row)) for name, row in rows.items()]
    return f"### {kind.replace('_', ' ').capitalize()}\n\n" + _table(("name", "meaning"), body)


def _meaning(row: Any) -> str:
    if isinstance(row, str):
        return row
    shows = ", ".join(f"`{event}`" for event in row.get("shows", ()))
    return row["means"] + (f" Seen as {shows}." if shows else "")


def _row(c: Any) -> tuple[str, ...]:
    places = ", ".join(sorted(c.places)) + (
        " with an oncoming lane" if c.oncoming else " with a sidewalk" if c.sidewalk else ""
    )
    return places, ", ".join(sorted(c.positions)), ", ".join(sorted(c.actions)), c.because


def _events(rows: dict[str, Any]) -> str:
    body = [
        (f"`{name}`", row["holds"] + (" (names the other)" if row.get("other") else "")) for name, row in rows.items()
    ]
    return _table(("event", "holds when it"), body)


def _table(head: typing.Sequence[str], rows: typing.Iterable[typing.Sequence[str]]) -> str:
    lines = [f"| {' | '.join(head)} |", f"|{' --- |' * len(head)}"]
    lines += [f"| {' | '.join(cell.replace('|', '/') for cell in row)} |" for row in rows]
    return "\n".join(lines)


def terms() -> list[dict[str, Any]]:
    """The field's terms: data/terms.yaml."""
    return yaml.safe_load(shipped("terms.yaml").read_text(encoding="utf-8"))


def terms_page() -> str:
    """How each is said in S, what is required of a run, and what stands in for it or why it cannot be said."""
    parts = [
        "# How terms are said in S",
        "Generated from data/terms.yaml: `python -m c2s_engine.write.typed.reference terms`. A term is said by "
        "composition of what docs/VOCABULARY.md has; a run of each that is said is a test (tests/write/test_terms.py), "
        "in which its requirements hold, and its program is in tests/write/golden/terms.",
    ]
    for part in dict.fromkeys(row["in"] for row in terms()):
        rows = [row for row in terms() if row["in"] == part]
        parts += [f"## {part}", _table(("term", "said", "required of a run", "stand-in or reason"), map(_term, rows))]
    return "\n\n".join(parts) + "\n"


def _term(row: dict[str, Any]) -> tuple[str, ...]:
    if "S" not in row:
        return row["term"], "", "", f"not expressible: {row['not_expressible']}"
    holds = ", ".join(f"`{name}`" for name in row["holds"])
    sees = "".join(f", event `{event}`" for names in row.get("sees", {}).values() for event in names)
    return row["term"], f"`{row['says']}: {_said(row)}`", holds + sees, row.get("stands_in", "")


def _said(row: dict[str, Any]) -> str:
    """The part of its scene that says a term, in YAML's flow style."""
    at: Any = row["S"]
    for name in row["says"].split("."):
        at = at["O"][int(name[1:]) - 1] if name[:1] == "O" and name[1:].isdigit() else at[name]
    return json.dumps(at).replace('"', "")


if __name__ == "__main__":
    print(terms_page() if sys.argv[1:] == ["terms"] else markdown(), end="")
