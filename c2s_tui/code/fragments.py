"""Where the fragments lie in a program that is being edited by hand: pure text work, fast enough for each key."""

from difflib import SequenceMatcher
from functools import lru_cache
from itertools import groupby

from c2s_engine.structure.diagnostics import Diagnostic
from c2s_engine.structure.layout import FREE, common, owners
from c2s_engine.structure.program import FragmentSpan, Program


def moved_spans(program: Program, text: str) -> tuple[FragmentSpan, ...]:
    """The spans of a program's fragments in an edited text of it. What is inserted belongs to the fragment it is in."""
    if text == program.text:
        return program.spans
    old = [(FREE, line) for line in program.text.split("\n")]
    for span in program.spans:
        for row in range(span.first - 1, min(span.last, len(old))):
            old[row] = (span.component, old[row][1])
    found = owners(old, text.split("\n"), lambda before, after: before or FREE)
    spans, line = [], 1
    for owner, group in groupby(found):
        last = line + len(list(group)) - 1
        if owner != FREE:
            spans.append(FragmentSpan(component=owner, first=line, last=last))
        line = last + 1
    return tuple(spans)


def moved_findings(found: tuple[Diagnostic, ...], before: str, after: str) -> tuple[Diagnostic, ...]:
    """Findings of a text in an edited one: at the lines where these are now; what was found in a line that is gone or
    another is found no more."""
    if before == after or not found:
        return found
    lines = _moved_lines(before, after)
    moved = []
    for finding in found:
        if finding.line is None or finding.line in lines:
            edit = finding.edit
            if edit is not None:
                there = [lines.get(n, 0) for n in range(edit.first, edit.last + 1)]
                whole = all(there) and there == list(range(there[0], there[0] + len(there)))
                edit = edit.model_copy(update={"first": there[0], "last": there[-1]}) if whole else None
            line = lines[finding.line] if finding.line else None
            moved.append(finding.model_copy(update={"line": line, "edit": edit}))
    return tuple(moved)


@lru_cache(maxsize=4)
def _moved_lines(before: str, after: str) -> dict[int, int]:
    """Where the lines (1-based) of a text that are still there stand in the edited one."""
    old = [(str(i), line) for i, line in enumerate(before.split("\n"), 1)]
    new = after.split("\n")
    found = owners(old, new, lambda *_: FREE)
    return {int(n): row for row, n in enumerate(found, 1) if n and old[int(n) - 1][1] == new[row - 1]}


@lru_cache(maxsize=8)
def changed_lines(before: str, after: str) -> frozenset[int]:
    """The lines (1-based) of `after` that are new or other than in `before`."""
    if before == after:
        return frozenset()
    old, new = before.split("\n"), after.split("\n")
    head = common(old, new)
    tail = common(old[head:][::-1], new[head:][::-1])
    inner_old, inner_new = old[head : len(old) - tail], new[head : len(new) - tail]
    if not inner_old:
        return frozenset(range(head + 1, head + 1 + len(inner_new)))
    matcher = SequenceMatcher(None, inner_old, inner_new, autojunk=False)
    return frozenset(
        head + line + 1
        for tag, _, _, first, last in matcher.get_opcodes()
        if tag != "equal"
        for line in range(first, last)
    )
