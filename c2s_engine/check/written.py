"""Behaviours in the shapes of the typed writer, read back: a line that is driven along at a speed, step by step.

A step is a `do Drive(line, speed, rate=...)`, or one of `Stop`, `SlowTo` and `SpeedUpTo`, with the condition that ends
it. What is in none of these shapes (a change to another line, a place to the side of it, a speed that follows that of
another) stays code.
"""

import ast
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from c2s_engine.check.values import Values, ends_of
from c2s_engine.structure.specs import Phase, Trigger

_DRIVE = ("points", "speed", "rate", "offset", "shift")
_BEFORE = {"way": "route", "need": "braking_needed", "most_need": "braking_needed", "pace": "following_speed"}
"""Names of the library's version 1."""
_REACHING = ("SlowTo", "SpeedUpTo")
_DRIVES = ("Drive", "Stop", *_REACHING)
_BRAKING = {(2.5, "BrakeFor"): False, (5.6, "EmergencyStop"): True}
"""Ego's, by the need for it (m/s2) and the behaviour: whether hard."""
_RATES = {3.0: "brake", 3.5: "stop", 2.5: "accelerate", 4.0: "wait"}  # m/s2


@dataclass
class Drive:
    """What such a behaviour says: the first speed (its expression), the phases, how ego answers to what comes near."""

    start: Any
    phases: tuple[Phase, ...]
    brakes: bool = False
    hard: bool = False


@dataclass
class _Step:
    speed: Any
    rate: float | None
    until: Any  # a condition
    seconds: float | None
    reaches: bool = False  # whether it ends as its speed is reached


class NotWritten(Exception):
    """The behaviour is not in one of the shapes."""


