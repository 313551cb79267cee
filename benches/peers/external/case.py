"""The problems, as in src/problems: equations, guards, reset maps; and the parameter file."""

from math import cos, exp, sin


class Case:
    """The parameter file: `name value` lines."""

    def __init__(self, path):
        self.values, self.tolerances, self.samples = {}, [], []
        for line in open(path, encoding="utf-8"):
            name, value = line.split()
            if name == "problem":
                self.problem = value
            elif name == "tolerance":
                self.tolerances.append(float(value))
            elif name == "sample":
                self.samples.append(float(value))
            else:
                self.values[name] = float(value)
        self.t_end, self.budget = self.values["t_end"], 1e-3 * self.values["budget_ms"]


class Ball:
    """State: height and speed."""

    longest_step = float("inf")

    def __init__(self, case):
        self.g, self.e, self.height = (case.values[name] for name in ("g", "e", "height"))

    def start(self):
        return None, [self.height, 0.0]

    def modes(self):
        """By mode: right-hand side, guards (positive while valid), their names."""
        g = self.g
        fall = lambda t, x: [x[1], -g]
        floor = lambda t, x: x[0]
        return {None: (fall, [floor], ["impact"])}

    def fire(self, mode, guard, x):
        return mode, [0.0, -self.e * x[1]]


class ModelB:
    """State: angles of hammer and key, and their rates."""

    def __init__(self, case):
        v = case.values
        self.v = v
        self.rest = [v[f"rest{i}"] for i in range(4)]
        self.bells = [tuple(v[f"bell{3 * i + j}"] for j in range(3)) for i in range(3)]
        self.longest_step = 1 / max(bell[2] for bell in self.bells)

    def start(self):
        return "coupled", list(self.rest)

    def modes(self):
        """By mode: right-hand side, guards (positive while valid), their names."""
        names = "L1 L3 L4 k1 k2 JK JH weight_key weight_hammer string".split()
        l1, l3, l4, k1, k2, jk, jh, key_weight, hammer_weight, string = (self.v[n] for n in names)
        (a1, t1, w1), (a2, t2, w2), (a3, t3, w3) = self.bells

        def drive(t, key):
            z1, z2, z3 = (t - t1) * w1, (t - t2) * w2, (t - t3) * w3
            return k1 * (a1 * exp(-z1 * z1) + a2 * exp(-z2 * z2) + a3 * exp(-z3 * z3) - key)

        def coupled(t, x):
            h, k, hammer_rate, key_rate = x.tolist()
            sin_h, cos_h, sin_k, cos_k = sin(h), cos(h), sin(k), cos(k)
            sin_d = sin_k * cos_h - cos_k * sin_h
            secant = 1 / (cos_k * cos_h + sin_k * sin_h)
            q4 = (l1 * sin_d - l4 * cos_h + l3 * sin_h) * secant
            q3 = (l1 - l3 * cos_k - l4 * sin_k) * secant
            force = k2 * q4
            hammer = (force * q3 * secant - hammer_weight * cos_h) / jh
            key = (drive(t, k) - force * (l1 + q4 * sin_d * secant) - key_weight * cos_k) / jk
            return [hammer_rate, key_rate, hammer, key]

        def apart(t, x):
            h, k, hammer_rate, key_rate = x.tolist()
            key = (drive(t, k) - key_weight * cos(k)) / jk
            return [hammer_rate, key_rate, -hammer_weight * cos(h) / jh, key]

        def gap(t, x):
            h, k = float(x[0]), float(x[1])
            return l4 * cos(h) - l3 * sin(h) - l1 * sin(k - h)

        below = lambda t, x: string - x[0]
        return {
            "coupled": (coupled, [lambda t, x: -gap(t, x), below], ["release", "string"]),
            "apart": (apart, [gap, below], ["land", "string"]),
        }

    def fire(self, mode, guard, x):
        if guard == 0:
            return ("apart" if mode == "coupled" else "coupled"), list(x)
        return mode, [self.v["string"], x[1], -self.v["restitution"] * x[2], x[3]]


def problem(case):
    """The problem that the case asks for."""
    return Ball(case) if case.problem == "ball" else ModelB(case)
