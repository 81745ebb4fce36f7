# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the parts of one job, each in a process of its own: run_parts.py JOB ATTEMPT MEMORY.

Ends with status 0 when every part has its row, and with 1 when some of them are to be run again with other limits.
"""

from __future__ import annotations

import fcntl
import json
import math
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

from part_table import MIB, Folder, Part, is_done, made_of, read_json, write_whole

# What a job takes beside the program, MiB: this script and its shell take 20, the engine in a job of a cluster 100.
BESIDE = 200
LAST_ATTEMPT = 3
_PICTURE = "96x72"  # pixels, as the summary shows it
# The statuses of runs that something outside has ended: by a signal, and by one that the program has obeyed.
_ENDED = (-1, 5)
_MORE_TIME, _MORE_MEMORY = 4, 2
# Seconds that a part is given at least when its time was short: less would measure how busy the machine is.
_LEAST_TIME = 60


def limits_of(part: Part, folder: Folder, version: str) -> dict[str, Any]:
    """The limits of the part's next run: those of its row in the table, or what the last run asked for."""
    row = read_json(folder.row(part.name))
    if row.get("made_of") == made_of(part, version) and row.get("next"):
        return row["next"]
    return {"memory": part.memory, "timeout": part.timeout, "beside": BESIDE}


def run(program: str, part: Part, folder: Folder, limits: dict[str, Any]) -> tuple[int, dict[str, Any]]:
    """The program's exit status, and its report or one in its place."""
    report = folder.report(part.name)
    if part.fault:
        return 2, _own_report(report, 2, "usage", part.fault)
    command = [program, part.source, str(folder.solid(part.name)), f"--threads={part.threads}", *part.arguments,
               f"--memory={limits['memory']}", f"--timeout={limits['timeout']}", f"--report={report}",
               f"--picture={folder.picture(part.name)}", f"--picture-size={_PICTURE}", "--skip-if-same", "--quiet"]  # fmt: skip
    ended = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    lines = ended.stderr.decode(errors="replace").splitlines()
    told = read_json(report)
    if ended.returncode == 0 and told.get("status") == "ok":
        return 0, told
    if ended.returncode > 0 and told.get("exit_status") == ended.returncode and ended.returncode != 2:
        return ended.returncode, told
    if ended.returncode > 0 and lines and lines[-1].startswith("thicken: "):
        code, sentence = lines[-1].removeprefix("thicken: ").split(": ", 1)
        return ended.returncode, _own_report(report, ended.returncode, code, sentence)
    sentence = f"the program was ended from outside (status {ended.returncode}), as the system does when memory runs out"
    return -1, _own_report(report, 5, "cancelled", sentence)


def _own_report(path: Path, status: int, code: str, sentence: str) -> dict[str, Any]:
    """A report for a run that could not write one."""
    told = {"version": "", "status": "refused", "key": None, "code": code, "exit_status": status, "sentence": sentence,
            "input": None, "repair": None, "memory": {"enough_bytes": None}, "time": {"enough_seconds": None},
            "defects": []}  # fmt: skip
    write_whole(path, json.dumps(told, indent=2, ensure_ascii=False) + "\n")
    return told


def next_limits(status: int, told: dict[str, Any], limits: dict[str, Any]) -> dict[str, Any] | None:
    """Limits that may do better; nothing where none would."""
    if status in _ENDED:
        return {**limits, "beside": limits["beside"] * 2 + math.ceil(float(limits["memory"]))}
    enough = math.ceil((told.get("memory", {}).get("enough_bytes") or 0) / MIB)
    lacked_room = any(place["stage"] == "memory" for place in told.get("fallbacks", []))
    if told.get("code") == "memory-limit":
        memory = float(limits["memory"])
        return {**limits, "memory": enough if enough > memory else math.ceil(_MORE_MEMORY * memory)}
    if lacked_room and enough > float(limits["memory"]):
        return {**limits, "memory": enough}
    if told.get("code") == "time-limit":
        estimate = told.get("time", {}).get("enough_seconds") or 0
        return {**limits, "timeout": math.ceil(max(_MORE_TIME * float(limits["timeout"]), estimate, _LEAST_TIME))}
    return None


def within(limits: dict[str, Any], memory: int) -> dict[str, Any]:
    """The limits, with no more memory than the job has."""
    try:
        least = min(float(limits["memory"]), max(memory - BESIDE, 1))
    except ValueError:  # the program says what is wrong with it
        return limits
    return {**limits, "memory": limits["memory"] if least == float(limits["memory"]) else least}


def make(job: dict[str, Any], part: Part, folder: Folder, attempt: int, memory: int) -> bool:
    """Makes one part and writes its row; whether it is done."""
    before = read_json(folder.row(part.name))
    limits = within(limits_of(part, folder, job["version"]), memory)
    begun = time.monotonic()
    made = made_of(part, job["version"])
    status, told = run(job["program"], part, folder, limits)
    more = next_limits(status, told, limits) if attempt < LAST_ATTEMPT else None
    row = {"final": more is None, "next": more, "made_of": made, "limits": limits, "told": _extract(told),
           "status": "ok" if status == 0 else "failed" if status in _ENDED else "refused",
           "runs": before.get("runs", 0) + 1 if before.get("next") else 1,
           "seconds": told.get("seconds", {}).get("total") or time.monotonic() - begun}  # fmt: skip
    if status == 0:
        row["solid_bytes"] = folder.solid(part.name).stat().st_size
    elif more is None:
        for left in (folder.solid(part.name), folder.picture(part.name)):
            left.unlink(missing_ok=True)
    write_whole(folder.row(part.name), json.dumps(row, ensure_ascii=False))
    if more:
        print(f"batch: {part.name}: {told.get('code', 'memory')}: runs again with {more}", flush=True)
    return more is None


def _extract(told: dict[str, Any]) -> dict[str, Any]:
    """What the summary shows of a report."""
    return {"code": told.get("code", ""), "sentence": told.get("sentence", ""),
            "exit_status": told.get("exit_status", 0), "warnings": told.get("warnings", []),
            "triangles": told.get("output", {}).get("triangles"),
            "thinnest_wall_mm": told.get("thinnest_wall", {}).get("mm"),
            "volume_ml": told.get("output", {}).get("volume_ml"),
            "peak_mib": (told.get("memory", {}).get("peak_bytes") or 0) / MIB or None}  # fmt: skip


def main(job_file: str, attempt: int, memory: int) -> int:
    path = Path(job_file)
    with open(path.with_suffix(".lock"), "w") as lock:
        # A run that was killed may have left this script at work: what it makes is not made twice.
        fcntl.flock(lock, fcntl.LOCK_EX)
        job = read_json(path)
        folder = Folder(path.parents[1])
        parts = [Part(*part) for part in job["parts"]]
        left = [part for part in parts if not is_done(part, folder, job["version"])]
        again = [part for part in left if not make(job, part, folder, attempt, memory)]
    if again:
        return 1
    write_whole(path.with_suffix(".done"), f"{len(parts)} parts\n")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], int(sys.argv[2]), int(sys.argv[3])))
