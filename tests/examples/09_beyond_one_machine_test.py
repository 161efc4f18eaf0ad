"""Programs spread over workers: what each of the three ways makes is what one run makes, though a worker is killed."""
import os
import pathlib
import random
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLE = ROOT / "examples/09_beyond_one_machine"
PROGRAMS = 300
PATIENCE = 120
FLEET = "(scripts/setup --dev --with-fleet)"


def skips_without(*programs):
    missing = [program for program in programs if shutil.which(program) is None]
    if missing:
        print(f"this test is skipped: {missing[0]} is not installed {FLEET}")
    return bool(missing)


class Shop(unittest.TestCase):
    """A folder of programs, and what one run makes of it."""

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)
        (self.folder / "bin").mkdir()
        (self.folder / "bin/plumbline").symlink_to(os.environ["PLUMBLINE_PROGRAM"])
        self.environment = {**os.environ, "PATH": f"{self.folder}/bin:{os.environ['PATH']}", "XDG_CONFIG_HOME": "/nonexistent"}
        self.environment.pop("PLUMBLINE_SETTINGS", None)
        random.seed(9)
        for i in range(PROGRAMS):
            path = self.folder / f"parts/{i % 7}/it's part {i}.nc"
            path.parent.mkdir(parents=True, exist_ok=True)
            moves = [f"G1 X{random.uniform(-50, 50):.3f} Y{random.uniform(-50, 50):.3f} A{random.uniform(-5, 5):.3f} F2000"
                     for _ in range(40)]
            path.write_text("\n".join(["G0 X0 Y0 Z5 A0 B0 C0", *moves, "M2", ""]))
        shutil.copy(ROOT / "models/pm600-like.toml", self.folder / "parts")
        readme = (EXAMPLE / "README.md").read_text()
        (self.folder / "parts/plumbline.toml").write_text(readme.split("```toml\n")[1].split("```")[0])
        self.run_there("plumbline", "batch", "-q", "parts", "-o", "serial", "--jobs", "1")

    def run_there(self, *words, **environment):
        done = subprocess.run([str(word) for word in words], cwd=self.folder, env={**self.environment, **environment},
                              capture_output=True, text=True, timeout=PATIENCE)
        self.assertEqual(done.returncode, 0, f"{words}\n{done.stdout}{done.stderr}")
        return done.stdout + done.stderr

    def programs(self, folder):
        return {str(path.relative_to(self.folder / folder)): path.read_bytes() for path in (self.folder / folder).rglob("*.nc")}

    def check_all(self, folder="out"):
        self.assertEqual(len(self.programs(folder)), PROGRAMS)
        self.assertEqual(self.programs(folder), self.programs("serial"))

    def there(self):
        return sum(1 for _ in (self.folder / "out").rglob("*.nc"))

    def wait_for(self, is_there):
        end = time.monotonic() + PATIENCE
        while not is_there():
            self.assertLess(time.monotonic(), end, "it does not come")
            time.sleep(0.005)


class Parallel(Shop):
    def test_a_job_that_dies_is_done_again(self):
        if skips_without("parallel"):
            return
        # The third job finds a plumbline that dies in the middle of its work, once.
        killer = self.folder / "dying/plumbline"
        killer.parent.mkdir()
        killer.write_text(f"#!/bin/bash\nif [[ $PARALLEL_SEQ == 3 ]] && mkdir '{self.folder}/died' 2>/dev/null; then\n"
                          f"  head -n 7 | '{self.folder}/bin/plumbline' \"$@\"\n  kill -9 $$\nfi\n"
                          f"exec '{self.folder}/bin/plumbline' \"$@\"\n")
        killer.chmod(0o755)
        self.run_there(EXAMPLE / "with_parallel", "parts", "out", PATH=f"{killer.parent}:{self.environment['PATH']}")
        self.assertTrue((self.folder / "died").exists())
        self.check_all()
        self.assertIn(f"{PROGRAMS} unchanged", self.run_there("plumbline", "batch", "parts", "-o", "out"))

    def test_by_ssh(self):
        if skips_without("parallel"):
            return
        # Plays ssh and its server: options, the host, then the command, in the user's own folder and shell.
        ssh = self.folder / "bin/ssh"
        ssh.write_text(f"#!/bin/bash\nwhile [[ $1 == -* ]]; do shift; done\nhost=$1; shift\n[[ $1 == -- ]] && shift\n"
                       f"echo $host >>'{self.folder}/hosts'\ncd ~\nSHELL=/bin/sh exec sh -c \"$*\"\n")
        ssh.chmod(0o755)
        self.run_there(EXAMPLE / "with_parallel", "parts", "out", "--sshlogin", "1/hex-pc-1,1/hex-pc-2",
                       PARALLEL_SSH=str(ssh))
        self.assertEqual(set((self.folder / "hosts").read_text().split()), {"hex-pc-1", "hex-pc-2"})
        self.check_all()


def free_port():
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


