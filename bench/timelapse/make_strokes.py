"""make_strokes.py SAMPLES: prints 1,000 raw strokes, the words, curves and hatching of the folder
SAMPLES (share/samples), repeated over an A4 page in landscape."""

import json
import sys

COUNT, COLUMNS = 1000, 5


def rows(path):
    with open(path, encoding="utf-8") as lines:
        return [row for row in map(json.loads, lines) if "points" in row]


def main():
    strokes = [row for name in ("handwriting", "page") for row in rows(f"{sys.argv[1]}/{name}.ndjson")]
    for n in range(COUNT):
        copy, k = divmod(n, len(strokes))
        dx, dy = 56.0 * (copy % COLUMNS), 40.0 * (copy // COLUMNS)
        points = [
            [round(0.55 * x + dx, 3), round(0.3 * y + dy, 3), 0.2 * time, pressure]
            for x, y, time, pressure in strokes[k]["points"]
        ]
        print(json.dumps({"id": f"s{n}", "points": points}))


main()
