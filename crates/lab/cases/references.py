"""Writes the references of cases.json: the numbers that are no round figures.

    pip install scipy mpmath
    python3 references.py          writes them
    python3 references.py --check  prints those that differ

Closed forms are evaluated by mpmath with 30 digits. Trajectories without one come from SciPy's
DOP853 at a tolerance of 1e-13, in coordinates of their own.
"""

import json
import math
import sys
from pathlib import Path

from mpmath import mp, mpf
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

mp.dps = 30
G = mpf("9.81")
EXACT = {"method": "DOP853", "rtol": 1e-13, "atol": 1e-15}


def impacts(e, height=1, gravity=G, until=None, most=10, apart=mpf("0.02")):
    """Impacts of a bouncing ball that are farther apart than `apart`, and the end of all."""
    first = mp.sqrt(2 * mpf(height) / gravity)
    t, flight, found = first, 2 * first * mpf(e), []
    while len(found) < most and apart * first < flight and (until is None or t < until):
        found.append(("floor", t))
        t, flight = t + flight, flight * mpf(e)
    return found, first * (1 + mpf(e)) / (1 - mpf(e))


def bounces(e, height=1):
    begins, end = impacts(e, height)
    return {"begins": begins, "ends": [("settled", end)], "final": {"y": 0, "y'": 0}}


def in_flight(e, height, until):
    """State of a ball in flight at `until`, with its impacts until then."""
    t = mp.sqrt(2 * mpf(height) / G)
    speed, events = G * t, []
    while t < until:
        events.append(("floor", t))
        start, speed = t, speed * mpf(e)
        t += 2 * speed / G
    age = until - start
    return events, speed * age - G * age**2 / 2, speed - G * age


def graze(d):
    middle, depth = mpf("0.123456789"), mp.sqrt(mpf(d))
    return {"events": [("touches", middle - depth), ("leaves", middle + depth)]}


def two_balls():
    # Impacts at one time are one event, of the first contact.
    first, _ = impacts("0.8", until=mpf("3.5"))
    other, _ = impacts("0.8", height="6.76", until=mpf("3.5"))
    other = [("floor_b", t) for _, t in other[1:]]
    events = sorted([("floor_a", t) for _, t in first] + other, key=lambda it: it[1])
    _, b, speed = in_flight("0.8", "6.76", mpf("3.5"))
    return {"begins": [it for it in events if it[1] < 3.45], "final": {"b": b, "b'": speed}}


def flat_box():
    return {"events": [("left", mp.sqrt(2 / G))], "final": {"a": 0, "y": 0, "y'": 0}}


def contact(k):
    # A mass of 1 kg at 1 m/s against a spring 0.1 m away, for half a period.
    return {"final": {"x": mpf("0.1") - (mpf("0.5") - mpf("0.1") - mp.pi / mp.sqrt(mpf(k))), "x'": -1}}


def pulse(width):
    return {"final": {"x": mpf("1e4") * mpf(width)}}


def slide(speed, mu):
    brake = mpf(mu) * G
    stop = abs(mpf(speed)) / brake
    events = [("floor", 0), ("floor_friction", stop)]
    return {"events": events, "final": {"x": mpf(speed) * stop / 2, "x'": 0}}


def oscillator(until):
    return {"final": {"x": mp.cos(mpf(until)), "x'": -mp.sin(mpf(until))}}


def jump(at, until=3):
    age = mpf(until) - mpf(at)
    return {"final": {"x": 1 - mp.cos(age), "x'": mp.sin(age)}}


def input_pulse():
    one, other = jump("0.7001")["final"], jump("0.7011")["final"]
    return {"final": {name: 100 * (one[name] - other[name]) for name in one}}


def filippov():
    events = [("switch_1", 2 - mp.sqrt(2)), ("switch_1", 2)]
    return {"events": events, "final": {"x": mpf(1) / 2, "y": mpf(7) / 3}}


def world(height):
    begins, end = impacts("0.8", height)
    return {"begins": begins, "ends": [("settled", end)]}


