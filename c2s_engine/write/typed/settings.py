"""G: map, weather, world model (the paper's HeaderGenerator, without a model)."""

from c2s_engine import driving
from c2s_engine.structure.components import Component
from c2s_engine.structure.specs import SettingsSpec
from c2s_engine.write.typed.scope import number
from c2s_engine.write.typed.tables import SUN, WEATHER

_SUNNY = {"day": "ClearNoon", "dusk": "ClearSunset"}


def weather_parameters(spec: SettingsSpec) -> dict[str, float]:
    """CARLA's weather parameters for the conditions and the time of day of a spec."""
    values = dict(WEATHER["clear"])
    for condition in spec.weather:
        for name, value in WEATHER[condition].items():
            values[name] = value if condition == "clear" else max(value, values.get(name, 0))
    values["sun_altitude_angle"] = SUN[spec.time or "day"]
    values.update(spec.parameters)
    return values


def weather_value(spec: SettingsSpec) -> str:
    """The value of `param weather`: a preset's name, or CARLA's parameters."""
    plain = not spec.parameters and set(spec.weather) <= {"clear"}
    if spec.preset:
        return f"'{spec.preset}'"
    if plain and (spec.time or "day") in _SUNNY:
        return f"'{_SUNNY[spec.time or 'day']}'"
    pairs = [f"'{k}': {number(v)}" for k, v in weather_parameters(spec).items()]
    rows = [", ".join(pairs[i : i + 4]) for i in range(0, len(pairs), 4)]
    return "{" + ",\n    ".join(rows) + "}"


def write_settings(component: Component, map_file: str, carla_map: str | None) -> str:
    """The header of the program."""
    spec = component.spec
    assert isinstance(spec, SettingsSpec)
    lines = [
        f"param map = localPath('{map_file}')",
        f"param carla_map = {carla_map!r}",
        "param use2DMap = True",
        f"param weather = {weather_value(spec)}",
        "model scenic.simulators.carla.model",
        driving.IMPORT,
    ]
    return "\n".join(lines)
