"""Computes the numbers of equations.md again, from the text of the paper and docs/design/errata.md.

paper_numbers.py EQUATIONS.md: prints what is wrong, and exits with 1 if anything is.
"""

import math
import re
import sys

text = open(sys.argv[1], encoding="utf-8").read().replace("\\", "")
wrong = 0


def check(what, got, want, within=0.5001e-4):
    global wrong
    if abs(got - want) > within:
        print(f"{what}: {got}, not {want}")
        wrong += 1


def tables(number):
    """Returns the tables below the heading of an equation, as lists of rows of numbers."""
    section = re.search(rf"^## Equation \({number}\)\n(.*?)(?=^## |\Z)", text, re.M | re.S).group(1)
    for table in section.strip().split("\n\n"):
        rows = table.split("\n")[2:]
        yield [[float(cell) for cell in row.strip("| ").split(" | ") if re.match(r"^-?[\d.]+$", cell)]
               for row in rows]


def summary(number):
    """Returns the cell with the main numbers of an equation."""
    return re.search(rf"^\| \({number}\) \|.*\| ([^|]*) \|$", text, re.M).group(1)


def numbers(number):
    return [float(n) for n in re.findall(r"\d+\.\d+(?:e[+-]\d+)?|\d+", summary(number))]


def level(d, spread=10.0):
    return 0.2 + 0.8 * d / (d + spread)


def edit(d):
    return min(level(d), 0.3 * d) if d > 0 else 0.0


# (1), (3): exact up to rounding. (5): nothing is nearer.
assert numbers(1)[0] < 1e-12 and numbers(3)[0] < 1e-11, (numbers(1), numbers(3))
pens, ends, of, nearer = numbers(5)
assert pens == 1000 and 0 < ends < pens and nearer < 1e-12, numbers(5)
assert numbers(6)[-1] < 1e-9, summary(6)
beside, deep, printed, read = (n for n in numbers(4) if n != 2)
check("(4) printed", printed, beside**2 + deep**2)
check("(4) read", read, beside**2)

# (2): more shared points make more segments, and joints are not smooth; Feltline's are, but for corners.
rows = re.findall(r"^\| equation 2, s = (\d+) \| ([\d.]+) \| (\d+) \| (\d+) \| (\d+) \|", text, re.M)
assert [int(r[0]) for r in rows] == [0, 2, 4, 8], rows
check("(2) gap", float(rows[3][1]) / float(rows[2][1]), 2.0, 0.1)
assert all(int(r[4]) < 0.2 * int(r[3]) for r in rows), rows

# (7): the weights of B4 and the shares of V that arrive.
(table,) = tables(7)
for t, b4, right, share, corrected, b2, cases, soft in table:
    s = 1.0 - t
    b = [s**3, 3 * t * s * s, 3 * t * t * s, t**3]
    check(f"(7) B4 at {t}", b4, t)
    check(f"(7) t^3 at {t}", right, t**3)
    check(f"(7) printed at {t}", share, b[0]**2 + b[1]**2 + b[2]**2 + b[3] * t)
    check(f"(7) with t^3 at {t}", corrected, sum(x * x for x in b))
    check(f"(7) cases at {t}", cases, 1.0)
    check(f"(7) soft at {t}", soft, 1.0)
    if 0.25 <= t <= 0.75:
        check(f"(7) case 3 at {t}", b2, 1.0 / (3.0 * t * s))
assert [row[0] for row in table] == [0, 0.1, 0.25, 0.39, 0.5, 0.75, 0.9, 1]
steps = [int(n) for n in re.search(r"after (\d+) steps as printed and (\d+)", summary(7)).groups()]
check("(7) steps as read", steps[1], math.log(100.0) / 0.2, 1.5)  # each leaves exp(-0.2) of the distance
assert steps[0] > steps[1], steps

# (8), (9): the law with and without its ramp.
(table,) = tables(8)
for d, printed, read in table:
    check(f"(8) printed at {d}", printed, level(d))
    check(f"(8) read at {d}", read, edit(d))
assert len(table) == 11
unrest, rest = (float(n) for n in re.search(r"by ([\d.]+) N, peak to peak, as printed and by ([\d.]+)",
                                            summary(8)).groups())
assert unrest >= 0.2 and rest < 0.04, (unrest, rest)
reached = [float(n) for n in re.search(r"at ([\d.]+) mm, 0.6 N at ([\d.]+) mm, 0.99 N at ([\d.]+) mm",
                                       summary(9)).groups()]
check("(9) 0.2 N", reached[0], 0.2 / 0.3)
check("(9) 0.6 N", reached[1], 10.0)
check("(9) 0.99 N", reached[2], 10.0 * 0.79 / 0.01, 0.1)

# (10): N curves, and the head of the cat.
moved, turned, scaled = tables(10)
for count, before, printed, read in moved:
    check(f"(10) {count} before", before, 0.0)
    for value in (printed, read):
        check(f"(10) {count} curves", value, level(10.0 * count, 40.0) if count else 0.0)
radii = float(re.search(r"sum of radii ([\d.]+) mm", text).group(1))
for deg, printed, read in turned:
    th = math.radians(deg)
    check(f"(10) chord at {deg}", printed, level(radii * 2.0 * abs(math.sin(th / 2)), 40.0))
    if deg >= 10:  # below, the ramp acts
        check(f"(10) arc at {deg}", read, level(radii * th, 40.0))
for s, printed, read in scaled:
    check(f"(10) printed at {s}", printed, level(radii * abs(s - 1.0), 40.0))
    check(f"(10) read at {s}", read, level(radii * abs(math.log(s)), 40.0))
count, printed, total, read = re.search(
    r"The (\d+) points .* with ([\d.]+) N .*\(sum ([\d.]+) mm\), and with ([\d.]+) N", summary(10)).groups()
check("(10) at the grab, printed", float(printed), level(float(total), 40.0))
check("(10) at the grab, read", float(read), 0.0)
assert int(count) >= 2, count

# (11): equation 11, and the profile of docs/design/forces.md.
(table,) = tables(11)
for d, printed, read in table:
    inside = 0.0 < d < 8.0
    x = (d - 6.0) / 2.0
    well = 0.3 * d if d < 2.0 else 0.6 if d <= 6.0 else 0.6 * (1 - 3 * x * x + 2 * x**3)
    check(f"(11) printed at {d}", printed, level(d) if inside else 0.0)
    check(f"(11) read at {d}", read, well if inside else 0.0)
assert len(table) == 11

# Figures 3 and 4: the force is that of the turn, and grows.
turns = re.findall(r"turned by ([\d.]+) degrees.*?feels ([\d.]+) N", text)
assert len(turns) == 2 and float(turns[0][0]) < float(turns[1][0]), turns
for deg, force in turns:
    th = math.radians(float(deg))
    sums = [radii * th, radii * 2.0 * math.sin(th / 2)]
    assert min(abs(float(force) - level(s, 40.0)) for s in sums) < 0.01, (deg, force)

sys.exit(1 if wrong else 0)
