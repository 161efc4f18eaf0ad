#!/usr/bin/python3
"""Stands in for the operator at LinuxCNC's screen: switches the machine on, homes it, runs programs, keeps what the
sampler sees. LinuxCNC calls it ([DISPLAY]DISPLAY) in the folder of the configuration, with the python that its module
linuxcnc is installed for; what it says goes to operator.txt there."""

import os
import subprocess
import sys
import time

import linuxcnc

command, status, errors = linuxcnc.command(), linuxcnc.stat(), linuxcnc.error_channel()


def wait(what, done, seconds):
    """Until it is done; an error of the control ends the work."""
    end = time.monotonic() + seconds
    while True:
        error = errors.poll()
        if error:
            raise RuntimeError(f"{what}: {error[1]}")
        status.poll()
        if done():
            return
        if time.monotonic() > end:
            raise RuntimeError(f"{what} takes longer than {seconds} s")
        time.sleep(0.01)


def switch_on():
    command.state(linuxcnc.STATE_ESTOP_RESET)
    wait("emergency stop", lambda: status.task_state == linuxcnc.STATE_ESTOP_RESET, 10)
    command.state(linuxcnc.STATE_ON)
    wait("switching on", lambda: status.task_state == linuxcnc.STATE_ON, 10)
    command.home(-1)
    wait("homing", lambda: all(status.homed[:6]), 10)
    command.mode(linuxcnc.MODE_AUTO)
    wait("automatic mode", lambda: status.task_mode == linuxcnc.MODE_AUTO, 10)


def sampling(on):
    subprocess.run(["halcmd", "setp", "sampler.0.enable", str(int(on))], check=True)


def is_idle():
    return status.interp_state == linuxcnc.INTERP_IDLE and status.inpos and status.queue == 0


def run(program, recording):
    command.program_open(os.path.abspath(program))
    wait("opening", lambda: status.file == os.path.abspath(program), 10)
    with open(recording, "w") as out:
        sampler = subprocess.Popen(["halsampler", "-t"], stdout=out)
        sampling(True)
        command.auto(linuxcnc.AUTO_RUN, 0)
        wait(program, lambda: not is_idle(), 10)
        wait(program, is_idle, 600)
        sampling(False)
        time.sleep(0.5)  # the sampler hands over every 10 ms what it holds
        sampler.terminate()
        sampler.wait()


def main():
    switch_on()
    with open("programs.txt") as programs:
        for line in programs:
            program, recording = line.split()
            run(program, recording)
            print("done", program, flush=True)


if __name__ == "__main__":
    sys.stdout = open("operator.txt", "w")
    try:
        main()
    except Exception as problem:  # nobody looks at LinuxCNC's own output
        print("failed", problem, flush=True)
