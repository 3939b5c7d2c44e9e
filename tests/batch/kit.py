"""What the batch tests share: jobs to render, and what became of them."""
# SPDX-License-Identifier: MIT
import hashlib
import json
import subprocess
from pathlib import Path


def write_job(folder, item_count, size=(128, 96)):
    """A job of `item_count` small pictures of three scenes, one of them wrong, in `folder`; its file."""
    folder.mkdir(parents=True, exist_ok=True)
    per_scene = -(-item_count // 4)
    job = {
        "facet": 1,
        "output": "out/{scene}/{index:05}.png",
        "defaults": {"size": list(size), "samples": 4, "shadows": "off", "env": "overcast"},
        "items": [
            {"scene": scene, "set": {"material.*.roughness": {"random": [0.1, 1], "count": count, "seed": 5}}}
            for scene, count in [
                ("builtin:ball", per_scene),
                ("builtin:spheres", per_scene),
                ("builtin:furnace", item_count - 2 * per_scene),
            ]
        ],
    }
    path = folder / "job.json"
    path.write_text(json.dumps(job))
    return path


def run(facet, *arguments, code=None, **options):
    """The finished process; `code`: what it has to end with."""
    done = subprocess.run([str(facet), *map(str, arguments)], capture_output=True, text=True, timeout=900, **options)
    if code is not None and done.returncode != code:
        raise SystemExit(f"facet {' '.join(map(str, arguments))}\nended with {done.returncode}, not {code}\n"
                         f"{done.stdout[-2000:]}\n{done.stderr[-2000:]}")
    return done


def sums(folder):
    """SHA-256 by path of every file below the output folder, temporary ones too."""
    return {
        str(path.relative_to(folder)): hashlib.sha256(path.read_bytes()).hexdigest()
        for path in sorted(Path(folder).rglob("*"))
        if path.is_file()
    }


def results(job):
    """The items' lines of every results file beside the job."""
    out = []
    for path in sorted(job.with_suffix(".facet").glob("results-*.jsonl")):
        lines = path.read_text().split("\n")
        out += [json.loads(line) for line in lines[1:-1]]  # what a crash tore is no line
    return out


def check(condition, message):
    if not condition:
        raise SystemExit(f"failed: {message}")
