"""Who rides what, told by "of", by "on" or behind the verb; animals and bicycles that somebody on foot takes along."""


def test_a_dog_that_breaks_free_goes_alone(read) -> None:
    woman, dog = read("A woman walks her dog on the right pavement. It runs across the road.").objects
    assert [p.action for p in dog.spec.phases] == ["cross_road"]
