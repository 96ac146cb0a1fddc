"""A dossier as Markdown."""

from collections.abc import Iterator, Sequence
from typing import Any

import yaml

from c2s_engine.structure.account import STATUS_WORDS
from c2s_engine.structure.components import field_words

MOMENTS, PLOTS = "moments.png", "plots.png"


def markdown(shown: dict[str, Any], pictures: Sequence[str] = ()) -> str:
    """The dossier's text; `pictures`: the files beside it that there are."""
    parts = [f"# {shown['id']}", *_text(shown)]
    if shown["problem"]:
        parts.append(f"**{shown['problem']}**")
    parts += _structure(shown)
    if shown["run"]:
        parts += [*_run(shown, pictures), *_timeline(shown), *_criticality(shown), *_tracks(shown)]
    parts += [*_requirements(shown), *_drivers(shown), *_program(shown)]
    return "\n\n".join(parts) + "\n"


def table(head: Sequence[str], lines: Sequence[Sequence[Any]]) -> str:
    """A Markdown table."""
    rows = [head, ["---"] * len(head), *lines]
    return "\n".join("| " + " | ".join(_cell(v) for v in row) + " |" for row in rows)


def fenced(text: str, language: str = "") -> str:
    """A text as it is, in a fence longer than any in it."""
    fence = "```"
    while fence in text:
        fence += "`"
    return f"{fence}{language}\n{text.rstrip()}\n{fence}"


def _cell(value: Any) -> str:
    return str(value).replace("|", "\\|").replace("\n", " ")


def _text(shown: dict[str, Any]) -> Iterator[str]:
    if not shown["text"]:
        yield "There is no text: S is what was recognised in the program, and no more than that."
        return
    yield "## Text"
    yield fenced(shown["text"])
    if shown["matters"]:
        yield f"What matters most to its writer: {_cell(shown['matters'])}"
    if not shown["account"]:
        return
    if shown["changes"]:
        yield "What was changed after it (S below has all of it; the table of clauses is of the text alone):"
        yield "\n".join(f"{i}. {_cell(said)}" for i, said in enumerate(shown["changes"], 1))
    yield "What became of each clause:"
    yield table(
        ["clause", "became", "of", "lost"],
        [[c["text"], STATUS_WORDS[c["status"]], ", ".join(c["fields"] or c["components"]) or "-", _lost(c)]
         for c in shown["account"]],
    )  # fmt: skip


def _lost(clause: dict[str, Any]) -> str:
    whole = clause["text"]
    said = [u["reason"] if u["text"] == whole else f"“{u['text']}”: {u['reason']}" for u in clause["lost"]]
    unread = [f"no field rests on {', '.join(f'“{word}”' for word in clause['unread'])}"] if clause["unread"] else []
    return "; ".join(dict.fromkeys([*said, *unread])) or "-"


def _structure(shown: dict[str, Any]) -> Iterator[str]:
    yield "## What was understood (S; m, m/s, s)"
    for c in shown["structure"]:
        lines = [f"**{c['id']}** {c['description'] or '-'}"]
        if c["spec"]:
            said = yaml.safe_dump(c["spec"], sort_keys=False, default_flow_style=None, width=110, allow_unicode=True)
            lines.append(fenced(said, "yaml"))
        notes = [f"- assumed {field_words(a['field'])} = {a['value']}: {a['reason']}" for a in c["assumed"]]
        notes += [f"- not expressible: “{u['text']}”: {u['reason']}" for u in c["unmet"]]
        notes += [f"- rests on the {s['kind']} “{s['label']}”" for s in c["sources"]]
        yield "\n\n".join([*lines, "\n".join(notes)] if notes else lines)


def _run(shown: dict[str, Any], pictures: Sequence[str]) -> Iterator[str]:
    run = shown["run"]
    yield f"## The run: {run['duration']:.1f} s, ended by {run['ended_by']}"
    yield (
        "From a dry run with simple vehicle dynamics, not from CARLA. Boxes are the actors, arrows their "
        "headings, solid lines the ways so far, dotted ones the ways to come."
    )
    yield from (f"![{name.removesuffix('.png')}]({name})" for name in pictures)
    yield "\n".join(f"- {k}: {v}" for k, v in shown["surroundings"].items())


