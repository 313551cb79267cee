"""Motions of free linkages by MuJoCo, beside those that were found from descriptions.

An open chain is stepped here by the same method as there, RK4 in steps of the same length, so that
nothing but rounding keeps both apart. MuJoCo's equality constraints are soft: a violation falls
back with the time constant 2 h here, and the reference acceleration is met to 1 - 0.9999. That
error falls with h, so a closed linkage is run with h and h/2, whose difference is what is left at
h/2: both may be apart by twice as much. Ours is run with two steps as well. Fails where a motion
is further off, and where a difference is too large to be a measure.
"""

import json
import sys

import mujoco
import numpy as np

# Relative to the largest angle and rate: what rounding may do, and what is no measure any more.
ROUNDING = 1e-11
COARSEST = 1e-5

# Longest step of a closed linkage (s).
CLOSED = 1e-5


def document(text, step):
    bodies = text["bodies"]

    def body(index):
        it = bodies[index]
        spring = text["spring"] if text["spring"]["joint"] == index else None
        law = "" if spring is None else 'stiffness="%.17g" springref="%.17g" damping="%.17g"' % (
            spring["stiffness"], spring["rest"], spring["damping"])
        inside = "".join(body(k) for k, other in enumerate(bodies) if other["parent"] == index)
        inertia = "%.17g" % it["inertia"]
        return """<body name="b%d" pos="%.17g %.17g 0">
          <joint name="j%d" type="hinge" axis="0 0 1" %s/>
          <inertial pos="%.17g %.17g 0" mass="%.17g" diaginertia="%s %s %s"/>%s</body>""" % (
            index, *it["at"], index, law, *it["centre"], it["mass"],
            inertia, inertia, inertia, inside)

    roots = "".join(body(k) for k, it in enumerate(bodies) if it["parent"] < 0)
    connect = ""
    if "connect" in text:
        first, second = text["connect"]["bodies"]
        connect = """<equality><connect body1="b%d" body2="b%d" anchor="%.17g %.17g 0"
          solref="%.17g 1" solimp="0.9999 0.9999 0.001"/></equality>""" % (
            first, second, *text["connect"]["at"], 2 * step)
    return """<mujoco><compiler angle="radian" autolimits="true"/>
      <option timestep="%.17g" integrator="RK4" gravity="0 -9.81 0" solver="Newton"
        iterations="100" tolerance="1e-15" cone="elliptic" jacobian="dense"/>
      <worldbody>%s</worldbody>%s</mujoco>""" % (step, roots, connect)


def motion(text, step):
    """Angles and rates at the times of the rows."""
    # An anchor is looked up in the pose of the document, so that the pose comes first.
    start = np.array(text["rows"][0])
    n = len(text["bodies"])
    model = mujoco.MjModel.from_xml_string(document(text, step))
    data = mujoco.MjData(model)
    data.qpos[:], data.qvel[:] = start[1:1 + n], start[1 + n:]
    if "connect" in text:
        mujoco.mj_kinematics(model, data)
        anchor = np.array([*text["connect"]["at"], 0.0])
        first, second = (1 + it for it in text["connect"]["bodies"])
        place = data.xpos[first] + data.xmat[first].reshape(3, 3) @ anchor
        other = data.xmat[second].reshape(3, 3).T @ (place - data.xpos[second])
        model.eq_data[0, :3], model.eq_data[0, 3:6] = anchor, other
    found, steps = [], 0
    for row in text["rows"]:
        wanted = round((row[0] - start[0]) / step)
        while steps < wanted:
            mujoco.mj_step(model, data)
            steps += 1
        found.append(np.concatenate([data.qpos, data.qvel]))
    return np.array(found)


def main():
    with open(sys.argv[1]) as file:
        cases = json.load(file)
    good = True
    for text in cases:
        rows, other = (np.array(text[it])[:, 1:] for it in ("rows", "coarse"))
        size = np.maximum(1.0, np.abs(rows).max(axis=0))

        def apart(one, two):
            return (np.abs(one - two) / size).max()

        own = apart(rows, other)
        if "connect" in text:
            coarse, fine = motion(text, CLOSED), motion(text, CLOSED / 2)
            measure = apart(coarse, fine)
            allowed = 2 * measure + own
        else:
            fine = motion(text, text["step"])
            measure, allowed = 0.0, ROUNDING
        moved = np.abs(rows - rows[0]).max(axis=0)
        print("%s: %d looks, moved by %s rad, deviation %.1e of %.1e; MuJoCo between steps %.1e, "
              "ours %.1e" % (
                  text["name"], len(rows), np.array2string(moved[:len(text["bodies"])], precision=2),
                  apart(fine, rows), allowed, measure, own), flush=True)
        good &= bool(apart(fine, rows) <= allowed and max(measure, own) <= COARSEST)
        good &= bool((moved[:len(text["bodies"])] > 0.3).all())
    return 0 if good and cases else 1


if __name__ == "__main__":
    sys.exit(main())
