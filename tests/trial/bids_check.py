#!/usr/bin/env python3
"""bids_check.py FOLDER: does a BIDS data set of an exported study follow the rules?

Checks the rules of BIDS 1.9 about motion
(https://bids-specification.readthedocs.io/en/v1.9.0/modality-specific-files/motion.html) that the
export could break. The official validator checks more; export_test.sh runs it where it is installed.
"""
import json
import os
import re
import sys

TYPES = {"ACCEL", "ANGACCEL", "GYRO", "JNTANG", "LATENCY", "MAGN", "MISC", "ORNT", "POS", "VEL"}
COMPONENTS = {"x", "y", "z", "quat_x", "quat_y", "quat_z", "quat_w", "n/a"}
NAME = re.compile(r"(sub-[0-9a-zA-Z]+)/(ses-[0-9a-zA-Z]+)/motion/\1_\2_task-[0-9a-zA-Z]+"
                  r"_tracksys-[0-9a-zA-Z]+_run-[0-9]+_(motion\.tsv|motion\.json|channels\.tsv|events\.tsv)")
root = sys.argv[1]
problems = []


def complain(file, what):
    problems.append(f"{file}: {what}")


def rows_of(file):
    with open(os.path.join(root, file), encoding="utf-8", newline="") as text:
        lines = text.read().split("\n")
    if lines.pop() != "":
        complain(file, "the last line has no end")
    rows = [line.split("\t") for line in lines]
    if any(len(row) != len(rows[0]) for row in rows):
        complain(file, "rows differ in their number of columns")
    if any(value.strip() != value or value == "" for row in rows for value in row):
        complain(file, "a value is empty or has blanks around it")
    return rows


def json_of(file):
    with open(os.path.join(root, file), encoding="utf-8") as text:
        return json.load(text)


def check_run(stem):
    description = json_of(stem + "motion.json")
    for key in ("TaskName", "SamplingFrequency"):
        if key not in description:
            complain(stem + "motion.json", f"{key} is missing")
    channels = rows_of(stem + "channels.tsv")
    header, channels = channels[0], channels[1:]
    if header[:5] != ["name", "component", "type", "tracked_point", "units"]:
        complain(stem + "channels.tsv", f"the columns are {header}")
        return
    for channel in channels:
        if channel[1] not in COMPONENTS or channel[2] not in TYPES:
            complain(stem + "channels.tsv", f"wrong component or type in {channel}")
        if channel[2] in ("POS", "VEL", "ACCEL") and channel[1] == "n/a":
            complain(stem + "channels.tsv", f"no component in {channel}")
    if len({channel[0] for channel in channels}) != len(channels):
        complain(stem + "channels.tsv", "two channels have the same name")
    samples = rows_of(stem + "motion.tsv")
    if any(len(sample) != len(channels) for sample in samples):
        complain(stem + "motion.tsv", "not one column for each channel")
    for value in (value for sample in samples for value in sample if value != "n/a"):
        float(value)
    latency = [channel[2] for channel in channels].index("LATENCY")
    times = [float(sample[latency]) for sample in samples]
    if times[0] != 0.0 or any(a >= b for a, b in zip(times, times[1:])):
        complain(stem + "motion.tsv", "the times do not rise from 0")
    if description.get("MotionChannelCount") != len(channels):
        complain(stem + "motion.json", "MotionChannelCount is wrong")
    for kind in TYPES:
        count = sum(channel[2] == kind for channel in channels)
        if description.get(kind + "ChannelCount", 0) != count:
            complain(stem + "motion.json", f"{kind}ChannelCount is not {count}")
    if rows_of(stem + "events.tsv")[0][:2] != ["onset", "duration"]:
        complain(stem + "events.tsv", "does not begin with onset and duration")


description = json_of("dataset_description.json")
for key in ("Name", "BIDSVersion"):
    if not description.get(key):
        complain("dataset_description.json", f"{key} is missing")
if os.path.getsize(os.path.join(root, "README")) < 5:
    complain("README", "is empty")
known = {row[0] for row in rows_of("participants.tsv")[1:]}
stems, subjects = set(), set()
for folder, _, names in os.walk(root):
    for name in names:
        file = os.path.relpath(os.path.join(folder, name), root)
        if os.sep not in file:
            continue
        if not NAME.fullmatch(file):
            complain(file, "is not a name of BIDS")
            continue
        stems.add(file[:file.rindex("_") + 1])
        subjects.add(file.split("/")[0])
if known != subjects:
    complain("participants.tsv", f"has {sorted(known)}, but there are {sorted(subjects)}")
for stem in sorted(stems):
    check_run(stem)
print("\n".join(problems[:20]) or f"{len(stems)} runs of {len(known)} participants")
sys.exit(1 if problems or not stems else 0)