class Slurm(Shop):
    """Slurm on this computer, without a database, without authentication."""

    def start_slurm(self):
        base = self.folder / "slurm"
        for name in ("state", "spool"):
            (base / name).mkdir(parents=True)
        host = socket.gethostname().split(".")[0]
        settings = {
            "ClusterName": "test", "SlurmctldHost": f"{host}(127.0.0.1)", "SlurmctldPort": free_port(),
            "SlurmdPort": free_port(), "AuthType": "auth/none", "CredType": "cred/none", "SlurmUser": "root",
            "SlurmdUser": "root", "StateSaveLocation": base / "state", "SlurmdSpoolDir": base / "spool",
            "SlurmctldPidFile": base / "slurmctld.pid", "SlurmdPidFile": base / "slurmd.pid",
            "SlurmctldLogFile": base / "slurmctld.log", "SlurmdLogFile": base / "slurmd.log",
            "ProctrackType": "proctrack/linuxproc", "TaskPlugin": "task/none", "SelectType": "select/cons_tres",
            "SelectTypeParameters": "CR_CPU", "MpiDefault": "none", "ReturnToService": 2,
            "SchedulerParameters": "batch_sched_delay=0,sched_interval=1", "JobAcctGatherType": "jobacct_gather/none",
            "AccountingStorageType": "accounting_storage/none", "KillWait": 1}
        lines = [f"{name}={value}" for name, value in settings.items()]
        lines += [f"NodeName={host} NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN",
                  f"PartitionName=all Nodes={host} Default=YES MaxTime=INFINITE State=UP", ""]
        (base / "slurm.conf").write_text("\n".join(lines))
        self.environment["SLURM_CONF"] = str(base / "slurm.conf")
        for daemon in ("slurmctld", "slurmd"):
            running = subprocess.Popen([daemon, "-D", "-c"], env=self.environment, cwd=base,
                                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            self.addCleanup(running.wait)
            self.addCleanup(running.terminate)
        self.wait_for(lambda: subprocess.run(["sinfo", "-h", "-o", "%T"], env=self.environment, capture_output=True,
                                             text=True).stdout.strip() in ("idle", "mixed"))

    def test_an_array_makes_the_same_files_though_a_task_is_killed(self):
        if skips_without("sbatch", "slurmctld", "slurmd"):
            return
        if os.geteuid() != 0:
            print("this test is skipped: Slurm's daemons are started as root alone")
            return
        self.start_slurm()
        shutil.copy(EXAMPLE / "with_slurm.sbatch", self.folder)
        submitted = self.run_there("sbatch", "with_slurm.sbatch").split()[-1]
        self.wait_for(lambda: self.there() > 0)
        killed = subprocess.run(["scontrol", "requeue", f"{submitted}_4"], env=self.environment, capture_output=True)
        self.wait_for(lambda: not subprocess.run(["squeue", "-h"], env=self.environment, capture_output=True,
                                                 text=True).stdout.strip() or self.release())
        self.assertIn(killed.returncode, (0, 1))
        # As after a node that failed for good: the array is submitted once more.
        self.run_there("sbatch", "--wait", "with_slurm.sbatch")
        self.check_all()
        lines = "".join((self.folder / f"straighten-{i}.jsonl").read_text() for i in range(1, 5))
        self.assertEqual(lines.count('"state":"unchanged"'), PROGRAMS, lines[-500:])

    def release(self):
        """A task that was requeued is held for a while: it need not be."""
        subprocess.run("scontrol release $(squeue -h -o %A) ; scontrol update JobId=$(squeue -h -o %A) StartTime=now",
                       shell=True, env=self.environment, capture_output=True)
        return False


class Dask(Shop):
    def test_two_workers_one_of_them_killed(self):
        try:
            sys.path.insert(0, os.environ.get("PLUMBLINE_PYTHON", ""))
            sys.path.insert(0, str(EXAMPLE))
            import plumbline
            from distributed import Client, LocalCluster
        except ModuleNotFoundError as missing:
            print(f"this test is skipped: {missing} {FLEET}")
            return
        import with_dask
        os.environ["PYTHONPATH"] = os.pathsep.join([os.environ.get("PLUMBLINE_PYTHON", ""), str(EXAMPLE)])
        (self.folder / "parts/bad.nc").write_text("G0 X0 Y0 Z5 A0 B0 C0\nG1 X1 X2 F100\n")
        with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None, silence_logs=50) as cluster, \
                Client(cluster) as client:
            victim = next(iter(client.run(os.getpid).values()))

            def kill():
                self.wait_for(lambda: self.there() > PROGRAMS // 5)
                os.kill(victim, signal.SIGKILL)
            killer = threading.Thread(target=kill)
            killer.start()
            refused = with_dask.straighten(self.folder / "parts", self.folder / "out",
                                           self.folder / "parts/pm600-like.toml", client)
            killer.join()
        self.assertEqual([(name, why.code) for name, why in refused.items()], [("bad.nc", "nc-word-twice")])
        names, jobs = with_dask.jobs_of(self.folder / "parts", self.folder / "parts/pm600-like.toml")
        serial = zip(names, plumbline.map(jobs))
        self.assertEqual(self.programs("out"), {str(name): done.bytes for name, done in serial if str(name) != "bad.nc"})
        self.assertEqual(len(self.programs("out")), PROGRAMS)


if __name__ == "__main__":
    unittest.main()
