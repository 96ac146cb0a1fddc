"""The lines of the structure pane, from S and what is known of it: pure, so that tests need no screen."""

from collections.abc import Mapping, Set
from dataclasses import dataclass

from c2s_engine.structure.components import Assumption, Component
from c2s_engine.structure.specs import ObjectSpec
from c2s_engine.structure.values import Field, fields, show
from c2s_tui.desk import Desk
from c2s_tui.look.kinds import kind_name

HEAD, SENTENCE, FIELD, UNMET, CONFLICT, LINK, ADD = "head", "sentence", "field", "unmet", "conflict", "link", "add"
HIT = "hit"
WRITER = "writer"
"""Who decides what is not in the spec."""


@dataclass(frozen=True)
class Row:
    """One line: `key` identifies it between two drawings."""

    key: str
    kind: str
    cid: str
    text: str = ""
    note: str = ""
    state: str = ""
    depth: int = 0
    field: Field | None = None
    seen: bool | None = None
    judged: bool = False
    achieved: str = ""  # what the run showed, beside what is said
    open: bool = False
    reached: bool = False


def rows(desk: Desk, unfolded: Set[str] = frozenset(), reached: Set[str] = frozenset()) -> list[Row]:
    """The whole sheet. Unfolded components show every field, the others those that are set."""
    found = _seen(desk)
    lines: list[Row] = []
    for component in desk.structure.components:
        lines += _component(desk, component, component.id in unfolded, component.id in reached, found)
    for unmet in desk.structure.not_understood:
        lines.append(Row(f"text:{unmet.text}", UNMET, "", unmet.text, unmet.reason))
    lines.append(Row("add", ADD, "", "add an object"))
    return lines


Seen = Mapping[str, tuple[bool | None, str]]


def _seen(desk: Desk) -> Seen:
    """By component and field, whether what it requires was seen, and what was: of a phase, by all that it requires,
    first what was missed."""
    found: dict[str, tuple[bool | None, str]] = {}
    for result in desk.results:
        parts = result.requirement.split(".")
        path = ".".join(parts[:3] if parts[1:2] == ["phases"] else parts)
        held, words = found.get(path, (True, ""))
        if not words or held and not result.holds:
            words = "" if result.seen in ("as said", "kept") else result.seen
        both = (held, result.holds)
        found[path] = (False if False in both else None if None in both else True, words)
    return found


def title(component: Component) -> str:
    """What a component is, in two words."""
    spec = component.spec
    if isinstance(spec, ObjectSpec):
        count = f" x{spec.count}" if spec.count > 1 else ""
        return (
            f"{spec.name} ({spec.type.replace('_', ' ')}{count})" if spec.name != spec.type else f"{spec.type}{count}"
        )
    return kind_name(component.kind)


def _component(
    desk: Desk, component: Component, unfolded: bool, reached: bool, found: Seen
) -> list[Row]:
    cid = component.id
    state = desk.state(component)
    lines = [Row(f"{cid}", HEAD, cid, title(component), state=state, open=unfolded, reached=reached)]
    if component.description:
        lines.append(Row(f"{cid}:sentence", SENTENCE, cid, component.description))
    hits = [c for c in desk.collisions if cid in c.components]
    lines += [Row(f"{cid}:hit:{c.time}", HIT, cid, c.of(cid), state="" if c.said else "failed") for c in hits]
    shown: set[str] = set()
    for field in fields(component.spec):
        if not unfolded and not _in_short(field):
            continue
        notes = [a for a in component.assumed if _told_by(field, a, unfolded)]
        shown.update(a.field for a in notes)
        held, achieved = found.get(f"{cid}.{field.path}", (None, ""))
        lines.append(
            Row(
                f"{cid}:{field.path}", FIELD, cid, show(field), _reasons(field, notes),
                depth=field.depth if unfolded else 0, field=field, seen=held, achieved=achieved,
                judged=f"{cid}.{field.path}" in found,
            )
        )  # fmt: skip
    left = [a for a in component.assumed if a.field not in shown]
    lines += [
        Row(f"{cid}:assumed:{a.field}", LINK, cid, f"{a.called} {a.value}", a.reason) for a in left
    ]
    lines += [Row(f"{cid}:unmet:{u.text}", UNMET, cid, u.text, u.reason) for u in component.unmet]
    if component.conflict is not None:
        lines.append(Row(f"{cid}:conflict", CONFLICT, cid, "written by hand, and its fields have changed since"))
    if component.by_hand == "apart":
        lines.append(Row(f"{cid}:apart", LINK, cid, "your code was kept", "it does not match these fields"))
    return lines


def _told_by(field: Field, assumption: Assumption, unfolded: bool) -> bool:
    """Whether a field's line shows the value that was assumed: its own, or, of a part in one line, one in it."""
    if unfolded or field.leaf or assumption.by == WRITER:
        return assumption.field == field.path
    return assumption.field == field.path or assumption.field.startswith(f"{field.path}.")


def _reasons(field: Field, notes: list[Assumption]) -> str:
    """Why what was assumed is so, each time with the field where that is only a part of the line."""
    return "; ".join(n.reason if n.field == field.path else f"{n.called}, {n.reason}" for n in notes)


def _in_short(field: Field) -> bool:
    """In the short form: what is set, parts in one line, the steps of a behaviour one line each."""
    if not field.set:
        return False
    if field.depth == 0:
        return not (field.many and not field.leaf)
    return field.depth == 1 and not field.leaf and field.path.rsplit(".", 1)[-1].isdigit()
