"""The Slurm script on a real cluster of two nodes on this host: one node loses its power in the middle.

    slurm.py FACET SOURCE_FOLDER

Starts slurmctld and two slurmd on loopback, without systemd, munge or accounting. Ends with 77 (left out) where that needs
rights or programs that are not here."""
# SPDX-License-Identifier: MIT
import os
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from kit import check, results, run, sums, write_job

ITEMS = 240
CONFIGURATION = """
ClusterName=two
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={port}
SlurmUser=root
SlurmdUser=root
AuthType=auth/none
CredType=cred/none
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/%n/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/%n.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/%n.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
MpiDefault=none
SwitchType=switch/none
SchedulerType=sched/backfill
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
SlurmdTimeout=5
SlurmctldTimeout=5
KillWait=5
InactiveLimit=0
MinJobAge=300
JobRequeue=1
NodeName=node1 NodeHostname={host} NodeAddr=127.0.0.1 Port={port1} CPUs=1 State=UNKNOWN
NodeName=node2 NodeHostname={host} NodeAddr=127.0.0.1 Port={port2} CPUs=1 State=UNKNOWN
PartitionName=all Nodes=node1,node2 Default=YES MaxTime=INFINITE State=UP
"""


def leave_out(why):
    print(f"left out: {why}")
    sys.exit(77)


def free_ports(count):
    held = [socket.socket() for _ in range(count)]
    for one in held:
        one.bind(("127.0.0.1", 0))
    ports = [one.getsockname()[1] for one in held]
    for one in held:
        one.close()
    return ports


class Cluster:
    def __init__(self, folder):
        self.folder = folder
        (folder / "state").mkdir(parents=True)
        ports = free_ports(3)
        self.conf = folder / "slurm.conf"
        self.conf.write_text(CONFIGURATION.format(host=socket.gethostname().split(".")[0], folder=folder, port=ports[0],
                                                  port1=ports[1], port2=ports[2]))
        os.environ["SLURM_CONF"] = str(self.conf)
        self.start(["slurmctld", "-c", "-f", self.conf])
        for node in ("node1", "node2"):
            self.start_node(node)
        end = time.time() + 60
        while self.ask("sinfo", "-h", "-t", "idle", "-o", "%D") != "2":
            if time.time() > end:
                self.stop()
                leave_out(f"the nodes do not come up here: {self.logs()[-500:]}")
            time.sleep(0.1)

    def start(self, command):
        done = subprocess.run(list(map(str, command)), capture_output=True, text=True, timeout=60)
        if done.returncode:
            leave_out(f"{command[0]} does not start here: {done.stderr[-300:]}")

    def start_node(self, node):
        (self.folder / node).mkdir(exist_ok=True)
        self.start(["slurmd", "-N", node, "-f", self.conf, "-c"])

    def ask(self, *command):
        return subprocess.run(command, capture_output=True, text=True, timeout=60).stdout.strip()

    def wait(self, holds, patience_s, what):
        end = time.time() + patience_s
        while not holds():
            check(time.time() < end, f"{what}\n{self.logs()}")
            time.sleep(0.1)

    def logs(self):
        return "\n".join(path.read_text()[-1500:] for path in sorted(self.folder.glob("*.log")))

    def cut_power(self, node):
        """Its daemon, its steps and their keepers end at once."""
        os.kill(int((self.folder / f"{node}.pid").read_text()), signal.SIGKILL)
        mark = f"SLURMD_NODENAME={node}".encode()
        for entry in Path("/proc").glob("[0-9]*"):
            try:
                if mark not in (entry / "environ").read_bytes().split(b"\0"):
                    continue
                parent = next(line.split()[1] for line in (entry / "status").read_text().splitlines() if line.startswith("PPid:"))
                if b"slurmstepd" in Path(f"/proc/{parent}/cmdline").read_bytes():
                    os.kill(int(parent), signal.SIGKILL)
                os.kill(int(entry.name), signal.SIGKILL)
            except (OSError, StopIteration):
                continue

    def stop(self):
        subprocess.run(["scancel", "-u", "root"], capture_output=True, timeout=60)
        time.sleep(0.5)
        for path in self.folder.glob("*.pid"):
            try:
                os.kill(int(path.read_text()), signal.SIGTERM)
            except (OSError, ValueError):
                pass
        time.sleep(1)


def main():
    facet, source = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
    if os.geteuid() != 0:
        leave_out("it needs root")
    for program in ("slurmctld", "slurmd", "sbatch", "scontrol"):
        if shutil.which(program) is None:
            leave_out(f"{program} is not installed")
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        alone = write_job(folder / "alone", ITEMS, (320, 240))
        run(facet, "batch", alone, "-q", code=0)
        truth = sums(alone.parent / "out")
        job = write_job(folder / "shared", ITEMS, (320, 240))
        cluster = Cluster(folder / "cluster")
        try:
            os.environ["FACET"] = str(facet)
            submitted = subprocess.run([source / "scripts/slurm/facet-array.sbatch", "--parts", "2", "--sbatch",
                                        f"--output={folder}/part-%a.out", job], capture_output=True, text=True, timeout=120)
            check(submitted.returncode == 0, submitted.stderr)
            numbers = dict(line.split() for line in submitted.stdout.splitlines())
            done = lambda: sum(line["status"] == "done" for line in results(job))
            cluster.wait(lambda: done() > ITEMS // 8, 120, "parts begin")
            before = done()
            cluster.cut_power("node2")
            check(before < ITEMS, "the power goes in the middle")
            time.sleep(10)  # the controller notices, and takes the part back
            cluster.start_node("node2")

            def ended():
                # Slurm holds what it takes back for two minutes; a test need not wait for that.
                for line in cluster.ask("squeue", "-h", "-t", "PENDING", "-o", "%i %r").splitlines():
                    if "BeginTime" in line:
                        cluster.ask("scontrol", "update", f"JobId={line.split()[0]}", "StartTime=now")
                return cluster.ask("squeue", "-h", "-o", "%i") == ""

            cluster.wait(ended, 240, f"jobs {numbers} end")
        finally:
            cluster.stop()
        told = cluster.logs() + "".join(path.read_text() for path in folder.glob("part-*.out"))
        check(sums(job.parent / "out") == truth, f"every item once, with the bytes of one machine\n{told}")
        lines = (job.with_suffix(".facet") / "results.jsonl").read_text().splitlines()
        check(len(lines) == ITEMS, f"the joined results have {len(lines)} lines\n{told}")
        run(facet, "batch", job, "--merge", code=0)
        print(f"ok: {before} of {ITEMS} were done when the node went")


main()
