#!/usr/bin/env python3
"""Writes two key drawings of a swimming fish as raw pen strokes: motion-fish.py KEY > FILE.ndjson.

KEY is 1 or 2. The fish is drawn along its spine, which is bent to one side in key 1 and to the other
in key 2; the second drawing has other directions and a shaky hand, as a person would redraw it.
"""
import json
import math
import random
import sys


def bent(x, y, key):
    """Bends the point (x along the spine from the nose, y across) with the beat of the tail."""
    beat = 1.0 if key == 1 else -1.0
    # The angle of the spine grows from the gills to the tail.
    angle = lambda s: beat * 0.5 * max(0.0, (s - 22.0) / 60.0) ** 1.4
    px, py, step = 0.0, 0.0, 0.5
    s = 0.0
    while s + step <= x:
        px += step * math.cos(angle(s))
        py += step * math.sin(angle(s))
        s += step
    px += (x - s) * math.cos(angle(s))
    py += (x - s) * math.sin(angle(s))
    a = angle(x)
    return px - y * math.sin(a), py + y * math.cos(a)


def arc(cx, cy, rx, ry, start, end, count=40):
    return [(cx + rx * math.cos(math.radians(start + (end - start) * i / count)),
             cy + ry * math.sin(math.radians(start + (end - start) * i / count))) for i in range(count + 1)]


def bezier(*p, count=40):
    line = []
    for i in range(count + 1):
        t = i / count
        b = [(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t ** 3]
        line.append((sum(w * q[0] for w, q in zip(b, p)), sum(w * q[1] for w, q in zip(b, p))))
    return line


def strokes():
    """The strokes of the fish, straight, with a pressure each."""
    back = bezier((0, 0), (18, -26), (48, -20), (72, -3.5))
    belly = bezier((0, 0), (16, 22), (46, 20), (72, 3.5))
    tail = (bezier((72, -3.5), (80, -6), (86, -14), (94, -19)) + bezier((94, -19), (89, -8), (89, 8), (94, 19))[1:]
            + bezier((94, 19), (86, 14), (80, 6), (72, 3.5))[1:])
    dorsal = bezier((26, -16.6), (34, -31), (48, -29), (56, -11.2))
    fin = bezier((30, 5), (34, 16), (44, 17), (47, 12)) + bezier((47, 12), (42, 7), (36, 4), (30, 5))[1:]
    gill = bezier((21, -9), (27, -4), (27, 5), (21, 10))
    mouth = bezier((0.5, 1), (4, 2.5), (7, 2.5), (9, 1))
    lines = [(back, 0.5), (belly, 0.5), (tail, 0.5), (dorsal, 0.4), (fin, 0.4), (gill, 0.3), (mouth, 0.35),
             (arc(11, -4, 2.6, 2.6, -90, 270), 0.4), (arc(11.2, -4, 0.7, 0.7, 0, 360, 16), 0.7)]
    for i in range(4):
        lines.append((arc(34 + 7.5 * i, -5 + 0.8 * (i % 2), 3.5, 4.6, -70, 70, 16), 0.25))
    for i in range(4):
        lines.append((arc(38 + 7.5 * i, 3.5, 3.2, 4.2, -70, 70, 16), 0.25))
    for i in (-1, 0, 1):
        lines.append((bezier((77, 1.5 * i), (81, 3 * i), (85, 6 * i), (88, 8 * i)), 0.2))
    return lines


def main():
    key = int(sys.argv[1])
    noise = random.Random(7)
    for number, (line, pressure) in enumerate(strokes()):
        points = []
        for i, (x, y) in enumerate(line):
            px, py = bent(x, y, key)
            if key == 2:  # the fish has swum on, and the hand is not a copier
                px, py = px - 6.0, py + 2.0
                px += 0.12 * math.sin(0.3 * i + number) + noise.gauss(0.0, 0.03)
                py += 0.12 * math.cos(0.25 * i + 2 * number) + noise.gauss(0.0, 0.03)
            share = i / (len(line) - 1)
            points.append([round(20 + px, 3), round(45 + py, 3),
                           round(pressure * (0.6 + 0.8 * math.sin(math.pi * min(max(share, 0.08), 0.92))), 3)])
        if key == 2 and number % 3 == 1:
            points.reverse()
        print(json.dumps({"points": points}))


if __name__ == "__main__":
    main()
