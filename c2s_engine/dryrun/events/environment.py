"""Weather and time of day from a scene's parameters, in the words of FORMAT.md."""

from typing import Any

import carla


def values(weather: Any) -> dict[str, float]:
    """The parameters of a preset's name, of a dictionary, or of CARLA's own object. Unknown presets have none."""
    if isinstance(weather, str):
        weather = getattr(carla.WeatherParameters, weather, None)
    if isinstance(weather, dict):
        weather = carla.WeatherParameters(**{k: v for k, v in weather.items() if isinstance(v, int | float)})
    return {} if weather is None else {k: float(v) for k, v in vars(weather).items()}


def weather_and_time(weather: Any) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """(every weather that holds, every time of day that holds)."""
    v = values(weather)
    if not v:
        return (), ()
    found = []
    if v["cloudiness"] >= 50:
        found.append("cloudy")
    if v["wetness"] >= 30 or v["precipitation_deposits"] >= 30:
        found.append("wet")
    if v["precipitation"] >= 20:
        found.append("rain")
    if v["precipitation"] >= 60:
        found.append("heavy_rain")
    if v["fog_density"] >= 30:
        found.append("fog")
    if v["wind_intensity"] >= 50:
        found.append("wind")
    if v["cloudiness"] < 30 and not found:
        found.append("clear")
    altitude, time = v["sun_altitude_angle"], []
    if altitude < 0:
        time.append("night")
    if -10 <= altitude <= 15:
        time += ["dawn", "dusk"]
    if altitude > 15:
        time.append("day")
    return tuple(found), tuple(time)
