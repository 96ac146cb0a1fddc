"""Typed fields of a spec as rows of text, and text back to values: read off the pydantic classes, none listed here."""

import re
import types
from dataclasses import dataclass
from typing import Any, Literal, Union, get_args, get_origin

from pydantic import BaseModel

from c2s_engine.structure import value_words as words
from c2s_engine.structure.edits import EditError

UNIT = re.compile(r"(?:^|[,:] )(m/s2|m/s|m|s)(?=$|[,;])")
_LEADING = re.compile(r"(?:m/s2|m/s|m|s)\b(?!/)")
_BY_KIND = re.compile(r"\w+(?:, \w+)*: (?:m/s2|m/s|m|s)\b")
KMH = 3.6


@dataclass(frozen=True)
class Field:
    """One field of a spec. `value` is its plain (JSON) form; `set` says whether it differs from its default."""

    path: str
    value: Any
    set: bool
    choices: tuple[str, ...] = ()
    many: bool = False
    unit: str = ""
    about: str = ""
    depth: int = 0
    leaf: bool = True

    @property
    def label(self) -> str:
        return self.path.rsplit(".", 1)[-1]


def fields(spec: BaseModel, prefix: str = "", depth: int = 0) -> list[Field]:
    """Every field of a spec, nested ones after the one that holds them."""
    found: list[Field] = []
    for name, info in type(spec).model_fields.items():
        if name == "component":
            continue
        found += _field(spec, name, info, f"{prefix}{name}", depth)
    return found


def _field(spec: BaseModel, name: str, info: Any, path: str, depth: int) -> list[Field]:
    value = getattr(spec, name)
    plain = spec.model_dump(mode="json")[name]
    default = info.get_default(call_default_factory=True)
    about = info.description or _described(info)
    is_set = value != default or info.is_required()
    if isinstance(value, BaseModel):
        return [Field(path, plain, is_set, about=about, depth=depth, leaf=False), *fields(value, f"{path}.", depth + 1)]
    model = model_in(info.annotation)
    if isinstance(value, tuple) and model is not None:
        rows = [Field(path, plain, is_set, about=about, depth=depth, leaf=False, many=True)]
        for i, item in enumerate(value):
            rows.append(Field(f"{path}.{i}", plain[i], True, about=about, depth=depth + 1, leaf=False))
            rows += fields(item, f"{path}.{i}.", depth + 2)
        return rows
    if model is not None and value is None:  # an optional part that is absent: one row, its own fields appear once set
        return [Field(path, None, False, about=about, depth=depth, choices=head_choices(model))]
    choices = _choices(info.annotation)
    unit = _unit_of(about, getattr(spec, "kind", None))
    many = isinstance(value, tuple) and not unit and get_origin(info.annotation) is tuple
    return [Field(path, plain, is_set, choices=choices, many=many, unit=unit, about=about, depth=depth)]


def field_at(spec: BaseModel, path: str) -> Field | None:
    """The field at a path, also in a part that is absent; None where there is none."""
    if (found := next((f for f in fields(spec) if f.path == path), None)) is not None:
        return found
    model: type[BaseModel] | None = type(spec)
    info: Any = None
    for name in [part for part in path.split(".") if not part.isdigit()]:
        info = model.model_fields.get(name) if model is not None else None
        if info is None:
            return None
        model = model_in(info.annotation)
    about = (info.description or _described(info)) if info else ""
    return Field(path, None, False, choices=_choices(info.annotation), unit=_unit(about), about=about) if info else None


def _unit(about: str) -> str:
    """The unit that a field's description names; "": none."""
    return match[1] if (match := UNIT.search(about)) else ""


def _unit_of(about: str, kind: Any) -> str:
    """The unit of a field beside a `kind`, where its description names one by kind: "ttc, time: s since the start"."""
    for part in about.split(";"):
        kinds, colon, rest = part.partition(":")
        if colon and kind in [name.strip() for name in kinds.split(",")]:
            return match[0] if (match := _LEADING.match(rest.strip())) else ""
    return "" if kind is not None and _BY_KIND.match(about) else _unit(about)


def _described(info: Any) -> str:
    return next((m.description for m in info.metadata if getattr(m, "description", None)), "")


def _walk(annotation: Any):
    yield annotation
    if get_origin(annotation) is not Literal:
        for part in get_args(annotation):
            yield from _walk(part)


def _choices(annotation: Any) -> tuple[str, ...]:
    found: list[str] = []
    for part in _walk(annotation):
        if part is bool:
            found += ["yes", "no"]
        elif get_origin(part) is Literal:
            found += [str(a) for a in get_args(part)]
    return tuple(found)


def model_in(annotation: Any) -> type[BaseModel] | None:
    return next((p for p in _walk(annotation) if isinstance(p, type) and issubclass(p, BaseModel)), None)


def head_choices(model: type[BaseModel]) -> tuple[str, ...]:
    first = next(iter(model.model_fields.values()))
    return _choices(first.annotation)


