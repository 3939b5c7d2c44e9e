#!/usr/bin/env python3
# The commands that lessons print run: commands.py FACET. Pictures are smaller: it is the words that are tried.
# SPDX-License-Identifier: MIT
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

LESSONS = Path(__file__).resolve().parent.parent.parent / "resources" / "lessons"


def commands():
    """{lesson: its command lines} of every ```sh block; a line that was seen in any lesson is left out."""
    seen = {}
    for text in sorted(LESSONS.glob("*/*.md")):
        for block in re.findall(r"```sh\n(.*?)```", text.read_text(), re.S):
            for line in block.splitlines():
                seen.setdefault(line, text.parent.name)
    lessons = {}
    for line, lesson in seen.items():
        lessons.setdefault(lesson, []).append(line)
    return lessons


def smaller(line):
    if not line.startswith("facet render") or "--pixel" in line:
        return line
    if "--size" in line:
        return re.sub(r"--size \d+x\d+", "--size 128x72", line)
    return f"{line} --size 128x72"


def main(facet):
    path = {**os.environ, "PATH": f"{Path(facet).parent}:{os.environ['PATH']}"}
    ran = failed = 0
    for lesson, lines in commands().items():
        # One folder a lesson: a command may use what those before it wrote.
        with tempfile.TemporaryDirectory() as folder:
            for line in lines:
                result = subprocess.run(["sh", "-c", smaller(line)], cwd=folder, env=path, capture_output=True, text=True,
                                        timeout=300)
                ran += 1
                if result.returncode != 0:
                    failed += 1
                    print(f"FAILED: {lesson}: {line}: {result.stderr.strip()}")
    print(f"{ran} commands of the lessons ran, {failed} failures")
    return 1 if failed or not ran else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
