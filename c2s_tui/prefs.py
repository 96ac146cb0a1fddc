"""What a user chose in the app: a small TOML file beside the engine's settings."""

import tomllib
from dataclasses import asdict, dataclass, field, fields
from pathlib import Path
from typing import Any

from c2s_engine.paths import config_file


@dataclass
class Prefs:
    """Read from and written to app.toml; the table [keys] maps ids of bindings to keys."""

    theme: str = "c2s-dark"
    method: str = ""
    model: str = ""
    map: str = ""
    animation: bool = True
    welcomed: bool = False
    session: str = ""
    graphics: str = "auto"  # how the picture is drawn: auto, kitty, sixel, blocks, text
    widths: str = ""  # shares of the three columns, such as "36 46 58"
    vim: bool = False  # Vim's keys in the code
    keys: dict[str, str] = field(default_factory=dict)
    trouble: str = field(default="", repr=False)  # why the file could not be used; shown once


def prefs_file() -> Path:
    return config_file().with_name("app.toml")


def load(path: Path | None = None) -> Prefs:
    """The choices of the file, else the defaults; a broken file is reported in `trouble`, never fatal."""
    path = path or prefs_file()
    try:
        data = tomllib.loads(path.read_text("utf-8"))
    except FileNotFoundError:
        return Prefs()
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        return Prefs(trouble=f"{path} cannot be read ({error}): the defaults are used. Correct or remove the file.")
    known = {f.name: f for f in fields(Prefs) if f.name != "trouble"}
    prefs = Prefs()
    wrong = []
    for name, value in data.items():
        if name not in known or type(value) is not type(getattr(prefs, name)):
            wrong.append(name)
        else:
            setattr(prefs, name, value)
    if wrong:
        prefs.trouble = f"{path}: {', '.join(wrong)} cannot be used; the defaults are used instead"
    return prefs


def save(prefs: Prefs, path: Path | None = None) -> None:
    """Write the file whole: beside, then renamed. Raises OSError."""
    path = path or prefs_file()
    path.parent.mkdir(parents=True, exist_ok=True)
    data = {k: v for k, v in asdict(prefs).items() if k not in ("trouble", "keys")}
    lines = [f"{name} = {_toml(value)}" for name, value in data.items()]
    lines += ["", "[keys]", *(f"{_toml(name)} = {_toml(key)}" for name, key in prefs.keys.items())]
    draft = path.with_name(f".{path.name}.part")
    draft.write_text("\n".join(lines) + "\n", "utf-8")
    draft.replace(path)


def _toml(value: Any) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    text = str(value).replace("\\", "\\\\").replace('"', '\\"')
    return f'"{text}"'
