"""S in short notation, one line a component: what the learned reader writes, and what it was trained to write.

    G: weather=rain light=red ; to=green @time value=5s
    R: intersection control=signal manoeuvre=left
    E: car hard speed=50km/h reaction=brake react_to=O2 ; turn_left
    O1: van at=parked side=right speed=0 ; stationary
    O2: child at=roadside side=right hidden_by=O1 pace=run ; cross_road @distance of=ego value=20m
    T: end collision subject=ego other=O2 ; duration=20s
    X: with its hazard lights on | without looking

Steps are parted by `;`, a trigger begins with `@`, what ends a phase with `^`. Quantities keep the text's units. The
last line has the phrases of the text that no component says ("none": there are none).
"""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

PLACEMENT = ("of", "along", "side", "gap", "lanes_over", "lateral", "arrives", "hidden_by", "facing")
WHOLE = ("arms", "lanes", "lanes_over", "count")
FLAGS = ("oncoming", "shoulder", "sidewalk", "crosswalk")
LEFT_OUT, NONE, BETWEEN = "X:", "none", " | "
"""What the line of phrases that no component says begins with; what it says where there are none; what parts them."""
PARTS = {"require": "require", "limit": "limits", "end": "terminate_when"}
"""The words of T's steps, and the fields that they fill."""

Components = dict[str, dict[str, Any]]


def parse(text: str) -> Components:
    """The components of a text in short notation as plain data, quantities as written; lines that are none are left
    out."""
    found: Components = {}
    for line in text.splitlines():
        cid, colon, rest = line.strip().partition(":")
        steps = [step.split() for step in rest.split(";")]
        if not colon or cid in found or not steps[0]:
            continue
        match cid[:1]:
            case "G" if cid == "G":
                found[cid] = _settings(steps)
            case "R" if cid == "R":
                found[cid] = {"kind": steps[0][0], **_fields(steps[0][1:])}
            case "E" if cid == "E":
                found[cid] = {"type": steps[0][0], **_fields(steps[0][1:], ("hard",)), **_phases(steps)}
            case "T" if cid == "T":
                found[cid] = _restrictions(steps)
            case "O" if cid[1:].isdigit():
                found[cid] = _object(steps)
    return found


def left_out(text: str) -> tuple[str, ...]:
    """The phrases that an answer in short notation says to be in no component."""
    said = next((li for li in text.splitlines() if li.startswith(LEFT_OUT)), LEFT_OUT).removeprefix(LEFT_OUT).strip()
    return tuple(filter(None, map(str.strip, said.split(BETWEEN.strip())))) if said != NONE else ()


def with_left_out(said: str, phrases: Sequence[str]) -> str:
    """S in short notation with those phrases of the text."""
    return f"{said}\n{LEFT_OUT} {BETWEEN.join(phrases) or NONE}"


def _settings(steps: list[list[str]]) -> dict[str, Any]:
    data = _fields(steps[0])
    if isinstance(weather := data.get("weather"), str):
        data["weather"] = weather.split(",")
    changes = []
    for step in steps[1:]:
        words, trigger, _ = _split(step)
        if trigger:
            changes.append({**_fields(words), "when": trigger})
    return {**data, "light_changes": changes} if changes else data


def _object(steps: list[list[str]]) -> dict[str, Any]:
    data = _fields(steps[0][1:])
    placement = {name: data.pop(name) for name in PLACEMENT if name in data}
    position = data.pop("at", "ahead")
    kind = steps[0][0]
    return {"name": kind, "type": kind, "placement": {"position": position, **placement}, **data, **_phases(steps)}


def _restrictions(steps: list[list[str]]) -> dict[str, Any]:
    data: dict[str, Any] = {}
    for step in filter(None, steps):
        if step[0].startswith("duration="):
            data |= _fields(step)
        elif step[0] in PARTS and len(step) > 1:
            data.setdefault(PARTS[step[0]], []).append({"kind": step[1], **_fields(step[2:])})
    return data


def _phases(steps: list[list[str]]) -> dict[str, Any]:
    found = []
    for step in filter(None, steps[1:]):
        words, trigger, until = _split(step)
        if words:
            phase = {"action": words[0], **_fields(words[1:], ("abandoned",))}
            found.append(phase | ({"trigger": trigger} if trigger else {}) | ({"until": until} if until else {}))
    return {"phases": found} if found else {}


