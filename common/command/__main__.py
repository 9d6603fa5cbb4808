"""Starts the command: python3 common/command test 1."""

import sys

if sys.version_info < (3, 9):
    sys.exit("tumble: python3 is older than 3.9: install a newer one, then type the same again")

from tumble.arguments import main  # noqa: E402 (an older Python could not read it)

sys.exit(main(sys.argv[1:]))
