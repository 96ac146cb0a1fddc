"""Parties that a text gives a code of its own and then tells of by it ("01 = lorry, ... 02 = car, ...", "T2: car, right
lane behind T1", "c1, c2: southbound cars"): the codes are read as labels, and the lines of a comment as lines."""

import re

COMMENT = re.compile(r"(?P<before>\S?)(?:^|(?<=\s))\s*(?:#|//)[ \t]+(?=(?:the )?[\w][\w -]{0,16}(?:, ?[\w -]{1,8})*: )")
