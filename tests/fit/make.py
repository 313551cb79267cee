#!/usr/bin/env python3
"""Writes published.csv: a static curve of a grand's key as it is published.

Sources: touch weights, dip, damper load and let-off from technicians' figures (down weight 50 gf, up
weight 26 gf, so a friction of 0.118 N; damper load 0.15 N from half travel on; let-off hump of
1.05 N over 8.3 to 9.3 mm of travel; 0.55 N behind it; the felt of the bed from 10 mm on). How the
jack goes back under the knuckle is published nowhere: the way up begins at 7.5 mm.
"""

FRICTION = 0.118  # N, at the key's front
FLAT = 0.372  # N, without friction: balance weight of 38 gf
DAMPER = 0.15  # N
HUMP = (8.3, 8.8, 9.3)  # mm: where it begins, is highest, and ends
TOP = 1.05  # N


def down(mm):
    """Force on the way down (N)."""
    force = FLAT + FRICTION + DAMPER * min(max((mm - 5.0) / 0.5, 0.0), 1.0)
    begin, top, end = HUMP
    if begin <= mm < top:
        force += (TOP - force) * (mm - begin) / (top - begin)
    elif top <= mm:
        force = TOP + (0.55 - TOP) * min((mm - top) / (end - top), 1.0)
    return force


def up(mm):
    """Force on the way up (N)."""
    return down(mm) - 2.0 * FRICTION


rows = [(mm, down(mm)) for mm in (0.1 * step for step in range(5, 100))]
rows += [(mm, up(mm)) for mm in (0.1 * step for step in range(75, 4, -1))]
with open("published.csv", "w", encoding="ascii") as file:
    file.write("travel_m,force_n\n")
    for mm, force in rows:
        file.write(f"{mm * 1e-3:.5f},{force:.4f}\n")
