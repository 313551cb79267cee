#!/usr/bin/env python3
"""The Hunt-Crossley contact of case C11: depth, times and exit speed, from its invariant.

    pip install mpmath
    python3 hunt_crossley.py

m v' = -k x^n (1 + L v), x' = v from x = 0 at v0. With u = 1 + L v, the sum of u - ln u over L²
and of k x^(n+1)/(m (n+1)) is constant; so x is a function of v, and t an integral over v.
"""

from mpmath import mp, mpf, lambertw, exp, log, quad

mp.dps = 50
M, N, LAMBDA, V0 = mpf("0.01"), mpf("1.5"), mpf("0.6"), mpf(1)


def psi(v):
    u = 1 + LAMBDA * v
    return u - log(u)


def contact(k):
    def depth(v):
        return (M * (N + 1) / (k * LAMBDA**2) * (psi(V0) - psi(v))) ** (1 / (N + 1))

    u0 = 1 + LAMBDA * V0
    exit_speed = (-lambertw(-u0 * exp(-u0)).real - 1) / LAMBDA

    def speed(x, branch):
        level = psi(V0) - k * LAMBDA**2 / (M * (N + 1)) * x ** (N + 1)
        return (-lambertw(-exp(-level), branch).real - 1) / LAMBDA

    def span(end, branch):
        """Time between x = 0 at the speed `end` and the deepest point."""
        # dt = dx/v where v is far from zero, dt = -dv m/(k x^n u) where x is.
        half = end / 2
        outer = quad(lambda x: 1 / abs(speed(x, branch)), [0, depth(half)])
        inner = quad(lambda v: M / (k * depth(v) ** N * (1 + LAMBDA * v)), sorted([half, mpf(0)]))
        return outer + inner

    press, release = span(V0, -1), span(exit_speed, 0)
    return depth(mpf(0)), press, press + release, exit_speed


for k in ("1e5", "1e7"):
    for name, number in zip(("depth", "deepest", "exit", "speed"), contact(mpf(k))):
        print(k, name, mp.nstr(number, 20))
