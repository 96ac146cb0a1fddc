"""The examples to start from: each runs and shows what it is an example of."""

import pytest

from c2s_engine.session.gallery import gallery
from c2s_engine.structure.progress import Finished


def test_there_are_ten_of_different_kinds():
    assert len(gallery()) == 10
    assert len({e.about.split(":")[0] for e in gallery().values()}) == 10


@pytest.mark.full(one_of=3)
@pytest.mark.parametrize("name", list(gallery()))
async def test_each_runs_and_shows_what_it_is_an_example_of(engine, name):
    done = None
    async for event in engine.generate(gallery()[name].text):
        done = event if isinstance(event, Finished) else done
    assert done is not None and done.ok and done.facts[0].ran
    who, wanted = gallery()[name].shows
    shown = {(o.component, e.event) for o in done.facts[0].objects for e in o.events}
    assert (who, wanted) in shown, sorted(shown)
    assert not [u for c in done.structure.components for u in c.unmet], "nothing of its text is lost"
    collided = bool(done.facts[0].contacts)
    assert collided == (wanted == "hits")
