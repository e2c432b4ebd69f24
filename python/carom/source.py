"""Texts that functions read: given as such, or as the name of a file."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Optional, Tuple, Union

Text = Union[str, "os.PathLike[str]"]
"""A text, or a file that holds it: a :class:`pathlib.Path`, or a name of one line with the right ending."""


@dataclass(frozen=True)
class Source:
    """A text, and the file that it was read from."""

    text: str
    path: Optional[str]


def claims_of(text: Text) -> Source:
    """The claims of a text or a file. A text without a head, `claim NAME "Title"`, is one claim called `law`."""
    found = source_of(text, ".claim")
    words = {line.split(None, 1)[0] for line in found.text.splitlines() if line.strip()}
    if "claim" in words or "prove" not in words:
        return found
    return Source(f'claim law ""\n{found.text}\n', found.path)


PAPERS = (".tex", ".ltx", ".md", ".markdown")
"""Endings of the names of papers."""


def is_paper(text: Text) -> bool:
    """Whether this is the name of a paper's file."""
    return _is_name(os.fspath(text), PAPERS)


def _is_name(text: str, endings: Tuple[str, ...]) -> bool:
    """Whether a text is the name of a file: one line with such an ending."""
    return "\n" not in text and text.endswith(endings)


def source_of(text: Text, *endings: str) -> Source:
    """The text itself, or that of the file; a file that cannot be read is an :class:`OSError`."""
    if isinstance(text, str) and not _is_name(text, endings):
        return Source(text, None)
    path = os.fspath(text)
    with open(path, encoding="utf-8-sig") as file:
        try:
            return Source(file.read(), path)
        except UnicodeDecodeError:
            raise ValueError(f"{path}: this is not UTF-8 text") from None
