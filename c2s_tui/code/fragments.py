"""Where the fragments lie in a program that is being edited by hand: pure text work, fast enough for each key."""

from difflib import SequenceMatcher
from functools import lru_cache

from c2s_engine.structure.program import FragmentSpan, Program


def moved_spans(program: Program, text: str) -> tuple[FragmentSpan, ...]:
    """The spans of a program's fragments in an edited text of it. What is inserted belongs to the fragment it is in."""
    if text == program.text:
        return program.spans
    old, new = program.text.split("\n"), text.split("\n")
    head = _common(old, new)
    tail = _common(old[head:][::-1], new[head:][::-1])
    inner_old, inner_new = old[head : len(old) - tail], new[head : len(new) - tail]
    blocks = SequenceMatcher(None, inner_old, inner_new, autojunk=False).get_matching_blocks() if inner_old else []
    shift = len(new) - len(old)

    def to(line: int) -> int:  # 0-based old line to 0-based new line
        if line < head:
            return line
        if line >= len(old) - tail:
            return line + shift
        inside = line - head
        for block in blocks:
            if block.a <= inside < block.a + block.size:
                return head + block.b + inside - block.a
            if inside < block.a:
                return head + block.b
        return len(new) - tail

    starts = [to(span.first - 1) for span in program.spans]
    spans = []
    for i, span in enumerate(program.spans):
        last = starts[i + 1] if i + 1 < len(starts) else max(starts[i] + 1, len(new) - (1 if new[-1] == "" else 0))
        if last > starts[i]:
            spans.append(FragmentSpan(component=span.component, first=starts[i] + 1, last=last))
    return tuple(spans)


def changed_fragments(program: Program, text: str) -> dict[str, str]:
    """The fragments that an edited text has changed, by component: what SetCode would take."""
    lines = text.split("\n")
    changed = {}
    spans = {span.component: span for span in moved_spans(program, text)}
    for span in program.spans:
        after = spans.get(span.component)
        code = "\n".join(lines[after.first - 1 : after.last]) if after else ""
        if code.strip("\n") != program.fragment(span.component).strip("\n"):
            changed[span.component] = code.rstrip("\n") + "\n" if code.strip() else ""
    return changed


@lru_cache(maxsize=8)
def changed_lines(before: str, after: str) -> frozenset[int]:
    """The lines (1-based) of `after` that are new or other than in `before`."""
    if before == after:
        return frozenset()
    old, new = before.split("\n"), after.split("\n")
    head = _common(old, new)
    tail = _common(old[head:][::-1], new[head:][::-1])
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


def _common(a: list[str], b: list[str]) -> int:
    count = 0
    for x, y in zip(a, b, strict=False):
        if x != y:
            break
        count += 1
    return count
