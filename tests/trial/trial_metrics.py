#!/usr/bin/env python3
"""trial_metrics.py < TRIALS: recomputes the metrics of trials that random_trials printed.

An independent implementation of src/felt/trial, written from the formulas of its data dictionary
(trial_columns.cc). It favours simple algorithms: every line is searched for the nearest one, the
Frechet distance fills a whole table, and a Fourier coefficient is a sum over all samples. Fails if
a metric differs by more than 1e-6 (of its unit), or is missing in one implementation only.
Needs only the standard library.
"""
import bisect
import collections
import itertools
import math
import operator
import sys

TOLERANCE = 1e-6
MAX_COORDINATE_MM = 1e9
MAX_FORCE_N = 1e6
STEP_NS = 5_000_000
STEP_S = 0.005

Sample = collections.namedtuple("Sample", "ns x y contact pressure fx fy height")
Near = collections.namedtuple("Near", "distance index t x y")


def dist(p, q):
    return math.hypot(p[0] - q[0], p[1] - q[1])


def mean(values):
    return math.fsum(values) / len(values)


def deviation(values):
    """The standard deviation of a sample."""
    m = mean(values)
    return math.sqrt(math.fsum((v - m) ** 2 for v in values) / (len(values) - 1))


def quantile(values, share):
    """Type 7 of Hyndman and Fan."""
    ordered = sorted(values)
    rank = share * (len(ordered) - 1)
    below = math.floor(rank)
    above = min(below + 1, len(ordered) - 1)
    return ordered[below] + (rank - below) * (ordered[above] - ordered[below])


def in_range(*numbers):
    return all(abs(v) <= MAX_COORDINATE_MM for v in numbers)  # false for NaN


def pairs(line):
    return list(zip(line, line[1:]))


class Curve:
    """A polyline with its cumulative arc lengths."""

    def __init__(self, points):
        self.points = points
        steps = [dist(a, b) for a, b in pairs(points)]
        self.lengths = [0.0] + list(itertools.accumulate(steps))
        self.length = self.lengths[-1]

    def at(self, s):
        if s <= 0.0 or len(self.points) == 1:
            return self.points[0]
        if s >= self.length:
            return self.points[-1]
        i = bisect.bisect_right(self.lengths, s) - 1
        u = (s - self.lengths[i]) / (self.lengths[i + 1] - self.lengths[i])
        (ax, ay), (bx, by) = self.points[i], self.points[i + 1]
        return (ax + u * (bx - ax), ay + u * (by - ay))

    def divided(self, steps):
        return [self.at(self.length * k / steps) for k in range(steps + 1)]


def nearest(lines, p):
    """The nearest of some lines (pairs of points); the first one of several."""
    best = None
    px, py = p
    for index, ((ax, ay), (bx, by)) in enumerate(lines):
        dx, dy = bx - ax, by - ay
        square = dx * dx + dy * dy
        t = ((px - ax) * dx + (py - ay) * dy) / square if square > 0.0 else 0.0
        if t <= 0.0:
            t, qx, qy = 0.0, ax, ay
        elif t >= 1.0:
            t, qx, qy = 1.0, bx, by
        else:
            qx, qy = ax + t * dx, ay + t * dy
        d = (px - qx) ** 2 + (py - qy) ** 2
        if best is None or d < best[0]:
            best = (d, index, t, qx, qy)
    return Near(math.sqrt(best[0]), *best[1:])


def steps_for(length, step, most):
    return max(1, min(most, math.ceil(length / step - 1e-9)))


