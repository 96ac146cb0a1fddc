"""Dossiers on disk: Markdown, HTML or JSON with the pictures beside it. Same inputs, same bytes."""

import base64
import json
import re
from pathlib import Path
from typing import Literal

from c2s_engine.report.dossier import decisive, dossier
from c2s_engine.report.markdown import MOMENTS, PLOTS, markdown
from c2s_engine.report.material import Material

Format = Literal["md", "html", "json"]
STYLE = (
    "body{font:15px/1.5 sans-serif;max-width:1100px;margin:2em auto;padding:0 1em}img{max-width:100%}"
    "table{border-collapse:collapse;font-size:13px}td,th{border:1px solid #ccc;padding:2px 6px;text-align:left}"
    "pre{background:#f4f4f0;padding:8px;overflow-x:auto;white-space:pre-wrap}"
)


def write(material: Material, folder: Path, form: Format = "md", *, blind: bool = False, head: str = "") -> Path:
    """Write a dossier into a folder of its own; the file to read. `head` stands above it (Markdown). Raises OSError."""
    folder.mkdir(parents=True, exist_ok=True)
    shown = dossier(material, blind)
    pictures = pictures_of(material)
    for name, data in pictures.items():
        (folder / name).write_bytes(data)
    file = folder / f"report.{form}"
    if form == "json":
        file.write_text(json.dumps({**shown, "pictures": list(pictures)}, indent=1, ensure_ascii=False) + "\n", "utf-8")
        return file
    text = "\n\n".join(filter(None, (head, markdown(shown, list(pictures)))))
    file.write_text(text if form == "md" else page(text, material.id, pictures), encoding="utf-8")
    return file


def pictures_of(material: Material) -> dict[str, bytes]:
    """The pictures by file name; none where nothing ran."""
    found = decisive(material)
    if not found or material.ways is None:
        return {}
    from c2s_engine.report.pictures import moments_png, plots_png

    return {MOMENTS: moments_png(material.ways, found), PLOTS: plots_png(material.ways, found)}


def page(text: str, title: str, pictures: dict[str, bytes]) -> str:
    """Markdown as one HTML page that holds its pictures."""
    from markdown_it import MarkdownIt

    body = MarkdownIt("commonmark", {"html": False}).enable("table").render(text)
    for name, data in pictures.items():
        body = body.replace(f'src="{name}"', f'src="data:image/png;base64,{base64.b64encode(data).decode()}"')
    safe = re.sub(r"[<>&]", "", title)
    return f'<!doctype html>\n<meta charset="utf-8">\n<title>{safe}</title>\n<style>{STYLE}</style>\n{body}'
