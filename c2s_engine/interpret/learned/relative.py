"""By how much a change changes something ("10 m closer"): counted from what S says, or from what is written where it
leaves that open. Which field that is, the model says."""

from collections.abc import Mapping

from c2s_engine.interpret import language
from c2s_engine.interpret.learned.account import Number, Span, numbers_of, same
from c2s_engine.interpret.learned.decoder import ReaderError
from c2s_engine.interpret.learned.units import quantities, unit_of_field
from c2s_engine.interpret.mentions import mentions, names_ego
from c2s_engine.structure.components import Structure, field_words
from c2s_engine.structure.edits import SetField, apply
from c2s_engine.structure.quantity import in_words, middle
from c2s_engine.structure.sentences import says_its_spec, with_own_sentence
from c2s_engine.structure.specs import ObjectSpec


def relative_amounts(text: str) -> list[tuple[Span, float, str, int]]:
    """The quantities by which something is to change: where, SI value, unit, and 1 for more, -1 for less, 0 where only
    other words of the text tell."""
    signs, found = language.table("trade")["relative"], []
    for (start, end), value, unit in quantities(text):
        before = text[:start].lower().split()[-1:]  # "slower, 50 km/h" says how fast
        beside = {*(word for word in before if word[-1] not in ".,;:!"), *text[end:].lower().split()[:1]}
        beside = {word.strip(".,;:!") for word in beside}
        sign = next((s for s, name in ((1, "more"), (-1, "less"), (0, "by")) if beside & set(signs[name])), None)
        if sign is not None:
            found.append(((start, end), value, unit, sign or _sign(text, signs)))
    return found


def _sign(text: str, signs: dict[str, list[str]]) -> int:
    said = {word.strip(".,;:!") for word in text.lower().split()}
    more, less = said & set(signs["more"]), said & set(signs["less"])
    return 0 if bool(more) == bool(less) else 1 if more else -1


def counted(text: str, before: Structure, after: Structure) -> Structure:
    """S after a change, with the numbers that it sets counted from what they were, where the text says by how much;
    raises ReaderError where that leads nowhere, or where it is not plain which number is meant."""
    amounts = relative_amounts(text)
    had = {(cid, path): value for cid, path, value in numbers_of(before)}
    changed = [n for n in numbers_of(after) if had.get(n[:2]) != n[2] and n[0] in before]
    known = {c.id: c.spec.type for c in before.objects if isinstance(c.spec, ObjectSpec)}
    found, left = after, list(changed)
    for span, amount, unit, sign in amounts:
        fitting = [n for n in left if unit_of_field(n[1]) == unit]
        if len(amounts) > 1:
            whose = _whose(text[: span[0]], known)
            fitting = [n for n in fitting if n[0] in whose]
        if len(fitting) != 1 or not sign:
            if len(amounts) > 1 or any(same(value, amount) for _, _, value in changed):
                which = text[slice(*span)]
                raise ReaderError(f"I cannot tell what “{which}” is to be counted from: name one field at a time")
            return after
        left.remove(fitting[0])
        found = _set(before, found, fitting[0], sign * amount)
    return found


def _whose(said: str, known: Mapping[str, str]) -> set[str]:
    """Whom one spoke of last in what was said so far: ids of components."""
    named = mentions(said)
    after = said[named[-1].end :] if named else said
    if names_ego(after):
        return {"E"}
    return {cid for cid, kind in known.items() if named and named[-1].fits(kind)}


def _set(before: Structure, after: Structure, number: Number, by: float) -> Structure:
    cid, path, said = number
    was = before[cid].amount(path)
    what = f"{cid}'s {field_words(path)}"
    if was is None and not same(said, abs(by)):  # counted by the model from what is usual
        return after
    if was is None:
        raise ReaderError(f"{what} is left open, so nothing can be counted from it: say how much it is to be")
    value = round(middle(was) + by, 3)
    if value <= 0:
        held = in_words(path, was)
        raise ReaderError(f"{what} is {held}, which cannot become so much less: say how much it is to be")
    found = apply(after, SetField(component=cid, path=path, value=value))
    return found.with_component(with_own_sentence(found[cid], found)) if says_its_spec(after[cid], after) else found