def reaction():
    def rate(_, x, forward=0.75, back=0.25):
        flow = forward * x[0] * x[1] - back * x[2]
        return [-flow, -flow, flow]

    level = lambda _, x: x[0] - 0.75
    level.terminal, level.direction = True, -1
    first = solve_ivp(rate, (0.0, 2.0), [1.0, 2.0, 0.0], events=level, **EXACT)
    x = first.y[:, -1].copy()
    x[1] = 1.0
    end = solve_ivp(rate, (first.t[-1], 2.0), x, **EXACT).y[:, -1]
    return {"events": [("level", first.t[-1])], "final": dict(zip("abc", end))}


def parachute():
    # y = 1000 - ln(cosh(sqrt(g k) t)) / k
    return {"events": [("ground", mp.acosh(mp.e ** 10) / mp.sqrt(mpf("0.1")))], "final": {"y": 0}}


def electron():
    a = mpf("1.602176634e-10") / mpf("9.1093837015e-31")
    return {"events": [("anode", mp.sqrt(2 * mpf("1e-6") / a))]}


def gravity_off():
    t = mp.sqrt(mpf(100) / mpf("9.8"))
    speed = mp.sqrt(2 * mpf("9.8") * 50)
    return {"events": [("floor", t), ("speed", t)], "final": {"y": speed * (15 - t)}}


def fifty_seconds():
    t = mp.sqrt(mpf(100) / mpf("9.8"))
    return {"events": [("floor", n * t) for n in range(1, 16, 2)]}


def platform():
    # Ball of 1 kg on a platform of 0.5 kg and 200 N/m: plastic impact, ride, and separation where
    # the platform alone would be slower, that is where the spring is at its natural length.
    g, k, m, p = 9.81, 200.0, 1.0, 0.5
    rest = -p * g / k
    fall = math.sqrt(2 * (0.5 - rest) / g)
    speed = -g * fall * m / (m + p)
    omega = math.sqrt(k / (m + p))
    middle = -(m + p) * g / k
    at = lambda t: middle + (rest - middle) * math.cos(omega * t) + speed / omega * math.sin(omega * t)
    bracket = next(t for t in (i * 1e-4 for i in range(1, 20000)) if at(t) < 0.0 <= at(t + 1e-4))
    leaves = fall + brentq(at, bracket, bracket + 1e-4, xtol=1e-15)
    return {"events": [("ride", fall), ("ride_opens", leaves)]}


def pendulum(length, angle, rate, until):
    """Angle from the downward vertical, in the angle itself."""
    swing = lambda _, x: [x[1], -9.81 / length * math.sin(x[0])]
    a, w = solve_ivp(swing, (0.0, until), [angle, rate], **EXACT).y[:, -1]
    return {"final": {"x": length * math.sin(a), "y": -length * math.cos(a)}}


def bead(speed, until):
    """Angle from the top until the normal force is zero, then a parabola."""
    slides = lambda _, x: [x[1], 9.81 * math.sin(x[0])]
    leaves = lambda _, x: 9.81 * math.cos(x[0]) - x[1] ** 2
    leaves.terminal = True
    it = solve_ivp(slides, (0.0, until), [0.0, speed], events=leaves, **EXACT)
    (a, w), t = it.y[:, -1], it.t[-1]
    assert abs(math.cos(a) - (2 + speed**2 / 9.81) / 3) < 1e-12
    age = until - t
    x = math.sin(a) + w * math.cos(a) * age
    y = math.cos(a) - w * math.sin(a) * age - 9.81 * age**2 / 2
    return {"events": [("hill", 0), ("hill_opens", t)], "final": {"x": x, "y": y}}


def crank(rod, rate, until=20.0, radius=0.1, start=0.3):
    """Energy is constant, which gives the rate over the crank's angle."""
    slider = lambda a: radius * math.cos(a) + math.sqrt(rod**2 - (radius * math.sin(a)) ** 2)

    def slope(a):
        root = math.sqrt(rod**2 - (radius * math.sin(a)) ** 2)
        return -radius * math.sin(a) * (1 + radius * math.cos(a) / root)

    inertia = lambda a: 0.01 + 2.0 * slope(a) ** 2
    constant = inertia(start) * rate**2
    turn = lambda _, a: [math.sqrt(constant / inertia(a[0]))]
    a = solve_ivp(turn, (0.0, until), [start], max_step=0.01, **EXACT).y[0, -1]
    return {"final": {"a": a, "x": slider(a)}}


