"""The choice of a sampler: all names give the uniform one."""

NAMES = ("random", "halton", "ce", "eg", "mab", "bo", "sa", "grid", "batch")


class UniformSampler:
    """Draws each point anew; feedback has no effect."""

    def __init__(self, space):
        self.space = space

    def getSample(self):
        return self.space.draw(), None

    def nextSample(self, feedback=None):
        return self.space.draw()

    def update(self, sample, info, rho):
        pass


def choose_sampler(space, sampler_type="random", sampler_params=None, **_):
    """(feature space, sampler), or None for an unknown name."""
    return (space, UniformSampler(space)) if sampler_type in NAMES else None
