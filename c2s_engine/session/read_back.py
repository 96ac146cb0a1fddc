"""Code edited by hand, read back into S: where the writer itself would write the edit for another value of a field, it
is an edit of that field; elsewhere S takes over what the program, read again, says anew."""

import re

from pydantic import ValidationError

from c2s_engine.check.client import CheckClient, CheckError
from c2s_engine.session.in_place import counterpart
from c2s_engine.session.steps import Emit
from c2s_engine.structure.components import ComponentId, Structure, field_words
from c2s_engine.structure.edits import SPEC_ADAPTER
from c2s_engine.structure.program import assemble
from c2s_engine.structure.progress import Say
from c2s_engine.structure.quantity import ends, in_words
from c2s_engine.structure.regenerate import key_of
from c2s_engine.structure.sentences import with_sentence, with_updated_sentences
from c2s_engine.write import by_hand
from c2s_engine.write.in_place import Change, at, changes, data, put, same
from c2s_engine.write.inverted import as_constant, as_field
from c2s_engine.write.merged import Upon, constants, without_numbers
from c2s_engine.write.typed.writer import TypedWriter

_NUMBER = r"-?\d+(?:\.\d+)?"


async def read_back(
    before: Structure, after: Structure, writer: TypedWriter, check: CheckClient, emit: Emit
) -> Structure:
    """S after edits of code by hand, in step with that code as far as it can be read."""
    edited = [c.id for c in after.components if c.id in before and _by_hand(before, after, c.id)]
    told: list[tuple[ComponentId, Change]] = []
    unread: dict[ComponentId, dict[str, str]] = {}
    for cid in [c for c in edited if before[c].origin in ("rendered", "by_hand") and after[c].code]:
        base = _base(before, cid, writer)
        was = base if constants(base).keys() - constants(before[cid].code).keys() else before[cid].code
        old = without_numbers(was, after[cid].code)
        unread[cid] = _renumbered(base, was, after[cid].code) | _no_number(base, was, after[cid].code)
        fields = _numbers_read(after, cid, old, base, writer) if base else None
        read = fields is not None
        if fields is None and unread[cid]:
            fields = as_constant(after, cid, writer, base) or _range_read(after, cid, unread[cid], was, base, writer)
        if fields is not None:
            found = changes(data(after[cid]), data(fields[cid]))
            told += [(cid, change) for change in found]
            plain = read and before[cid].origin == "rendered" and old == before[cid].code
            fields = _not_assumed(fields, cid, {change.name for change in found})
            after = _rendered(before, fields, cid, writer) if plain else _in_step(before, fields, cid)
            edited.remove(cid)
    if edited:
        after, more = await _read_again(before, after, check)
        told += more
    for cid, change in told:
        emit(Say(text=f"{cid}, read from the code: {field_words(change.name)} is {_shown(change)}."))
    for cid, numbers in unread.items():
        if numbers and cid not in {c for c, _ in told}:
            which = ", ".join(f"{name} = {value}" for name, value in numbers.items())
            said = after[cid].description
            emit(Say(text=f"{cid}: {which} was not read from the code; S still says: {said}"))
    return after


def _base(before: Structure, cid: ComponentId, writer: TypedWriter) -> str:
    """What the writer wrote, or would have written, before the edit; empty where it cannot say."""
    try:
        return before[cid].code if before[cid].origin == "rendered" else writer.write(before, cid).code
    except ValueError:
        return ""


def _renumbered(base: str, was: str, code: str) -> dict[str, str]:
    """The constants of the writer's own that an edit of the code `was` gave other numbers, and these numbers."""
    before, ours = constants(was), constants(base)
    found = constants(code).items()
    return {name: n for name, n in found if name in ours and name in before and float(n) != float(before[name])}


def _no_number(base: str, was: str, code: str) -> dict[str, str]:
    """The constants of the writer's own that were numbers and are anything else now, such as a range."""
    lost = constants(was).keys() & constants(base).keys() - constants(code).keys()
    found = {name: re.search(rf"^{name} = ([^#\n]*)", code, re.MULTILINE) for name in lost}
    return {name: match[1].strip() for name, match in found.items() if match}