def _split(step: list[str]) -> tuple[list[str], dict[str, Any], dict[str, Any]]:
    """The words of a step itself, of its trigger and of what ends it."""
    parts: dict[str, list[str]] = {"": [], "@": [], "^": []}
    mark = ""
    for word in step:
        if word[:1] in ("@", "^"):
            mark, word = word[0], word[1:]
        parts[mark].append(word)
    triggers = ({"kind": p[0], **_fields(p[1:])} if p and p[0] else {} for p in (parts["@"], parts["^"]))
    return parts[""], *triggers  # type: ignore[return-value]


def _fields(words: list[str], flags: tuple[str, ...] = ()) -> dict[str, Any]:
    data: dict[str, Any] = {word: True for word in words if word in flags}
    for word in words:
        name, given, value = word.partition("=")
        if given and value:
            data[name] = _value(name, value)
    return data


def _value(name: str, value: str) -> Any:
    if name in FLAGS:
        return value == "yes"
    if name in WHOLE:
        return int(value) if value.isdigit() else value
    return 0 if value == "0" else value


def short(components: Mapping[str, Mapping[str, Any]]) -> str:
    """The notation of components given as plain data, quantities as strings with their units ("50 km/h"); what is a
    default is left out."""
    lines = []
    for cid, data in components.items():
        match cid[:1]:
            case "G":
                steps = [" ".join(_pairs(data, ("light_changes",)))]
                steps += [" ".join([f"to={c['to']}", *_trigger("@", c["when"])]) for c in data.get("light_changes", ())]
            case "R":
                steps = [" ".join([data.get("kind", "road"), *_pairs(data, ("kind",))])]
            case "E":
                steps = [" ".join([data.get("type", "car"), *(["hard"] if data.get("hard") else []),
                                   *_pairs(data, ("type", "phases", "hard"))]), *_steps(data)]  # fmt: skip
            case "T":
                steps = list(_ends(data))
            case _:
                usual = (("lanes_over", 1), ("of", "ego"))
                placement = {k: v for k, v in data.get("placement", {}).items() if (k, v) not in usual}
                own = {k: v for k, v in data.items() if (k, v) != ("count", 1)}
                ordered = {k: placement[k] for k in PLACEMENT if k in placement}
                said = [*_pairs(ordered), *_pairs(own, ("type", "phases", "placement", "name"))]
                head = [data.get("type", "car"), f"at={placement.get('position', 'ahead')}"]
                steps = [" ".join([*head, *said]), *_steps(data)]
        if any(steps):
            lines.append(f"{cid}: {' ; '.join(steps)}")
    return "\n".join(lines)


def _ends(data: Mapping[str, Any]) -> Iterator[str]:
    if data.get("duration"):
        yield f"duration={_word(data['duration'])}"
    for word, name in PARTS.items():
        yield from (" ".join([word, row["kind"], *_pairs(row, ("kind",))]) for row in data.get(name, ()))


def _steps(data: Mapping[str, Any]) -> Iterator[str]:
    phases = list(data.get("phases") or ())
    for phase in phases[1:] if phases[:1] == [{"action": "keep_lane"}] else phases:
        yield " ".join([
            phase["action"], *(["abandoned"] if phase.get("abandoned") else []),
            *_pairs(phase, ("action", "trigger", "until", "abandoned")),
            *_trigger("@", phase.get("trigger")), *_trigger("^", phase.get("until")),
        ])  # fmt: skip


def _trigger(mark: str, data: Mapping[str, Any] | None) -> list[str]:
    return [mark + data["kind"], *_pairs(data, ("kind",))] if data else []


def _pairs(data: Mapping[str, Any], but: tuple[str, ...] = ()) -> list[str]:
    said = ((k, v) for k, v in data.items() if k not in but and v is not None)
    return [f"{name}={_word(value)}" for name, value in said if (name, value) != ("reaction", "none")]


def _word(value: Any) -> str:
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, list | tuple):
        return ",".join(map(_word, value))
    if isinstance(value, str):
        return value.replace(" ", "") if value.lstrip("-")[:1].isdigit() else value
    return f"{value:g}"
