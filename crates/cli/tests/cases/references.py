"""References of the cases that have no closed form at hand, to be copied into cases.toml.

    pip install scipy mpmath

Times by mpmath's root finding on closed forms where there are some, else by SciPy's DOP853.
"""

import math

import mpmath
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

mpmath.mp.dps = 30


def reaction():
    def rate(_, x, forward=0.75, back=0.25):
        flow = forward * x[0] * x[1] - back * x[2]
        return [-flow, -flow, flow]

    level = lambda _, x: x[0] - 0.75
    level.terminal, level.direction = True, -1
    options = {"method": "DOP853", "rtol": 1e-13, "atol": 1e-15}
    first = solve_ivp(rate, (0.0, 2.0), [1.0, 2.0, 3.0 * 0.0], events=level, **options)
    t = first.t[-1]
    x = first.y[:, -1].copy()
    x[1] = 1.0
    end = solve_ivp(rate, (t, 2.0), x, **options).y[:, -1]
    print("reaction: level", repr(float(t)), "final", [float(it) for it in end])


def parachute():
    # y = 1000 - ln(cosh(sqrt(g k) t)) / k
    t = mpmath.acosh(mpmath.e ** 10) / mpmath.sqrt(mpmath.mpf("0.1"))
    print("parachute: ground", t)


def electron():
    a = mpmath.mpf("1.602176634e-10") / mpmath.mpf("9.1093837015e-31")
    print("electron: anode", mpmath.sqrt(2 * mpmath.mpf("1e-6") / a))


def gravity_off():
    t = mpmath.sqrt(mpmath.mpf(100) / mpmath.mpf("9.8"))
    v = mpmath.sqrt(2 * mpmath.mpf("9.8") * 50)
    print("gravity-off: floor", t, "final y at 15 s", v * (15 - t))


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
    times = [i * 1e-4 for i in range(1, 20000)]
    bracket = next(t for t in times if at(t) < 0.0 <= at(t + 1e-4))
    print("platform: ride", fall, "opens", fall + brentq(at, bracket, bracket + 1e-4, xtol=1e-15))


for reference in [reaction, parachute, electron, gravity_off, platform]:
    reference()
