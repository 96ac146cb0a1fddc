"""The picture pane: a run from above, stepped and played by key."""

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from textual import getters, on
from textual.app import ComposeResult
from textual.binding import Binding
from textual.containers import Vertical
from textual.timer import Timer
from textual.widgets import Static

from c2s_engine.structure.event_words import USUAL
from c2s_engine.structure.facts import ContactFact, RunFacts, Trajectories
from c2s_tui.app import C2SApp
from c2s_tui.desk import Desk
from c2s_tui.look.kinds import ascii_only
from c2s_tui.messages import CommandAsked
from c2s_tui.picture.draw import View, caption, draw, fitting, frames, names, turned
from c2s_tui.picture.graphics import KITTY, SIXEL, TEXT, cell_size, chosen, pixel_widget
from c2s_tui.picture.timebar import TimeBar

if TYPE_CHECKING:
    from PIL import Image

FRAMES_PER_SECOND = 8
ZOOM = 1.25


class PicturePane(Vertical, can_focus=True):
    """Shows one rollout at one step; plays in real time."""

    BORDER_TITLE = "picture"
    HELP_NAME = "picture"
    app = getters.app(C2SApp)
    BINDINGS = [
        Binding("space", "play", "Play", id="picture.play", tooltip="Play or pause"),
        Binding("left", "step(-0.1)", "Back", show=False, id="picture.back", tooltip="A step back"),
        Binding("right", "step(0.1)", "On", show=False, id="picture.on", tooltip="A step on"),
        Binding("down,pageup", "step(-1)", "1 s back", show=False, id="picture.second_back", tooltip="A second back"),
        Binding("up,pagedown", "step(1)", "1 s on", show=False, id="picture.second_on", tooltip="A second on"),
        Binding("home", "edge(0)", "Start", show=False, id="picture.start", tooltip="To the start"),
        Binding("end", "edge(1)", "End", show=False, id="picture.end", tooltip="To the end"),
        Binding("plus,equals_sign", "zoom(-1)", "Nearer", show=False, id="picture.nearer", tooltip="Nearer"),
        Binding("minus", "zoom(1)", "Farther", show=False, id="picture.farther", tooltip="Farther"),
        Binding("w", "whole", "Whole", show=False, id="picture.whole", tooltip="The whole run, or following ego"),
        Binding("f", "follow", "Follow", id="picture.follow", tooltip="Follow the next actor"),
        Binding("c", "contact", "Contact", show=False, id="picture.contact", tooltip="To the moment of contact"),
        Binding("n", "rollout", "Next run", show=False, id="picture.next_run", tooltip="The next rollout"),
        Binding("escape", "close", "Close", id="picture.close", tooltip="Close the picture"),
    ]

    def __init__(self, **options: Any):
        super().__init__(**options)
        self.ways: tuple[Trajectories, ...] = ()
        self.facts: tuple[RunFacts, ...] = ()
        self.run, self.frame, self.view = 0, 0, View()
        self._fitted = self._zoomed = False
        self._turned: dict[int, tuple[Trajectories, str]] = {}  # by run: as it is drawn, and where north is
        self._timer: Timer | None = None

    def compose(self) -> ComposeResult:
        yield Static(id="frame", markup=False)
        yield TimeBar(id="time", markup=False)
        yield Static(id="caption", markup=False)

    def show(self, desk: Desk) -> None:
        """Take the runs of the desk; the step shown stays where there still is one."""
        if desk.trajectories is not self.ways:
            self.ways, self.facts = desk.trajectories, desk.facts
            self._turned.clear()
            self.run = min(self.run, max(0, len(self.ways) - 1))
            self.frame = 0
            self._fitted = self._zoomed = False
            self.stop()
        self._draw()

    @property
    def way(self) -> str:
        """How the terminal is to show it: kitty, sixel, blocks or text."""
        return chosen(self.app.prefs.graphics, self.app.theme, ascii_only(), self.app.console.color_system)

    def _paint(
        self, ways: Trajectories, columns: int, rows: int, labels: dict[str, str], hits: Sequence[ContactFact]
    ) -> None:
        """Draw the frame in the way that the terminal can show; sixel is too slow to play, so blocks stand for it."""
        frame, way = self.query_one("#frame", Static), self.way
        if way == TEXT:
            frame.update(draw(ways, self.frame, columns, rows, labels, self.view, hits), layout=False)
            return
        from c2s_tui.picture import pixels

        at = max(0, min(self.frame, frames(ways) - 1))
        colours = pixels.palette(self.app.theme_variables)
        exact = way == KITTY or way == SIXEL and not self.playing
        frame.display = not exact
        for widget in self.query("#pixels"):
            widget.display = exact
        if exact:
            self._show_image(pixels.paint(ways, at, columns, rows, labels, self.view, colours, hits, cell_size(), True))
            return
        image = pixels.paint(ways, at, columns, rows, labels, self.view, colours, hits)
        frame.update(pixels.blocks(image, ways, at, labels, self.view, colours, hits), layout=False)

    def _show_image(self, image: "Image.Image") -> None:
        there = self.query("#pixels")
        if there:
            there.first().image = image  # type: ignore[attr-defined]
        else:
            self.mount(pixel_widget(self.way)(image, id="pixels"), before="#frame")

    @property
    def available(self) -> bool:
        return any(frames(w) for w in self.ways)

    @property
    def playing(self) -> bool:
        return self._timer is not None

    def on_resize(self) -> None:
        self._fitted = self._fitted and self._zoomed
        self._draw()

    def _draw(self) -> None:
        if not self.has_class("-on") or not self.available:
            return
        if self.run not in self._turned:
            self._turned[self.run] = turned(self.ways[self.run])
        ways, north = self._turned[self.run]
        facts = self.facts[self.run] if self.run < len(self.facts) else None
        columns, rows = self.content_size.width, self.content_size.height - 3
        if columns < 4 or rows < 2:
            return
        if not self._fitted:
            self.view = replace(self.view, scale=fitting(ways, columns, rows))
            self._fitted = True
        labels = names(facts, ways)
        hits = facts.contacts if facts else ()
        self._paint(ways, columns, rows, labels, hits)
        words = caption(ways, self.frame, labels, self.view, facts, north)
        self.query_one("#caption", Static).update(words, layout=False)
        last = (frames(ways) - 1) * ways.step
        events = [e.time for o in (facts.objects if facts else ()) for e in o.events if e.event not in USUAL]
        shares = [[min(1.0, t / max(last, 0.1)) for t in times] for times in (events, [h.time for h in hits])]
        self.query_one(TimeBar).show(self.frame * ways.step / max(last, 0.1), *shares)
        state = "playing" if self.playing else "space plays"
        several = f", run {self.run + 1} of {len(self.ways)}" if len(self.ways) > 1 else ""
        self.border_subtitle = f"{self.frame * ways.step:.1f} of {last:.1f} s, {state}{several}"

    def go(self, frame: int) -> None:
        """Show a step."""
        self.frame = max(0, min(frame, frames(self.ways[self.run]) - 1)) if self.available else 0
        self._draw()

    def stop(self) -> None:
        """Stop playing."""
        if self._timer is not None:
            self._timer.stop()
            self._timer = None

    def action_play(self) -> None:
        if not self.available:
            return
        if not self.app.prefs.animation:
            self.action_step(0.5)
            return
        if self.playing:
            self.stop()
        else:
            if self.frame >= frames(self.ways[self.run]) - 1:
                self.frame = 0
            self._timer = self.set_interval(1 / FRAMES_PER_SECOND, self._tick)
        self._draw()

    def _tick(self) -> None:
        ways = self.ways[self.run]
        self.frame += max(1, round(1 / FRAMES_PER_SECOND / ways.step))
        if self.frame >= frames(ways) - 1:
            self.stop()
        self.go(self.frame)

    def action_step(self, seconds: float) -> None:
        if self.available:
            step = self.ways[self.run].step
            self.go(self.frame + (1 if seconds > 0 else -1) * max(1, round(abs(seconds) / step)))

    def action_edge(self, end: int) -> None:
        if self.available:
            self.go(frames(self.ways[self.run]) - 1 if end else 0)

    def action_zoom(self, by: int) -> None:
        self._zoomed = True
        self.view = replace(self.view, scale=min(8.0, max(0.2, self.view.scale * ZOOM**by)), follow=True)
        self._draw()

    def action_whole(self) -> None:
        self.view = replace(self.view, follow=not self.view.follow)
        self._draw()

    def action_follow(self) -> None:
        """Put the next actor that moves into the middle."""
        if self.available:
            names = [t.name for t in self.ways[self.run].tracks if t.kind != "prop"]
            at = names.index(self.view.whom) + 1 if self.view.whom in names else 0
            self.view = replace(self.view, follow=True, whom=names[at % len(names)])
            self._draw()

    def action_contact(self) -> None:
        """To the first contact, where there is one."""
        facts = self.facts[self.run] if self.run < len(self.facts) else None
        if self.available and facts and facts.contacts:
            self.stop()
            self.go(round(min(c.time for c in facts.contacts) / self.ways[self.run].step))

    @on(TimeBar.Asked)
    def _scrubbed(self, event: TimeBar.Asked) -> None:
        event.stop()
        if self.available:
            self.stop()
            self.go(round(event.share * (frames(self.ways[self.run]) - 1)))

    def action_rollout(self) -> None:
        if len(self.ways) > 1:
            self.run = (self.run + 1) % len(self.ways)
            self._fitted = False
            self.go(0)

    def action_close(self) -> None:
        self.post_message(CommandAsked("picture"))
