"""The paper's SettingsDetector without a model: weather, time of day, map, preset and ego's blueprint that a text
names, with where the text says so."""

import re
from dataclasses import dataclass
from functools import cache
from typing import Any

from c2s_engine.interpret import language
from c2s_engine.interpret.text import normalised, sentences
from c2s_engine.structure.specs import SettingsSpec

NEGATED = re.compile(
    r"(\bno|\bnot( yet| any)?|without( any)?|free of|never|neither|instead of|isn't|wasn't|nor)\s+([\w-]+\s+)?$"
)

OF_THE_WAY = re.compile(
    r"(nearly|almost|gets?|got|is|was|be|been|stay(s|ed)?|keeps?|kept|safely|well|fully|completely|pull(s|ed)?"
    r"|(let|lets|allow|allows|allowed) .*|until .*|lane|road|way|path|coast|junction|intersection|crossing|becomes?"
    r"|became|all)\s+$"
)
"""What stands before a "clear" that is no weather: "let the bus clear", "the road was clear"."""


EXCLUDED = re.compile(
    r"(?:[- ]?time)?(?: (?:driving|operations?|runs?|tests?|use))? (?:is|are|was|were) "
    r"(?:not(?= ?[,.;:]| (?:permitted|allowed|covered|supported|part|included|within|in scope))"
    r"|excluded|forbidden|ruled out|prohibited|outside|out of scope)"
)
"""What says that a time of day is none of the scene: "darkness is not (permitted)"."""


@dataclass(frozen=True)
class Found:
    """A value of a setting, and where the text says so."""

    value: str
    span: tuple[int, int]


@cache
def _compiled(section: str) -> list[tuple[str, re.Pattern[str], re.Pattern[str] | None]]:
    return [
        (e["is"], re.compile(e["find"]), re.compile(e["not"]) if "not" in e else None)
        for e in language.table("environment")[section]
    ]


def _hits(section: str, plain: str, parts: list[tuple[int, int]]) -> list[Found]:
    found: list[Found] = []
    for value, pattern, unless in _compiled(section):
        for start, end in parts:
            sentence = plain[start:end]
            if unless is not None and unless.search(sentence):
                continue
            for match in pattern.finditer(sentence):
                before = sentence[max(0, match.start() - 30) : match.start()]
                excluded = section == "time" and EXCLUDED.match(sentence, match.end())
                if (
                    excluded
                    or NEGATED.search(before)
                    or match[0].strip(" ,.;") == "clear"
                    and OF_THE_WAY.search(before)
                ):
                    continue
                found.append(Found(value, (start + match.start(), start + match.end())))
                break
    return found


def weather(plain: str, parts: list[tuple[int, int]]) -> list[Found]:
    """All weather that holds; contradictions are dropped in favour of what is said more strongly."""
    hits = _hits("weather", plain, parts)
    values = {h.value for h in hits}
    if "heavy_rain" in values:
        hits = [h for h in hits if h.value not in ("rain", "wet", "clear", "cloudy")]
    if values & {"rain", "snow", "heavy_rain"}:
        hits = [h for h in hits if h.value not in ("clear", "wet")]
    if values & {"wet"} and "clear" in values and not values & {"rain", "heavy_rain"}:
        hits = [h for h in hits if h.value != "clear"]
    if values & {"cloudy", "fog"}:
        hits = [h for h in hits if h.value != "clear"]
    first: dict[str, Found] = {}
    for hit in hits:
        first.setdefault(hit.value, hit)
    return list(first.values())


def time_of_day(plain: str, parts: list[tuple[int, int]]) -> Found | None:
    """The time of day; the more special word wins (dawn, dusk, night, then day)."""
    hits = _hits("time", plain, parts)
    if not hits:
        return clock(plain)
    always = [m.span() for m in ALWAYS.finditer(plain)]
    hits = [h for h in hits if not any(start <= h.span[0] < end for start, end in always)] or hits
    told, late = [h for h in hits if not EARLIER.search(plain[: h.span[0]])], clock(plain)
    if not told and late is not None:
        return late
    hits = told or hits
    if any(h.value == "night" for h in hits):  # a dark evening
        hits = [h for h in hits if not plain[slice(*h.span)].startswith("evening")]
    elif late is not None and HALF.search(plain[: late.span[1]]) and late.value == "night":
        return late  # "on Wednesday evening at about 9.45 p.m."
    values = [h.value for h in hits]
    if "day" in values and "night" in values:  # "night-time variant of the daytime test": the first that is said
        return min((h for h in hits if h.value in ("day", "night")), key=lambda h: h.span)
    return hits[0]


EARLIER = re.compile(
    r"\b(?:(?:earlier|before|previously)(?: on)?(?: in the| that| this| during the)?"
    r"|previous|next|following|preceding) $"
)
"""What stands before a time that was another: "rain earlier in the evening", "awake since the previous morning"."""


