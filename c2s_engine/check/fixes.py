"""Deterministic remedies as edits of the program's lines, and their application."""

import re
from typing import Any

from c2s_engine.check import catalogue, drawn
from c2s_engine.structure.diagnostics import Diagnostic, TextEdit


def attach(diagnostic: Diagnostic, line: str) -> Diagnostic:
    """The diagnostic with its edit made on its source line, or without one where it would change nothing."""
    edit = diagnostic.edit
    if edit is None or "\0" not in edit.text:
        return diagnostic
    pattern, _, target = edit.text.partition("\0")
    changed = re.sub(pattern, lambda _: target, line, count=1)
    made = edit.model_copy(update={"text": changed}) if changed != line else None
    return diagnostic.model_copy(update={"edit": made})


def propose(entry: catalogue.Entry, values: dict[str, str], lines: list[str], number: int | None) -> TextEdit | None:
    """The edit of a catalogue entry for an exception on a line (1-based) of the program."""
    if entry.code in ELSEWHERE:
        cause, by = ELSEWHERE[entry.code]
        return _elsewhere(lines, re.compile(cause), by, catalogue.fill(entry.fix, values))
    if number is None or not 1 <= number <= len(lines):
        return None
    reason = catalogue.fill(entry.fix, values)
    line = lines[number - 1].rstrip("\r\n")
    if entry.code in SPECIAL:
        return SPECIAL[entry.code](lines, number, reason)
    if entry.replace is not None and all(map(values.get, named := re.findall(r"\{(\w+)\}", entry.replace[1]))):
        by = catalogue.fill(entry.replace[1], values) if named else entry.replace[1]
        pattern = re.compile(catalogue.fill(entry.replace[0].pattern, {k: re.escape(v) for k, v in values.items()}))
        changed = pattern.sub(by, line, count=1)
        if changed != line:
            return TextEdit(first=number, last=number, text=changed, reason=reason)
    return None


def head_of(lines: list[str], number: int) -> int:
    """The first line of the statement whose continuation stands on a line (1-based)."""
    indent = len(lines[number - 1]) - len(lines[number - 1].lstrip())
    for i in range(number - 2, -1, -1):
        text = lines[i].strip()
        if text and not text.startswith("#") and len(lines[i]) - len(lines[i].lstrip()) < indent:
            return i + 1
    return number


def _comma(lines: list[str], number: int, reason: str) -> TextEdit | None:
    """A comma at the end of the last code line before a line that begins with a specifier."""
    for i in range(number - 2, -1, -1):
        code = lines[i].rstrip("\r\n")
        bare = re.sub(r"\s+#.*$", "", code).rstrip()
        if not bare or bare.lstrip().startswith("#"):
            continue
        if bare.endswith((",", ":", "(")):
            return None
        return TextEdit(first=i + 1, last=i + 1, text=bare + "," + code[len(bare) :], reason=reason)
    return None


def _monitor(lines: list[str], number: int, reason: str) -> TextEdit | None:
    """`monitor M:` becomes `monitor M():`, and `require monitor M()` follows its body."""
    head = lines[number - 1].rstrip("\r\n")
    match = re.match(r"(\s*)monitor\s+(\w+)\s*:", head)
    if not match:
        return None
    last = number
    indent = len(match[1])
    for i in range(number, len(lines)):
        text = lines[i].strip()
        if text and len(lines[i]) - len(lines[i].lstrip()) <= indent:
            break
        if text:
            last = i + 1
    body = [line.rstrip("\r\n") for line in lines[number:last]]
    new_head = head.replace(match[0], f"{match[1]}monitor {match[2]}():", 1)
    text = "\n".join([new_head, *body, f"{match[1]}require monitor {match[2]}()"])
    return TextEdit(first=number, last=last, text=text, reason=reason)


def _interrupt(lines: list[str], number: int, reason: str) -> TextEdit | None:
    """Statements before a lone `interrupt when` at the same depth go into a `try:`."""
    head = lines[number - 1]
    indent = len(head) - len(head.lstrip())
    first = number
    for i in range(number - 2, -1, -1):
        text = lines[i].strip()
        if not text:
            continue
        depth = len(lines[i]) - len(lines[i].lstrip())
        if depth < indent or (depth == indent and re.match(r"(try|interrupt|except)\b", text)):
            break
        first = i + 1
    if first == number:
        return None
    pad = " " * indent
    body = [("    " + line if line.strip() else line).rstrip("\r\n") for line in lines[first - 1 : number - 1]]
    return TextEdit(first=first, last=number - 1, text="\n".join([f"{pad}try:", *body]), reason=reason)


def _elsewhere(lines: list[str], pattern: re.Pattern[str], by: str, reason: str) -> TextEdit | None:
    """The edit of the line that caused what showed itself on another one, or on none."""
    for number, line in enumerate(lines, 1):
        changed = pattern.sub(by, line.rstrip("\r\n"), count=1)
        if changed != line.rstrip("\r\n"):
            return TextEdit(first=number, last=number, text=changed, reason=reason)
    return None


ELSEWHERE = {
    "list_for_member": (
        r"\bUniform\(\s*([A-Za-z_][\w.]*|\[[^\[\]]*\]|filter\((?:[^()]|\([^()]*\))*\))\s*\)",
        r"Uniform(*\1)",
    ),
    "render_text": (r"^(\s*param\s+render\s*=\s*)(['\"])([01])\2", r"\1\3"),
}
SPECIAL = {
    "missing_comma": _comma, "old_monitor": _monitor, "interrupt_without_try": _interrupt,
    "random_index": drawn.index, "random_comprehension": drawn.comprehension, "random_unpacking": drawn.unpacking,
}  # fmt: skip


def apply_fixes(program: str, diagnostics: Any) -> str:
    """The program with the edits of its diagnostics made, from the bottom up; overlapping ones once."""
    ending = "\r\n" if "\r\n" in program else "\n"
    lines = program.split("\n")
    edits = sorted(
        {(d.edit.first, d.edit.last, d.edit.text) for d in diagnostics if d.edit is not None}, key=lambda e: -e[0]
    )
    touched = len(lines) + 2
    for first, last, text in edits:
        if last >= touched:
            continue
        keep = "\r" if ending == "\r\n" else ""
        lines[first - 1 : last] = [line + keep for line in text.split("\n")]
        touched = first
    return "\n".join(lines)
