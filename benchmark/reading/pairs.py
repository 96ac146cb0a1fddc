"""What the learned reader is trained on: texts with their S in short notation, and variants made of them by program.

Mirrored scenes (left and right exchanged), other numbers in text and S alike, and sloppy writing; and what rules that
are no longer there read without a fault of the fresh descriptions that were worked on (silver: none only counted).
"""

import random
import re
from collections.abc import Iterator, Sequence

import yaml

from c2s_bench.reading.scenes import FOLDER, scenes
from c2s_engine.interpret.learned.notation import LEFT_OUT, short, with_left_out

Pair = tuple[str, str]
"""A text, and what is answered to it. Where nobody noted what S leaves out, the answer breaks off before that line's
phrases, and what would follow is not learned."""

_SIDES = {
    one + end: other + end
    for one, other in (("left", "right"), ("right", "left")) for end in ("", "most", "ward", "wards", "hand")
}  # fmt: skip
_SIDE = re.compile(r"\b(" + "|".join(sorted(_SIDES, key=len, reverse=True)) + r")\b", re.I)
_NOT = yaml.safe_load((FOLDER.parent / "not_mirrored.yaml").read_text(encoding="utf-8"))
NOT_MIRRORED = re.compile(rf"\b({'|'.join(_NOT)})\b", re.I)
"""Words by which "right" or "left" is no side, or the text tells on which side one drives."""
_NUMBER = re.compile(r"=(\d+)(?:km/h|mph|m|s|ft)(?=[ ,\n;]|$)")


def pairs(writers: Sequence[str] = (), seed: int = 5) -> list[Pair]:
    """All that is trained on but the silver; with `writers`, their scenes alone."""
    rng = random.Random(seed)
    found = [] if writers else [p for text, said in judged() for p in variants(text, said, random.Random(seed))]
    for scene in scenes():
        if scene.held or writers and scene.writer not in writers:
            continue
        said = short(scene.components)
        for text, lost in zip(scene.texts, scene.lost or [None] * len(scene.texts), strict=True):
            found += variants(_flat(text), said, rng, lost)
    return found


def changes() -> Iterator[Pair]:
    """Changes upon scenes that are not held out, as they are asked and answered, and their mirror images."""
    from c2s_bench.reading.turns import turns
    from c2s_engine.interpret.learned.change import TYPED, answer_of, prompt

    for turn in turns():
        if turn.held:
            continue
        asked, answer = prompt(turn.scene.structure, turn.text), answer_of(turn.lines)
        yield asked, answer
        there, _, typed = asked.partition(TYPED)
        if (other := mirror(typed, there)) and (lines := mirror(typed, answer)):
            yield f"{other[1]}{TYPED}{other[0]}", lines[1]
    for row in yaml.load((FOLDER.parent / "commands.yaml").read_text(encoding="utf-8"), Loader=yaml.CSafeLoader):
        yield f"{row['upon'].rstrip()}{TYPED}{row['say']}", answer_of(row["change"])


def judged() -> Iterator[Pair]:
    """The first two judged batches, whose S was written by hand."""
    from c2s_engine.interpret.learned.units import with_units
    from c2s_engine.report.gather import structure_of

    for name in ("2026-11-24", "2026-11-24-second"):
        file = FOLDER.parents[1] / "judging" / "batches" / f"{name}.yaml"
        for row in yaml.load(file.read_text(encoding="utf-8"), Loader=yaml.CSafeLoader):
            structure = structure_of(row["structure"], row["text"])
            yield _flat(row["text"]), short(with_units(structure, row["text"]))


def variants(text: str, said: str, rng: random.Random, lost: Sequence[str] | None = None) -> Iterator[Pair]:
    """A pair and its variants; `lost`: the phrases of the text that S leaves out, where they were noted."""
    said = f"{said}\n{LEFT_OUT}" if lost is None else with_left_out(said, lost)
    yield text, said
    mirrored = mirror(text, said)
    if mirrored:
        yield mirrored
    if rng.random() < 0.6 and not any(c.isdigit() for phrase in lost or () for c in phrase):
        yield from filter(None, [other_numbers(*(mirrored if mirrored and rng.random() < 0.5 else (text, said)), rng)])
    if rng.random() < 0.15 and not lost:
        yield sloppy(text, rng), said


def mirror(text: str, said: str) -> Pair | None:
    """The scene with left and right exchanged; None where the words may mean something else."""
    if not re.search(r"\b(left|right)", text, re.I) or NOT_MIRRORED.search(text):
        return None

    def other(match: re.Match[str]) -> str:
        word = _SIDES[match[0].lower()]
        return word.upper() if match[0].isupper() else word.capitalize() if match[0][:1].isupper() else word

    said, line, lost = said.partition(f"\n{LEFT_OUT}")  # the phrases are the text's words, not S's
    return _SIDE.sub(other, text), re.sub("left|right", lambda m: _SIDES[m[0]], said) + line + _SIDE.sub(other, lost)


def other_numbers(text: str, said: str, rng: random.Random) -> Pair | None:
    """The scene with other quantities, so that they are learned as what is copied; None where none can be changed."""
    changed = False
    for old in sorted(set(_NUMBER.findall(said))):
        apart = re.search(rf"(?<![\d.,]){old}(?![\d.,:])", text)
        if not apart or re.search(rf"\d+-{old}|{old}-\d|{old}\.\d", text + said):
            continue
        low, high = (0.75, 1.3) if int(old) < 30 else (0.8, 1.2)
        new = str(max(1, round(int(old) * rng.uniform(low, high))))
        if new == old or re.search(rf"(?<!\d){new}(?!\d)", text):
            continue
        text = re.sub(rf"(?<![\d.,\w]){old}(?![\d.,:])", new, text)
        said = re.sub(rf"={old}(?=(?:km/h|mph|m|s|ft)(?:[ ,\n;]|$))", f"={new}", said)
        changed = True
    return (text, said) if changed else None


def sloppy(text: str, rng: random.Random) -> str:
    """The text as typed in haste: small letters, no commas or articles, letters exchanged."""
    text = text.lower() if rng.random() < 0.5 else text
    text = text.replace(",", "") if rng.random() < 0.3 else text
    if rng.random() < 0.3:
        text = re.sub(r"\b(the|a|an) ", lambda m: "" if rng.random() < 0.5 else m[0], text)
    words = text.split(" ")
    for _ in range(rng.randint(0, 2)):
        at = rng.randrange(len(words))
        if len(words[at]) > 4 and words[at].isalpha():
            k = rng.randrange(1, len(words[at]) - 2)
            words[at] = words[at][:k] + words[at][k + 1] + words[at][k] + words[at][k + 2 :]
    return " ".join(words)


def silver() -> Iterator[Pair]:
    """Texts of the fresh descriptions worked on, read by rules that are no longer there, as was expected of them."""
    for row in yaml.load((FOLDER.parent / "silver.yaml").read_text(encoding="utf-8"), Loader=yaml.CSafeLoader):
        yield row["text"], f"{row['s'].rstrip()}\n{LEFT_OUT}"


def _flat(text: str) -> str:
    return " ".join(text.split()) if text.count("\n") < 3 else text.strip()
