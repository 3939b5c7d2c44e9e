#!/usr/bin/env python3
# Makes the scenes, lamps and textures of resources/ from nothing, the same bytes on every run: make_resources.py NAME...
# SPDX-License-Identifier: MIT
# Needs Debian's python3-numpy and python3-pil; what it makes is committed, so a build needs
# neither.
import sys
from pathlib import Path

from make_resources import check, cornell, grids, lamps, ramps, relief, showcase, subsurface

COPYRIGHT = "CC0-1.0, the Facet project"
SCENES = {
    "ball": grids.ball,
    "showcase": showcase.build,
    "spheres": grids.spheres,
    "cornell": cornell.build,
    "furnace": grids.furnace,
    "relief": relief.build,
    "subsurface": subsurface.build,
}


def main(names):
    resources = Path(__file__).resolve().parent.parent / "resources"
    known = [*SCENES, *lamps.LAMPS, *ramps.TEXTURES]
    for name in names or known:
        if name not in known:
            sys.exit(f"make_resources: no {name}; there are {' '.join(known)}")
        if name in lamps.LAMPS:
            target = resources / "lamps" / f"{name}.ies"
            target.write_text(lamps.LAMPS[name]())
            print(target)
            continue
        if name in ramps.TEXTURES:
            target = resources / "textures" / f"{name}.png"
            target.write_bytes(ramps.TEXTURES[name]())
            print(target)
            continue
        data = SCENES[name](COPYRIGHT)
        report = check.check(data)
        target = resources / "scenes" / f"{name}.glb"
        target.write_bytes(data)
        print(f"{target}: {report}")


if __name__ == "__main__":
    main(sys.argv[1:])
