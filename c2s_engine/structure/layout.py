"""In which order the texts of components stand in a program that somebody wrote or edited, and the lines of nobody.

A program is a row of pieces: (component, text), and under "" the comments and empty lines between components. The
pieces joined are the program, byte for byte; what is written anew takes the place of its component's pieces.
"""

import io
import re
from collections.abc import Callable, Iterable, Sequence
from difflib import SequenceMatcher
from itertools import groupby

from c2s_engine.structure.components import Component, ComponentId, Structure

Piece = tuple[ComponentId, str]
FREE = ""
"""The owner of lines that belong to no component."""
OWN = ("by_hand", "imported")


def pieces(structure: Structure) -> list[Piece]:
    """The program of a structure as it stands now: as it was arranged, with what has been written or removed since."""
    components = {c.id: c for c in structure.components if c.code}
    if not structure.arrangement:
        return _ended(_in_order(components.values()))
    placed = _with_present_code(structure, components)
    there = {cid for cid, _ in placed}
    before: set[ComponentId] = set()
    for cid, component in components.items():
        if cid not in there:
            _insert(placed, before, component)
        before.add(cid)
    return _ended(placed)


def edited(structure: Structure, text: str) -> Structure:
    """The structure whose program is `text`, edited by hand: components whose lines are others are by hand now."""
    old = pieces(structure)
    if text == "".join(t for _, t in old):
        return structure
    lines = _lines(text)
    found = owners([(cid, line) for cid, piece in old for line in _lines(piece)], lines, lambda before, after: FREE)
    found = _statements_belong(found, lines)
    new = [
        (cid, "".join(line for _, line in group))
        for cid, group in groupby(zip(found, lines, strict=True), key=lambda pair: pair[0])
    ]
    for component in structure.components:
        was, now = _of(old, component.id), _of(new, component.id)
        if was != now:
            structure = structure.with_component(component.with_own_code(now))
    return structure.model_copy(update={"arrangement": tuple(new)})


def moved(structure: Structure, cid: ComponentId) -> Structure:
    """The structure in which an object that stands in one piece comes after the one before it in S."""
    rest = [p for p in structure.arrangement if p[0] != cid]
    if len(structure.arrangement) - len(rest) != 1:
        return structure
    (piece,) = (p for p in structure.arrangement if p[0] == cid)
    ids = structure.ids
    earlier = ids[: ids.index(cid)]
    at = max((i + 1 for i, (other, _) in enumerate(rest) if other in earlier), default=0)
    gap = [(FREE, "\n")] if at and rest[at - 1][0] != FREE else []
    return structure.model_copy(update={"arrangement": (*rest[:at], *gap, piece, *rest[at:])})


def owners(
    old: Sequence[Piece], new: Sequence[str], between: Callable[[ComponentId | None, ComponentId | None], ComponentId]
) -> list[ComponentId]:
    """To whom each line of an edited text belongs: a line that stayed to whom it was, one in place of another to its
    owner, one between two lines to theirs; where these are two owners, as `between` says."""
    was = [line for _, line in old]
    head = common(was, new)
    tail = common(was[head:][::-1], new[head:][::-1])
    end = len(was) - tail
    matcher = SequenceMatcher(None, was[head:end], new[head : len(new) - tail], autojunk=False)
    found = [cid for cid, _ in old[:head]]
    for tag, a, b, c, d in matcher.get_opcodes():
        first, last = head + a, head + b
        if tag == "insert":
            before, after = (old[first - 1][0] if first else None), (old[first][0] if first < len(old) else None)
            inside = before if before is not None and before == after else between(before, after)
            found += [inside] * (d - c)
        elif tag != "delete":
            found += [old[min(first + k, last - 1)][0] for k in range(d - c)]
    return found + [cid for cid, _ in old[end:]]


def merged(base: str, mine: str, theirs: str) -> str:
    """Both changes of a text, line by line; where both changed the same lines, mine."""
    if base in (mine, theirs):
        return theirs if base == mine else mine
    old, own, other = _lines(base), _lines(mine), _lines(theirs)
    hunks = _hunks(old, own)
    kept = [h for h in _hunks(old, other) if not any(_overlap(h, m) for m in hunks)]
    lines, at = [], 0
    for first, last, new in sorted([*hunks, *kept], key=lambda h: h[:2]):
        lines += [*old[at:first], *new]
        at = last
    return "".join([*lines, *old[at:]])


def _hunks(old: list[str], new: list[str]) -> list[tuple[int, int, list[str]]]:
    codes = SequenceMatcher(None, old, new, autojunk=False).get_opcodes()
    return [(a, b, new[c:d]) for tag, a, b, c, d in codes if tag != "equal"]


def _overlap(one: tuple[int, int, list[str]], other: tuple[int, int, list[str]]) -> bool:
    return max(one[0], other[0]) < min(one[1], other[1]) or one[0] in other[:2] or one[1] in other[:2]


