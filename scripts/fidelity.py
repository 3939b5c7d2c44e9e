#!/usr/bin/env python3
# Prints how far each --quality is from the reference on every bundled scene, and how long it takes: docs/fidelity.md
# holds the last table. SPDX-License-Identifier: MIT
# fidelity.py [--samples N] [--size WxH]; needs build/facet.
import argparse
import json
import statistics
import subprocess
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
QUALITIES = ["draft", "standard", "final"]
SUN = ["--env", "black", "--light", "directional:azimuth=60,elevation=40,lux=3", "--exposure", "1"]
LIGHTS = {
    "studio": ["--env", "studio", "--no-file-lights"],
    "sky": ["--env", "sky", "--no-file-lights"],
    "sun alone": SUN + ["--no-file-lights"],
    "file's own": ["--env", "black"],
}
SCENES = ["furnace", "spheres", "showcase", "cornell", "ball"]


def run(facet, arguments, ok=(0,)):
    out = subprocess.run([facet, *arguments], capture_output=True, text=True)
    if out.returncode not in ok:
        raise SystemExit(out.stderr)
    return json.loads(out.stdout.splitlines()[0])


def render(options, scene, light, output, more):
    command = ["render", f"builtin:{scene}", "--size", options.size, "--tonemap", "none", "--background", "none"]
    command += ["--depth", "16", "--json", "-q", *LIGHTS[light], *more, "-o", str(output)]
    return run(options.facet, command)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--samples", type=int, default=512)
    parser.add_argument("--size", default="320x180")
    parser.add_argument("--facet", default=str(ROOT / "build" / "facet"))
    options = parser.parse_args()
    print("| scene | light |", " | ".join(f"{q}, RMSE | s" for q in QUALITIES), "| reference's noise | s |")
    print("| --- | --- |", " | ".join("--- | ---" for _ in QUALITIES), "| --- | --- |")
    errors = {quality: [] for quality in QUALITIES}
    with tempfile.TemporaryDirectory() as folder:
        truth, picture = Path(folder) / "truth.png", Path(folder) / "picture.png"
        for scene in SCENES:
            listed = run(options.facet, ["info", f"builtin:{scene}", "--json"])["lights"]
            for light in LIGHTS:
                if light == "file's own" and not listed:
                    continue
                exposure = render(options, scene, light, picture, [])["exposure"]
                fixed = [] if "--exposure" in LIGHTS[light] else ["--exposure", repr(exposure)]
                reference = render(options, scene, light, truth, [*fixed, "--reference", str(options.samples)])
                cells = []
                for quality in QUALITIES:
                    drawn = render(options, scene, light, picture, [*fixed, "--quality", quality])
                    rmse = run(options.facet, ["diff", str(truth), str(picture), "--mask", "--json"])["rmse"]
                    errors[quality].append(rmse)
                    cells.append(f"{rmse:.4f} | {drawn['ms']['render'] / 1000:.2f}")
                report = reference["reference"]
                print(f"| {scene} | {light} |", " | ".join(cells), f"| {report['noise']:.4f} | {report['trace_s']:.1f} |", flush=True)
    print("| median | |", " | ".join(f"{statistics.median(errors[q]):.4f} | " for q in QUALITIES), "| | |")


if __name__ == "__main__":
    main()
