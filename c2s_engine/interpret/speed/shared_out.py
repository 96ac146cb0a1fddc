"""Values that several are given in order: "ego and the van drive at 50 and 30 km/h (respectively)"."""

import re

IN_ORDER = re.compile(r"\brespective(?:ly)?\b|\bin (?:that|this) order\b")
