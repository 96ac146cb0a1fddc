"""The themes: dark, light, the terminal's own 16 colours, and one without colour."""

from textual.theme import BUILTIN_THEMES, Theme

from c2s_tui.look.kinds import look

DEFAULT = "c2s-dark"


def themes() -> list[Theme]:
    """All themes of the app, each with the colours of the kinds as variables."""
    made = [_theme(name, data) for name, data in look()["themes"].items()]
    return [*made, _ansi()]


def names() -> list[str]:
    return [theme.name for theme in themes()]


def _theme(name: str, data: dict) -> Theme:
    if name == "c2s-mono":
        kinds = {f"kind-{k.lower()}": data["foreground"] for k in look()["kinds"]}
    else:
        shade = "dark" if data["dark"] else "light"
        kinds = {f"kind-{k.lower()}": kind[shade] for k, kind in look()["kinds"].items()}
    data = dict(data)
    kinds |= {"muted": data.pop("muted"), "faint": data.pop("faint")}
    variables = {**kinds, "border": data["panel"], "border-blurred": data["panel"]}
    return Theme(name=name, variables=variables, **data)


def _ansi() -> Theme:
    base = BUILTIN_THEMES["ansi-dark"]
    kinds = {f"kind-{k.lower()}": kind["ansi"] for k, kind in look()["kinds"].items()}
    return Theme(
        name="c2s-ansi", ansi=True, dark=True, primary=base.primary, secondary=base.secondary, warning=base.warning,
        error=base.error, success=base.success, accent="ansi_yellow", foreground=base.foreground,
        background=base.background, surface=base.surface, panel=base.panel, boost=base.boost,
        variables={**base.variables, **kinds, "muted": "ansi_bright_black", "faint": "ansi_bright_black"},
    )  # fmt: skip