HALF = re.compile(r"[ap]\.?m\.?$")
ALWAYS = re.compile(r"\b(?:by )?day(?:time|light)?(?: (?:and|or|as well as) |/)(?:by |at )?night")
"""What holds at every time: "motorways, day and night"."""
CLOCK = re.compile(
    r"\b(?:(?P<hour>[01]?\d|2[0-3])[:.h](?P<minute>[0-5]\d)(?!\d)(?: ?(?P<half>[ap])\.?m\b)?"
    r"|(?P<hour2>1[0-2]|[1-9]) ?(?P<half2>[ap])\.?m\b|(?P<hour3>[01]\d|2[0-3])[0-5]\d (?:hours"
    r"|hrs|h)\b|\bat (?:about |approx(?:imately|\.)? |around )?(?P<hour4>[01]\d|2[0-3])[0-5]\d(?=,|\.\s|$| on\b))"
)


def clock(plain: str) -> Found | None:
    """The time of day by the clock: night from nine to five, dawn and dusk around six, else day."""
    return next((found for match in CLOCK.finditer(plain) if (found := _time_of(match, plain)) is not None), None)


def _time_of(match: re.Match[str], plain: str) -> Found | None:
    """The time of day by one time of the clock."""
    if re.match(r"\s?(?:m|s|km|ft|g|%)\b", plain[match.end() : match.end() + 4]):
        return None
    if match["hour"] == "0" and not plain[: match.start()].endswith("at "):
        return None  # of a film
    hour = int(match["hour"] or match["hour2"] or match["hour3"] or match["hour4"])
    half = match["half"] or match["half2"]
    hour = hour % 12 + (12 if half == "p" else 0) if half else hour
    if (
        match["hour"]
        and not half
        and not re.search(
            r"(?:at|around|about|approximately|approx\.?|by|was|is|says|said|reads?|shows?|(?:clock|stamp|time) ?:?"
            r"|hours?:?)\s+$",
            plain[max(0, match.start() - 16) : match.start()],
        )
        and not re.match(r"\s?(?:hours|hrs|h|local|on|in the)\b", plain[match.end() : match.end() + 8])
        and (plain[: match.start()].strip() or CLOCK.search(plain, match.end()))
    ):
        return None
    value = "night" if hour >= 21 or hour < 5 else "dawn" if hour < 7 else "dusk" if hour >= 19 else "day"
    return Found(value, match.span())


def _named(plain: str) -> dict[str, Found]:
    """The map, weather preset and blueprint that the text names outright."""
    data = language.table("environment")
    found: dict[str, Found] = {}
    match = re.search(data["maps"], plain)
    if match:
        found["map"] = Found(
            "Town" + match[1].upper() + ("_Opt" if match[2] else ""), match.span()
        )
    match = re.search(data["presets"], plain)
    if match:
        found["preset"] = Found(preset_name(match[1], match[2]), match.span())
    match = re.search(data["blueprint"], plain)
    if match:
        found["blueprint"] = Found(match[0].rstrip("."), match.span())
    return found


def preset_name(sky: str, sun: str) -> str:
    """CARLA's spelling of a weather preset."""
    names: dict[str, Any] = {
        "clear": "Clear",
        "cloudy": "Cloudy",
        "wet": "Wet",
        "wetcloudy": "WetCloudy",
        "softrain": "SoftRain",
        "midrain": "MidRain",
        "midrainy": "MidRainy",
        "hardrain": "HardRain",
    }
    return names.get(sky, sky.capitalize()) + sun.capitalize()


@dataclass(frozen=True)
class Settings:
    """What a text names; None, or nothing, where it does not, or not surely enough."""

    weather: tuple[Found, ...] = ()
    time: Found | None = None
    map: Found | None = None
    preset: Found | None = None
    model: Found | None = None

    def spec(self) -> SettingsSpec:
        """G of it."""
        single = {name: f.value for name in ("time", "map", "preset") if (f := getattr(self, name)) is not None}
        return SettingsSpec.model_validate({"weather": [f.value for f in self.weather], **single})

    def found(self) -> list[tuple[str, str, Found]]:
        """Component, field and find of all that is named."""
        single = (("G", n, getattr(self, n)) for n in ("time", "map", "preset"))
        own = [("E", "model", self.model)] if self.model else []
        return [*(("G", "weather", f) for f in self.weather), *((c, n, f) for c, n, f in single if f), *own]


def detect(text: str) -> Settings:
    """The settings of a text."""
    plain, parts = normalised(text), sentences(text)
    named = _named(plain)
    blueprint = named.get("blueprint")
    if blueprint is not None:
        near = plain[max(0, blueprint.span[0] - 40) : blueprint.span[0]]
        sure = any(word in near for word in ("ego", "host", "model", "subject", "my", "our"))
        blueprint = blueprint if sure else None
    return Settings(
        tuple(weather(plain, parts)), time_of_day(plain, parts), named.get("map"), named.get("preset"), blueprint
    )