class Path:
    def __init__(self, points, closed):
        line = [p for p in points if in_range(*p)]
        line = [p for p, _ in itertools.groupby(line)]
        if closed and len(line) > 1 and line[0] != line[-1]:
            line.append(line[0])
        self.curve = Curve(line) if line else None
        self.lines = pairs(line) or [(p, p) for p in line]
        self.closed = closed and len(line) > 1

    def directions(self, near):
        """The unit directions of the lines that meet at a point of the path."""
        n = len(self.lines)
        found = [near.index]
        if near.t == 0.0 and (self.closed or near.index > 0):
            found.append((near.index - 1) % n)
        if near.t == 1.0 and (self.closed or near.index < n - 1):
            found.append((near.index + 1) % n)
        units = []
        for i in found:
            a, b = self.lines[i]
            units.append(((b[0] - a[0]) / dist(a, b), (b[1] - a[1]) / dist(a, b)))
        return units

    def tangent(self, near):
        units = self.directions(near)
        x, y = sum(u[0] for u in units), sum(u[1] for u in units)
        size = math.hypot(x, y)
        return (x / size, y / size) if size > 1e-9 else units[0]

    def ends_at(self, near):
        return (not self.closed and near.t in (0.0, 1.0)
                and len(self.directions(near)) == 1)


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def valid_samples(samples):
    good = []
    for s in samples:
        numbers = [v for v in (s.pressure, s.fx, s.fy) if v is not None]
        ok = in_range(s.x, s.y) and all(abs(v) <= MAX_FORCE_N for v in numbers)
        if ok and (not good or s.ns > good[-1].ns):
            good.append(s)
    return good


def seconds(a, b):
    return (b.ns - a.ns) * 1e-9


def time_metrics(good, touches):
    start, end = touches[0][0], touches[-1][-1]
    contact = math.fsum(seconds(t[0], t[-1]) for t in touches)
    length = math.fsum(dist((a.x, a.y), (b.x, b.y)) for t in touches for a, b in pairs(t))
    return {
        "reaction_s": seconds(good[0], start),
        "movement_s": seconds(start, end),
        "in_air_s": math.fsum(seconds(a[-1], b[0]) for a, b in pairs(touches)),
        "lifts": len(touches) - 1,
        "ink_length_mm": length,
        "speed_mean_mm_per_s": length / contact if contact > 0 else None,
    }


def signed_error(path, near, p):
    side = cross(path.tangent(near), (p[0] - near.x, p[1] - near.y))
    return side if path.ends_at(near) else math.copysign(near.distance, side)


def direction_error(path, strokes):
    angles, weights = [], []
    for stroke in strokes:
        curve = Curve(stroke)
        if curve.length == 0.0:
            continue
        for a, b in pairs(curve.divided(steps_for(curve.length, 1.0, 20000))):
            middle = ((a[0] + b[0]) / 2, (a[1] + b[1]) / 2)
            tx, ty = path.tangent(nearest(path.lines, middle))
            turn = abs(math.atan2(b[1] - a[1], b[0] - a[0]) - math.atan2(ty, tx)) % math.pi
            angles.append(math.degrees(min(turn, math.pi - turn)))
            weights.append(dist(a, b))
    if not sum(weights) > 0.0:
        return None
    return math.fsum(a * w for a, w in zip(angles, weights)) / math.fsum(weights)