def _range_read(
    after: Structure, cid: ComponentId, numbers: dict[str, str], was: str, base: str, writer: TypedWriter
) -> Structure | None:
    """S with the field that a constant stands for which is a range now, read by the range's middle; None where it is
    not one such constant, or no field that is a single number."""
    (name, value), *others = numbers.items()
    found = re.fullmatch(rf"Range\(({_NUMBER}), ({_NUMBER})\)", value)
    if others or found is None or not base:
        return None
    least, most = float(found[1]), float(found[2])
    middle = (least + most) / 2
    code = re.sub(rf"^{name} = Range\([^)]*\)", f"{name} = {middle:g}", after[cid].code, flags=re.MULTILINE)
    trial = after.with_component(after[cid].model_copy(update={"code": code}))
    read = _numbers_read(trial, cid, without_numbers(was, code), base, writer) or as_constant(trial, cid, writer, base)
    changed = changes(data(after[cid]), data(read[cid])) if read is not None else []
    if read is None or len(changed) != 1 or not isinstance(changed[0].new, int | float) or not middle:
        return None
    both = [round(changed[0].new * end / middle, 3) for end in (least, most)]
    try:
        spec = SPEC_ADAPTER.validate_python(put(data(read[cid]), changed[0].path, both))
    except ValidationError:  # a field that is no range
        return None
    return read.with_component(read[cid].model_copy(update={"spec": spec, "code": after[cid].code}))


def _numbers_read(
    after: Structure, cid: ComponentId, old: str, base: str, writer: TypedWriter
) -> Structure | None:
    """S with the fields that numbers changed by hand stand for, `old` being the code without these changes, `base` that
    of the writer; None where there are none or no field does."""
    if after[cid].code.strip() == old.strip():
        return None
    return as_field(after, cid, Upon(writer, base, old))


def _not_assumed(fields: Structure, cid: ComponentId, said: set[str]) -> Structure:
    """S in which fields that code by hand says now are assumed no longer."""
    assumed = tuple(a for a in fields[cid].assumed if a.field not in said)
    return fields.with_component(fields[cid].model_copy(update={"assumed": assumed}))


def _rendered(before: Structure, fields: Structure, cid: ComponentId, writer: TypedWriter) -> Structure:
    """S whose code of a component, in which but numbers were changed, is what the writer writes for its fields."""
    ours = fields[cid].model_copy(update={"origin": "rendered", "conflict": None})
    after = with_updated_sentences(before, fields.with_component(ours))
    key = key_of(after, cid, writer) if after[cid].description == ours.description else ""  # to be written anew
    return after.with_component(after[cid].model_copy(update={"key": key}))


def _in_step(before: Structure, fields: Structure, cid: ComponentId) -> Structure:
    """S whose code of a component, in which more than numbers was changed, is by hand and says its fields."""
    told = fields.with_component(with_sentence(before, fields, cid))
    return by_hand.followed(told, before, cid, before[cid].origin == "rendered" or by_hand.in_step(before, cid))


def _by_hand(before: Structure, after: Structure, cid: ComponentId) -> bool:
    return after[cid].origin in by_hand.OWN and after[cid].code != before[cid].code


async def _read_again(
    before: Structure, after: Structure, check: CheckClient
) -> tuple[Structure, list[tuple[ComponentId, Change]]]:
    """S with the fields that the program says otherwise than it did; a program that cannot be read says nothing."""
    try:
        was = (await check.import_program(assemble(before).text)).structure
        now = (await check.import_program(assemble(after).text)).structure
    except CheckError:
        return after, []
    told = []
    if was is None or now is None:
        return after, []
    for component in after.components:
        cid = component.id
        if component.origin not in by_hand.OWN or cid not in before:
            continue
        one, other = counterpart(before[cid], was), counterpart(component, now)
        if one is None or other is None or one not in was or other not in now:
            continue
        fields, taken = data(component), []
        for change in changes(data(was[one]), data(now[other])):
            if same(at(fields, change.path), change.old):
                fields = put(fields, change.path, change.new)
                taken.append((cid, change))
        update = {"description": now[other].description} if component.description == was[one].description else {}
        if not taken and not update:
            continue
        try:
            spec = SPEC_ADAPTER.validate_python(fields)
        except ValidationError:
            continue  # what was read in part does not fit the rest
        after = after.with_component(component.model_copy(update={"spec": spec, **update}))
        after = by_hand.followed(after, before, cid, whole=by_hand.in_step(before, cid))
        told += taken
    return after, told


def _shown(change: Change) -> str:
    """The new value of a field in short, with its unit."""
    return plain(change.name, change.new)


def plain(name: str, value: object) -> str:
    """A value as people read it: of what has several parts, those that say something."""
    if number := ends(value):
        return in_words(name, number)
    if isinstance(value, dict):
        parts = {k: v for k, v in value.items() if v not in (None, "", [], {}, False)}
        return ", ".join(f"{field_words(k)} {plain(k, v)}" for k, v in parts.items())
    if isinstance(value, list):
        return "; ".join(plain(name, v) for v in value) or "nothing"
    return "nothing" if value is None else str(value).replace("_", " ")
