"""From a model's answer to a component's code: thoughts, words, fences, repetitions of the code so far removed."""

import re

from c2s_engine.models.errors import AnswerUnusable

_THOUGHT = re.compile(r"<think(?:ing)?>.*?(?:</think(?:ing)?>|\Z)", re.S)
_FENCE = re.compile(r"^[ \t]*```[^\n`]*\n(.*?)(?:^[ \t]*```[ \t]*$|\Z)", re.S | re.M)
_BORDER = re.compile(r"^##\s*(?:G|R|E|T|O\d+)\b.*\n?", re.M)
_HEADER = re.compile(r"^(?:param\s+(?:map|carla_map|timestep|weather)\b.*|model\s+[\w.]+)[ \t]*\n?", re.M)
_CODE_LINE = re.compile(
    r"^\s*(?:#|$|\w[\w.]*\s*(?:,\s*\w+\s*)*=|behavior |monitor |require |terminate |param |model |import |from |new |"
    r"def |class |try:|do |take |wait|if |for |while |interrupt |return |with |[\])}])"
)


def code_of(answer: str, kind: str, before: str = "") -> str:
    """The component's code in an answer; raises AnswerUnusable where there is none."""
    text = _THOUGHT.sub("", answer)
    blocks = [b for b in _FENCE.findall(text) if b.strip()]
    code = blocks[-1] if blocks else _unfenced(text)
    code = _BORDER.sub("", code.replace("\t", "    ").replace("\r", ""))
    if kind != "G":
        code = _HEADER.sub("", code)
        code = _without_repetition(code, before)
    code = _dedented(code).strip("\n")
    if not re.sub(r"#.*", "", code).strip():
        raise AnswerUnusable("it holds no code")
    return "\n".join(line.rstrip() for line in code.splitlines())


def program_of(answer: str) -> str:
    """The whole program in an answer (the longest block); raises AnswerUnusable where there is none."""
    text = _THOUGHT.sub("", answer)
    blocks = [b for b in _FENCE.findall(text) if b.strip()]
    code = _dedented(max(blocks, key=len) if blocks else _unfenced(text)).strip()
    if not re.sub(r"#.*", "", code).strip():
        raise AnswerUnusable("it holds no code")
    return "\n".join(line.rstrip() for line in code.replace("\t", "    ").splitlines())


def _unfenced(text: str) -> str:
    """An answer without fences counts as code where most of its lines look like code."""
    lines = [line for line in text.splitlines() if line.strip()]
    if not lines or sum(bool(_CODE_LINE.match(line)) for line in lines) < 0.6 * len(lines):
        return ""
    return text


def _without_repetition(code: str, before: str) -> str:
    """Without the top-level statements that stand word for word in the code so far."""
    known = {_plain(s) for s in _statements(before)}
    return "\n".join(s for s in _statements(code) if _plain(s) not in known or not _plain(s))


def _statements(code: str) -> list[str]:
    found: list[str] = []
    for line in code.splitlines():
        if found and (not line.strip() or line[0] in " \t)]}" or found[-1].rstrip().endswith((",", "(", "["))):
            found[-1] += "\n" + line
        else:
            found.append(line)
    return found


def _plain(statement: str) -> str:
    return re.sub(r"\s+", " ", re.sub(r"#.*", "", statement)).strip()


def _dedented(code: str) -> str:
    lines = [line for line in code.splitlines() if line.strip()]
    margin = min((len(line) - len(line.lstrip()) for line in lines), default=0)
    return "\n".join(line[margin:] for line in code.splitlines())
