# SPDX-License-Identifier: MIT
"""Entry point of ./run."""

import sys
from pathlib import Path

sys.path[0] = str(Path(__file__).resolve().parent.parent)

from setup.cli import main  # noqa: E402

sys.exit(main(sys.argv[1:]))
