#!/usr/bin/env python3
"""pull.py FELTLINE TOOLS: prints the moving picture of README.md, an animated SVG.

Runs the act of the pull tool on the drawing of the pencil's act, stops it every 30 ms, and writes
each line as one path: a fixed one, or one that takes the shapes that it has over time.
"""
import json
import re
import subprocess
import sys
import tempfile

STEP_MS = 30
PEN = "M0 0l.6-3.6 8.6-21 3.4 1.4-8.6 21z"  # its tip is at 0 0


def run(feltline, *arguments):
    subprocess.run([feltline, "--quiet", "replay", *arguments], check=True)


def paths(file):
    with open(file, encoding="utf-8") as svg:
        return dict(re.findall(r'<path id="(s\d+)" d="([^"]+)"', svg.read()))


def animated(attribute, times, values, seconds, mode="discrete"):
    keys = ";".join(f"{t:.4f}".rstrip("0").rstrip(".") for t in times)
    return (f'<animate attributeName="{attribute}" dur="{seconds}s" repeatCount="indefinite" '
            f'calcMode="{mode}" keyTimes="{keys}" values="{";".join(values)}"/>')


def changes(frames, line):
    """The frames at which a line gets another shape, as (index, shape)."""
    kept = []
    for i, frame in enumerate(frames):
        if not kept or frame[line] != kept[-1][1]:
            kept.append((i, frame[line]))
    return kept


def pen_track(script):
    """(time_ms, x, y - height) of the tip."""
    with open(script, encoding="utf-8") as lines:
        events = [json.loads(line) for line in lines]
    return [(e["t_ms"], e["x"], e["y"] - 0.8 * max(e["z"], 0.0)) for e in events if e["event"] == "hand"]


def main():
    feltline, tools = sys.argv[1:]
    script = f"{tools}/pull/2-pull.ndjson"
    track = pen_track(script)
    end_ms = int(track[-1][0])
    with tempfile.TemporaryDirectory() as scratch:
        run(feltline, f"{tools}/pencil/1-pencil.ndjson", "-o", f"{scratch}/drawn.ndjson")
        frames = []
        for t in range(0, end_ms + 1, STEP_MS):
            run(feltline, script, "--on", f"{scratch}/drawn.ndjson", "--until", str(t), "-o", f"{scratch}/f.svg")
            frames.append(paths(f"{scratch}/f.svg"))
    seconds = end_ms / 1000
    print('<svg xmlns="http://www.w3.org/2000/svg" width="560" height="608" viewBox="-6 -16 140 152">')
    print("<title>The pen pulls an ear and the back of a drawn cat into another shape</title>")
    print('<rect x="-6" y="-16" width="140" height="152" fill="#fff"/>')
    for line in frames[0]:
        shapes = changes(frames, line)
        if len(shapes) == 1:
            print(f'<path d="{shapes[0][1]}"/>')
        else:
            times = [i * STEP_MS / end_ms for i, _ in shapes]
            print(f'<path d="{shapes[0][1]}">{animated("d", times, [d for _, d in shapes], seconds)}</path>')
    times = ";".join(f"{t / end_ms:.4f}" for t, _, _ in track)
    points = ";".join(f"{x:.2f} {y:.2f}" for _, x, y in track)
    print(f'<path d="{PEN}" fill="#b4472e" fill-opacity=".85"><animateTransform attributeName="transform" '
          f'type="translate" dur="{seconds}s" repeatCount="indefinite" keyTimes="{times}" values="{points}"/></path>')
    print("</svg>")


if __name__ == "__main__":
    main()
