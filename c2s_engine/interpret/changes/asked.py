"""What is asked: a question, and a demand that is put as one ("could the van be a bus?", "would you mind ...?")."""

import re
from typing import Any

from c2s_engine.interpret import language
from c2s_engine.interpret.reading import scan


def _table() -> dict[str, Any]:
    found: dict[str, Any] = language.table("refine")
    return found


def supposed(plain: str) -> str:
    """What a "what if" supposes, as a demand; empty where the text is none."""
    match = next((m for pattern in _table()["supposed"] if (m := re.match(pattern, plain))), None)
    if not match:
        return ""
    said = _present(match["said"].strip())
    said = re.sub(r"^there (?:were|was|is|are) (?:also )?", "add ", said)
    subject = r"(?!add )(?P<what>(?:(?!\b(?:when|if|once|after|while|who|that|which)\b).)+?)"
    return re.sub(rf"^{subject} (?:were|was|is|are|be) (?P<how>.+)$", r"make \g<what> \g<how>", said)


def _present(said: str) -> str:
    """What is supposed in the past tense, in the present."""
    table = language.table("wordings")["supposed_past"]
    forms = table["forms"]
    pattern = rf"{table['after']}(?P<verb>{'|'.join(forms)})\b(?! (?:overtaken|passed|followed|hit|replaced|removed)\b)"
    return re.sub(pattern, lambda m: f"{m['before']}{forms[m['verb']]}", said)


def requested(plain: str) -> str:
    """What is asked for politely, as an order: "would you mind removing the van?"; empty where the text is none."""
    table = _table()
    for pattern, new in table["requested"]:
        said, number = re.subn(rf"^(?:please |and |so |ok,? )?(?:{pattern})", new, plain)
        if number:
            first, _, rest = said.rstrip("? ").partition(" ")
            return _present(f"{table['orders'].get(first, first)} {rest}")
    return ""


def asks(plain: str) -> bool:
    """Whether a text only asks; a demand behind the question ("why so slow? make it 50") makes it none."""
    sentences = _sentences(plain)
    return any(map(_asks, sentences)) and all(_asks(s) for s in sentences)


def demanded(plain: str) -> str:
    """The text without the questions in it, where it asks and demands."""
    sentences = _sentences(plain)
    rest = [s for s in sentences if not _asks(s)]
    demands = any(re.search(_table()["asking"]["demands"], s) for s in rest)
    if not rest or not demands or len(rest) == len(sentences):
        return plain
    named = [s[n.start : n.end] for s in sentences if s not in rest for n in scan.names(s) if n.kind == "actor"]
    said = ". ".join(rest)
    for judged in (m for s in sentences if s not in rest if (m := re.search(_table()["asking"]["judged"], s))):
        whose = judged["who"] or judged["whom"]
        others = not whose and any(n.kind == "actor" for n in scan.names(said))
        return said if others else f"{whose or 'ego'} is too {judged['how']}. {said}"
    return re.sub(r"\b(?:it|he|she|they|him|them)\b", f"the {named[0]}", said, count=1) if named else said


def _sentences(plain: str) -> list[str]:
    plain = re.sub(_table()["asking"]["tags"], "", plain)
    return [s for part in re.split(r"(?<=[.?!])\s+|(?<=\?)(?=\w)", plain) if (s := part.strip(" .!"))]


def _asks(sentence: str) -> bool:
    table = _table()
    sentence = re.sub(table["asking"]["before"], "", sentence)
    if re.search(table["asked_for"], sentence):
        return False
    if any(re.match(pattern, sentence) for pattern in table["asking"]["shapes"]):
        return True
    if sentence.endswith("?"):
        return not re.match(
            r"(can|could|would|will) (you|we) (please )?(make|change|add|remove|put|set|move|let|replace|turn|have)\b",
            sentence,
        )
    return bool(re.match(table["question"], sentence)) and not re.match(
        r"(is|are|do|does|have|will)\b(?!.*\?)|.*\b(instead)\b", sentence
    )
