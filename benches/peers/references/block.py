"""A block that rocks, slides and sticks: all events, and the states between them.

A rectangle of half width A and half height B [m] falls on a level floor with Coulomb friction,
its lower left corner down, tilted and sliding to the right. In each mode one corner touches:
it sticks, or it slides. The five unknowns of a mode (accelerations of the centre and of the
angle, friction, normal force; all over the mass) come from five linear equations, and so do
impulse and speeds of an impact; Gragg's midpoint rule with extrapolation integrates them, and
Newton's method shortens the step that has an event. The impact of the other corner is plastic
(restitution 0), with Coulomb's law for its impulse.

The whole is done with two orders of extrapolation, and their difference printed.
`python3 block.py` writes block.json beside itself.
"""

import pathlib

from mpmath import cos, lu_solve, matrix, mp, mpf, sin

import written

mp.dps = 40
A, B, G, MU = mpf("0.05"), mpf("0.1"), mpf("9.81"), mpf("0.3")
INERTIA = (A**2 + B**2) / 3
START, FIRST = [mpf(0), mpf("0.25"), mpf("0.5"), mpf(0)], (-1, 1)
T_END, ROW = mpf("0.58"), mpf("0.01")


def arm(corner, angle):
    """From the centre to the corner [m]."""
    x, y = corner * A, -B
    return x * cos(angle) - y * sin(angle), x * sin(angle) + y * cos(angle)


def unknowns(mode, x):
    """ax, ay, turn, friction, normal force."""
    corner, slides = mode
    (px, py), rate = arm(corner, x[1]), x[3]
    sticks = slides == 0
    rows = [
        [1, 0, 0, -1, 0],
        [0, 1, 0, 0, -1],
        [0, 0, INERTIA, py, -px],
        [0, 1, px, 0, 0],
        [1, 0, -py, 0, 0] if sticks else [0, 0, 0, 1, MU * slides],
    ]
    return lu_solve(matrix(rows), matrix([0, -G, 0, rate**2 * py, rate**2 * px if sticks else 0]))


def derivative(mode, x):
    found = unknowns(mode, x)
    return [x[2], x[3], found[0], found[2]]


def step(mode, x, h, columns):
    """Gragg's midpoint rule with 2, 4, 6, … parts, extrapolated."""
    table = []
    for j in range(columns):
        n = 2 * (j + 1)
        part = h / n
        before, now = x, [a + part * b for a, b in zip(x, derivative(mode, x))]
        for _ in range(n - 1):
            rate = derivative(mode, now)
            before, now = now, [a + 2 * part * b for a, b in zip(before, rate)]
        rate = derivative(mode, now)
        row = [[(a + b + part * c) / 2 for a, b, c in zip(now, before, rate)]]
        for k in range(j):
            ratio = (mpf(n) / (n - 2 * (k + 1))) ** 2 - 1
            row.append([a + (a - b) / ratio for a, b in zip(row[k], table[k])])
        table = row
    return table[-1]


def sliding(mode, x):
    """Speed of the corner along the floor [m/s]."""
    return x[2] - x[3] * arm(mode[0], x[1])[1]


def guards(mode, x):
    """Positive while the mode holds."""
    corner, slides = mode
    if slides:
        return {"impact": -corner * x[1], "stick": slides * sliding(mode, x)}
    friction, normal = unknowns(mode, x)[3:]
    return {"impact": -corner * x[1], "slip": MU * normal - abs(friction)}


def stopped(corner, x):
    """The mode after a corner has lost its speed."""
    friction, normal = unknowns((corner, 0), x)[3:]
    if abs(friction) <= MU * normal:
        return (corner, 0)
    return (corner, -1 if friction > 0 else 1)


def impact(corner, x):
    """Speeds and impulses from linear equations: vx, vy, rate, along, up; then the mode."""
    up = -x[3] * arm(-corner, mpf(0))[0]
    px, py = corner * A, -B

    def solve(last, right):
        rows = [[1, 0, 0, -1, 0], [0, 1, 0, 0, -1], [0, 0, INERTIA, py, -px], [0, 1, px, 0, 0]]
        return lu_solve(matrix(rows + [last]), matrix([x[2], up, INERTIA * x[3], 0, right]))

    slides, found = 0, solve([1, 0, -py, 0, 0], 0)
    if abs(found[3]) > MU * found[4]:
        slides = -1 if found[3] > 0 else 1
        found = solve([0, 0, 0, 1, MU * slides], 0)
        assert slides * (found[0] - found[2] * py) > 0
    assert found[1] - found[2] * px > 0, "the corner that was down must rise"
    x = [x[0], mpf(0), found[0], found[2]]
    return (stopped(corner, x) if slides == 0 else (corner, slides)), x


def fire(mode, guard, x):
    if guard == "impact":
        return impact(-mode[0], x)
    x = [x[0], x[1], x[3] * arm(mode[0], x[1])[1], x[3]]
    if guard == "slip":
        return (mode[0], -1 if unknowns(mode, x)[3] > 0 else 1), x
    return stopped(mode[0], x), x


def first_event(mode, x, h, names, columns):
    """Length of the step to the first event, its name, and the state there."""
    found = []
    for name in names:
        value = lambda length: guards(mode, step(mode, x, length, columns))[name]
        low, high = mpf(0), h
        for _ in range(12):
            middle = (low + high) / 2
            low, high = (middle, high) if value(middle) > 0 else (low, middle)
        root = mp.findroot(value, (low, high), solver="anderson", tol=mpf(10) ** -60)
        found.append((root, name))
    length, name = min(found)
    return length, name, step(mode, x, length, columns)


def run(columns):
    mode, x, t, row = FIRST, START, mpf(0), 1
    events, rows = [], [(mpf(0), START)]
    while t < T_END:
        h = row * ROW - t
        end = step(mode, x, h, columns)
        assert unknowns(mode, end)[4] > 0, "the block leaves the floor"
        fallen = [name for name, value in guards(mode, end).items() if value <= 0]
        if fallen:
            h, name, x = first_event(mode, x, h, fallen, columns)
            t += h
            events.append((t, name))
            mode, x = fire(mode, name, x)
        else:
            t, x, row = row * ROW, end, row + 1
            rows.append((t, x))
    return events, rows


def main():
    (events, rows), (others, _) = run(13), run(11)
    off = max(abs(a[0] - b[0]) for a, b in zip(events, others))
    print([(mp.nstr(t, 8), name) for t, name in events], "off by", mp.nstr(off, 3))
    text = lambda value: mp.nstr(value, 24)
    parameters = {"a": A, "b": B, "g": G, "mu": MU, "corner": FIRST[0], "slides": FIRST[1],
                  **{f"start{i}": value for i, value in enumerate(START)}}
    written.write(pathlib.Path(__file__).with_name("block.json"), {
        "parameters": {name: text(mpf(value)) for name, value in parameters.items()},
        "t_end": text(T_END),
        "events": [{"t": text(t), "guard": guard} for t, guard in events],
        "rows": [[text(t), *map(text, state)] for t, state in rows],
    })


if __name__ == "__main__":
    main()
