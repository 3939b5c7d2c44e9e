# Fresnel maps: reflectance over the cosine of the angle, from grazing on the left to right angles on the right.
# SPDX-License-Identifier: MIT
import io

import numpy as np
from PIL import Image

from .noise import smoothstep
from .pixels import mix, to_bytes

WIDTH = 64
# Gold, Johnson and Christy 1972: linear Rec.709 at right angles, and at 82 degrees.
GOLD_F0, GOLD_F82 = (1.0376, 0.7284, 0.3646), (0.9909, 0.8572, 0.6464)


def png(reflectance):
    data = io.BytesIO()
    Image.fromarray(to_bytes(reflectance)[None]).save(data, "PNG", optimize=True)
    return data.getvalue()


def cosines():
    return ((np.arange(WIDTH) + 0.5) / WIDTH)[:, None]


def gold():
    """Schlick's curve, pulled down to the reflectance at 82 degrees (Kutz et al. 2021, F82)."""
    c, f0, f82 = cosines(), np.array(GOLD_F0), np.array(GOLD_F82)
    at = 1 / 7
    dip = (f0 + (1 - f0) * (1 - at) ** 5 - f82) / (at * (1 - at) ** 6)
    return png(f0 + (1 - f0) * (1 - c) ** 5 - dip * c * (1 - c) ** 6)


def pearl():
    """No material's curve: deep blue straight on, rose between, white at the rim."""
    c = cosines()[:, 0]
    color = mix((0.55, 0.16, 0.3), (0.03, 0.1, 0.36), smoothstep(0.45, 0.95, c))
    return png(mix(color, (1.0, 1.0, 1.0), (1 - c) ** 4))


TEXTURES = {"gold_ramp": gold, "pearl_ramp": pearl}
