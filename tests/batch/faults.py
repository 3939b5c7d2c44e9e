"""Bad weather for facet batch: processes killed, disks full, folders read-only; nothing may be lost or half-written.

    faults.py FACET [--items N] [--kills K] [--seed S]

Renders a job undisturbed, then again while workers and the parent are killed at random moments, signals ask it to end,
its folder turns read-only and its disk is full; runs it until it is done, and compares every byte."""
# SPDX-License-Identifier: MIT
import argparse
import os
import random
import shutil
import signal
import subprocess
import tempfile
import time
from pathlib import Path

from kit import check, results, run, sums, write_job


def workers_of(pid):
    try:
        return [int(child) for child in Path(f"/proc/{pid}/task/{pid}/children").read_text().split()]
    except OSError:
        return []


def count_done(job):
    return len({line["output"] for line in results(job) if line["status"] == "done"})


def disturb(facet, job, chance, step, kind):
    """One run of the job that something happens to; its exit status."""
    process = subprocess.Popen([facet, "batch", job, "--jobs", "2", "-q", "--retries", "3"], stdout=subprocess.DEVNULL,
                               stderr=subprocess.PIPE, text=True)
    # Moments are counted in what is done, so that they fall into the work on any machine.
    goal = count_done(job) + chance.randrange(1, max(2, step))
    while process.poll() is None and count_done(job) < goal:
        time.sleep(0.01)
    time.sleep(chance.random() * 0.05)
    if process.poll() is None:
        if kind == "worker":
            for worker in workers_of(process.pid)[: chance.randrange(1, 3)]:
                os.kill(worker, chance.choice([signal.SIGKILL, signal.SIGSEGV]))
            # It goes on; told to end a little later.
            time.sleep(0.3)
            process.terminate()
        elif kind == "parent":
            orphans = workers_of(process.pid)
            process.kill()
            process.wait()
            deadline = time.time() + 5
            while any(Path(f"/proc/{pid}").exists() and "Z" not in state(pid) for pid in orphans):
                check(time.time() < deadline, "workers outlive their parent")
                time.sleep(0.02)
        else:
            process.send_signal({"term": signal.SIGTERM, "int": signal.SIGINT, "hup": signal.SIGHUP}[kind])
            start = time.time()
            process.wait()
            check(time.time() - start < 10, f"{kind} is answered in time")
    _, said = process.communicate()
    # Before the first item and after the last a signal ends it as it ends any program: a shell sees the same status.
    allowed = {"worker": (0, 143, -15), "parent": (0, -9), "term": (0, 143, -15), "hup": (0, 143, -1), "int": (0, 130, -2)}[kind]
    check(process.returncode in allowed, f"{kind}: status {process.returncode}: {said}")


def state(pid):
    try:
        return Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0]
    except OSError:
        return "Z"


def full_disk(facet, job):
    """The job on a file system of 400 kB: what does not fit fails with 75, and nothing is half-written."""
    folder = job.parent / "tiny"
    folder.mkdir()
    if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=400k", "none", folder], stderr=subprocess.DEVNULL).returncode:
        print("no mount here: the full disk is left out")
        return
    try:
        shutil.copy(job, folder / "job.json")
        done = run(facet, "batch", folder / "job.json", "--jobs", "2", "--retries", "0")
        check(done.returncode in (1, 75), f"a full disk ends with {done.returncode}: {done.stderr[-500:]}")
        check("Traceback" not in done.stderr, "no trace")
        # Every picture that is there is whole: a second run takes none of them back.
        for line in results(folder / "job.json"):
            if line["status"] == "failed":
                check(line["code"] == 75, f"a full disk is temporary: {line}")
        left = [path for path in sums(folder / "out") if path.endswith(".tmp")]
        check(not left, f"temporary files stay: {left}")
        subprocess.run(["mount", "-o", "remount,size=64m", folder], check=True)
        run(facet, "batch", folder / "job.json", "--jobs", "2", "-q", code=0)
        check(sums(folder / "out") == sums(job.parent / "whole" / "out"), "bytes after a full disk")
    finally:
        subprocess.run(["umount", folder], check=False)


