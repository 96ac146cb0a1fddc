"""The settings detector for G: map, weather and ego model, each with a confidence (accepted from 0.6 on)."""

from dataclasses import dataclass

from c2s_engine.interpret.surroundings import environment
from c2s_engine.interpret.surroundings.environment import Found

ACCEPTED = 0.6
DEFAULTS = {"map": "Town05", "weather": "ClearNoon", "ego_model": "vehicle.lincoln.mkz_2017"}


@dataclass(frozen=True)
class Settings:
    """What the detector found; a value below the threshold gives way to the default."""

    map: Found | None
    weather: tuple[Found, ...]
    time: Found | None
    preset: Found | None
    ego_model: Found | None

    def confidences(self) -> dict[str, float]:
        """The confidence of each setting (0 where the text says nothing of it)."""
        sky = max([f.confidence for f in (*self.weather, *filter(None, (self.time, self.preset)))], default=0.0)
        return {
            "map": self.map.confidence if self.map else 0.0,
            "weather": sky,
            "ego_model": self.ego_model.confidence if self.ego_model else 0.0,
        }


class SettingsDetector:
    """Finds the global settings that a text names."""

    def detect(self, plain: str, sentences: list[tuple[int, int]]) -> Settings:
        """The settings of a normalised text."""
        named = environment.named(plain)
        blueprint = named.get("blueprint")
        if blueprint is not None:
            near = plain[max(0, blueprint.span[0] - 40) : blueprint.span[0]]
            sure = 0.95 if any(w in near for w in ("ego", "host", "model", "subject", "my", "our")) else 0.55
            blueprint = Found(blueprint.value, sure, blueprint.span)
        return Settings(
            named.get("map"),
            tuple(environment.weather(plain, sentences)),
            environment.time_of_day(plain, sentences),
            named.get("preset"),
            blueprint,
        )
