#!/usr/bin/env python3
# Prints how far the rasteriser is from the reference on every bundled scene: docs/fidelity.md holds the last table.
# SPDX-License-Identifier: MIT
# fidelity.py [--samples N] [--size WxH] [--markdown]; needs build/facet.
import argparse
import json
import subprocess
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
# Half of each object is black then, which automatic exposure would make up for.
SUN = ["--env", "black", "--light", "directional:azimuth=60,elevation=40,lux=3", "--exposure", "1"]
LIGHTS = {
    "studio": ["--env", "studio", "--no-file-lights"],
    "sky": ["--env", "sky", "--no-file-lights"],
    "sun alone": SUN + ["--no-file-lights"],
    "file's own": ["--env", "black"],
}
SCENES = ["furnace", "spheres", "showcase", "cornell"]


def has_lights(facet, scene):
    out = subprocess.run([facet, "info", f"builtin:{scene}", "--json"], check=True, capture_output=True, text=True)
    return bool(json.loads(out.stdout.splitlines()[0]).get("lights"))


def compare(facet, scene, light, options, folder):
    command = [facet, "render", f"builtin:{scene}", "--compare", "--reference", str(options.samples)]
    command += ["--size", options.size, "--tonemap", "none", "--quality", "final", "--json", "-q"]
    command += LIGHTS[light] + ["-o", str(Path(folder) / "compare.png")]
    out = subprocess.run(command, check=True, capture_output=True, text=True)
    return json.loads(out.stdout.splitlines()[0])


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--samples", type=int, default=128)
    parser.add_argument("--size", default="480x270")
    parser.add_argument("--facet", default=str(ROOT / "build" / "facet"))
    options = parser.parse_args()
    print("| scene | light | RMSE | FLIP | noise of the reference | reference, s |")
    print("| --- | --- | --- | --- | --- | --- |")
    with tempfile.TemporaryDirectory() as folder:
        for scene in SCENES:
            for light in LIGHTS:
                if light == "file's own" and not has_lights(options.facet, scene):
                    continue
                r = compare(options.facet, scene, light, options, folder)
                c, t = r["compared"], r["reference"]
                print(
                    f"| {scene} | {light} | {c['rmse']:.4f} | {c['flip']:.4f} |"
                    f" {t['noise']:.4f} | {t['trace_s']:.1f} |",
                    flush=True,
                )


if __name__ == "__main__":
    main()
