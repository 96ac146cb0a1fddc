"""Which variable and which component of a program an object of its scene belongs to."""

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from c2s_engine.check.diagnose import Program, made_on
from c2s_engine.structure.facts import EGO


class Names:
    """Follows where objects are made, and how the program calls them."""

    def __init__(self, program: Program) -> None:
        self.program = program
        self.lines: dict[int, int] = {}
        self.names: dict[int, str] = {}

    @contextmanager
    def watching(self) -> Iterator[None]:
        """While the program runs, note the line that each object is made on."""
        from scenic.core.distributions import Samplable
        from scenic.syntax import veneer

        register, begin = veneer.registerObject, Samplable.__init__

        def registered(obj: Any) -> None:
            line = self._line()
            if line is not None:
                self.lines[id(obj)] = made_on[id(obj)] = line
            register(obj)

        def begun(value: Any, *args: Any, **kwargs: Any) -> None:
            begin(value, *args, **kwargs)
            line = self._line()
            if line is not None:
                made_on[id(value)] = line

        veneer.registerObject = registered
        Samplable.__init__ = begun
        try:
            yield
        finally:
            veneer.registerObject = register
            Samplable.__init__ = begin

    def _line(self) -> int | None:
        """The line of the program that is being executed."""
        frame = sys._getframe(2)
        while frame is not None and frame.f_code.co_filename != self.program.filename:
            frame = frame.f_back  # type: ignore[assignment]
        return None if frame is None else frame.f_lineno

    def gather(self, namespace: dict[str, Any], scenario: Any) -> None:
        """Take the names from the program's variables (and those of its modular scenario)."""
        objects = {id(o) for o in scenario.objects}
        if scenario.egoObject is not None:
            self.names[id(scenario.egoObject)] = EGO
        spaces = [vars(scenario.dynamicScenario), namespace]
        for space in spaces:
            for name, value in list(space.items()):
                if name.startswith("_"):
                    continue
                if id(value) in objects:
                    self.names.setdefault(id(value), name)
                    continue
                members = getattr(value, "coordinates", value)  # of a list in which something is drawn
                if isinstance(members, list | tuple) and len(members) <= 200:
                    for i, member in enumerate(members):
                        if id(member) in objects:
                            self.names.setdefault(id(member), f"{name}[{i}]")

    def label(self, obj: Any) -> str:
        """What to call an object of the scenario in a message."""
        if id(obj) in self.names:
            return self.names[id(obj)]
        line = self.lines.get(id(obj))
        return f"the {type(obj).__name__} of line {line}" if line else f"a {type(obj).__name__}"

    def component(self, obj: Any) -> str | None:
        return self.program.component_at(self.lines.get(id(obj)))

    def of(self, scenario: Any, scene: Any) -> tuple[dict[int, str], dict[str, str]]:
        """For the runner: id of a sampled object -> name, and name -> component."""
        names: dict[int, str] = {}
        components: dict[str, str] = {}
        for i, (obj, sampled) in enumerate(zip(scenario.objects, scene.objects, strict=True)):
            name = self.names.get(id(obj)) or f"{type(obj).__name__.lower()}_{self.lines.get(id(obj), i)}"
            while name in names.values():
                name += "_"
            names[id(sampled)] = name
            component = self.component(obj)
            if component:
                components[name] = component
        return names, components

    def positions(self, scenario: Any, scene: Any) -> dict[str, tuple[float, float, float]]:
        """Where each object stands at the start: x, y in m, heading in rad."""
        names, _ = self.of(scenario, scene)
        return {names[id(o)]: (float(o.position.x), float(o.position.y), float(o.heading)) for o in scene.objects}
