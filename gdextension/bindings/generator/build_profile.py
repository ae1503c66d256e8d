# SPDX-License-Identifier: MIT
"""Command line: python3 -m generator.build_profile surface.json OUT.json

Writes the build profile (GODOTCPP_BUILD_PROFILE) that keeps upstream godot-cpp to the classes of the surface,
which makes its build several times shorter.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path


def main() -> int:
    if len(sys.argv) != 3:
        print(__doc__, file=sys.stderr)
        return 2
    surface = json.loads(Path(sys.argv[1]).read_text(encoding="utf-8"))
    profile = {"enabled_classes": sorted(surface["classes"])}
    Path(sys.argv[2]).write_text(json.dumps(profile, indent=2) + "\n", encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
