"""Which names a fragment of Scenic defines and which it reads, without Scenic (the front does not import it).

Scenic's tokens are Python's, so the standard tokenizer finds the names; definitions are what stands at the left margin.
"""

import io
import keyword
import re
import tokenize

_DEFINITION = re.compile(r"^(?P<kind>behavior|monitor|scenario|class|def)\s+(?P<name>\w+)")
_ASSIGNMENT = re.compile(r"^(?P<name>[A-Za-z_]\w*)\s*(?::[^=]+)?=(?!=)")
_HEAD = re.compile(
    r"^[ \t]*(?P<kind>behavior|monitor|scenario|def)\s+\w+\s*\((?P<listed>[^()]*(?:\([^()]*\)[^()]*)*)\)", re.M
)
_PARAM = re.compile(r"^param\s+(?P<names>.+)")


def defines(code: str) -> dict[str, str]:
    """The names that a fragment defines at top level, each with its kind (value, behavior, class, def, monitor)."""
    found: dict[str, str] = {}
    for line in code.splitlines():
        if match := _DEFINITION.match(line):
            found[match["name"]] = match["kind"]
        elif match := _ASSIGNMENT.match(line):
            found.setdefault(match["name"], "value")
        elif match := _PARAM.match(line):
            for name in re.findall(r"(\w+)\s*=", match["names"]):
                found[f"param {name}"] = "param"
    return found


def uses(code: str) -> frozenset[str]:
    """Every name that occurs in a fragment, other than keywords and what follows a dot."""
    names: set[str] = set()
    previous = ""
    try:
        for token in tokenize.generate_tokens(io.StringIO(code).readline):
            if token.type == tokenize.NAME and previous != "." and not keyword.iskeyword(token.string):
                names.add(token.string)
            previous = token.string
    except (tokenize.TokenError, SyntaxError, IndentationError):
        names.update(re.findall(r"(?<!\.)\b[A-Za-z_]\w*", code))
    return frozenset(names)


def renamed(code: str, called: dict[str, str]) -> str:
    """The code in which names are others: not attributes, names of arguments, comments or strings, nor what a
    definition has a parameter of that name for."""
    if not called:
        return code
    try:
        tokens = list(tokenize.generate_tokens(io.StringIO(code).readline))
    except (tokenize.TokenError, SyntaxError, IndentationError):
        return code
    lines, own, found, depth = code.splitlines(keepends=True), _parameters(code), [], 0
    for before, token, after in zip([tokens[0], *tokens], tokens, [*tokens[1:], tokens[-1]], strict=False):
        depth += (token.string in "([{") - (token.string in ")]}") if token.type == tokenize.OP else 0
        argument = before.string == "." or depth > 0 and after.string == "="
        if token.type == tokenize.NAME and token.string in called and not argument:
            found.append(token)
    for token in reversed(found):
        row, (start, end) = token.start[0] - 1, (token.start[1], token.end[1])
        if token.string not in own[row]:
            lines[row] = lines[row][:start] + called[token.string] + lines[row][end:]
    return "".join(lines)


def _parameters(code: str) -> list[frozenset[str]]:
    """By line, the parameters of the definition that it is in."""
    found, own = [], frozenset[str]()
    heads = {code.count("\n", 0, m.start("kind")): m["listed"] for m in _HEAD.finditer(code)}
    for row, line in enumerate(code.splitlines()):
        if row in heads:
            own = frozenset(re.findall(r"(?:^|,)[\s*]*(\w+)", heads[row]))
        elif line[:1] not in (*" \t#)]}", ""):
            own = frozenset()
        found.append(own)
    return found
