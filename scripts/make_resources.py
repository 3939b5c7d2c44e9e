#!/usr/bin/env python3
# Makes resources/scenes/*.glb from nothing, the same bytes on every run: make_resources.py NAME...
# SPDX-License-Identifier: MIT
# Needs Debian's python3-numpy and python3-pil; what it makes is committed, so a build needs
# neither.
import sys
from pathlib import Path

from make_resources import check, cornell, grids, showcase

COPYRIGHT = "CC0-1.0, the Facet project"
SCENES = {
    "ball": grids.ball,
    "showcase": showcase.build,
    "spheres": grids.spheres,
    "cornell": cornell.build,
    "furnace": grids.furnace,
}


def main(names):
    folder = Path(__file__).resolve().parent.parent / "resources" / "scenes"
    folder.mkdir(parents=True, exist_ok=True)
    for name in names or SCENES:
        if name not in SCENES:
            sys.exit(f"make_resources: no scene {name}; there are {' '.join(SCENES)}")
        data = SCENES[name](COPYRIGHT)
        report = check.check(data)
        target = folder / f"{name}.glb"
        target.write_bytes(data)
        print(f"{target}: {report}")


if __name__ == "__main__":
    main(sys.argv[1:])
