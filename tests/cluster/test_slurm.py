"""The recipe for Slurm on a real slurmctld and slurmd: one node, on the loopback, as the user who runs the tests.

Where Slurm is not installed, Debian's packages are unpacked into target/slurm, without a change to the system.
"""

from __future__ import annotations

import getpass
import shutil
import socket
import subprocess
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from conftest import ROOT, Desk, recipe

PACKAGES = ["slurmctld", "slurmd", "slurm-client"]
UNPACKED = ROOT / "target" / "slurm"
PLUGINS = "usr/lib/x86_64-linux-gnu/slurm-wlm"


def unpacked() -> Path:
    """The root folder of the packages."""
    root = UNPACKED / "root"
    if (root / PLUGINS).is_dir():
        return root
    if not shutil.which("apt-get"):
        pytest.skip("SKIPPED: Slurm is not installed, and here is no apt-get to fetch it by")
    for folder in ["lists/partial", "archives/partial"]:
        (UNPACKED / folder).mkdir(parents=True, exist_ok=True)
    own = [f"Dir::State::Lists={UNPACKED}/lists", f"Dir::Cache={UNPACKED}", f"Dir::Cache::Archives={UNPACKED}/archives"]
    options = [word for option in ["Debug::NoLocking=1", *own] for word in ("-o", option)]
    fetch = ["install", "-qy", "--no-install-recommends", "--download-only", *PACKAGES]
    for command in [["update", "-q"], fetch]:
        done = subprocess.run(["apt-get", *options, *command], capture_output=True, text=True)
        if done.returncode != 0:
            pytest.skip(f"SKIPPED: the packages of Slurm cannot be had: {done.stderr.strip()[-300:]}")
    for package in (UNPACKED / "archives").glob("*.deb"):
        subprocess.run(["dpkg", "-x", package, root], check=True)
    return root


def free_port() -> int:
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        return taken.getsockname()[1]


def wait(what: str, is_so: Callable[[], object]) -> None:
    end = time.monotonic() + 600
    while not is_so():
        assert time.monotonic() < end, f"{what}: not within ten minutes"
        time.sleep(0.02)


# the first try of task 1 halts at a change of the disk, after its first part and before its last: it cannot end before it is
# cancelled
HELD = """#!/bin/bash
if [ "${SLURM_ARRAY_TASK_ID:-}" = 1 ] && mkdir held 2>/dev/null; then
    export PLM_IMPACT_TEST_SIGNAL="$(kill -l STOP)@100"
    echo $$ >held/process
fi
exec COMMAND "$@"
"""


@pytest.fixture
def slurm(tmp_path: Path) -> Iterator[Desk]:
    """A cluster of one node that says it has eight processors."""
    root = unpacked()
    desk = Desk(tmp_path)
    host = socket.gethostname().split(".")[0]
    folders = {name: tmp_path / name for name in ["state", "spool"]}
    for folder in folders.values():
        folder.mkdir()
    configuration = tmp_path / "slurm.conf"
    configuration.write_text(
        f"""
ClusterName=one
SlurmctldHost={host}(127.0.0.1)
SlurmUser={getpass.getuser()}
SlurmdUser={getpass.getuser()}
AuthType=auth/none
CredType=cred/none
SlurmctldPort={free_port()}
SlurmdPort={free_port()}
StateSaveLocation={folders["state"]}
SlurmdSpoolDir={folders["spool"]}
SlurmctldPidFile={tmp_path}/slurmctld.pid
SlurmdPidFile={tmp_path}/slurmd.pid
PluginDir={root / PLUGINS}
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
MpiDefault=none
SwitchType=switch/none
ReturnToService=2
KillWait=5
SchedulerParameters=batch_sched_delay=0,sched_interval=1,sched_min_interval=0
SlurmdParameters=config_overrides
NodeName={host} NodeAddr=127.0.0.1 CPUs=8
PartitionName=all Nodes=ALL Default=YES State=UP
"""
    )
    libraries = f"{root / PLUGINS}:{root}/usr/lib/x86_64-linux-gnu"
    desk.environment |= {"SLURM_CONF": str(configuration), "LD_LIBRARY_PATH": libraries}
    held = tmp_path / "bin" / "plm-impact"
    held.parent.mkdir()
    held.write_text(HELD.replace("COMMAND", f"'{shutil.which('plm-impact', path=desk.environment['PATH'])}'"))
    held.chmod(0o755)
    desk.environment["PATH"] = f"{held.parent}:{root}/usr/bin:{desk.environment['PATH']}"
    daemons = [
        [f"{root}/usr/sbin/slurmctld-wlm", "-D", "-i"],
        [f"{root}/usr/sbin/slurmd-wlm", "-D", "-d", f"{root}/usr/sbin/slurmstepd-wlm"],
    ]
    running = []
    try:
        for i, daemon in enumerate(daemons):
            log = (tmp_path / f"daemon-{i}.log").open("w")
            running.append(subprocess.Popen(daemon, env=desk.environment, stdout=log, stderr=log))
        wait("an idle node", lambda: "idle" in desk.run("sinfo || true"))
        yield desk
    finally:
        for daemon in reversed(running):
            daemon.terminate()
            daemon.wait(timeout=600)


def test_an_array_with_a_task_that_is_cancelled_and_requeued_gives_the_bytes_of_one_run(slurm: Desk) -> None:
    submit, whole = recipe("sbatch").rstrip("\n").rsplit("\n", 1)
    assert whole == "plm-impact run big.toml --out big"
    job = slurm.run(submit.replace("sbatch ", "sbatch --parsable ", 1)).strip()
    parts = slurm.folder / "big" / "parts"

    def state(task: str) -> str:
        return slurm.run(f"squeue --noheader --states all --jobs {task} --format %T").strip()

    # part 1 is the first of shard 1
    wait("a part of shard 1", (parts / "part-00001.csv").exists)
    slurm.run(f"scancel {job}_1")
    wait("the end of task 1", lambda: state(f"{job}_1") == "CANCELLED")
    # Slurm without control groups may leave it behind
    slurm.run("kill -KILL $(cat held/process) || true")
    kept = (parts / "part-00001.csv").stat().st_ino
    slurm.run(f"scontrol requeue {job}_1")
    slurm.run(f"scontrol update jobid={job}_1 starttime=now")
    wait("the end of the array", lambda: not slurm.run(f"squeue --noheader --jobs {job}").strip())
    assert (parts / "part-00001.csv").stat().st_ino == kept, "the task computed a part anew"
    slurm.run(whole)
    assert slurm.is_whole()
    for output in slurm.folder.glob("slurm-*.out"):
        text = output.read_text()
        assert "error" not in text or "_1.out" in output.name, f"{output.name}: {text}"
