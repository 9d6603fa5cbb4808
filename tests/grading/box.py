"""The sandbox for a test, which is skipped where this machine has none."""

import unittest

from tumble.console import Failure
from tumble.grading.sandbox import Sandbox


def box_or_skip() -> Sandbox:
    try:
        return Sandbox.find(allow_none=False)
    except Failure as failure:
        raise unittest.SkipTest(str(failure)) from failure