def total_error(there, heights):
    if None in heights:
        return None
    middle = sorted(heights)[len(heights) // 2]
    return mean([math.hypot(d, h - middle) for d, h in zip(there, heights)])


def error_metrics(path, strokes, heights, tunnel):
    points = [p for stroke in strokes for p in stroke]
    nears = [nearest(path.lines, p) for p in points]
    length = path.curve.length
    marks = path.curve.divided(steps_for(length, 0.5, 20000)) if length > 0 else path.curve.points
    if path.closed:
        marks = marks[:-1]
    ink = [pair for stroke in strokes for pair in (pairs(stroke) or [(stroke[0], stroke[0])])]
    there = [n.distance for n in nears]
    back = [nearest(ink, p).distance for p in marks]
    area, rest = [], iter(there)
    for stroke in strokes:
        errors = [next(rest) for _ in stroke]
        area += [(e + f) / 2 * dist(a, b) for (e, f), (a, b) in zip(pairs(errors), pairs(stroke))]
    has_length = length > 0.0
    return {
        "err_mean_mm": (mean(there) + mean(back)) / 2,
        "err_rms_mm": math.sqrt((mean([d * d for d in there]) + mean([d * d for d in back])) / 2),
        "err_p95_mm": max(quantile(there, 0.95), quantile(back, 0.95)),
        "err_max_mm": max(there + back),
        "err_total_mm": total_error(there, heights),
        "err_signed_mm": mean([signed_error(path, n, p) for n, p in zip(nears, points)])
                         if has_length else None,
        "direction_err_deg": direction_error(path, strokes) if has_length else None,
        "area_mm2": math.fsum(area),
        "coverage": sum(d <= 1.0 + 1e-9 for d in back) / len(back),
        "out_of_tunnel_share": sum(d > tunnel / 2 + 1e-9 for d in there) / len(there)
                               if tunnel else None,
    }


def discrete_frechet(a, b):
    """Eiter, Mannila 1994: c(i, j) = max(d(i, j), min(c(i-1, j), c(i, j-1), c(i-1, j-1)))."""
    table = [[0.0] + [math.inf] * len(b)]  # with a border, so that every cell has predecessors
    for x, y in a:
        above, left = table[-1], math.inf
        row = [left]
        for k, (u, v) in enumerate(b):
            reach = above[k]
            if above[k + 1] < reach:
                reach = above[k + 1]
            if left < reach:
                reach = left
            d = (x - u) * (x - u) + (y - v) * (y - v)
            left = d if d > reach else reach
            row.append(left)
        table.append(row)
    return math.sqrt(table[-1][-1])


def frechet_metric(path, points):
    line = path.curve.points
    if path.closed:
        near = nearest(path.lines, points[0])
        begin = (near.x, near.y)
        loop = line[:-1]
        k = (near.index + 1) % len(loop)
        line = [begin] + loop[k:] + loop[:k] + [begin]
    ink = Curve(points)
    count = max(2, min(256, math.ceil(max(path.curve.length, ink.length) / 0.5 - 1e-9) + 1))
    a, b = Curve(line).divided(count - 1), ink.divided(count - 1)
    return min(discrete_frechet(a, b), discrete_frechet(a[::-1], b))


def sign_changes(values):
    signs = [v > 0 for v in values if abs(v) > 1e-9]
    return sum(s != t for s, t in pairs(signs))


def straight_metrics(path, points, target):
    line = path.curve.points
    chord = dist(line[0], line[-1])
    if path.closed or chord == 0.0 or path.curve.length > chord * (1 + 1e-9):
        return {}
    angle = math.atan2(line[-1][1] - line[0][1], line[-1][0] - line[0][0])
    c, s = math.cos(angle), math.sin(angle)
    turned = [(c * (x - line[0][0]) + s * (y - line[0][1]),
               c * (y - line[0][1]) - s * (x - line[0][0])) for x, y in points]
    ys = [y for _, y in turned]
    result = {
        "axis_crossings": sign_changes(ys),
        "direction_changes": sign_changes([b[1] - a[1] for a, b in pairs(turned)]),
        "orthogonal_changes": sign_changes([b[0] - a[0] for a, b in pairs(turned)]),
        "movement_variability_mm": deviation(ys) if len(ys) > 1 else None,
        "movement_error_mm": mean([abs(y) for y in ys]),
        "movement_offset_mm": mean(ys),
    }
    if target:
        inside = [dist(p, line[-1]) <= target / 2 + 1e-9 for p in points]
        entries = sum(now and not before for before, now in pairs([False] + inside))
        result["target_reentries"] = max(0, entries - 1)
    return result


def every_5_ms(movement):
    times = [s.ns - movement[0].ns for s in movement]
    out = []
    for t in range(0, min(times[-1], 300 * 10**9) + 1, STEP_NS):
        i = min(bisect.bisect_left(times, t), len(times) - 1)
        a, b = movement[max(i - 1, 0)], movement[i]
        u = (t - (a.ns - movement[0].ns)) / (b.ns - a.ns) if b.ns > a.ns else 0.0
        out.append((a.x + u * (b.x - a.x), a.y + u * (b.y - a.y)))
    return out


def smoothed(values):
    weights = {k: math.exp(-0.5 * (k * STEP_S / 0.02) ** 2) for k in range(-12, 13)}
    total = sum(weights.values())
    last = len(values) - 1
    padded = [values[0]] * 12 + values + [values[last]] * 12
    return [sum(w * padded[i + 12 + k] for k, w in weights.items()) / total
            for i in range(last + 1)]


def derived(values):
    return [(b - a) / (2 * STEP_S) for a, b in zip(values, values[2:])]


def amplitudes(values, size, first, last):
    """The absolute values of the Fourier coefficients first..last of `size` values."""
    turn = [2 * math.pi * k / size for k in range(size)]
    cosines, sines = [math.cos(a) for a in turn], [math.sin(a) for a in turn]
    out = []
    for k in range(first, last + 1):
        at = [k * n % size for n in range(len(values))]
        real = sum(map(operator.mul, values, map(cosines.__getitem__, at)))
        imaginary = sum(map(operator.mul, values, map(sines.__getitem__, at)))
        out.append(math.hypot(real, imaginary))
    return out


def sparc(speed):
    size = 2 ** (math.ceil(math.log2(len(speed))) + 4)
    limit = math.floor(10.0 * STEP_S * size)
    # Speed is never negative, so that no coefficient is larger than the one at 0 Hz.
    spectrum = [a / sum(speed) for a in amplitudes(speed, size, 0, limit)]
    strong = [k for k, a in enumerate(spectrum) if a >= 0.05]
    if len(strong) < 2:
        return None
    part = spectrum[strong[0]:strong[-1] + 1]
    return -math.fsum(math.hypot(1 / (len(part) - 1), b - a) for a, b in pairs(part))


def tremor_share(xs, ys):
    velocity = [derived(xs), derived(ys)]
    n = len(velocity[0])
    centred = [[v - mean(axis) for v in axis] for axis in velocity]
    if not math.sqrt(sum(v * v for axis in centred for v in axis) / n) > 1e-6:
        return None
    size = 2 ** math.ceil(math.log2(n))
    first, last = math.ceil(3 * STEP_S * size), math.floor(12 * STEP_S * size)
    band = total = 0.0
    for axis in centred:
        hann = [v * math.sin(math.pi * i / (n - 1)) ** 2 for i, v in enumerate(axis)]
        band += sum(2 * a * a for a in amplitudes(hann, size, first, last))
        total += size * sum(v * v for v in hann)  # Parseval's theorem
    return band / total


def speed_peaks(speed, least):
    """Counts the highest speeds between two lows, if they are higher by `least` than both."""
    extremes = [speed[0]]  # alternately high and low
    for v in speed[1:]:
        looking_for_high = len(extremes) % 2 == 1
        higher = v > extremes[-1]
        if higher == looking_for_high and v != extremes[-1]:
            extremes[-1] = v
        elif abs(v - extremes[-1]) > least:
            extremes.append(v)
    return len(extremes) // 2


def power_law(velocity, acceleration, top):
    law = []
    for v, a in list(zip(velocity[1:-1], acceleration))[4:-4]:
        speed, turn = math.hypot(*v), abs(cross(v, a))
        if speed >= 0.02 * top and turn >= 0.01 * speed ** 2:
            law.append((math.log(turn) - 3 * math.log(speed), math.log(speed)))
    if len(law) < 10:
        return None, None
    mx, my = mean([x for x, _ in law]), mean([y for _, y in law])
    xx, yy = mean([(x - mx) ** 2 for x, _ in law]), mean([(y - my) ** 2 for _, y in law])
    xy = mean([(x - mx) * (y - my) for x, y in law])
    if xx < 1e-9:
        return None, None
    return xy / xx, xy * xy / (xx * yy) if yy >= 1e-9 else None


def smoothness_metrics(movement):
    if len(movement) < 4 or seconds(movement[0], movement[-1]) < 0.6:
        return {}
    points = every_5_ms(movement)
    x0, y0 = points[0]
    xs, ys = [x - x0 for x, _ in points], [y - y0 for _, y in points]
    vx, vy = derived(smoothed(xs)), derived(smoothed(ys))
    speed = [math.hypot(x, y) for x, y in zip(vx, vy)]
    top = max(speed)
    if not top > 1e-6:
        return {}
    ax, ay = derived(vx), derived(vy)
    duration = STEP_S * len(speed)
    jerk = STEP_S * math.fsum(x * x + y * y for x, y in zip(derived(ax), derived(ay)))
    exponent, r2 = power_law(list(zip(vx, vy)), list(zip(ax, ay)), top)
    return {
        "velocity_peaks_per_s": speed_peaks(speed, 0.02 * top) / duration,
        "sparc": sparc(speed),
        "log_dimensionless_jerk":
            2 * math.log(top) - 3 * math.log(duration) - math.log(jerk) if jerk > 0 else None,
        "power_law_exponent": exponent,
        "power_law_r2": r2,
        "power_share_3_12_hz": tremor_share(xs, ys),
    }


def force_metrics(movement):
    steps = [(a, b) for a, b in pairs(movement) if a.fx is not None and b.fx is not None]
    if not steps:
        return {}
    time = math.fsum(seconds(a, b) for a, b in steps)
    impulse = math.fsum(
        seconds(a, b) * (math.hypot(a.fx, a.fy) + math.hypot(b.fx, b.fy)) / 2 for a, b in steps)
    strong = math.fsum(
        seconds(a, b) * sum(math.hypot(s.fx, s.fy) > 0.5 for s in (a, b)) / 2 for a, b in steps)
    work = math.fsum(
        (a.fx + b.fx) / 2 * (b.x - a.x) + (a.fy + b.fy) / 2 * (b.y - a.y) for a, b in steps)
    return {"force_mean_n": impulse / time, "force_impulse_n_s": impulse, "work_mj": work,
            "force_above_half_n_share": strong / time}


def pressure_metrics(touches):
    values = [s.pressure for touch in touches for s in touch if s.pressure is not None]
    if not values:
        return {}
    m = mean(values)
    return {"pressure_mean": m,
            "pressure_cv": deviation(values) / m if len(values) > 1 and m > 0 else None}


def closing_metrics(ink, closed):
    """`ink`: points with widths for each number of a line; `closed`: numbers of closed lines."""
    if not ink:
        return {}
    ends = [line[i][:2] for n, line in ink.items() if n not in closed for i in (0, -1)]
    loose = [i for i, p in enumerate(ends)
             if not any(dist(p, q) <= 0.01 for k, q in enumerate(ends) if k != i)]
    return {"is_closed": 0.0 if loose else 1.0}


def width_metrics(ink, required):
    widths = []
    for line in ink.values():
        curve = Curve([p[:2] for p in line])
        inner = curve.length - 10.0
        if not inner > 0.0:
            continue
        steps = max(1, math.ceil(inner / 0.5 - 1e-9))
        for k in range(steps + 1):
            s = 5.0 + inner * k / steps
            i = min(max(0, bisect.bisect_left(curve.lengths, s) - 1), len(line) - 2)
            u = (s - curve.lengths[i]) / (curve.lengths[i + 1] - curve.lengths[i])
            widths.append(line[i][2] + u * (line[i + 1][2] - line[i][2]))
    if not widths:
        return {}
    m = mean(widths)
    return {"width_mean_mm": m, "width_err_mm": mean([abs(w - required) for w in widths]),
            "width_cv": deviation(widths) / m}


def erased_length(line, begin, end, pieces):
    """The erased length of a line between two distances along it, and the one that is left."""
    if not end > begin:
        return 0.0, 0.0
    curve, steps = Curve(line), max(1, math.ceil((end - begin) / 0.1 - 1e-9))
    step = (end - begin) / steps
    gone = sum(not pieces or nearest(pieces, curve.at(begin + (k + 0.5) * step)).distance > 0.02
               for k in range(steps))
    return gone * step, (steps - gone) * step


def erasing_metrics(before, span, ink):
    pieces = [pair for line in ink.values() for pair in pairs([p[:2] for p in line])]
    first, length = before[0], Curve(before[0]).length
    lost = [erased_length(line, 0.0, Curve(line).length, pieces)[0]
            for n, line in before.items() if n > 0]
    beyond = [erased_length(first, a, b, pieces)[0] for a, b in ((0.0, span[0]), (span[1], length))]
    return {"erased_extra_mm": math.fsum(beyond + lost),
            "erased_left_mm": erased_length(first, *span, pieces)[1],
            "erased_wrong_lines": sum(mm > 0.1 + 1e-9 for mm in lost)}


def measure(samples, path_points, closed, tunnel, target):
    """Returns a dictionary of the metrics of samples; missing ones are None or absent."""
    good = valid_samples(samples)
    path = Path(path_points, closed)
    metrics = {"samples": len(good), "samples_ignored": len(samples) - len(good)}
    if path.curve:
        metrics["path_length_mm"] = path.curve.length
        metrics["steering_id"] = path.curve.length / tunnel if tunnel else None
    touches = [list(group) for contact, group in itertools.groupby(good, lambda s: s.contact)
               if contact]
    if not touches:
        return metrics
    strokes = [[(s.x, s.y) for s in touch] for touch in touches]
    points = [p for stroke in strokes for p in stroke]
    movement = [s for s in good if touches[0][0].ns <= s.ns <= touches[-1][-1].ns]
    metrics.update(time_metrics(good, touches))
    if path.curve:
        heights = [s.height for touch in touches for s in touch]
        metrics.update(error_metrics(path, strokes, heights, tunnel))
        metrics["frechet_mm"] = frechet_metric(path, points)
        metrics.update(straight_metrics(path, points, target))
        if path.closed:
            metrics["end_gap_mm"] = dist(points[0], points[-1])
    metrics.update(smoothness_metrics(movement))
    metrics.update(force_metrics(movement))
    metrics.update(pressure_metrics(touches))
    return metrics


def number(text):
    return None if text == "NA" else float(text)


class Comparison:
    def __init__(self):
        self.trials = self.values = self.errors = 0
        self.largest = (0.0, "none")
        self.present = collections.Counter()

    def compare(self, trial, expected, actual):
        self.trials += 1
        for name in sorted(set(expected) - set(actual)):
            self.complain(f"trial {trial}: {name} is missing in the C++ library")
        for name, value in actual.items():
            wanted = expected.get(name)
            if (value is None) != (wanted is None):
                self.complain(f"trial {trial}: {name} is {value} in C++, {wanted} in Python")
            elif value is not None:
                self.values += 1
                self.present[name] += 1
                difference = abs(value - wanted)
                self.largest = max(self.largest, (difference, f"{name}, trial {trial}"))
                if not difference <= TOLERANCE:
                    self.complain(f"trial {trial}: {name} is {value} in C++, {wanted} in Python")
            else:
                self.present[name] += 0

    def complain(self, text):
        self.errors += 1
        if self.errors <= 20:
            print(text)

    def report(self):
        print(f"{self.trials} trials, {self.values} values compared; largest difference "
              f"{self.largest[0]:.3g} ({self.largest[1]}); {self.errors} differ")
        never = [name for name, count in self.present.items() if count == 0]
        if self.trials >= 1000 and never:
            self.complain(f"never defined: {', '.join(never)}")
        return self.trials > 0 and self.errors == 0


def main():
    comparison = Comparison()
    for line in sys.stdin:
        kind, *words = line.split()
        if kind == "seed":
            print("seed", words[0])
        elif kind == "trial":
            trial, closed = words[0], words[1] == "closed"
            tunnel, target = number(words[2]), number(words[3])
            path, samples, actual = [], [], {}
            before, ink, closed_ink = {}, {}, set()
        elif kind == "path":
            path.append((float(words[0]), float(words[1])))
        elif kind == "sample":
            samples.append(Sample(int(words[0]), float(words[1]), float(words[2]),
                                  words[3] == "1", *map(number, words[4:])))
        elif kind == "width":
            required = float(words[0])
        elif kind == "erase":
            span = tuple(map(float, words))
        elif kind in ("before", "ink"):
            lines = before if kind == "before" else ink
            lines.setdefault(int(words[0]), []).append(tuple(map(float, words[1:])))
        elif kind == "closed":
            closed_ink.add(int(words[0]))
        elif kind == "metric":
            actual[words[0]] = number(words[1])
        elif kind == "end":
            expected = measure(samples, path, closed, tunnel, target)
            expected.update(closing_metrics(ink, closed_ink))
            expected.update(width_metrics(ink, required))
            expected.update(erasing_metrics(before, span, ink))
            comparison.compare(trial, expected, actual)
    return 0 if comparison.report() else 1


if __name__ == "__main__":
    sys.exit(main())