def file_size_limit(facet, job):
    """A limit on the size of files stands for a full disk where nothing can be mounted."""
    folder = job.parent / "limited"
    folder.mkdir()
    shutil.copy(job, folder / "job.json")
    done = subprocess.run(["bash", "-c", 'ulimit -f 8; exec "$0" batch "$1" --jobs 2 --retries 0 -q', facet, folder / "job.json"],
                          capture_output=True, text=True, timeout=600)
    check(done.returncode in (1, 75), f"a limit of file sizes ends with {done.returncode}: {done.stderr[-500:]}")
    run(facet, "batch", folder / "job.json", "--jobs", "2", "-q", code=0)
    check(sums(folder / "out") == sums(job.parent / "whole" / "out"), "bytes after a limit of file sizes")


def read_only(facet, job):
    folder = job.parent / "fixed"
    folder.mkdir()
    shutil.copy(job, folder / "job.json")
    if subprocess.run(["mount", "--bind", folder, folder], stderr=subprocess.DEVNULL).returncode:
        print("no mount here: the read-only folder is left out")
        return
    try:
        subprocess.run(["mount", "-o", "remount,bind,ro", folder], check=True)
        done = run(facet, "batch", folder / "job.json", code=3)
        check(done.stderr.count("\n") == 1 and "cannot" in done.stderr, f"one line: {done.stderr}")
        subprocess.run(["mount", "-o", "remount,bind,rw", folder], check=True)
        run(facet, "batch", folder / "job.json", "-q", code=0)
    finally:
        subprocess.run(["umount", folder], check=False)
    check(sums(folder / "out") == sums(job.parent / "whole" / "out"), "bytes after a read-only folder")


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("facet")
    arguments.add_argument("--items", type=int, default=1000)
    arguments.add_argument("--kills", type=int, default=50)
    arguments.add_argument("--seed", type=int, default=1)
    options = arguments.parse_args()
    chance = random.Random(options.seed)
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        whole = write_job(folder / "whole", options.items)
        run(options.facet, "batch", whole, "-q", code=0)
        truth = sums(whole.parent / "out")
        check(len(truth) == options.items, f"{len(truth)} pictures")
        job = write_job(folder / "broken", options.items)
        for number in range(options.kills):
            kind = ["worker", "parent", "term", "parent", "int", "worker", "hup"][number % 7]
            disturb(options.facet, job, chance, 2 * options.items // options.kills, kind)
            if number % 5 == 4:  # a crash in the middle of a line
                with open(job.with_suffix(".facet") / "results-0-of-1.jsonl", "ab") as lines:
                    lines.write(b'{"item":3,"output":"out/')
            for path, digest in sums(job.parent / "out").items():
                if not path.endswith(".tmp"):
                    check(truth.get(path) == digest, f"{path} is half-written after {kind}")
        before = count_done(job)
        run(options.facet, "batch", job, "-q", code=0)
        found = sums(job.parent / "out")
        odd = {path for path in {*found, *truth} if found.get(path) != truth.get(path)}
        check(not odd, f"every picture once, no temporary file, the same bytes: {sorted(odd)}")
        done = [line for line in results(job) if line["status"] == "done"]
        check({line["item"] for line in done} == set(range(options.items)), "every item has its line")
        again = run(options.facet, "batch", job, "--json", code=0)
        check(f'"skipped":{options.items}' in again.stdout, "nothing is left to do")
        print(f"{options.items} items, {options.kills} disturbances: {before} done when they ended, all in the end")
        small = write_job(folder / "small" / "whole", min(options.items, 120))
        run(options.facet, "batch", small, "-q", code=0)
        for fault in (full_disk, file_size_limit, read_only):
            shutil.copy(small, folder / "small" / "job.json")
            fault(options.facet, folder / "small" / "job.json")
    print("ok")


main()
