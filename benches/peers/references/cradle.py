"""A Newton's cradle of five balls: all impacts, and the states between them, in 50 digits.

Ball i hangs from its own point and swings with u'' = -w^2 u about it, u [m] to the right; the
points stand so that balls at rest have the gaps of GAPS [m] between them. At an impact two
neighbours of equal mass exchange their relative speed, times -e. Between impacts all motion
is a cosine, so that impacts are roots in closed form: nothing is integrated.

`python3 cradle.py E` writes cradle-E.json beside itself.
"""

import pathlib
import sys

from mpmath import acos, atan2, cos, hypot, mp, mpf, pi, sin, sqrt

import written

mp.dps = 50
BALLS = 5
W = sqrt(mpf("9.81") / mpf("0.25"))
GAPS = [mpf(gap) for gap in ("1e-4", "1.1e-4", "1.2e-4", "1.3e-4")]
PULLED = mpf("0.05")
T_END = mpf("2.5")
ROW = mpf("0.01")


def flow(u, v, t):
    """Positions and speeds after t [s]."""
    c, s = cos(W * t), sin(W * t)
    return [a * c + b / W * s for a, b in zip(u, v)], [b * c - a * W * s for a, b in zip(u, v)]


def next_impact(u, v):
    """Time until the first impact [s], and the left ball of the pair."""
    found = []
    for i, gap in enumerate(GAPS):
        near, speed = u[i] - u[i + 1], (v[i] - v[i + 1]) / W
        largest = hypot(near, speed)
        if largest <= gap:
            continue
        phase = (atan2(speed, near) - acos(gap / largest)) % (2 * pi)
        # A pair that has just hit leaves its gap: the root at zero is the one behind it.
        if phase < mpf(10) ** -30 or phase > 2 * pi - mpf(10) ** -30:
            raise SystemExit(f"pair {i} touches without a speed")
        found.append((phase / W, i))
    return min(found) if found else (mp.inf, None)


def main(e):
    u, v = [-PULLED] + [mpf(0)] * (BALLS - 1), [mpf(0)] * BALLS
    t, events, rows, row = mpf(0), [], [], 0
    while t < T_END:
        after, pair = next_impact(u, v)
        while row * ROW <= min(t + after, T_END):
            rows.append((row * ROW, sum(flow(u, v, row * ROW - t), [])))
            row += 1
        if t + after > T_END:
            break
        u, v = flow(u, v, after)
        t += after
        mean, half = (v[pair] + v[pair + 1]) / 2, (v[pair + 1] - v[pair]) / 2
        u[pair] = u[pair + 1] + GAPS[pair]
        v[pair], v[pair + 1] = mean + mpf(e) * half, mean - mpf(e) * half
        events.append((t, f"pair{pair}"))
    text = lambda value: mp.nstr(value, 24)
    written.write(pathlib.Path(__file__).with_name(f"cradle-{e}.json"), {
        "parameters": {"w": text(W), "e": e, "pulled": text(PULLED),
                       **{f"gap{i}": text(gap) for i, gap in enumerate(GAPS)}},
        "t_end": text(T_END),
        "events": [{"t": text(t), "guard": guard} for t, guard in events],
        "rows": [[text(t), *map(text, state)] for t, state in rows],
    })
    apart = [float(b[0] - a[0]) for a, b in zip(events, events[1:])]
    print(len(events), "impacts, the closest two", min(apart), "s apart")
    return events


if __name__ == "__main__":
    main(sys.argv[1])
