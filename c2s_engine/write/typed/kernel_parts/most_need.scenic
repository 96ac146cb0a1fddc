def most_need(car, others):
    """The greatest `need` of all of them."""
    return max([0, *[need(car, other) for other in others]])
