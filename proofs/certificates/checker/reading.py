"""From the text of a claim file to the statements of its claims: section 14 of docs/certificates.md."""
from . import abbreviations, angles, floors, limits
from .author import Author, SHARED
from .claims import Claim, need, need_new_names, NotCovered, PI, Refused
from .making import need_constants
from .preamble import free_of_claim, need_one_pi, Preamble
from .recurrences import need_values
from .walk import Fresh

TOO_LARGE = (RecursionError, MemoryError, OverflowError)


class File:
    """A claim file, under the preamble that the file `folder` holds. Each claim is read when it is asked for."""

    def __init__(self, source, folder=None):
        author = self.author = Author(source)
        self.fault, self.preamble = (folder.fault, folder.preamble) if folder else (None, Preamble())
        places = [k for k, (_, text, first) in enumerate(author.tokens) if first and text == "claim"]
        self.places = {author.tokens[k + 1][1]: k for k in places}
        need(len(self.places) == len(places), "two claims of a file have the same name")
        try:
            self.preamble = preamble(author, self.preamble)
        except (Refused, *TOO_LARGE) as fault:
            self.fault = self.fault or f"its preamble is not read: {fault}"

    def claim(self, name):
        """The statement of a claim. NotCovered where it is not read, Refused where the page does not let it be written out."""
        author = self.author
        if self.fault:
            raise NotCovered(self.fault)
        author.at_token, author.declared, author.integer = self.places[name], set(self.preamble.names), False
        try:
            written = author.claim()
        except Refused as refused:
            raise NotCovered(f"it is not read: {refused}")
        except TOO_LARGE as fault:
            raise NotCovered(f"it is too large: {fault!r}")
        try:
            return statement(written, self.preamble)
        except TOO_LARGE as fault:
            raise NotCovered(f"it is too large: {fault!r}")


def preamble(author, folder):
    """The preamble of a folder, and behind it the clauses before the first claim."""
    items, author.declared = [], set(folder.names)
    while author.at_clause() and author.at(*SHARED):
        word = author.kind("word")
        if word in ("given", "let", "define", "assume"):
            items += author.item(word)
        else:
            author.skip()
        need(author.at_clause(), "expected the end of the clause")
    need_one_pi([*folder.items, *items])
    return Preamble((*folder.items, *items))


def statement(written, shared):
    """Writes a claim out, in the order of the page."""
    shared.put_before(written)
    need(free_of_claim(written) <= {PI}, "a name is not declared")
    need_one_pi(written.items, [written.goal, *written.argument])
    need_values(written.items)
    fresh = Fresh(written)
    written.items = [new for item in written.items for new in integer(item, fresh)]
    for step in (angles, limits, floors, abbreviations):
        step.write_out(written, fresh)
    need_new_names(written.items, written.goal)
    claim = Claim(written.name, written.using, written.items, written.goal)
    need_constants(written, claim)
    return claim


def integer(item, fresh):
    return floors.whole(item[1], fresh) if item[0] == "integer" else [item]
