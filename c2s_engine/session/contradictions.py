"""Where not all that S requires can be shown: the numbers of the text that contradict one another."""

from collections.abc import AsyncGenerator

from c2s_engine.session.places import map_choice
from c2s_engine.session.solving import Trials
from c2s_engine.session.steps import Tools, silent
from c2s_engine.solve import relaxations
from c2s_engine.structure.components import Structure
from c2s_engine.structure.offers import Offer
from c2s_engine.structure.quantity import in_words


async def contradictions(
    structure: Structure, tools: Tools, *, map_name: str, room: float = 1.0, seed: int = 0
) -> AsyncGenerator[Offer, None]:
    """Each number of the text that alone resolves it, as soon as it is found; none where all that is required is shown.

    Raises MapNotFound."""
    folder = str(map_choice(tools.library, tools.library.find(map_name)).path.parent)
    trials = Trials({"map_name": map_name, "room": room, "seed": seed, "folder": folder}, tools, silent, 0)
    first = await trials.run(structure)
    if first is None or not first.failing:
        return
    async for found in relaxations(first, trials.run, room):
        number = found.said
        said, value = (in_words(number.path, v) for v in (number.value, found.value))
        yield Offer(component=number.component, field=number.path, said=said, value=value, amount=found.value)
