#!/usr/bin/env python3
"""Reference trajectories of model B with stiffer springs, by Taylor series.

    pip install gmpy2
    python3 model_b_stiff.py model-b-stiff-100   100 3   0
    python3 model_b_stiff.py model-b-stiff-10000 1e4 3   11

Arguments: name, factor on k1 and k2, end of the run [s], events after which it is cut off
(0: none). Writes NAME.json and NAME.csv beside this file, in the form of the references of
models/tests/reference. Equations: models/src/key_hammer_springs/README.md.

Each step is the Taylor series of the motion, of order ORDER in BITS bits, over a part of its
radius of convergence; guards are located on the series by bisection and Newton. The second
code, model_b_stiff_check.cc, integrates the same equations by extrapolation in 113 bits and
shares nothing with this file but the parameters; README.md has how closely they agree.
"""

import json
import sys
from pathlib import Path

import gmpy2
from gmpy2 import mpfr

BITS = 240
ORDER = 48
# The last terms of a series are this small beside its first.
TERM = 1e-60
# Guards are looked at in this many places of each step, which spans less than a radian.
LOOKS = 16

gmpy2.get_context().precision = BITS
ZERO, ONE = mpfr(0), mpfr(1)

PARAMETERS = {
    "L1": "0.4", "L2": "1.0", "L3": "0.1", "L4": "0.05", "M1": "6.5", "M2": "0.01",
    "k1": "6.2", "k2": "15", "cK": "0.002", "JK": "0.01625", "JH": "0.01", "g": "9.81",
    "string_angle": "0.398", "restitution": "1",
}
BELLS = [("0.099", "0.514", "0.079"), ("0.181", "1.095", "0.109"), ("0.186", "1.573", "0.059")]
STATES = ["theta_h", "theta_k", "theta_h_dot", "theta_k_dot"]


# A series is a list of coefficients; each function gives the n-th coefficient of its result.

def product(a, b, n):
    return gmpy2.fsum([a[i] * b[n - i] for i in range(n + 1)])


def sine_and_cosine(angle, sin, cos, n):
    """Coefficients n > 0 of sin and cos of a series whose own coefficients are known to n."""
    if n == 0:
        return gmpy2.sin(angle[0]), gmpy2.cos(angle[0])
    terms = [(i * angle[i], n - i) for i in range(1, n + 1)]
    return (gmpy2.fsum([k * cos[j] for k, j in terms]) / n,
            -gmpy2.fsum([k * sin[j] for k, j in terms]) / n)


def quotient(a, b, q, n):
    return (a[n] - gmpy2.fsum([q[i] * b[n - i] for i in range(n)])) / b[0]


def value(series, t):
    total = ZERO
    for coefficient in reversed(series):
        total = total * t + coefficient
    return total


def slope(series, t):
    total = ZERO
    for n in range(len(series) - 1, 0, -1):
        total = total * t + n * series[n]
    return total


def bell_series(t):
    """s around t: each bell solves b' = -2 (t - tc)/w² b."""
    total = [ZERO] * (ORDER + 1)
    for a, tc, w in BELLS:
        z, w2 = t - mpfr(tc), mpfr(w) ** 2
        b = [mpfr(a) * gmpy2.exp(-z * z / w2)]
        for n in range(ORDER):
            before = b[n - 1] if n > 0 else ZERO
            b.append(-2 * (z * b[n] + before) / (w2 * (n + 1)))
        total = [x + y for x, y in zip(total, b)]
    return total


