"""Domains and feature spaces from which values are drawn."""

import itertools
import random
from collections import namedtuple


class Box:
    """A product of intervals; a value is a tuple."""

    def __init__(self, *intervals):
        self.intervals = tuple((float(low), float(high)) for low, high in intervals)

    def draw(self):
        return tuple(random.uniform(low, high) for low, high in self.intervals)


class DiscreteBox:
    """A product of integer ranges, both ends included."""

    def __init__(self, *intervals):
        self.intervals = tuple((int(low), int(high)) for low, high in intervals)

    def draw(self):
        return tuple(random.randint(low, high) for low, high in self.intervals)

    def __iter__(self):
        return itertools.product(*(range(low, high + 1) for low, high in self.intervals))


class Feature:
    """A domain under a name."""

    def __init__(self, domain, **_):
        self.domain = domain


class FeatureSpace:
    """Named features; a point is a named tuple."""

    def __init__(self, features, **_):
        self.features = dict(features)
        self.makePoint = namedtuple("SpacePoint", self.features)

    def draw(self):
        return self.makePoint(**{name: feature.domain.draw() for name, feature in self.features.items()})
