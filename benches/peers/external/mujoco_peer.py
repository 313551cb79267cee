"""MuJoCo on the bouncing ball: a sphere on a slide joint above a plane.

Contacts in MuJoCo are soft and last for several steps; there is no coefficient of
restitution. default: the scene as it comes (2 ms, solref 0.02 1): the ball does not bounce.
best, as its documentation ("Solver parameters") has it: solref in its direct form (negative
stiffness and damping), RK4, impedance near 1. Stiffness is set so that a contact lasts 50
steps, and damping is found by bisection so that the first impact has e = 0.8. What remains is
the time that the contacts take, which no setting removes: it is in the event error.
An impact is the instant of first touch, located on the free fall before it.

Timed is `rollout`, which steps in C; a row is one run of it. Prints one line of JSON per row.
"""

import json
import math
import sys
import time

import mujoco
import numpy as np
from mujoco import rollout

from case import Case, problem

STEPS_PER_CONTACT = 50
SCENE = """<mujoco>
  <option timestep="{dt}" gravity="0 0 -{g}" integrator="{integrator}"/>
  <worldbody>
    <geom type="plane" size="1 1 1" condim="1" {contact}/>
    <body pos="0 0 {radius}">
      <joint type="slide" axis="0 0 1"/>
      <geom type="sphere" size="{radius}" mass="1" condim="1" {contact}/>
    </body>
  </worldbody>
</mujoco>"""


def model(it, dt, integrator, contact):
    """The scene; the joint's position is the ball's height above the floor."""
    scene = SCENE.format(dt=dt, g=it.g, integrator=integrator, contact=contact, radius=0.1)
    return mujoco.MjModel.from_xml_string(scene)


def roll(scene, height, speed, steps):
    """Heights and speeds after each of `steps`, and the time that it took [ns]."""
    data = mujoco.MjData(scene)
    data.qpos[0], data.qvel[0] = height, speed
    kind = mujoco.mjtState.mjSTATE_FULLPHYSICS
    state = np.zeros(mujoco.mj_stateSize(scene, kind))
    mujoco.mj_getState(scene, data, state, kind)
    before = time.process_time_ns()
    states, _ = rollout.rollout(scene, data, state, nstep=steps)
    took = time.process_time_ns() - before
    return states[0, :, 1], states[0, :, 2], took


def contact(dt, damping_ratio):
    """Direct stiffness and damping of a contact that lasts STEPS_PER_CONTACT steps."""
    omega = math.pi / (STEPS_PER_CONTACT * dt)
    stiffness, damping = omega**2, 2 * damping_ratio * omega
    return f'solref="-{stiffness} -{damping}" solimp="0.9999 0.9999 0.001 0.5 2"'


def damping(it, dt):
    """The damping ratio with which the first impact has the restitution that is wanted."""
    # The last step before the first touch, so that the contact begins where it will.
    fallen = math.floor(math.sqrt(2 * it.height / it.g) / dt) * dt
    height, speed = it.height - 0.5 * it.g * fallen**2, -it.g * fallen
    touch = math.sqrt(2 * it.g * it.height)
    low, high = 0.0, 1.0
    for _ in range(40):
        middle = 0.5 * (low + high)
        scene = model(it, dt, "RK4", contact(dt, middle))
        y, v, _ = roll(scene, height, speed, 4 * STEPS_PER_CONTACT)
        out = math.sqrt(max(v[-1] ** 2 + 2 * it.g * y[-1], 0.0)) if v[-1] > 0 else 0.0
        low, high = (middle, high) if out > it.e * touch else (low, middle)
    return middle


def touches(it, y, v, dt):
    """Times of first touch, on the free fall from the step before [s]."""
    y, v = np.concatenate([[it.height], y]), np.concatenate([[0.0], v])
    for i in np.flatnonzero((y[:-1] > 0) & (y[1:] <= 0)):
        yield i * dt + (v[i] + math.sqrt(v[i] ** 2 + 2 * it.g * y[i])) / it.g


def row(it, case, dt, setting, scene, method, note):
    """Runs one row, times it, and prints it."""
    steps, times, begin = round(case.t_end / dt), [], time.process_time()
    while not times or time.process_time() - begin < case.budget:
        y, v, took = roll(scene, it.height, 0.0, steps)
        times.append(took)
    per_sample = [round(t / dt) - 1 for t in case.samples]
    states = [float(value) for i in per_sample for value in (y[i], v[i])]
    print(json.dumps({
        "version": mujoco.__version__, "method": method, "setting": setting, "knob": dt,
        "note": note, "events": [[float(t), "floor"] for t in touches(it, y, v, dt)],
        "states": states, "rhs": None, "ns": times, "error": None,
    }), flush=True)


def main():
    case = Case(sys.argv[1])
    it = problem(case)
    row(it, case, 2e-3, "default", model(it, 2e-3, "Euler", ""), "Euler", "soft contact as it comes")
    note = f"soft contact of {STEPS_PER_CONTACT} steps, damping calibrated at the first impact"
    for dt in (1e-3, 1e-4, 2e-5):
        scene = model(it, dt, "RK4", contact(dt, damping(it, dt)))
        row(it, case, dt, "direct solref", scene, "RK4", note)


if __name__ == "__main__":
    main()
