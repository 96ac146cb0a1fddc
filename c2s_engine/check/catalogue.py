"""The catalogue of errors (errors.yaml): cause and remedy of each in words, and the edit where one is certain."""

import functools
import re
from dataclasses import dataclass
from importlib.resources import files
from typing import Any

import yaml

from c2s_engine.structure.diagnostics import Diagnostic, TextEdit
from c2s_engine.structure.program import without_comment


@dataclass(frozen=True)
class Entry:
    """One kind of error. `types`, `match`, `source` and `raised` say which exceptions are of it; without `types` it is
    found by the lint."""

    code: str
    stage: str
    message: str
    fix: str
    severity: str = "error"
    types: tuple[str, ...] = ()
    match: re.Pattern[str] | None = None
    source: re.Pattern[str] | None = None
    raised: str = ""
    replace: tuple[re.Pattern[str], str] | None = None
    insert: str = ""
    delete: bool = False


@functools.cache
def entries() -> dict[str, Entry]:
    """The catalogue, in the order in which it is searched."""
    text = files("c2s_engine.check").joinpath("errors.yaml").read_text(encoding="utf-8")
    return {code: _entry(code, data) for code, data in yaml.safe_load(text).items()}


def _entry(code: str, data: dict[str, Any]) -> Entry:
    replace = data.get("replace")
    return Entry(
        code=code,
        stage=data.get("stage", "compile"),
        message=" ".join(data["message"].split()),
        fix=" ".join(data.get("fix", "").split()),
        severity=data.get("severity", "error"),
        types=tuple(data.get("types", ())),
        match=re.compile(data["match"], re.S) if "match" in data else None,
        source=re.compile(data["source"]) if "source" in data else None,
        raised=data.get("raised", ""),
        replace=(re.compile(replace[0]), replace[1]) if replace else None,
        insert=data.get("insert", ""),
    )


def find(kinds: list[str], text: str, line: str, raised: str = "") -> tuple[Entry, dict[str, str]] | None:
    """The first entry that an exception (its class names, its text, the source line, the function that raised it)
    belongs to; a comment on the line does not count."""
    line = without_comment(line)
    for entry in entries().values():
        if not entry.types or not set(entry.types) & set(kinds) or entry.raised not in ("", raised):
            continue
        values: dict[str, str] = {}
        if entry.match is not None:
            found = entry.match.search(text)
            if not found:
                continue
            values.update({k: v or "" for k, v in found.groupdict().items()})
        if entry.source is not None:
            found = entry.source.search(line)
            if not found:
                continue
            values.update({k: v or "" for k, v in found.groupdict().items()})
        return entry, values
    return None


def fill(template: str, values: dict[str, str]) -> str:
    """A template with its values; parts in [brackets] fall away where a value in them is empty."""

    def part(match: re.Match[str]) -> str:
        names = re.findall(r"\{(\w+)\}", match[1])
        return match[1] if all(values.get(n) for n in names) else ""

    text = re.sub(r"\[\[(.*?)\]\]", part, template)
    return re.sub(r"\{(\w+)\}", lambda m: str(values.get(m[1], m[0])), text).strip()


def finding(code: str, line: int | None, column: int | None, **values: Any) -> Diagnostic:
    """The diagnostic of a lint's finding; its edit is made when its source line is known (fixes.attach)."""
    entry = entries()[code]
    said = {k: str(v) for k, v in values.items()}
    return Diagnostic(
        stage=entry.stage, code=code, severity=entry.severity, line=line, column=column,
        message=fill(entry.message, said), fix=fill(entry.fix, said),
        edit=_promise(entry, said, line),
    )  # type: ignore[arg-type]  # fmt: skip


def _promise(entry: Entry, values: dict[str, str], line: int | None) -> TextEdit | None:
    """A lint's replacement of `name` by `near`, to be made on the source line."""
    if line is None or entry.replace is None:
        return None
    target = fill(entry.replace[1], values)
    if not target or "{" in target:
        return None
    pattern = fill(entry.replace[0].pattern, {k: re.escape(v) for k, v in values.items()})
    return TextEdit(first=line, last=line, text=f"{pattern}\0{target}", reason=fill(entry.fix, values))
