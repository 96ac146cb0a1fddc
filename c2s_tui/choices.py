"""Choosing what a turn uses: method, model, map."""

from dataclasses import replace
from typing import TYPE_CHECKING

from c2s_engine.config import WITHOUT_MODEL
from c2s_engine.structure.components import Structure
from c2s_engine.structure.edits import SetField
from c2s_engine.structure.specs import SettingsSpec
from c2s_tui.part import Part, background, sentence
from c2s_tui.screens.dialogs import Choosable, Chooser, Reading
from c2s_tui.status import Choice

if TYPE_CHECKING:
    from c2s_tui.workbench import Workbench

METHODS = [
    Choosable("reader", "reader", "a small model that was trained to read scenarios, in this process"),
    Choosable("typed", "typed", "a language model fills in S; the code is written from its fields"),
    Choosable("mixed", "mixed", "like typed; what no field can express, the model writes as code"),
    *(Choosable(f"chat2scenic:C{i}", f"C{i}", f"configuration {i} of Chat2Scenic: a language model writes the code")
      for i in range(1, 13)),
]  # fmt: skip


class Choices(Part):
    """Commands that open a list, or take the name that follows them."""

    def __init__(self, bench: "Workbench"):
        super().__init__(bench)
        self.choice = Choice()

    @property
    def served(self) -> bool:
        """Whether the next turn asks a model that is served."""
        return self.choice.method not in WITHOUT_MODEL

    async def do_method(self, argument: str) -> None:
        names = {m.value: m.value for m in METHODS} | {m.label: m.value for m in METHODS}
        if argument in names:
            self.choose(method=names[argument])
            return
        if argument:
            await self.chat.note(
                f"There is no method {argument}; there are {', '.join(m.label for m in METHODS)}.", "error"
            )
            return
        self.app.push_screen(
            Chooser("How programs are written", METHODS, self.choice.method),
            lambda value: self.choose(method=value) if value else None,
        )

    async def do_map(self, argument: str) -> None:
        self.offer_maps(argument)

    @background("choices")
    async def offer_maps(self, argument: str) -> None:
        """The maps that are installed; `auto` leaves it to the text."""
        maps = list(await self.backend.do(lambda engine: engine.maps()))
        entries = [Choosable("auto", "auto", "the one that the text names, else the default")]
        entries += [Choosable(m.name, m.name, str(m.path)) for m in maps]
        if argument:
            if argument not in {e.value for e in entries}:
                names = ", ".join(e.value for e in entries)
                await self.chat.note(f"There is no map {argument}; there are {names}.", "error")
                return
            chosen: str | None = argument
        else:
            chosen = await self.app.push_screen_wait(Chooser("Map", entries, self.choice.map or "auto"))
        if not chosen:
            return
        if chosen != "auto" and self.bench.session is not None and self.desk.program.text:
            if await self.bench.turns.may_begin():
                await self.bench.turns.make_edits((SetField(component="G", path="map", value=chosen),))
                await self.chat.note(f"The map of this session is {chosen} from now on (G's field `map`).")
            return
        self.choose(map="" if chosen == "auto" else chosen)
        how = "the one that a text names, else the usual one" if chosen == "auto" else chosen
        await self.chat.note(f"The map of new scenarios, in any session: {how}.")

    def map_of(self, structure: Structure) -> str | None:
        """The map that a turn upon S is asked for: S's own where it was set by hand, else the default."""
        spec = structure.settings.spec
        own = spec.map if isinstance(spec, SettingsSpec) else None
        if own and own.lower() not in structure.text.lower():
            return own
        return self.choice.map or None

    async def do_model(self, argument: str) -> None:
        if argument:
            await self.take_model(argument)
        else:
            self.offer_models()

    async def take_model(self, name: str) -> None:
        """Use a model from now on."""
        await self.backend.set_model(name)
        self.choose(model=name)

    @background("choices")
    async def offer_models(self) -> None:
        """The models that Ollama has, with sizes; a typed name is pulled."""
        try:
            models = await self.backend.models()
        except Exception as error:
            self.app.push_screen(
                Reading("No models", f"{sentence(error)}\n\nThe method `reader` needs none: /method reader")
            )
            return
        entries = [Choosable(m["name"], m["name"], m.get("note", "")) for m in models]
        chosen = await self.app.push_screen_wait(
            Chooser("Language model", entries, self.choice.model, free="type to filter, or the name of a model to pull")
        )
        if not chosen:
            return
        if chosen not in {e.value for e in entries} and not await self._pull(chosen):
            return
        await self.take_model(chosen)

    async def _pull(self, name: str) -> bool:
        """Pull a model, its progress in the status line; whether that went well."""
        try:
            async for status, done, total in self.backend.pull(name):
                share = f" {100 * done // total} %" if total else ""
                self.bench.turns.working = f"pulling {name}: {status}{share}"
                self.bench.show_status()
        except Exception as error:
            await self.chat.note(f"{name} could not be pulled: {sentence(error)}", "error")
            return False
        finally:
            self.bench.turns.working = ""
            self.bench.show_status()
        return True

    def choose(self, **values: str) -> None:
        """Change what the next turn uses, and remember it."""
        self.choice = replace(self.choice, **values)
        self.app.remember(**values)
        self.bench.show_status()
        if values.get("map"):
            self.bench.run_worker(self.backend.warm(values["map"]), group="warm", exit_on_error=False)