class ModelB:
    def __init__(self, factor):
        p = {name: mpfr(text) for name, text in PARAMETERS.items()}
        p["k1"] *= mpfr(factor)
        p["k2"] *= mpfr(factor)
        self.p = p

    def series(self, mode, t, x):
        """The motion around (t, x), and the series of q4, gap and q3 along it."""
        p = self.p
        l1, l3, l4 = p["L1"], p["L3"], p["L4"]
        s = bell_series(t)
        h, k, hd, kd = ([entry] for entry in x)
        delta = []
        names = "sh ch sk ck sd cd q4 q3 tan inv num3 force lever gap".split()
        v = {name: [] for name in names}
        for n in range(ORDER + 1):
            delta.append(k[n] - h[n])
            for angle, sin, cos in ((h, "sh", "ch"), (k, "sk", "ck"), (delta, "sd", "cd")):
                both = sine_and_cosine(angle, v[sin], v[cos], n)
                v[sin].append(both[0])
                v[cos].append(both[1])
            one = ONE if n == 0 else ZERO
            v["gap"].append(l4 * v["ch"][n] - l3 * v["sh"][n] - l1 * v["sd"][n])
            minus_gap = [-g for g in v["gap"]]
            v["q4"].append(quotient(minus_gap, v["cd"], v["q4"], n))
            v["num3"].append(l1 * one - l3 * v["ck"][n] - l4 * v["sk"][n])
            v["q3"].append(quotient(v["num3"], v["cd"], v["q3"], n))
            torque_h = torque_k = ZERO
            if mode == "B1":
                v["tan"].append(quotient(v["sd"], v["cd"], v["tan"], n))
                v["force"].append(quotient(v["q3"], v["cd"], v["force"], n))
                v["lever"].append(l1 * one + product(v["q4"], v["tan"], n))
                torque_h = p["k2"] * product(v["q4"], v["force"], n)
                torque_k = -p["k2"] * product(v["q4"], v["lever"], n)
            if n == ORDER:
                break
            weight_h = p["M2"] * p["g"] * p["L2"] * v["ch"][n]
            weight_k = p["M1"] * p["g"] * p["cK"] * v["ck"][n]
            spring = p["k1"] * (s[n] - k[n])
            h.append(hd[n] / (n + 1))
            k.append(kd[n] / (n + 1))
            hd.append((torque_h - weight_h) / (p["JH"] * (n + 1)))
            kd.append((spring - weight_k + torque_k) / (p["JK"] * (n + 1)))
        return [h, k, hd, kd], v, s

    def equilibrium(self):
        """At rest in B1 for s = 0: Newton, with central differences in 240 bits."""
        x = [mpfr("-0.2"), mpfr("0")]
        tiny = mpfr(2) ** (-BITS // 3)

        def imbalance(y):
            (_, _, hd, kd), _, s = self.series("B1", ZERO, [y[0], y[1], ZERO, ZERO])
            return [hd[1], kd[1] - self.p["k1"] * s[0] / self.p["JK"]]

        for _ in range(40):
            f = imbalance(x)
            columns = []
            for j in range(2):
                up, down = list(x), list(x)
                up[j] += tiny
                down[j] -= tiny
                up, down = imbalance(up), imbalance(down)
                columns.append([(a - b) / (2 * tiny) for a, b in zip(up, down)])
            (a, c), (b, d) = columns
            determinant = a * d - b * c
            x[0] -= (d * f[0] - b * f[1]) / determinant
            x[1] -= (a * f[1] - c * f[0]) / determinant
        return [x[0], x[1], ZERO, ZERO]

    def reset(self, guard, x):
        if guard == "string":
            return [self.p["string_angle"], x[1], -self.p["restitution"] * x[2], x[3]]
        return x


def radius(series):
    """A step over which the last terms of all series are below TERM of the largest."""
    steps = []
    for s in series:
        size = max(abs(s[0]), abs(s[1]), mpfr("1e-6"))
        for n in (ORDER - 1, ORDER):
            if s[n] != 0:
                steps.append((mpfr(TERM) * size / abs(s[n])) ** (ONE / n))
    return min(steps)


def first_crossing(guard, t_end):
    """First place in (0, t_end] where the series falls through zero, looked at closely."""
    places = [t_end * i / LOOKS for i in range(LOOKS + 1)]
    values = [value(guard, t) for t in places]
    for i in range(LOOKS):
        lo, hi = places[i], places[i + 1]
        if i == 0 and abs(values[0]) < mpfr("1e-50"):
            # Starts at zero: counts from where it has been positive.
            if slope(guard, lo) < 0:
                raise SystemExit("a guard begins at zero and falls")
            lo = (hi - lo) / 2 ** 20
            if value(guard, lo) <= 0 < values[1]:
                raise SystemExit("a guard begins at zero and dips")
        if values[i + 1] > 0:
            # A dip between two positive ends?
            if slope(guard, lo) < 0 < slope(guard, hi):
                a, b = lo, hi
                for _ in range(60):
                    m = (a + b) / 2
                    a, b = (m, b) if slope(guard, m) < 0 else (a, m)
                if value(guard, a) <= 0:
                    return bisect(guard, lo, a)
            continue
        if value(guard, lo) > 0:
            return bisect(guard, lo, hi)
    return None


def bisect(guard, lo, hi):
    for _ in range(60):
        m = (lo + hi) / 2
        lo, hi = (m, hi) if value(guard, m) > 0 else (lo, m)
    t = lo
    for _ in range(8):
        t -= value(guard, t) / slope(guard, t)
    return t


def digits(number, n=24):
    return f"{number:.{n}g}"


def run(factor, t_end, most):
    model = ModelB(factor)
    x, t, mode = model.equilibrium(), ZERO, "B1"
    events, rows, sample = [], [], 0
    t_end = mpfr(t_end)
    closest = None
    while True:
        motion, v, s = model.series(mode, t, x)
        h = min(radius(motion), t_end - t)
        string = [model.p["string_angle"] - motion[0][0]] + [-c for c in motion[0][1:]]
        guards = {"string": string, "release" if mode == "B1" else "land":
                  v["q4"] if mode == "B1" else v["gap"]}
        crossings = [(first_crossing(g, h), name) for name, g in guards.items()]
        crossings = sorted((c, name) for c, name in crossings if c is not None)
        step = crossings[0][0] if crossings else h
        while sample * mpfr("0.01") <= t + step and sample * mpfr("0.01") <= t_end:
            tau = sample * mpfr("0.01") - t
            rows.append(row(model, mode, sample, [value(c, tau) for c in motion], tau, v, s))
            sample += 1
        x = [value(c, step) for c in motion]
        t += step
        if not crossings:
            if t >= t_end:
                break
            continue
        name = crossings[0][1]
        after = model.reset(name, x)
        to = {"release": "B2", "land": "B1"}.get(name, mode)
        events.append({
            "t": digits(t), "guard": name, "to": to,
            "before": dict(zip(STATES, (digits(e, 20) for e in x))),
            "after": dict(zip(STATES, (digits(e, 20) for e in after))),
            "from": mode,
        })
        print(len(events), digits(t), name, mode, "->", to, flush=True)
        x, mode = after, to
        if most and len(events) == most:
            # On for a row or two, up to a row.
            most, t_end = 0, min(t_end, gmpy2.floor(100 * t + 2) / 100)
            closest = len(events)
    if closest is not None and len(events) > closest:
        raise SystemExit("another event follows within 0.02 s")
    return model, events, rows, t_end


def row(model, mode, sample, x, tau, v, s):
    q4, q3 = value(v["q4"], tau), value(v["q3"], tau)
    position = value(s, tau)
    torque = model.p["k1"] * (position - x[1])
    force = model.p["k2"] * q4 if mode == "B1" else ZERO
    gap = value(v["gap"], tau)
    # Apart, the spring is slack and the slider is nowhere on the hammer.
    q4, q3 = (q4, q3) if mode == "B1" else (ZERO, ZERO)
    numbers = [*x, position, force, torque, gap, q4, q3]
    return ",".join([f"{sample / 100:.3f}", mode, *(digits(n, 18) for n in numbers)])


def main():
    name, factor, t_end, most = sys.argv[1:]
    model, events, rows, t_end = run(factor, t_end, int(most))
    parameters = {key: float(number) for key, number in model.p.items()}
    case = {
        "case": name,
        "model": "key-hammer-springs",
        "parameters": parameters,
        "input": {
            "s": "sum A exp(-((t-tc)/w)^2)",
            "A_tc_w": [[float(x) for x in bell] for bell in BELLS],
        },
        "start": "at rest in B1 at the equilibrium for s = 0",
        "t_end": digits(t_end, 17),
        "cross_check": "see README.md",
        "events": events,
    }
    here = Path(__file__).parent
    (here / f"{name}.json").write_text(json.dumps(case, indent=1) + "\n")
    header = "t,mode,theta_h,theta_k,theta_h_dot,theta_k_dot,s,F_KH,T_KU,gap,q4,q3"
    (here / f"{name}.csv").write_text("\n".join([header, *rows]) + "\n")


main()