def _timeline(shown: dict[str, Any]) -> Iterator[str]:
    yield "## Events"
    lines = [[f"{e['time']:.1f}", e["who"], e["event"].replace("_", " "), e["other"]] for e in shown["timeline"]]
    yield table(["s", "who", "event", "towards"], lines) if lines else "No event."


def _criticality(shown: dict[str, Any]) -> Iterator[str]:
    if not shown["criticality"]:
        return
    yield "## Criticality"
    yield (
        "Smallest gap between the boxes; smallest time to collision (both keep speed and heading); post-encroachment "
        "time where the ways cross; the largest deceleration that ego needed so as not to reach the other on its way."
    )
    yield table(
        ["ego and", "gap", "TTC", "PET", "required deceleration"],
        [[c["other"], _at(c, "gap", "m"), _at(c, "ttc", "s"), _at(c, "pet", "s"),
          _at(c, "required_deceleration", "mps2").replace("mps2", "m/s2")] for c in shown["criticality"]],
    )  # fmt: skip


def _at(found: dict[str, Any], name: str, unit: str) -> str:
    value, when = found[f"{name}_{unit}"], found[f"{name}_at_s"]
    return "-" if value is None or when is None else f"{value:g} {unit} at {when:.1f} s"


def _tracks(shown: dict[str, Any]) -> Iterator[str]:
    if not shown["tracks"]:
        return
    names = list(shown["tracks"][0]["others"])
    yield "## Tracks"
    yield (
        "Each other: speed; gap between its box and ego's; metres ahead of ego along ego's way / to the left of that "
        "way (negative: behind, right), centre to centre; where it is. Actors get their speeds in the first steps, so "
        "that all stand at 0 s."
    )
    lines = []
    for row in shown["tracks"]:
        others = [row["others"][n] for n in names]
        cells = [f"{o['speed']:g} km/h; {o['gap']:g} m; {o['ahead']:+g} / {o['left']:+g}; {o['where']}" for o in others]
        lines.append([f"{row['time']:g}", f"{row['speed']:g} km/h; {row['where']}", *cells])
    yield table(["s", "ego", *names], lines)


def _requirements(shown: dict[str, Any]) -> Iterator[str]:
    asked = shown.get("requirements")
    if not asked:
        return
    held = sum(1 for r in asked if r["holds"])
    yield f"## What S requires: {held} of {len(asked)} seen"
    if not shown["text"]:
        yield "S was recognised in a program: what was not recognised in it is not required here."
    marks = {True: "yes", False: "**no**", None: "not judged"}
    lines = [
        [r["text"], marks[r["holds"]], r["seen"] or r["why"] or "-",
         "-" if r["robustness"] is None else f"{r['robustness']:+.2f}", r["requirement"]]
        for r in asked
    ]  # fmt: skip
    yield table(["required", "holds", "seen", "by", "id"], lines)


def _drivers(shown: dict[str, Any]) -> Iterator[str]:
    if not shown.get("drivers"):
        return
    yield "## Other drivers in ego's place"
    yield "What S requires of where the others start and what they do; they drive by the same code."
    lines = [
        [d["name"], f"{d['required'] - len(d['missed'])} of {d['required']}",
         d["problem"] or "; ".join(d["missed"]) or "-"]
        for d in shown["drivers"]
    ]  # fmt: skip
    yield table(["driver", "seen", "not seen"], lines)


def _program(shown: dict[str, Any]) -> Iterator[str]:
    yield "## Program"
    yield fenced(shown["program"], "scenic") if shown["program"].strip() else "There is no program."
    if shown["faults"]:
        yield "\n".join(["Diagnostics:", "", *(f"- {f}" for f in shown["faults"])])
    if "digests" in shown:
        yield "## Versions and digests"
        yield table(["", ""], [["made by", shown["origin"]], *shown["digests"].items()])
