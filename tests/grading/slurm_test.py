"""A class on a cluster of one machine: munge, slurmctld and slurmd started for this test alone.

Skipped where Slurm is not installed (slurmctld, slurmd, slurm-client, munge) or not run as root.
"""

import os
import shutil
import socket
import subprocess
import time
import unittest
from pathlib import Path

from class_kit import ALL, ROOT, ClassTestCase

BUNDLE = Path("solutions/grading/slurm")
_CONFIG = """ClusterName=tumble
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={port}
SlurmdPort={node_port}
AuthType=auth/munge
AuthInfo=socket={base}/munge.sock
CredType=cred/munge
SlurmUser=root
StateSaveLocation={base}/state
SlurmdSpoolDir={base}/spool
SlurmctldPidFile={base}/ctld.pid
SlurmdPidFile={base}/d.pid
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
ReturnToService=2
SlurmdParameters=config_overrides
SchedulerParameters=sched_interval=1,bf_interval=1
MinJobAge=300
NodeName={host} NodeAddr=127.0.0.1 CPUs={cpus} RealMemory=100000 State=UNKNOWN
PartitionName=all Nodes={host} Default=YES MaxTime=INFINITE State=UP
"""


def _free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


@unittest.skipUnless(all(map(shutil.which, ("munged", "slurmctld", "slurmd", "sbatch")))
                     and os.geteuid() == 0, "Slurm is not installed, or this is not root")
class Slurm(ClassTestCase):
    def setUp(self) -> None:
        super().setUp()
        shutil.copytree(ROOT / BUNDLE, self.kit.root / BUNDLE)
        self.base = Path(f"/tmp/tumble-slurm-{os.getpid()}")  # a socket's path must be short
        self.base.mkdir(mode=0o755)
        self.addCleanup(shutil.rmtree, self.base, ignore_errors=True)
        for name in ("state", "spool"):
            (self.base / name).mkdir()
        self.config = self.base / "slurm.conf"
        host = socket.gethostname().split(".")[0]
        self.config.write_text(_CONFIG.format(
            host=host, base=self.base, port=_free_port(), node_port=_free_port(),
            cpus=os.cpu_count()), encoding="utf-8")
        (self.base / "cgroup.conf").write_text("CgroupPlugin=autodetect\n", encoding="utf-8")
        key = self.base / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o600)
        self.environment = {**os.environ, "SLURM_CONF": str(self.config)}
        self.start("munged", "-F", f"--key-file={key}", f"--socket={self.base}/munge.sock",
                   f"--pid-file={self.base}/munged.pid", f"--log-file={self.base}/munged.log",
                   f"--seed-file={self.base}/munged.seed", "--force")
        self.wait_for(lambda: (self.base / "munge.sock").exists(), "munged")
        self.start("slurmctld", "-D", "-f", self.config)
        self.start("slurmd", "-D", "-f", self.config, "-N", host)
        self.wait_for(lambda: "idle" in self.run_tool("sinfo", "-h", "-o", "%t").stdout, "slurmd")

    def start(self, *command: object) -> None:
        log = open(self.base / f"{command[0]}.out", "w", encoding="utf-8")
        process = subprocess.Popen([str(part) for part in command], env=self.environment,
                                   stdout=log, stderr=subprocess.STDOUT)
        self.addCleanup(log.close)
        self.addCleanup(process.wait)
        self.addCleanup(process.terminate)

    def run_tool(self, *command: object) -> subprocess.CompletedProcess[str]:
        return subprocess.run([str(part) for part in command], env=self.environment, text=True,
                              capture_output=True, timeout=60)

    def wait_for(self, ready, what: str, seconds: float = 40.0) -> None:
        end = time.monotonic() + seconds
        while not ready():
            if time.monotonic() > end:
                logs = "".join(path.read_text(errors="replace")[-2000:]
                               for path in self.base.glob("*.out"))
                self.fail(f"{what} is not ready: {logs}")
            time.sleep(0.2)

    def submit(self, *options: object) -> subprocess.CompletedProcess[str]:
        return self.run_tool("bash", self.kit.root / BUNDLE / "submit.sh", *options)

    def wait_for_jobs(self) -> None:
        self.wait_for(lambda: not self.run_tool("squeue", "-h").stdout.strip(), "the last job",
                      seconds=300.0)

    def test_three_parts_make_one_class(self) -> None:
        for i in range(10):
            self.hand_in(f"s{i}", f"// passes 1.{1 + i % 6}\n")
        self.hand_in("all", ALL)
        done = self.submit(3, self.folder, self.out, self.kit.root / "secret", "--labs", "1")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.wait_for_jobs()
        logs = sorted((self.out / ".logs").iterdir())
        self.assertEqual(len(logs), 1 + 3 + 1, logs)
        rows = (self.out / "class.csv").read_text(encoding="utf-8").splitlines()
        self.assertEqual(len(rows), 1 + 11)
        self.assertEqual(self.results("all")["score"], 115)
        self.assertEqual(self.judged(), 2 + 11)  # the proof once, each student once
        for log in logs:
            self.assertNotIn("Traceback", log.read_text(encoding="utf-8"))

    def test_without_proof_no_part_runs(self) -> None:
        self.kit.write("labs/1_spin/spin.cpp", "// passes 1.1\n")
        self.hand_in("all", ALL)
        self.submit(2, self.folder, self.out, self.kit.root / "secret")
        self.wait_for_jobs()
        self.assertFalse((self.out / "all").exists())
        self.assertFalse((self.out / "class.csv").exists())

    def test_bad_arguments_get_one_line(self) -> None:
        for options in ([], [0, self.folder, self.out, self.kit.root / "secret"],
                        [2, "/no/such", self.out, self.kit.root / "secret"],
                        [2, self.folder, self.out, "/no/such"]):
            done = self.submit(*options)
            self.assertEqual(done.returncode, 2)
            self.assertRegex(done.stderr, r"\Asubmit.sh: [^\n]+\n\Z")
        self.assertEqual(self.judged(), 0)


if __name__ == "__main__":
    unittest.main()