def head_name(spec: BaseModel, path: str) -> str | None:
    """For an absent optional part, the name of its first field: setting that makes the part."""
    annotation: Any = type(spec)
    for part in path.split("."):
        model = annotation if isinstance(annotation, type) else model_in(annotation)
        if model is None or not issubclass(model, BaseModel):
            return None
        annotation = model.__pydantic_fields__[part].annotation if not part.isdigit() else model
    model = model_in(annotation)
    return next(iter(model.model_fields)) if model is not None and get_origin(annotation) in (Union, types.UnionType) \
        else None  # fmt: skip


def show(field: Field) -> str:
    """A field's value as a person reads it: km/h for speeds, a range with an en dash, lists with commas."""
    return text_of(field.value, field.unit)


def text_of(value: Any, unit: str = "") -> str:
    if value is None or value == [] or value == {}:
        return ""
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, int | float):
        return f"{value * KMH:.3g} km/h" if unit == "m/s" else f"{value:.4g} {unit}".rstrip()
    if isinstance(value, list):
        if unit and len(value) == 2:
            low, high = (text_of(v, unit).removesuffix(unit if unit != "m/s" else "km/h").rstrip() for v in value)
            return f"{low}-{high} {'km/h' if unit == 'm/s' else unit}".rstrip()
        return ", ".join(text_of(v) for v in value)
    if isinstance(value, dict):
        return summary(value)
    return str(value)


def summary(part: dict[str, Any]) -> str:
    """A nested part in one line of plain words."""
    if "position" in part:
        return words.placement(part, text_of)
    if "action" in part and "kind" not in part:
        return words.phase(part, text_of)
    if "kind" in part and "value" in part:
        return words.trigger(part, text_of)
    return " ".join(_piece(name, value, part) for name, value in part.items() if value not in words.EMPTY)


def _piece(name: str, value: Any, part: dict[str, Any]) -> str:
    """One field of a condition or another small part."""
    if name in ("minimum", "maximum"):
        return f"{'at least' if name == 'minimum' else 'at most'} {text_of(value)}"
    if name == "subject" and part.get("kind") in ("time", "collision"):
        return ""
    if name in ("other", "target"):
        return f"to {value}"
    if isinstance(value, bool):
        return name if value else f"not {name}"
    if isinstance(value, str):
        return value.replace("_", " ")
    return f"{name.replace('_', ' ')} {text_of(value)}"


_NUMBER = r"[-+]?\d+(?:[.,]\d+)?(?:[eE][-+]?\d+)?"
_RANGE = re.compile(rf"^\[?\s*({_NUMBER})\s*(?:-|–|\.\.|,\s|to|;)\s*({_NUMBER})\s*\]?\s*(\S*)$")
_SINGLE = re.compile(rf"^({_NUMBER})\s*(\S*)$")
_FACTORS = {
    "m/s": {"": 1 / KMH, "km/h": 1 / KMH, "kmh": 1 / KMH, "kph": 1 / KMH, "m/s": 1.0, "mph": 0.44704},
    "m": {"": 1.0, "m": 1.0, "km": 1000.0, "ft": 0.3048},
    "s": {"": 1.0, "s": 1.0, "min": 60.0},
    "m/s2": {"": 1.0, "m/s2": 1.0, "m/s²": 1.0, "g": 9.81},
    "": {"": 1.0, "m": 1.0, "s": 1.0},
}


def parse(field: Field, text: str) -> Any:
    """The value that a typed text means; an empty text unsets the field. Raises EditError with what would do."""
    text = text.strip()
    if not text:
        return [] if field.many else None
    if field.many:
        return [_one(field, part.strip()) for part in text.split(",") if part.strip()]
    if isinstance(field.value, dict) and not field.leaf:
        raise EditError(f"{field.path} consists of several fields: open it and set them")
    return _one(field, text)


def _one(field: Field, text: str) -> Any:
    if field.choices:
        wanted = text.lower().replace(" ", "_")
        close = [c for c in field.choices if c.lower() == wanted] or [
            c for c in field.choices if len(wanted) > 1 and c.lower().startswith(wanted)
        ]
        if len(close) != 1 and wanted not in field.choices:
            raise EditError(f"{field.label} is one of {', '.join(field.choices)}")
        value = close[0]
        if value in ("yes", "no"):
            return value == "yes"
        return int(value) if value.isdigit() else value
    factors = _FACTORS.get(field.unit, _FACTORS[""])
    if match := _RANGE.match(text):
        return [_number(match[1], match[3], factors, field), _number(match[2], match[3], factors, field)]
    if match := _SINGLE.match(text):
        return _number(match[1], match[2], factors, field)
    if field.unit:
        unit = "km/h" if field.unit == "m/s" else field.unit
        raise EditError(f"{field.label} is a number or a range, such as 5 or 5-8 {unit}")
    return text


def _number(digits: str, word: str, factors: dict[str, float], field: Field) -> Any:
    if word.lower() not in factors:
        raise EditError(f"{field.label} has the unit {' or '.join(u for u in factors if u) or 'none'}, not {word}")
    value = round(float(digits.replace(",", ".")) * factors[word.lower()], 4)
    return int(value) if not field.unit and value.is_integer() else value
