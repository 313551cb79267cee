"""MuJoCo on the cradle and the block: contacts are soft, and there are no events.

default: contacts as they come, steps of 2 ms.
best, the cradle: solref in its direct form, calibrated as in mujoco_peer.py so that an impact
of two balls alone has the restitution; RK4. A contact lasts 50 steps, and while it lasts the
next ball may be met, which no setting but the step removes.
best, the block: as its documentation ("Solver parameters", "Friction cones") has it for
contacts that stick: elliptic cones, impratio 100, solref of two steps.

Timed is `rollout`, which steps in C. Prints one line of JSON per row.
"""

import sys
from types import SimpleNamespace

import mujoco
import numpy as np
from mujoco import rollout

from case import Case, problem
from mujoco_peer import contact, damping
from rows import process_time, row

RADIUS, DEPTH = 0.01, 0.05


def cradle(it, option, surface):
    """Balls on slide joints with springs; the order of the state is ours."""
    bodies, place = "", 0.0
    for i in range(5):
        bodies += (f'<body pos="{place!r} 0 0"><joint type="slide" axis="1 0 0" '
                   f'stiffness="{it.square!r}"/><geom type="sphere" size="{RADIUS}" mass="1" '
                   f'condim="1" {surface}/></body>')
        place += 2 * RADIUS + (it.gaps[i] if i < 4 else 0.0)
    return f'<mujoco><option gravity="0 0 0" {option}/><worldbody>{bodies}</worldbody></mujoco>'


def block(it, option, surface):
    """A box on two slides and a hinge above a plane."""
    friction = f'friction="{it.mu} 0 0" condim="3" {surface}'
    inertia = f'<inertial pos="0 0 0" mass="1" diaginertia="{it.turn} {it.turn} {it.turn}"/>'
    return f'''<mujoco><option gravity="0 0 -{it.g}" {option}/><worldbody>
      <geom type="plane" size="9 9 1" {friction}/>
      <body>{inertia}<joint type="slide" axis="1 0 0"/><joint type="slide" axis="0 0 1"/>
      <joint type="hinge" axis="0 -1 0"/>
      <geom type="box" size="{it.a} {DEPTH} {it.b}" {friction}/></body></worldbody></mujoco>'''


def begin(it, case):
    """Coordinates and speeds at the start, and which of them are the problem's state."""
    if case.problem == "cradle":
        return it.start()[1], list(range(10))
    x, angle, speed, rate = it.begin
    px, py = it.arm(it.first[0], angle)
    return [x, -py, angle, speed, -rate * px, rate], [0, 2, 3, 5]


class Scene:
    """A scene with its start."""

    def __init__(self, it, case, dt, scene):
        self.model = mujoco.MjModel.from_xml_string(scene)
        data = mujoco.MjData(self.model)
        start, self.columns = begin(it, case)
        data.qpos[:], data.qvel[:] = np.split(np.array(start), 2)
        kind = mujoco.mjtState.mjSTATE_FULLPHYSICS
        self.start = np.zeros(mujoco.mj_stateSize(self.model, kind))
        mujoco.mj_getState(self.model, data, self.start, kind)
        self.data, self.steps, self.dt = data, round(case.t_end / dt), dt

    def roll(self):
        return rollout.rollout(self.model, self.data, self.start, nstep=self.steps)[0][0]

    def states(self, samples):
        rows = self.roll()
        return [float(rows[round(t / self.dt) - 1, 1 + i]) for t in samples for i in self.columns]


def main():
    case = Case(sys.argv[1])
    it = problem(case)
    is_cradle = case.problem == "cradle"
    make = cradle if is_cradle else block

    def show(method, setting, dt, option, surface, note):
        scene = Scene(it, case, dt, make(it, f'timestep="{dt}" {option}', surface))
        row(case, (mujoco.__version__, method, setting, note), dt, None,
            scene.states(case.samples), lambda: process_time(scene.roll))

    show("Euler", "default", 2e-3, "", "", "soft contacts as they come")
    for dt in (1e-4, 1e-5) if is_cradle else (1e-3, 1e-4, 1e-5):
        if is_cradle:
            height = it.pulled**2 * it.square / 19.62
            drop = SimpleNamespace(g=9.81, height=height, e=it.e)
            show("RK4", "direct solref", dt, 'integrator="RK4"', contact(dt, damping(drop, dt)),
                 "soft contacts of 50 steps")
        else:
            surface = f'solref="{2 * dt} 1" solimp="0.99 0.9999 0.001 0.5 2"'
            option = 'integrator="implicitfast" cone="elliptic" impratio="100"'
            show("implicitfast", "elliptic", dt, option, surface, "soft contacts of 2 steps")


main()
