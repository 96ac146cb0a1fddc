"""Code edited by hand, read back into S: where the writer itself would write the edit for another value of a field, it
is an edit of that field; elsewhere S takes over what the program, read again, says anew."""

from pydantic import ValidationError

from c2s_engine.check.client import CheckClient, CheckError
from c2s_engine.session.in_place import counterpart
from c2s_engine.session.steps import Emit
from c2s_engine.structure.components import ComponentId, Structure, field_words
from c2s_engine.structure.edits import SPEC_ADAPTER
from c2s_engine.structure.program import assemble
from c2s_engine.structure.progress import Say
from c2s_engine.structure.quantity import in_words
from c2s_engine.structure.regenerate import key_of
from c2s_engine.structure.sentences import retold, with_sentence
from c2s_engine.write import by_hand
from c2s_engine.write.in_place import Change, at, changes, data, ends, put, same
from c2s_engine.write.inverted import as_field
from c2s_engine.write.merged import Upon, without_numbers
from c2s_engine.write.typed.writer import TypedWriter


async def read_back(
    before: Structure, after: Structure, writer: TypedWriter, check: CheckClient, emit: Emit
) -> Structure:
    """S after edits of code by hand, in step with that code as far as it can be read."""
    edited = [c.id for c in after.components if c.id in before and _by_hand(before, after, c.id)]
    told: list[tuple[ComponentId, Change]] = []
    for cid in [c for c in edited if before[c].origin in ("rendered", "by_hand") and after[c].code]:
        fields = _numbers_read(before, after, cid, writer)
        if fields is not None:
            found = changes(data(after[cid]), data(fields[cid]))
            told += [(cid, change) for change in found]
            after = _in_step(before, after, fields, cid, {change.name for change in found}, writer)
            edited.remove(cid)
    if edited:
        after, more = await _read_again(before, after, check)
        told += more
    for cid, change in told:
        emit(Say(text=f"{cid}, read from the code: {field_words(change.name)} is {_shown(change)}."))
    return after


def _numbers_read(before: Structure, after: Structure, cid: ComponentId, writer: TypedWriter) -> Structure | None:
    """S with the fields that numbers changed by hand stand for; None where there are none or no field does."""
    own, old = after[cid].code, without_numbers(before[cid].code, after[cid].code)
    if own.strip() == old.strip():
        return None
    try:
        base = before[cid].code if before[cid].origin == "rendered" else writer.write(before, cid).code
    except ValueError:
        return None
    return as_field(old, after, cid, Upon(writer, base, old))


def _in_step(
    before: Structure, after: Structure, fields: Structure, cid: ComponentId, said: set[str], writer: TypedWriter
) -> Structure:
    """S with those fields: code in which but numbers were changed is what the writer writes for them."""
    assumed = tuple(a for a in after[cid].assumed if a.field not in said)
    plain = before[cid].origin == "rendered" and without_numbers(before[cid].code, after[cid].code) == before[cid].code
    update = {"assumed": assumed, **({"origin": "rendered", "conflict": None} if plain else {})}
    ours = fields[cid].model_copy(update=update)
    if not plain:
        ours = with_sentence(before, fields.with_component(ours), cid)
        whole = before[cid].origin == "rendered" or by_hand.in_step(before, cid)
        return by_hand.followed(fields.with_component(ours), before, cid, whole)
    after = retold(before, fields.with_component(ours))
    key = key_of(after, cid, writer) if after[cid].description == ours.description else ""  # to be written anew
    return after.with_component(after[cid].model_copy(update={"key": key}))


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
    number = ends(change.new)
    return in_words(change.name, number) if number else str(change.new)