def rod(speed, mu, until, start=1.0, half=0.5):
    """The rod's lower end slides; force and slip of its end stay positive."""
    inertia = half**2 / 3

    def rate(_, x):
        _, v, a, w = x
        # y = half sin(a): m (y'' + g) = n, and I a'' = -n half (cos(a) + mu sin(a)).
        arm = half * (math.cos(a) + mu * math.sin(a))
        n = (9.81 - half * w**2 * math.sin(a)) / (1 + half * math.cos(a) * arm / inertia)
        assert n > 0 and v + half * w * math.sin(a) > 0
        return [v, -mu * n, w, -n * arm / inertia]

    x, v, a, w = solve_ivp(rate, (0.0, until), [0.0, speed, start, 0.0], **EXACT).y[:, -1]
    return {"final": {"x": x, "a": a, "y": half * math.sin(a), "x'": v, "a'": w}}


def hunt(speed, damping, stiffness, mass=0.01, gap=1e-3, until=0.02):
    """With u = 1 + c x', u - ln(u) is the same before and after; SciPy has the duration."""
    u = 1 + mpf(damping) * mpf(speed)
    after = (-mp.lambertw(-u * mp.exp(-u), 0).real - 1) / mpf(damping)
    c, k = float(damping), float(stiffness)
    rate = lambda _, x: [x[1], -k / mass * max(x[0], 0.0) ** 1.5 * (1 + c * x[1])]
    leaves = lambda _, x: x[0]
    leaves.terminal, leaves.direction = True, -1
    start = [0.0, float(speed)]
    it = solve_ivp(rate, (0.0, 1.0), start, events=leaves, max_step=1e-5, **EXACT)
    assert abs(it.y[1, -1] - after) < 1e-9
    closes = gap / float(speed)
    opens = closes + it.t[-1]
    x = gap + after * (until - opens)
    return {"events": [("felt", closes), ("felt", opens)], "final": {"x": x, "x'": after}}


def swing(restitution="0.9", most=10):
    amplitude, t, events = mpf("1.2"), mpf(0), []
    for number in range(most):
        quarter = mp.ellipk(mp.sin(amplitude / 2) ** 2) / mp.sqrt(G)
        t += quarter if number == 0 else 2 * quarter
        events.append(("wall", t))
        speed = mpf(restitution) * 2 * mp.sqrt(G) * mp.sin(amplitude / 2)
        amplitude = 2 * mp.asin(speed / (2 * mp.sqrt(G)))
    return {"events": events}


def shaker(until="0.06"):
    table = lambda t: mpf("0.002") * mp.sin(40 * mp.pi * t)
    speed = lambda t: mpf("0.08") * mp.pi * mp.cos(40 * mp.pi * t)
    opens = mp.asin(G / (mpf("0.002") * (40 * mp.pi) ** 2)) / (40 * mp.pi)
    ball = lambda t, at: table(at) + speed(at) * (t - at) - G * (t - at) ** 2 / 2
    lands = mp.findroot(lambda t: ball(t, opens) - table(t), mpf("0.0519"))
    again = opens + mpf("0.05")
    events = [("table", 0), ("table_opens", opens), ("table", lands), ("table_opens", again)]
    return {"events": events, "final": {"y": ball(mpf(until), again)}}


def belt():
    """Sticks until the spring has 5 N, then slides about the equilibrium under 3 N."""
    stick, omega, speed = mpf(5) / 100, mpf(10), mpf("0.1")
    # A mass at rest slips until it has the belt's speed.
    middle = mpf("0.03")
    catch = mp.asin(speed / (middle * omega)) / omega
    at = middle * (1 - mp.cos(omega * catch))
    slips = catch + (stick - at) / speed
    return {"begins": [("belt", 0), ("belt", catch), ("belt", slips)]}


def dry():
    """Half swings about +-0.02 m, each 0.04 m shorter, until the spring holds less than 2 N."""
    shift, x, speed, side = mpf("0.02"), mpf(0), mpf(5), 1
    reach = mp.sqrt((x + shift) ** 2 + speed**2 / 100) - shift
    while reach > shift:
        reach, side = reach - 2 * shift, -side
    return {"final": {"x": side * reach, "x'": 0}}


def cylinder():
    v = mpf(2) / 3 * G * mp.sin(mp.radians(20)) * 2
    return {"final": {"x": v, "phi'": v / mpf("0.1")}}


