#!/usr/bin/env python3
"""detail.py RAW SKETCH X Y WIDTH HEIGHT > picture.svg

Draws the strokes in one part of the page (in mm) large, as SVG: the raw samples as dots, the
segments fitted to them in alternating colours, as wide as the default tolerance on both sides, and
their joints (ring: smooth; square: corner or end). Counts go to stderr.
"""
import json
import sys

COLOURS = ("#f2a541", "#5aa9e6")


def read(path):
    with open(path, encoding="utf-8") as lines:
        return {stroke["id"]: stroke for stroke in map(json.loads, lines)}


def ring(x, y, r=0.16):
    return f'<circle cx="{x:.3f}" cy="{y:.3f}" r="{r}" fill="#fff" stroke="#1b1b1b" stroke-width=".06"/>'


def square(x, y, r=0.16):
    return f'<rect x="{x - r:.3f}" y="{y - r:.3f}" width="{2 * r}" height="{2 * r}" fill="#1b1b1b"/>'


def draw(points, sketch):
    segments = sketch["segments"]
    for i, (x1, y1, *rest) in enumerate(segments):
        print(f'<path d="M{x1} {y1}C{" ".join(map(str, rest))}" fill="none" stroke-width=".3" '
              f'stroke="{COLOURS[i % 2]}"/>')
    for x, y, *_ in points:
        print(f'<circle cx="{x}" cy="{y}" r=".065" fill="#b3123f"/>')
    print(square(*segments[0][:2]), square(*segments[-1][6:]))
    for segment, kind in zip(segments[1:], sketch["joints"]):
        print((square if kind == "corner" else ring)(*segment[:2]))


def main():
    raw, sketch = read(sys.argv[1]), read(sys.argv[2])
    left, top, width, height = map(float, sys.argv[3:7])
    print(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{left} {top} {width} {height}" '
          f'width="{width}mm" height="{height}mm">')
    print(f'<rect x="{left}" y="{top}" width="{width}" height="{height}" fill="#fff"/>')
    shown = [name for name, stroke in raw.items()
             if all(left <= x <= left + width and top <= y <= top + height
                    for x, y, *_ in stroke["points"])]
    for name in shown:
        draw(raw[name]["points"], sketch[name])
    print("</svg>")
    samples = sum(len(raw[name]["points"]) for name in shown)
    segments = sum(len(sketch[name]["segments"]) for name in shown)
    print(f"{len(shown)} strokes, {samples} samples, {segments} segments", file=sys.stderr)


main()
