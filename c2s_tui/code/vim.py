"""Vim's keys in the code, as an option: normal and insert mode, motions with counts, common edits; no visual mode."""

from typing import TYPE_CHECKING

from textual.events import Key

from c2s_tui.messages import CommandAsked

if TYPE_CHECKING:
    from c2s_tui.code.area import CodeArea

MOTIONS = {
    "h": "cursor_left", "left": "cursor_left", "l": "cursor_right", "right": "cursor_right", "j": "cursor_down",
    "down": "cursor_down", "k": "cursor_up", "up": "cursor_up", "w": "cursor_word_right", "e": "cursor_word_right",
    "b": "cursor_word_left", "0": "cursor_line_start", "$": "cursor_line_end", "ctrl+d": "cursor_page_down",
    "ctrl+u": "cursor_page_up", "x": "delete_right", "D": "delete_to_end_of_line", "u": "undo", "ctrl+r": "redo",
}  # fmt: skip
"""Keys of normal mode and the actions of the text area that they stand for."""
PAIRS = ("gg", "dd", "yy", "cc", "dw", "cw")
INSERTING = "iIaAoO"
TYPING = ("enter", "backspace", "delete", "tab")
"""Keys that type in insert mode, and do nothing in normal mode."""


class Vim:
    """What is typed into one text area; `take` says whether a key was one of these."""

    def __init__(self, area: "CodeArea"):
        self.area = area
        self.normal = True
        self.lines = ""  # what dd and yy took
        self._before = ""  # a count, and the first key of a pair

    @property
    def mode(self) -> str:
        return "normal" if self.normal else "insert"

    def take(self, event: Key) -> bool:
        """Do what a key means; False where it is typed, or means nothing to Vim."""
        if event.key == "escape":
            inserting, self.normal, self._before = not self.normal, True, ""
            return inserting
        if not self.normal:
            return False
        key = event.character if event.is_printable and event.character else event.key
        count, first = self._before.rstrip("gdyc"), self._before[-1:] if self._before[-1:] in tuple("gdyc") else ""
        if key.isdigit() and not first and (key != "0" or count):
            self._before += key
        elif first + key in PAIRS:
            self._before = ""
            self._pair(first + key, int(count or 1), bool(count))
        elif key in "gdyc" and not first:
            self._before += key
        elif first:
            self._before = ""
        else:
            self._before = ""
            return self._single(key, int(count or 1), bool(count)) or event.is_printable or key in TYPING
        return True

    def _single(self, key: str, count: int, counted: bool) -> bool:
        area, (row, _) = self.area, self.area.cursor_location
        if key in MOTIONS:
            for _ in range(count):
                getattr(area, f"action_{MOTIONS[key]}")()
        elif key in INSERTING:
            self._insert(key)
        elif key == "G":
            area.move_cursor((min(count, area.document.line_count) - 1 if counted else area.document.line_count - 1, 0))
        elif key == "^":
            area.move_cursor((row, self._first(row)))
        elif key in "pP" and self.lines:
            at = row + (key == "p")
            last = at >= area.document.line_count
            end = (row, len(area.document.get_line(row)))
            area.insert(f"\n{self.lines.rstrip(chr(10))}" if last else self.lines, end if last else (at, 0))
            area.move_cursor((at, self._first(at)))
        elif key in "/nN":
            area.post_message(CommandAsked("find"))
        else:
            return False
        return True

    def _insert(self, key: str) -> None:
        area, (row, column) = self.area, self.area.cursor_location
        end, first = len(area.document.get_line(row)), self._first(row)
        if key in "oO":
            indent = area.document.get_line(row)[:first]
            area.insert(f"\n{indent}" if key == "o" else f"{indent}\n", (row, end if key == "o" else 0))
            area.move_cursor((row + (key == "o"), len(indent)))
        else:
            area.move_cursor((row, {"i": column, "a": min(column + 1, end), "I": first, "A": end}[key]))
        self.normal = False

    def _pair(self, keys: str, count: int, counted: bool) -> None:
        area, row = self.area, self.area.cursor_location[0]
        last = min(row + count, area.document.line_count) - 1
        if keys == "gg":
            area.move_cursor((min(count, area.document.line_count) - 1 if counted else 0, 0))
        elif keys[1] == "w":
            start = area.cursor_location
            for _ in range(count):
                area.action_cursor_word_right()
            area.delete(start, area.cursor_location)
        else:
            self.lines = "".join(f"{area.document.get_line(i)}\n" for i in range(row, last + 1))
            if keys == "cc":
                first = self._first(row)
                area.delete((row, first), (last, len(area.document.get_line(last))))
                area.move_cursor((row, first))
            elif keys == "dd" and last + 1 < area.document.line_count:
                area.delete((row, 0), (last + 1, 0))
            elif keys == "dd":
                area.delete((row - 1, len(area.document.get_line(row - 1))) if row else (0, 0),
                            (last, len(area.document.get_line(last))))  # fmt: skip
        if keys[0] == "c":
            self.normal = False

    def _first(self, row: int) -> int:
        """The column of a row's first character that is no blank."""
        line = self.area.document.get_line(row)
        return len(line) - len(line.lstrip())
