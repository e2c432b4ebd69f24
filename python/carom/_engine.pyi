from typing import Callable, List, Optional, Tuple, TypedDict, Union

__version__: str

_Hex = Tuple[str, str]

class Found(TypedDict):
    exact: Optional[_Hex]
    radical: Optional[str]
    latex: Optional[str]
    lower: Optional[_Hex]
    upper: Optional[_Hex]
    lo: float
    hi: float
    decimal: Optional[str]

Answer = Union[Found, List[Found], List[List[List[Found]]], str, List[str], Tuple[str, str, bool]]

class LimitReached(Exception): ...

class Chain:
    def __new__(
        cls,
        ends: Tuple[str, str],
        e: Optional[Tuple[bool, List[str]]],
        n: Optional[int],
        masses: Optional[List[str]],
        speed: str,
        velocities: Optional[List[str]],
    ) -> Chain: ...
    def count(self) -> Optional[int]: ...
    def is_exact(self) -> bool: ...
    def answer(self, quantity: str, digits: int, rounding: str) -> Answer: ...

class Plan:
    def __new__(cls, want: str, ratio: str, e: Optional[str], n: Optional[str]) -> Plan: ...
    def rows(self) -> int: ...
    def shape(self) -> List[Tuple[str, int]]: ...
    def labels(self, axis: int, start: int, stop: int) -> List[str]: ...
    def fill(self, start: int, stop: int, sink: Callable[[int, bytes, bytes], object]) -> None: ...

def audit(text: Optional[str], file: str, only: List[str], seconds: int) -> str: ...
def language() -> str: ...
def rounded(parts: _Hex, digits: int, direction: str) -> str: ...
def replay(
    scene: str,
    form: str,
    until: Optional[str],
    most: int,
    list: int,
    through_collapse: bool,
    orders: bool,
    digits: Optional[int],
) -> str: ...
def worksheet(
    scene: str,
    form: str,
    which: str,
    title: Optional[str],
    standard: Optional[str],
    digits: int,
    exact: bool,
    letter: bool,
) -> str: ...
def plot(picture: str, ratio: List[str], e: List[str], n: List[int]) -> str: ...
def plot_velocities(scene: str, title: Optional[str]) -> str: ...
def judged(
    written: str, quantity: str, ratio: str, e: Optional[str], n: Optional[int], direction: str
) -> Tuple[bool, str, str]: ...
def export(text: str, language: str) -> str: ...
def check(text: str, certificate: str) -> str: ...
def law_point(text: str, random: List[int]) -> Optional[Tuple[List[Tuple[str, str]], Optional[bool]]]: ...
