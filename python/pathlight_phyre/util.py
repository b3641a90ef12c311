"""PHYRE's reproducible shuffle."""

from typing import Iterable, List

from pathlight_phyre import _native


def stable_shuffle(strings: Iterable[str], salt: str = "") -> List[str]:
    """Returns texts in an order that depends on nothing but the texts and the salt."""
    return _native.stable_shuffle(list(strings), salt)
