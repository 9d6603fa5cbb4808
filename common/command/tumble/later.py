"""Commands that the course describes and this version does not have."""

from __future__ import annotations

import argparse
from pathlib import Path

from .console import BAD_USAGE, Failure


def run(_root: Path, options: argparse.Namespace) -> int:
    raise Failure(f"'{options.command}' is not part of this version yet", BAD_USAGE)
