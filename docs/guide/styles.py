#!/usr/bin/env python3
"""Writes the page of styles as sketch strokes: styles.py > FILE.ndjson.

Each row shows a medium: a curve with constant and with growing width, a line with corners, a tight
wave, and two closed lines.
"""
import json

MEDIA = ['dashed-pen', 'double-line', 'arrow-pen', 'rope', 'leaf', 'hatched']
WIDTHS = {'dashed-pen': 1.2, 'double-line': 2.5, 'arrow-pen': 3.2, 'rope': 3.5, 'leaf': 5, 'hatched': 0.8}
COLORS = {'dashed-pen': '#8c2f39', 'double-line': '#1b4965', 'arrow-pen': '#202020', 'rope': '#8a5a20', 'leaf': '#2f6b3a',
          'hatched': '#40306b'}


def line(*points):
    return [[*a, a[0] + (b[0] - a[0]) / 3, a[1] + (b[1] - a[1]) / 3, a[0] + 2 * (b[0] - a[0]) / 3, a[1] + 2 * (b[1] - a[1]) / 3, *b]
            for a, b in zip(points, points[1:])]


def ring(x, y, rx, ry):
    k = 0.5522847498
    p = [(rx, 0), (rx, k * ry), (k * rx, ry), (0, ry), (-k * rx, ry), (-rx, k * ry), (-rx, 0), (-rx, -k * ry), (-k * rx, -ry),
         (0, -ry), (k * rx, -ry), (rx, -k * ry), (rx, 0)]
    p = [(x + a, y + b) for a, b in p]
    return [[c for q in p[i:i + 4] for c in q] for i in range(0, 12, 3)]


def stroke(medium, segments, widths, joint, closed=False):
    n = len(segments)
    joints = joint if isinstance(joint, list) else [joint] * (n if closed else n - 1)
    print(json.dumps({'closed': closed, 'segments': segments, 'joints': joints,
                      'widths': [[n * u, w] for u, w in widths], 'material': medium, 'color': COLORS[medium]}))


for row, medium in enumerate(MEDIA):
    y, w = 14 + 24 * row, WIDTHS[medium]
    stroke(medium, [[8, y + 4, 16, y - 14, 22, y + 18, 34, y]], [(0, w), (1, w)], 'smooth')
    stroke(medium, [[40, y + 4, 48, y - 14, 54, y + 18, 66, y]], [(0, 0.4 * w), (1, 1.8 * w)], 'smooth')
    stroke(medium, line((72, y + 7), (79, y - 7), (86, y + 7), (93, y + 7), (93, y - 6)), [(0, w), (1, w)], 'corner')
    wave = [[100 + 5 * i, y, 102.5 + 5 * i, y + s, 102.5 + 5 * i, y + s, 105 + 5 * i, y] for i, s in enumerate((-9, 9, -9, 9))]
    stroke(medium, wave, [(0, w), (1, w)], 'corner')
    stroke(medium, ring(137, y, 10, 8), [(0, w), (0.5, 0.6 * w), (1, w)], 'smooth', True)
    stroke(medium, line((155, y - 7), (172, y - 7), (175, y + 7), (155, y + 7), (155, y - 7)), [(0, w), (1, w)], 'corner', True)
