# Lamps by what they do with light, not measured: IES LM-63-2002 files of candela by direction.
# SPDX-License-Identifier: MIT
import math

STEP_DEG = 5  # of the vertical angle


def text(name, what, azimuths_deg, candela):
    """candela(polar, azimuth) in radians, polar 0 straight ahead; for a lamp of 1,000 candela at most."""
    polar = list(range(0, 91, STEP_DEG))
    table = [[candela(math.radians(v), math.radians(h)) for v in polar] for h in azimuths_deg]
    most = max(max(row) for row in table)
    lines = ["IESNA:LM-63-2002", f"[TEST] computed, not measured: {what}", "[MANUFAC] Facet", f"[LUMINAIRE] {name}"]
    lines += ["TILT=NONE", f"1 -1 1 {len(polar)} {len(azimuths_deg)} 1 2 0 0 0", "1 1 0"]
    lines += [" ".join(str(v) for v in polar), " ".join(str(h) for h in azimuths_deg)]
    lines += [" ".join(f"{1000 * max(c, 0) / most:.0f}" for c in row) for row in table]
    return "\n".join(lines) + "\n"


def downlight(v, _):
    """A narrow beam within a wide, weak field, cut off by its ring."""
    ring = max(0.0, 1 - (v / math.radians(60)) ** 6)
    return (math.cos(v) ** 24 + 0.12 * math.cos(v)) * ring


def batwing(v, _):
    """Two wings at 45 degrees: level ground under it is lit evenly far out, as light falls off with cos^3."""
    return min(math.cos(v) ** -3, 2.8) * max(0.0, 1 - (v / math.radians(75)) ** 8)


def wall_washer(v, h):
    """Most of it to one side, azimuth 0, 40 degrees off the axis."""
    aimed = math.radians(40)
    toward = math.cos(v) * math.cos(aimed) + math.sin(v) * math.sin(aimed) * math.cos(h)
    return max(toward, 0.0) ** 6


LAMPS = {
    "downlight": lambda: text("downlight", downlight.__doc__, [0], downlight),
    "batwing": lambda: text("batwing", batwing.__doc__, [0], batwing),
    "wall_washer": lambda: text("wall washer", wall_washer.__doc__, list(range(0, 181, 15)), wall_washer),
}
