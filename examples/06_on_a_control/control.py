"""Runs programs on LinuxCNC's own motion controller, without a screen and without real time, and records its joints."""

import os
import pathlib
import pwd
import re
import shutil
import signal
import subprocess
import tempfile

LOCK = pathlib.Path("/tmp/linuxcnc.lock")  # of LinuxCNC, which knows one running control a computer
SAMPLER = """# Every period, once the control has said where the struts are to be: their lengths (mm), and what motion it is.
loadrt sampler depth=30000 cfg=ffffffs
addf sampler.0 servo-thread
setp sampler.0.enable 0
{nets}net motion-type motion.motion-type => sampler.0.pin.6
"""


class ControlError(Exception):
    """The control did not run the programs; the text says why."""


def missing():
    """Why no control can be run here; empty: one can."""
    if not shutil.which("linuxcnc") or not shutil.which("halsampler"):
        return "LinuxCNC is not installed (scripts/setup --dev --with-oracle)"
    if LOCK.exists():
        return f"another LinuxCNC is running here, or was killed: {LOCK} is there"
    return ""


def ordinary_user():
    """Whom LinuxCNC runs as: it refuses root."""
    return pwd.getpwnam("nobody") if os.geteuid() == 0 else pwd.getpwuid(os.geteuid())


def prepare(folder, configuration, programs):
    """The configuration with a sampler, the operator in place of a screen, and the programs, copied into `folder`."""
    here = pathlib.Path(__file__).resolve().parent
    for source in (*pathlib.Path(configuration).iterdir(), here / "operate.py", *programs):
        shutil.copy(source, folder)
    nets = "".join(f"net commanded{j} joint.{j}.pos-cmd => sampler.0.pin.{j}\n" for j in range(6))
    (folder / "sampler.hal").write_text(SAMPLER.format(nets=nets))
    ini = (folder / "hexapod.ini").read_text()
    ini = re.sub(r"(?m)^DISPLAY = .*$", "DISPLAY = ./operate.py", ini)
    ini = re.sub(r"(?m)^APP = .*\n", "", ini)
    ini = re.sub(r"(?m)^(HALFILE = hexapod\.hal)$", r"\1\nHALFILE = sampler.hal", ini)
    (folder / "hexapod.ini").write_text(ini)
    lines = (f"{pathlib.Path(program).name} {pathlib.Path(program).stem}.samples\n" for program in programs)
    (folder / "programs.txt").write_text("".join(lines))


def start(folder, seconds):
    user = ordinary_user()
    for path in (folder, *folder.iterdir()):
        shutil.chown(path, user.pw_uid, user.pw_gid)
    as_user = {"user": user.pw_uid, "group": user.pw_gid, "extra_groups": []} if os.geteuid() == 0 else {}
    with open(folder / "linuxcnc.txt", "w") as log:
        control = subprocess.Popen(["linuxcnc", "hexapod.ini"], cwd=folder, stdin=subprocess.DEVNULL, stdout=log,
                                   stderr=subprocess.STDOUT, start_new_session=True,
                                   env={"PATH": "/usr/bin:/bin", "HOME": str(folder), "LC_ALL": "C"}, **as_user)
        try:
            control.wait(seconds)
        finally:
            if control.poll() is None:  # its script unloads what it had loaded
                os.killpg(control.pid, signal.SIGTERM)
                control.wait(30)


def whole(samples):
    """The lines of halsampler. It counts on from one recording to the next, and takes that for lost samples: the word
    that it puts before the first line says nothing; anywhere else samples are missing."""
    samples = samples.removeprefix("overrun\n")
    if "overrun" in samples:
        raise ControlError("the sampler lost samples: the computer is too busy")
    return samples


def run(configuration, programs, into, seconds=600):
    """Runs the programs one after the other; leaves NAME.samples of each in the folder `into` and returns their paths.
    Raises ControlError."""
    why_not = missing()
    if why_not:
        raise ControlError(why_not)
    with tempfile.TemporaryDirectory(prefix="on_a_control.") as name:  # where an ordinary user may read and write
        folder = pathlib.Path(name)
        prepare(folder, configuration, programs)
        start(folder, seconds)
        said = folder / "operator.txt"
        words = said.read_text() if said.exists() else (folder / "linuxcnc.txt").read_text()
        if words.count("done") != len(programs):
            raise ControlError("LinuxCNC did not run the programs:\n" + words)
        recordings = [pathlib.Path(into) / f"{pathlib.Path(program).stem}.samples" for program in programs]
        for recording in recordings:
            recording.write_text(whole((folder / recording.name).read_text()))
        return recordings