def _in_order(components: Iterable[Component]) -> list[Piece]:
    """In the order of writing, an empty line after what the engine wrote."""
    found: list[Piece] = []
    spaced = True
    for component in components:
        if not spaced:
            found.append((FREE, "\n"))
        spaced = component.origin == "imported"
        found.append((component.id, component.code if spaced else component.code.rstrip("\n") + "\n"))
    return found


def _with_present_code(structure: Structure, components: dict[ComponentId, Component]) -> list[Piece]:
    """The arrangement with the code of now. Code by hand stands where its lines stood; what has been written anew in
    one piece: G where it began, R after the world model (all may read it), the others where they ended (what they
    read stands before that)."""
    arranged = structure.arrangement
    texts: dict[int, str] = {}
    place: tuple[int, Piece] | None = None
    for cid, component in components.items():
        at = [i for i, (owner, _) in enumerate(arranged) if owner == cid]
        if not at:
            continue
        if _of(arranged, cid).rstrip("\n") == component.code.rstrip("\n"):
            texts |= {i: arranged[i][1] for i in at}
        elif component.origin in OWN:
            texts |= _spread([(i, arranged[i][1]) for i in at], component.code)
        elif cid == "R" and (model := _model(structure)) is not None and not _follows(arranged, model, at[0]):
            place = model, (cid, component.code.rstrip("\n") + "\n")
        else:
            chosen = at[0] if cid == "G" else at[-1]
            texts[chosen] = component.code.rstrip("\n") + _tail(arranged[chosen][1])
    found: list[Piece] = []
    gone = False  # whether the component before this piece is: then the empty lines after it are, too
    for i, (owner, text) in enumerate(arranged):
        if owner != FREE:
            gone = not texts.get(i)
            found += [] if gone else [(owner, texts[i])]
        elif text.strip() or not gone:
            found.append((owner, text))
        if place and place[0] == i:
            found += [(FREE, "\n"), place[1], (FREE, "\n")]
    return found


def _follows(arranged: Sequence[Piece], model: int, at: int) -> bool:
    """Whether a piece is the next of a component after the world model's."""
    return at > model and all(owner == FREE for owner, _ in arranged[model + 1 : at])


def _spread(parts: list[tuple[int, str]], code: str) -> dict[int, str]:
    """Code by hand cut into the pieces in which it stood."""
    lines = _lines(code)
    old = [(str(i), line) for i, text in parts for line in _lines(text)]
    found = owners(old, lines, lambda before, after: before or after or "")
    texts = {i: "".join(line for at, line in zip(found, lines, strict=True) if at == str(i)) for i, _ in parts}
    last = max((i for i, text in texts.items() if text), default=parts[-1][0])
    texts[last] = texts[last].rstrip("\n") + _tail(dict(parts)[last])
    return texts


def _insert(placed: list[Piece], before: set[ComponentId], component: Component) -> None:
    """Put what is new after the last piece of those before it, which it may read."""
    at = max((i + 1 for i, (cid, _) in enumerate(placed) if cid in before), default=0)
    new = [(component.id, component.code.rstrip("\n") + "\n")]
    if at and not placed[at - 1][1].endswith("\n\n"):
        new.insert(0, (FREE, "\n"))
    if at < len(placed) and placed[at][1].strip():
        new.append((FREE, "\n"))
    placed[at:at] = new


def _model(structure: Structure) -> int | None:
    """The piece of G that names the world model; G's first where that was written anew."""
    mine = [(i, text) for i, (cid, text) in enumerate(structure.arrangement) if cid == "G"]
    own = structure.settings.origin in OWN
    named = [i for i, text in mine if own and re.search(r"^model\s", text, re.M)]
    return next(iter([*named, *(i for i, _ in mine)]), None)


def _statements_belong(found: list[ComponentId], lines: list[str]) -> list[ComponentId]:
    """Lines of nobody are comments and empty lines; with a statement among them, they are the component's before."""
    at = 0
    for owner, group in groupby(list(found)):
        end = at + len(list(group))
        said = [i for i in range(at, end) if lines[i].strip()]
        if owner == FREE and any(not lines[i].lstrip().startswith("#") for i in said):
            near = found[at - 1] if at else found[end] if end < len(found) else "G"
            found[said[0] : said[-1] + 1] = [near] * (said[-1] + 1 - said[0])
        at = end
    return found


def _ended(placed: list[Piece]) -> list[Piece]:
    """Every piece but the last ends its line."""
    whole = [p for p in placed if p[1]]
    return [(c, t if t.endswith("\n") or i == len(whole) - 1 else t + "\n") for i, (c, t) in enumerate(whole)]


def _of(row: Iterable[Piece], cid: ComponentId) -> str:
    return "".join(text for owner, text in row if owner == cid)


def _tail(text: str) -> str:
    """The empty lines with which a text ends, its own line's end included."""
    return text[len(text.rstrip("\n")) :] or "\n"


def _lines(text: str) -> list[str]:
    return list(io.StringIO(text, newline="\n"))


def common(a: Sequence[str], b: Sequence[str]) -> int:
    """How many lines two texts begin with in common."""
    count = 0
    for x, y in zip(a, b, strict=False):
        if x != y:
            break
        count += 1
    return count
