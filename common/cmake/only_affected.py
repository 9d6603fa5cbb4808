"""Of answers with a mistake keeps what the mistake can reach; the rest comes from the right answer.

A mistake is an edit of the right answer, of a line or two. To compile all of the answer for it is
most of what the proof of the kit would take. So only these are kept: the functions that the edit is
in; if it is in a helper, those that name the helper, over any number of steps; and the helpers that
all of these need. The program is linked with the right answer, too, whose functions give way to
those of the same name (objcopy --weaken). Position-independent code calls a function of the
contract by its name, so the right answer's other functions call the wrong one. An edit outside of a
function, as of a constant, keeps the whole file.
"""

import re
from typing import NamedTuple, Sequence

_STRING = re.compile(r'"(?:[^"\\]|\\.)*"|\'(?:[^\'\\]|\\.)*\'')
_NOT_FUNCTIONS = re.compile(r"(?:template <.*?>\s*)?(?:struct|class|enum|union|using|static_assert|#)")
_NAME = re.compile(r"(\w+)\s*\(")


class Part(NamedTuple):
    """A function with the comment above it, or the text between functions, whose name is empty."""

    text: str
    name: str
    is_helper: bool
    """May be compiled into its callers: it is in an unnamed namespace, or a template, or inline."""


def parts(text: str) -> list[Part]:
    found: list[Part] = []
    pending: list[str] = []
    depth = 0
    is_helper = False
    for line in text.splitlines(keepends=True):
        code = _STRING.sub("", line).split("//")[0].strip()
        if depth == 0 and re.match(r"namespace\b|}", code):
            found.append(Part("".join([*pending, line]), "", False))
            pending = []
            is_helper = code == "namespace {"
            continue
        pending.append(line)
        depth += code.count("{") - code.count("}")
        if depth == 0 and code.endswith((";", "}")):
            found.append(_part("".join(pending), is_helper))
            pending = []
    return [*found, Part("".join(pending), "", False)]


def _part(text: str, is_helper: bool) -> Part:
    code = re.sub(r"//[^\n]*|\[\[[^]]*\]\]", "", text).strip()
    head = re.sub(r"^template <[^{]*?>\n", "", code.split("{")[0])
    name = _NAME.search(head)
    is_function = (code.endswith("}") and name and "=" not in head[:name.start()]
                   and not _NOT_FUNCTIONS.match(code))
    is_helper = is_helper or re.match(r"template|inline|constexpr", code) is not None
    return Part(text, name.group(1) if is_function and name else "", is_helper)


def only_affected(right: str, wrong: str) -> str:
    after = parts(wrong)
    changed = set(parts(right)) ^ set(after)
    helpers = {part.name for part in after if part.is_helper}
    affected = _closure({part.name for part in changed}, helpers, after)
    if "" in affected:
        return wrong
    kept = set(affected)
    needed = [part for part in after if not part.name or part.name in kept]
    while needed:
        words = set().union(*(_words(part.text) for part in needed))
        new = (words & helpers) - kept
        kept |= new
        needed = [part for part in after if part.name in new]
    return "".join(part.text for part in after if not part.name or part.name in kept)


def _closure(names: set[str], helpers: set[str], all_parts: Sequence[Part]) -> set[str]:
    """The names, and those of all parts that name a helper of them; "" for text between functions."""
    while True:
        more = {part.name for part in all_parts if _words(part.text) & names & helpers} | names
        if more == names or "" in more:
            return more
        names = more


def _words(text: str) -> set[str]:
    return set(re.findall(r"\w+", re.sub(r"//[^\n]*|^(?:namespace|#)[^\n]*", "", text, flags=re.M)))
