"""How the app looks and behaves, and whether all that it needs is there."""

from c2s_tui.part import Part, background
from c2s_tui.screens.dialogs import Choosable, Chooser, Reading


class Settings(Part):
    """Commands that concern the app itself."""

    mouse_free = False  # the terminal has it

    async def do_settings(self, _: str) -> None:
        self.settings_dialog()

    @background("choices")
    async def settings_dialog(self) -> None:
        """Everything that can be chosen, with what stands."""
        from c2s_tui.prefs import prefs_file

        prefs, choice = self.app.prefs, self.bench.choices.choice
        entries = [
            Choosable("method", "method", choice.method),
            Choosable("model", "model", choice.model or "none (the reader works without one)"),
            Choosable("map", "map", choice.map or "auto"),
            Choosable("theme", "theme", self.app.theme),
            Choosable("animation", "animation", "on" if prefs.animation else "off (for slow connections)"),
            Choosable("doctor", "doctor", "check the installation"),
        ]
        foot = f'Keys are remapped under [keys] in {prefs_file().name}, beside config.toml: "app.run" = "f6"'
        chosen = await self.app.push_screen_wait(Chooser("Settings", entries, foot=foot))
        if chosen == "animation":
            self.app.remember(animation=not prefs.animation)
            self.app.animation_level = "full" if prefs.animation else "none"
            self.settings_dialog()
        elif chosen:
            await self.bench.run_command(chosen)

    async def do_doctor(self, _: str) -> None:
        self.look_over()

    @background("choices")
    async def look_over(self) -> None:
        """Show what the doctor finds."""
        from c2s_tui.findings import findings

        self.bench.turns.working = self.bench.turns.working or "checking the installation"
        self.bench.show_status()
        try:
            lines = await findings(self.backend)
        finally:
            self.bench.turns.working = ""
            self.bench.show_status()
        self.app.push_screen(Reading("Doctor", "\n".join(lines)))

    async def do_vim(self, _: str) -> None:
        """Vim's keys in the code, on or off."""
        on = not self.app.prefs.vim
        self.app.remember(vim=on)
        self.bench.code.area.use_vim(on)
        state = "on: Esc leaves insert mode, i enters it" if on else "off"
        self.app.notify(f"Vim keys in the code are {state}.", markup=False)

    async def do_mouse(self, _: str) -> None:
        """Leave the mouse to the terminal, so that text is selected and copied as anywhere else in it, or take it."""
        driver, self.mouse_free = self.app._driver, not self.mouse_free
        switch = getattr(driver, f"_{'disable' if self.mouse_free else 'enable'}_mouse_support", None)
        if switch is not None:
            switch()
        free = "The mouse is the terminal's: select and copy as usual; /mouse takes it back."
        self.app.notify(free if self.mouse_free else "The mouse works here again.", markup=False)

    async def do_theme(self, argument: str) -> None:
        from c2s_tui.look.themes import names

        if argument and argument not in names():
            await self.chat.note(f"There is no theme {argument}; there are {', '.join(names())}.", "error")
            return
        if argument:
            self.take_theme(argument)
            return
        entries = [Choosable(n, n, _THEMES.get(n, "")) for n in names()]
        self.app.push_screen(
            Chooser("Theme", entries, self.app.theme), lambda value: self.take_theme(value) if value else None
        )

    def take_theme(self, name: str) -> None:
        self.app.theme = name
        self.app.remember(theme=name)
        self.bench.show()


_THEMES = {
    "c2s-dark": "dark", "c2s-light": "light", "c2s-ansi": "the terminal's own 16 colours", "c2s-mono": "without colour",
}  # fmt: skip
