"""Words for a share of those who were told of, without their noun: "the first two turn off, the rest go on"."""

NUMBER = r"(?P<n>two|three|four|five|six|couple|few|[2-6])"
