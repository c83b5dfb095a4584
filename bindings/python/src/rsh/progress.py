"""Bars for long work, by tqdm. Where it is not installed, or stderr is no terminal, there are none."""

from collections.abc import Iterable
from typing import Any, TypeVar

Item = TypeVar("Item")


def watched(items: Iterable[Item], text: str) -> Iterable[Item]:
    """Go through items, such as frames, behind a bar.

    Parameters
    ----------
    items : iterable
    text : str
        What they are.

    Returns
    -------
    iterable
        The same items.
    """
    bar = _tqdm()
    return items if bar is None else bar(items, desc=text, leave=False, disable=None)


class Bar:
    """A callable for `progress=` of rsh.prepare, rsh.traverse and the like, which draws a bar.

    The call is made in a `with` statement; the bar disappears at its end.

    Parameters
    ----------
    text : str
        What is done.
    """

    def __init__(self, text: str) -> None:
        bar = _tqdm()
        self._bar = None if bar is None else bar(desc=text, leave=False, disable=None)

    def __enter__(self) -> "Bar":
        """Return the bar."""
        return self

    def __exit__(self, *_: object) -> None:
        """Take it off the terminal."""
        if self._bar is not None:
            self._bar.close()

    def __call__(self, done: int, count: int) -> None:
        """Draw how many are done of `count`; 0: nobody knows."""
        if self._bar is not None:
            self._bar.n, self._bar.total = done, count or None
            self._bar.refresh()


def _tqdm() -> Any:
    try:
        from tqdm import tqdm
    except ImportError:
        return None
    return tqdm
