"""The clauses of a text: what one verb governs, as runs of words."""

from collections.abc import Iterator

from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.scene import Scene

HEADS = ("conj", "advcl", "relcl", "ccomp", "parataxis", "csubj")
OPENED_BY = ("nsubj", "nsubjpass", "expl", "mark", "advmod")


def of_sentences(scene: Scene, length: int) -> Iterator[list[list[Word]]]:
    """The clauses of each sentence that begins before `length`, as their words in the text's order."""
    for number in range(len(scene.sentences)):
        words = [w for w in scene.words if w.sentence == number and w.start < min(w.end, length)]
        words.sort(key=lambda w: w.start)
        if words:
            yield _clauses(scene, words)


def span_of(words: list[Word]) -> tuple[int, int]:
    return words[0].start, max(w.end for w in words)


def _clauses(scene: Scene, words: list[Word]) -> list[list[Word]]:
    """Runs of words under one head; a run without its head belongs to the next one, else to the one before."""
    inside = {w.i for w in words}
    heads = {w.i for w in words if _is_head(scene, w, inside)}
    runs: list[tuple[int, list[Word]]] = []
    for word in words:
        head = _head_of(scene, word, heads, inside)
        if not runs or runs[-1][0] != head and word.tag[:1].isalpha():
            runs.append((head, []))
        runs[-1][1].append(word)
    merged: list[list[Word]] = []
    carried: list[Word] = []
    for head, run in runs:
        carried += run
        if any(w.i == head for w in run):
            merged.append(carried)
            carried = []
    if carried and merged:
        merged[-1] += carried
    return merged or [words]


def _is_head(scene: Scene, word: Word, inside: set[int]) -> bool:
    if word.head == word.i or word.head not in inside:
        return True
    if not word.tag.startswith("VB") or word.dep not in HEADS:
        return False
    if word.dep == "conj":
        return scene.words[word.head].tag.startswith("VB")
    return any(scene.words[c].dep in OPENED_BY for c in word.children)


def _head_of(scene: Scene, word: Word, heads: set[int], inside: set[int]) -> int:
    at = word
    for _ in range(len(inside)):
        if at.i in heads or at.head not in inside:
            break
        at = scene.words[at.head]
    return at.i