REFERENCES = {
    "a reaction that is topped up": reaction,
    "a fall with drag": parachute,
    "femtoseconds": electron,
    "an impact that turns a speed": gravity_off,
    "a ball for fifty seconds": fifty_seconds,
    "a ball on a springy platform": platform,
    "a condition on places stated in speeds": cylinder,
    "stick and slip on a belt": belt,
    "dry friction by a sign": dry,
    "a pendulum in x and y": lambda: pendulum(1.0, math.pi / 2, 0.0, 20.0),
    "a pendulum in x and y from below": lambda: pendulum(1.0, 0.0, 7.0, 5.0),
    "a long pendulum in x and y": lambda: pendulum(2.0, math.pi / 2, -2.5, 20.0),
    "a crossing of 1 ms by a platform": lambda: graze("1e-6"),
    "a crossing of 0.1 ms by a platform": lambda: graze("1e-8"),
    "a crossing of 0.01 ms by a platform": lambda: graze("1e-10"),
    "endless bounces of restitution 0.5": lambda: bounces("0.5"),
    "endless bounces of restitution 0.8": lambda: bounces("0.8"),
    "endless bounces of restitution 0.9": lambda: bounces("0.9"),
    "ticks near 2^52": lambda: bounces("0.8"),
    "two balls that land at one time": two_balls,
    "a box that lands flat without rebound": flat_box,
    "a contact of 1e5 N/m": lambda: contact("1e5"),
    "a contact of 1e8 N/m": lambda: contact("1e8"),
    "a contact of 1e12 N/m": lambda: contact("1e12"),
    "a felt of 1e5 N/m": lambda: contact("1e5"),
    "a felt of 1e8 N/m": lambda: contact("1e8"),
    "a felt of 1e12 N/m": lambda: contact("1e12"),
    "a bead off a round hill at 0.5 m/s": lambda: bead(0.5, 1.2),
    "a bead off a round hill at 2 m/s": lambda: bead(2.0, 0.6),
    "a slider-crank with a rod of 0.25 m": lambda: crank(0.25, 5.0),
    "a slider-crank with a rod of 0.11 m": lambda: crank(0.11, 8.0),
    "a block that a rough floor brakes": lambda: slide("3", "0.3"),
    "a block on a floor of friction 1": lambda: slide("-4", "1"),
    "a rod that slides on its end": lambda: rod(2.0, 0.2, 0.3),
    "a switching surface that lets go": filippov,
    "a relay at a long step": lambda: {"final": {"x": 0}},
    "an input that jumps": lambda: jump("0.55"),
    "an input that jumps at a tick": lambda: jump("0.5"),
    "a pulse of 1 ms": lambda: pulse("0.001"),
    "a pulse of 1 us": lambda: pulse("1e-6"),
    "a pulse of the input": input_pulse,
    "1e5 ticks of an oscillator": lambda: oscillator("1000"),
    "1e7 ticks of an oscillator": lambda: oscillator("1e5"),
    "an oscillator near tick 2^52": lambda: oscillator("100"),
    "a felt of exponent 1.5 at 1 m/s": lambda: hunt("1", "0.6", "1e5"),
    "a felt of exponent 1.5 at 5 m/s": lambda: hunt("5", "0.1", "1e7"),
    "a pendulum at a wall": swing,
    "a ball on a table that shakes": shaker,
    "a world of 1 nm": lambda: world("1e-9"),
    "a world of 1e6 m": lambda: world("1e6"),
}


def numbers(reference):
    pairs = lambda all: [[name, float(t)] for name, t in all]
    named = lambda all: {name: float(value) for name, value in all.items()}
    return {key: (named if key == "final" else pairs)(value) for key, value in reference.items()}


def main():
    path = Path(__file__).with_name("cases.json")
    cases = json.loads(path.read_text())
    for case in cases:
        found = numbers(REFERENCES[case["name"]]()) if case["name"] in REFERENCES else {}
        for key, value in found.items():
            if case["expected"].get(key) != value:
                print(f"{case['name']}: {key} {case['expected'].get(key)} -> {value}")
        case["expected"].update(found)
    unknown = REFERENCES.keys() - {case["name"] for case in cases}
    assert not unknown, unknown
    if "--check" not in sys.argv:
        rows = ",\n".join("  " + json.dumps(case, ensure_ascii=False) for case in cases)
        path.write_text(f"[\n{rows}\n]\n")


main()
