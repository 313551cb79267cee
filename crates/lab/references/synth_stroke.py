"""Strokes of the synthesizer's key by SciPy, from the numbers of configs/models/synth.toml.

Prints when its lower switch closes, and angle and speed of the key at the end, for the soft stroke
and the forte of `src/scenario/described.rs`. Needs SciPy.
"""

from math import cos, cosh, sin, tanh

from scipy.integrate import solve_ivp
from scipy.optimize import brentq

GRAM_FORCE = 9.80665e-3
G, FRONT, DIP, LOWER = 9.81, 0.18, 0.01, 0.0075
SOFT, FIRM = 50 * GRAM_FORCE, 110 * GRAM_FORCE
KEY, WEIGHT, PIN, K1, B1 = 0.045, 0.012, 0.012, 12000.0, 20.0
WALL, TOP, LOSS = 5.4e5, 1e7, 3.0
INERTIA = (KEY / 3 + WEIGHT) * FRONT**2
GRAVITY = (KEY / 2 + WEIGHT) * G
RATE = (FIRM - SOFT) / DIP


def acceleration(theta, omega, s, rate, touches):
    pressed, arm = FRONT * sin(theta), FRONT * cos(theta)
    speed = arm * omega
    force = K1 * (s - pressed) + B1 * (rate - speed)
    force += GRAVITY - RATE * (pressed + (SOFT + GRAVITY) / RATE)
    if touches == "bed":
        force -= WALL * max(pressed - DIP, 0.0) ** 1.5 * (1 + LOSS * speed)
    if touches == "rest":
        force += TOP * max(-pressed, 0.0) ** 2 * (1 - LOSS * speed)
    return (force * arm - PIN * omega) / INERTIA


def stroke(tc, width, until):
    def derivative(t, x, touches):
        z = (t - tc) / width
        s, rate = DIP * (1 + tanh(z)) / 2, DIP / (2 * width * cosh(z) ** 2)
        return [x[1], acceleration(*x, s, rate, touches)]

    def passes(place):
        event = lambda t, x, touches: FRONT * sin(x[0]) - place
        event.terminal = True
        return event

    rest = brentq(lambda theta: acceleration(theta, 0.0, 0.0, 0.0, "rest"), -1e-2, 0.0, xtol=1e-17)
    t, x, switch = 0.0, [rest, 0.0], None
    for place, touches in [(0.0, "rest"), (LOWER, None), (DIP, None), (DIP, "bed"), (DIP, None)] * 9:
        if t >= until:
            break
        event = passes(place)
        event.direction = -1 if touches == "bed" else 1
        run = solve_ivp(derivative, (t, until), x, "DOP853", args=(touches,), events=[event],
                        rtol=1e-13, atol=1e-16, max_step=1e-3)
        t, x = run.t[-1], run.y[:, -1]
        if place == LOWER and t < until and switch is None:
            switch = t
    return switch, x


for name, terms in {"soft": (0.15, 0.03, 0.35), "forte": (0.06, 0.01, 0.2)}.items():
    switch, (theta, omega) = stroke(*terms)
    print(f"{name}: lower switch at {switch:.15f} s, at the end {theta:.15f} rad, {omega:.3e} rad/s")
