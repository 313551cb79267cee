"""Drake's MultibodyPlant on the cradle and the block: contacts are compliant, without events.

default: a discrete plant with steps of 1 ms, contacts as they come.
best: "discrete", the plant that its documentation prefers, with stiff contacts and short
steps; "continuous", a plant without steps under `Simulator` with the error-controlled
integrator of its default (runge_kutta3), over a sweep of accuracies.
A discrete plant has no restitution (its documentation): the cradle's rows there show what
that means. In a continuous plant the restitution is that of Hunt and Crossley's dissipation,
which is exact at the speed of the first impact, and rises as the speed falls.

Timed is `Simulator.AdvanceTo` to the end. Prints one line of JSON per row.
"""

import importlib.metadata
import math
import sys

import numpy as np
from pydrake.all import (
    AddContactMaterial, AddMultibodyPlantSceneGraph, CoulombFriction, DiagramBuilder, FixedOffsetFrame, HalfSpace,
    PlanarJoint, PrismaticJoint, PrismaticSpring, ProximityProperties,
    ResetIntegratorFromFlags, RigidTransform, RotationMatrix, Simulator, SpatialInertia, Sphere,
    UnitInertia,
)

from case import Case, problem
from rows import process_time, row

VERSION = importlib.metadata.version("drake")
# Spheres of the cradle, and those that stand for corners: points, as far as Drake has any [m].
RADIUS, POINT = 0.01, 1e-6
# The speed that counts as sticking [m/s].
SLIPPING = 1e-5
# Dissipation [s/m] of a contact that is as good as plastic at the speeds of the block.
PLASTIC = 1e3


def material(stiffness, dissipation, mu):
    """Properties of a surface; what is None stays as it comes."""
    properties = ProximityProperties()
    AddContactMaterial(properties, dissipation=dissipation, point_stiffness=stiffness,
                       friction=CoulombFriction(mu, mu))
    return properties


def body(plant, name, inertia):
    """A body of 1 kg with its centre in its origin."""
    return plant.AddRigidBody(name, SpatialInertia(1.0, np.zeros(3), UnitInertia(*inertia)))


def cradle(it, plant, stiffness, dissipation):
    """Balls on prismatic joints with springs."""
    surface, place = material(stiffness, dissipation, 0.0), 0.0
    plant.mutable_gravity_field().set_gravity_vector(np.zeros(3))
    for i in range(5):
        ball = body(plant, f"ball{i}", (1e-4, 1e-4, 1e-4))
        hung = plant.AddFrame(FixedOffsetFrame(
            f"hung{i}", plant.world_frame(), RigidTransform(np.array([place, 0, 0]))))
        joint = plant.AddJoint(
            PrismaticJoint(f"swing{i}", hung, ball.body_frame(), np.array([1.0, 0, 0])))
        plant.AddForceElement(PrismaticSpring(joint, 0.0, it.square))
        plant.RegisterCollisionGeometry(ball, RigidTransform(), Sphere(RADIUS), f"ball{i}", surface)
        place += 2 * RADIUS + (it.gaps[i] if i < 4 else 0.0)
    return it.start()[1], lambda x: x


def block(it, plant, stiffness, dissipation):
    """A block on a planar joint, gravity against y, with a point at each lower corner."""
    surface = material(stiffness, dissipation, it.mu)
    plant.mutable_gravity_field().set_gravity_vector(np.array([0, -it.g, 0]))
    box = body(plant, "block", (it.turn, it.turn, it.turn))
    plant.AddJoint(PlanarJoint("plane", plant.world_frame(), box.body_frame(), np.zeros(3)))
    for corner in (1, -1):
        at = RigidTransform(np.array([corner * it.a, -it.b, 0]))
        plant.RegisterCollisionGeometry(box, at, Sphere(POINT), f"corner{corner}", surface)
    upwards = RigidTransform(RotationMatrix.MakeXRotation(-math.pi / 2), np.array([0, -POINT, 0]))
    plant.RegisterCollisionGeometry(plant.world_body(), upwards, HalfSpace(), "floor", surface)
    x, angle, speed, rate = it.begin
    px, py = it.arm(it.first[0], angle)
    return [x, -py, angle, speed, -rate * px, rate], lambda x: [x[0], x[2], x[3], x[5]]


class Scene:
    """A diagram with its simulator, which starts anew for each run."""

    def __init__(self, it, case, step, stiffness=None, dissipation=None, accuracy=None):
        builder = DiagramBuilder()
        self.plant, _ = AddMultibodyPlantSceneGraph(builder, step)
        make = cradle if case.problem == "cradle" else block
        self.begin, self.of = make(it, self.plant, stiffness, dissipation)
        self.plant.Finalize()
        if stiffness:
            self.plant.set_stiction_tolerance(SLIPPING)
        self.simulator, self.t_end = Simulator(builder.Build()), case.t_end
        if accuracy:
            integrator = ResetIntegratorFromFlags(self.simulator, "runge_kutta3", 1e-3)
            integrator.set_target_accuracy(accuracy)

    def restart(self):
        context = self.simulator.get_mutable_context()
        context.SetTime(0.0)
        plant_context = self.plant.GetMyMutableContextFromRoot(context)
        self.plant.SetPositionsAndVelocities(plant_context, self.begin)
        self.simulator.Initialize()

    def states(self, samples):
        self.restart()
        found = []
        for t in samples:
            self.simulator.AdvanceTo(t)
            context = self.plant.GetMyContextFromRoot(self.simulator.get_context())
            found += map(float, self.of(self.plant.GetPositionsAndVelocities(context)))
        return found

    def run(self):
        self.restart()
        return process_time(lambda: self.simulator.AdvanceTo(self.t_end))


def dissipation(e, speed):
    """Hunt and Crossley's dissipation [s/m] with restitution e at an impact of `speed` [m/s]."""
    if e == 1:
        return 0.0
    low, high = 1e-9, (1 - 1e-9) / e
    for _ in range(80):
        u = 0.5 * (low + high)
        # Energy that the law loses at d v = u: positive while the restitution is above e.
        low, high = (u, high) if u * (1 + e) < math.log((1 + u) / (1 - e * u)) else (low, u)
    return u / speed


def main():
    case = Case(sys.argv[1])
    it = problem(case)

    def show(scene, setting, method, knob, note):
        error, states = None, []
        try:
            states = scene.states(case.samples)
        except Exception as stopped:
            error = str(stopped).splitlines()[0]
        row(case, (VERSION, method, setting, note), knob, None, states, scene.run, error)

    show(Scene(it, case, 1e-3), "default", "discrete", 1e-3, "contacts as they come")
    speed = lambda: it.pulled * math.sqrt(it.square)
    loss = dissipation(it.e, speed()) if case.problem == "cradle" else PLASTIC
    for step in (1e-3, 1e-4):
        note = f"stiffness 1e8 N/m, dissipation {loss:.3g} s/m"
        show(Scene(it, case, step, 1e8, loss), "stiff", "discrete", step, note)
    for stiffness, accuracy in ((1e4, 1e-4), (1e6, 1e-5), (1e8, 1e-6)):
        note = f"stiffness {stiffness:.0e} N/m, dissipation {loss:.3g} s/m"
        show(Scene(it, case, 0.0, stiffness, loss, accuracy), "sweep", "continuous", accuracy, note)


main()
