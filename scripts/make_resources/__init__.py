# The generator of resources/scenes: geometry, textures and baked occlusion, all computed here.
# SPDX-License-Identifier: MIT