class Written:
    """Reads behaviours of one program; `trigger` reads `(distance from self to ...) < 9`."""

    def __init__(self, values: Values, trigger: Callable[[Any], Trigger | None]) -> None:
        self.values, self.trigger = values, trigger

    def read(self, definition: Any) -> Drive | None:
        """What a behaviour says; None where it is in none of the shapes."""
        if definition.args.args or not self._drives():
            return None
        try:
            return self._read(list(definition.body))
        except NotWritten:
            return None

    def _drives(self) -> bool:
        own = self.values.behaviors.get("Drive")
        return self.values.library if own is None else tuple(a.arg for a in own.args.args) == _DRIVE

    def _read(self, body: list[Any]) -> Drive:
        from scenic.syntax import ast as s

        if not (body and isinstance(body[0], ast.Assign) and _called(body[0].value) == "route"):
            raise NotWritten
        line = body.pop(0).targets[0].id
        braking = None
        if len(body) == 1 and isinstance(body[0], s.TryInterrupt):
            braking = self._braking(body[0])
            body = list(body[0].body)
        start: Any = None
        if body and isinstance(body[0], s.Take) and [_called(e) for e in body[0].elts] == ["SetSpeedAction"]:
            start = body.pop(0).elts[0].args[0]
        steps = [self._step(node, line) for node in body]
        phases = self._phases(start, steps)
        return Drive(start, phases, braking is not None, bool(braking))

    def _braking(self, node: Any) -> bool:
        """Whether the interruption brakes hard, where `braking_needed(self, other) > 2.5`, by a library behaviour."""
        from scenic.syntax import ast as s

        if len(node.interrupt_when_handlers) != 1:
            raise NotWritten
        handler = node.interrupt_when_handlers[0]
        (done, *then), limit = handler.body, self._need(handler.cond)
        if then and (len(then) > 1 or not _stays_behind(then[0])):
            raise NotWritten
        if not isinstance(done, s.Do) or len(done.elts) != 1 or limit is None:
            raise NotWritten
        call = done.elts[0]
        if (limit, _called(call)) not in _BRAKING or call.keywords or len(call.args) != 2:
            raise NotWritten
        return _BRAKING[limit, _called(call)]

    def _need(self, cond: Any) -> float | None:
        compared = _comparison(cond)
        if compared is None or _called(compared[0]) != "braking_needed":
            return None
        value = self.values.number(compared[2])
        return value if isinstance(value, float) else None

    def _step(self, node: Any, line: str) -> _Step:
        from scenic.syntax import ast as s

        if not isinstance(node, s.Do | s.DoUntil | s.DoFor) or len(node.elts) != 1:
            raise NotWritten
        call = node.elts[0]
        named = {k.arg: k.value for k in call.keywords} if isinstance(call, ast.Call) else {}
        does = _called(call)
        if does not in _DRIVES or len(call.args) != 2 - (does == "Stop") or set(named) - {"rate"}:
            raise NotWritten
        if not isinstance(call.args[0], ast.Name) or call.args[0].id != line:
            raise NotWritten
        rate, seconds = self._exactly(named["rate"]) if "rate" in named else None, None
        if isinstance(node, s.DoFor):
            if not isinstance(node.duration, s.Seconds):
                raise NotWritten
            seconds = self._exactly(node.duration.value)
        speed = ast.Constant(0) if does == "Stop" else call.args[1]
        until = node.cond if isinstance(node, s.DoUntil) else None
        return _Step(speed, rate, until, seconds, reaches=does in _REACHING and until is None and seconds is None)

    def _exactly(self, node: Any) -> float:
        value = self.values.number(node)
        if not isinstance(value, float):
            raise NotWritten
        return value

    def _phases(self, start: Any, steps: Sequence[_Step]) -> tuple[Phase, ...]:
        """The phases of the steps after the first, which drives on at the first speed where there is one."""
        found: list[Phase] = []
        todo = list(steps)
        now = ends_of(self._speed(start)) if start is not None else (0.0, 0.0)
        trigger: Trigger | None = None
        if todo and start is not None and todo[0].rate is None and ast.dump(todo[0].speed) == ast.dump(start):
            trigger = self._waits(todo.pop(0))
        while todo:
            step = todo.pop(0)
            action = _RATES.get(step.rate or 0.0, "")
            goal = self._exactly(step.speed)
            told: dict[str, Any] = {"action": action, "trigger": trigger}
            if action == "stop" and goal == 0 and not todo and step.until is None and step.seconds is None:
                ended = True  # and stands for good
            elif action == "stop" and goal == 0:
                if not self._reaches(step, ast.Lt, 0.2) or not todo or todo[0].rate != 3.5:
                    raise NotWritten
                step = todo.pop(0)
                ended = step.until is None and step.seconds in (1.0, None)
            elif action == "wait" and goal == 0:
                told["action"] = "wait" if todo or not found else "stationary"
                ended = step.until is None and step.seconds in (3.0, None)
            elif action == "brake" and 0 < goal < now[0] or action == "accelerate" and goal > now[1]:
                sign, over = (ast.Lt, 0.5) if action == "brake" else (ast.Gt, -0.5)
                usual = (now[0] + now[1]) / 4 if action == "brake" else max(0.7 * sum(now), sum(now) / 2 + 5)
                told["speed"] = None if abs(goal - usual) < 0.005 else goal
                ended = self._reaches(step, sign, goal + over) if todo else step.until is None
            else:
                raise NotWritten
            if step.seconds is not None and not ended:
                told["duration"], ended = step.seconds, True
            trigger = None
            if not ended:
                trigger = self._waits(step)
            found.append(Phase(**told))
            now = (goal, goal)
        if trigger is not None:
            raise NotWritten
        return tuple(found)

    def _speed(self, node: Any) -> Any:
        value = self.values.number(node)
        if value is None:
            raise NotWritten
        return value

    def _reaches(self, step: _Step, sign: type, speed: float) -> bool:
        """Whether a step ends as its own speed comes under or over that many m/s."""
        if step.reaches:
            return True
        compared = _comparison(step.until)
        if compared is None or not isinstance(compared[1], sign) or _attribute(compared[0]) != "self.speed":
            return False
        return abs(self._exactly(compared[2]) - speed) < 0.006

    def _waits(self, step: _Step) -> Trigger | None:
        """What the phase after a step waits for; nothing where it waits 3 s, as a phase without a trigger does."""
        if step.until is None:
            if step.seconds not in (3.0, None):
                raise NotWritten
            return None
        compared = _comparison(step.until)
        if compared is not None and isinstance(compared[1], ast.GtE) and _called(compared[0]) == "clock":
            return Trigger(kind="time", value=self._exactly(compared[2]))
        found = self.trigger(step.until)
        if found is None:
            raise NotWritten
        return found


def _called(node: Any) -> str:
    """What is called, by the library's present name."""
    name = node.func.id if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) else ""
    return _BEFORE.get(name, name)


def _comparison(node: Any) -> tuple[Any, Any, Any] | None:
    """What is compared, how, and with what."""
    if not isinstance(node, ast.Compare) or len(node.ops) != 1:
        return None
    return node.left, node.ops[0], node.comparators[0]


def _attribute(node: Any) -> str:
    if not isinstance(node, ast.Attribute) or not isinstance(node.value, ast.Name):
        return ""
    return f"{node.value.id}.{node.attr}"


def _stays_behind(node: Any) -> bool:
    """Whether a statement goes on behind one ahead: `do Drive(line, lambda: following_speed(self, car, 9))`."""
    calls = [n for e in getattr(node, "elts", ()) for n in ast.walk(e) if isinstance(n, ast.Call)]
    return [_called(c) for c in calls] == ["Drive", "following_speed"]
