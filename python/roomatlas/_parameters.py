# SPDX-License-Identifier: GPL-3.0-or-later
"""Keyword arguments as the parameters of the command line."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Optional

from ._core import UsageError

#: Told the stage's name and its share in [0, 1], or None where that is unknown.
Progress = Optional[Callable[[str, Optional[float]], Any]]


def as_toml(parameters: dict[str, Any]) -> str:
    """A line each, `max_range=8` as `max-range=8`."""
    return "".join(
        f"{name.replace('_', '-')}={_value(name, value)}\n" for name, value in parameters.items())


def _value(name: str, value: Any) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, str) and '"' not in value and "\n" not in value:
        return f'"{value}"'
    raise UsageError(f"{name}: expected a number, a text or a bool, found {value!r}")
