"""PHYRE's reproducible shuffle."""

from typing import Iterable, List

from pathlight_phyre import _native


def stable_shuffle(strings: Iterable[str], salt: str = "") -> List[str]:
    """Shuffles texts in an order that depends only on the texts and the salt."""
    return _native.stable_shuffle(list(strings), salt)
