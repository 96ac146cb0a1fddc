"""What an imported behaviour does, in the words of S: phases, their speeds and triggers, ego's reaction."""

import ast
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any

from c2s_engine.check.values import Number, Values, ends_of
from c2s_engine.check.written import Written
from c2s_engine.structure.specs import Phase, Trigger

DEPTH = 6  # behaviours that do behaviours
_NEAR = "withinDistanceTo"


@dataclass
class Conduct:
    """What was recognised; `whole`: nothing of the code is left out."""

    phases: list[Phase] = field(default_factory=list)
    brakes: bool = False  # for what comes near
    hard: bool = False
    whole: bool = True
    waits: Trigger | None = None  # of the phase that comes next


class Reader:
    """Reads behaviours of one program; `ids`: the components of its objects by their names."""

    def __init__(self, values: Values, ids: Mapping[str, str], table: Mapping[str, Any]) -> None:
        self.values = values
        self.ids = ids
        self.known: Mapping[str, Any] = table["behaviors"]
        self.written = Written(values, lambda cond: self._trigger(cond, {}, ast.Lt))

    def of(self, node: Any) -> Conduct:
        """Of the value of `with behavior`."""
        found = Conduct()
        own = self.values.behaviors.get(_name(node))
        drive = self.written.read(own) if own is not None else None
        if drive is not None:
            speed = None if drive.start is None else self.values.number(drive.start)
            first = [Phase(action="keep_lane", speed=speed)] if speed is not None else []
            return Conduct([*first, *drive.phases], drive.brakes, drive.hard)
        self._do(node, {}, found, None, 0)
        return found

    def _do(self, node: Any, local: Mapping[str, Any], found: Conduct, duration: float | None, depth: int) -> None:
        call = node if isinstance(node, ast.Call) else ast.Call(func=node, args=[], keywords=[])
        name = call.func.id if isinstance(call.func, ast.Name) else ""
        own = self.values.behaviors.get(name)
        if own is not None and depth < DEPTH:
            self._body(own.body, self._arguments(own, call, local), found, depth + 1)
            return
        known = self.known.get(name)
        if known is None:
            found.whole = False
            return
        trigger, found.waits = found.waits, None
        if "near" in known:
            near = self._argument(call, known["near"], local)
            value = near if near is not None else known["near"][2]
            trigger = Trigger(kind="distance", value=ends_of(value)[1], of="ego")
        speed = self._argument(call, known["speed"], local) if "speed" in known else None
        if speed is None and "speed" in known and not self._given(call, known["speed"]):
            speed = known["speed"][2]
        found.brakes |= bool(known.get("brakes"))
        phase = Phase(action=known["action"], speed=_speed(speed), duration=duration, trigger=trigger)
        if not found.phases or phase != found.phases[-1]:
            found.phases.append(phase)

    def _arguments(self, definition: Any, call: Any, local: Mapping[str, Any]) -> dict[str, Any]:
        """The nodes that a behaviour's arguments stand for, those of the caller resolved."""
        names = [a.arg for a in definition.args.args]
        given = dict(zip(reversed(names), reversed(definition.args.defaults), strict=False))
        given |= dict(zip(names, call.args, strict=False)) | {k.arg: k.value for k in call.keywords if k.arg}
        return {n: local.get(v.id, v) if isinstance(v, ast.Name) else v for n, v in given.items()}

    def _argument(self, call: Any, where: list[Any], local: Mapping[str, Any]) -> Number | None:
        name, place = where[0], where[1]
        node = next((k.value for k in call.keywords if k.arg == name), None)
        if node is None and len(call.args) > place:
            node = call.args[place]
        return None if node is None else self.values.number(node, local)

    @staticmethod
    def _given(call: Any, where: list[Any]) -> bool:
        return len(call.args) > where[1] or any(k.arg == where[0] for k in call.keywords)

    def _body(self, body: Iterable[Any], local: Mapping[str, Any], found: Conduct, depth: int) -> None:
        from scenic.syntax import ast as s

        for node in body:
            if isinstance(node, s.DoFor | s.DoUntil | s.Do):
                duration = self._seconds(node.duration) if isinstance(node, s.DoFor) else None
                for element in node.elts:
                    self._do(element, local, found, duration, depth)
                if isinstance(node, s.DoUntil):
                    found.waits = self._trigger(node.cond, local, ast.Lt | ast.LtE)
                    found.whole &= found.waits is not None
            elif isinstance(node, s.TryInterrupt):
                self._body(node.body, local, found, depth)
                for handler in node.interrupt_when_handlers:
                    self._interrupt(handler, local, found, depth)
            elif isinstance(node, s.Take):
                self._take(node, found)
            elif isinstance(node, ast.While):
                self._while(node, local, found, depth)
            elif not isinstance(node, s.Wait | s.Terminate | s.Abort | ast.Pass | ast.Assert | ast.Assign | ast.Expr):
                found.whole = False

    def _while(self, node: Any, local: Mapping[str, Any], found: Conduct, depth: int) -> None:
        from scenic.syntax import ast as s

        if isinstance(node.test, ast.Constant) and node.test.value:
            self._body(node.body, local, found, depth)
        elif all(isinstance(n, s.Wait) for n in node.body):
            found.waits = self._trigger(node.test, local, ast.Gt | ast.GtE)
            found.whole &= found.waits is not None
            if found.waits is not None and not found.phases:
                found.phases.append(Phase(action="wait"))
        elif all(isinstance(n, s.Take) for n in node.body):
            self._body(node.body, local, found, depth)
            found.whole &= _near(node.test)
        else:
            found.whole = False

    def _interrupt(self, handler: Any, local: Mapping[str, Any], found: Conduct, depth: int) -> None:
        """An interruption that brakes for what is near; others stay code."""
        from scenic.syntax import ast as s

        inner = Conduct()
        if all(isinstance(n, s.Terminate) for n in handler.body):
            return
        self._body(handler.body, local, inner, depth)
        brakes = bool(inner.phases) and all(p.action in ("brake", "stop") for p in inner.phases)
        near = _near(handler.cond)
        near = near or self._trigger(handler.cond, local, ast.Lt | ast.LtE) is not None
        found.brakes |= brakes and near
        found.whole &= brakes and near and inner.whole

    def _take(self, node: Any, found: Conduct) -> None:
        actions = [e.func.id for e in node.elts if isinstance(e, ast.Call) and isinstance(e.func, ast.Name)]
        trigger, found.waits = found.waits, None
        wanted = "SetBrakeAction" in actions
        if wanted and not (found.phases and found.phases[-1].action == "stop"):
            found.phases.append(Phase(action="stop", trigger=trigger))
        found.whole &= wanted

    def _trigger(self, cond: Any, local: Mapping[str, Any], kinds: Any) -> Trigger | None:
        """`gap(self, ego) < 9`, `(distance from self to ego) < 9` and the like."""
        if not (isinstance(cond, ast.Compare) and len(cond.ops) == 1 and isinstance(cond.ops[0], kinds)):
            return None
        between = between_of(cond.left)
        if between is None:
            return None
        value = self.values.number(cond.comparators[0], local)
        named = [n.id for n in between if isinstance(n, ast.Name)]
        other = next(
            (self.ids[n] for n in named if n != "self" and n in self.ids), "ego" if named == ["self"] else None
        )
        if value is None or other is None:
            return None
        return Trigger(kind="distance", value=value, of="ego" if other == "E" else other)

    def _seconds(self, node: Any) -> float | None:
        from scenic.syntax import ast as s

        value = self.values.number(getattr(node, "value", None))
        return value if isinstance(node, s.Seconds) and isinstance(value, float) else None


def between_of(node: Any) -> tuple[Any, Any] | None:
    """The two whose distance is taken: `gap(one, other)` from bumper to bumper, Scenic's operator from centre to
    centre (None for one that is not named: ego)."""
    from scenic.syntax import ast as s

    if isinstance(node, s.DistanceFromOp):
        return node.target, node.base
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "gap" and len(node.args) == 2:
        return node.args[0], node.args[1]
    return None


def _name(node: Any) -> str:
    """The name of a behaviour that is given as it is or called without arguments."""
    called = node.func if isinstance(node, ast.Call) and not node.args and not node.keywords else node
    return called.id if isinstance(called, ast.Name) else ""


def _near(cond: Any) -> bool:
    """Whether a condition asks for what is near."""
    calls = [n.func for n in ast.walk(cond) if isinstance(n, ast.Call)]
    return any(isinstance(f, ast.Name) and f.id.startswith(_NEAR) for f in calls)


def _speed(value: Number | None) -> Number | None:
    return value if value is not None and ends_of(value)[0] >= 0 else None
