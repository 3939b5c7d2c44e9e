#!/usr/bin/env python3
# Draws docs/materials.png, a ball of every preset of resources/materials: materials_sheet.py [--facet build/facet] (two minutes;
# needs python3-pil).
# SPDX-License-Identifier: MIT
import argparse
import json
import subprocess
import tempfile
from pathlib import Path

from PIL import Image, ImageDraw

ROOT = Path(__file__).resolve().parent.parent
ACROSS, SIDE_PX, LABEL_PX = 8, 150, 18


def main():
    parser = argparse.ArgumentParser(description="A contact sheet of the material presets.")
    parser.add_argument("--facet", default=str(ROOT / "build" / "facet"))
    options = parser.parse_args()
    presets = sorted((ROOT / "resources" / "materials").glob("*.json"))
    down = (len(presets) + ACROSS - 1) // ACROSS
    sheet = Image.new("RGB", (ACROSS * SIDE_PX, down * (SIDE_PX + LABEL_PX)), (58, 58, 58))
    draw = ImageDraw.Draw(sheet)
    with tempfile.TemporaryDirectory() as folder:
        for i, preset in enumerate(presets):
            picture = Path(folder) / f"{preset.stem}.png"
            subprocess.run([options.facet, "render", "builtin:ball", "--material", f"ball={preset.stem}", "--size",
                            f"{SIDE_PX}x{SIDE_PX}", "--quality", "final", "--exposure", "1", "--background", "#3a3a3a", "-q",
                            "-o", str(picture)], check=True)
            x, y = i % ACROSS * SIDE_PX, i // ACROSS * (SIDE_PX + LABEL_PX)
            sheet.paste(Image.open(picture).convert("RGB"), (x, y))
            name = json.loads(preset.read_text())["name"]
            draw.text((x + (SIDE_PX - draw.textlength(name)) // 2, y + SIDE_PX + 2), name, fill=(220, 220, 220))
    sheet.save(ROOT / "docs" / "materials.png", optimize=True)


if __name__ == "__main__":
    main()
