//! A planar rigid body between thirteen felts, skids and buffers, read from the reference.
//!
//! Centre (x, y), angle φ, their rates, and two sums of energy: absorbed by contacts and friction,
//! and supplied by the drive.

use std::cell::Cell;

use pode::contacts::{
    ContactIndices, ContactSpec, ContactSystem, CoupledFrictions, FrictionLimits, FrictionSpec,
    FrictionalContacts, GuardedContacts, Surface,
};
use pode::{GuardValue, State as _};

use crate::driven::Clock;

/// The state: q, q', and two energies (J).
pub(super) type BodyState = [f64; 8];

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Pad {
    /// The point in the body's frame (m), the wall's normal, and the wall's place (m).
    r: [f64; 2],
    n: [f64; 2],
    d: f64,
    /// N = k e^p (1 + χ e').
    k: f64,
    p: f64,
    chi: f64,
    stiction: f64,
    kinetic: f64,
}

#[derive(Debug, Default)]
pub(super) struct Calls {
    /// Evaluations of the derivative, and of normal forces in it.
    pub(super) derivatives: Cell<usize>,
    pub(super) normals: Cell<usize>,
    pub(super) gaps: Cell<usize>,
}

impl Calls {
    pub(super) fn now(&self) -> [usize; 3] {
        [&self.derivatives, &self.normals, &self.gaps].map(Cell::get)
    }
}

fn count(calls: &Cell<usize>) {
    calls.set(calls.get() + 1);
}

#[derive(Debug)]
pub(super) struct Body {
    mass: f64,
    inertia: f64,
    gravity: f64,
    /// Amplitude, rate (rad/s) and phase of force x, force y and torque.
    drive: Vec<[f64; 3]>,
    pub(super) specs: Vec<ContactSpec>,
    pads: Vec<Pad>,
    pub(super) calls: Calls,
}

struct Kinematics {
    pad: Pad,
    arm: [f64; 2],
    v: [f64; 2],
    t: [f64; 2],
    gap: f64,
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

impl Kinematics {
    fn rate(&self) -> f64 {
        dot(self.pad.n, self.v)
    }

    /// Returns elastic part and whole of the normal force (N), as odd functions of the depth.
    fn normal(&self) -> [f64; 2] {
        let elastic = -self.pad.k * self.gap.abs().powf(self.pad.p).copysign(self.gap);
        [elastic, elastic * (1.0 - self.pad.chi * self.rate())]
    }
}

fn numbers<const N: usize>(fields: &[&str]) -> [f64; N] {
    assert_eq!(fields.len(), N, "{fields:?}");
    std::array::from_fn(|i| fields[i].parse().unwrap())
}

pub(super) fn lines(file: &'static str, kind: &str) -> Vec<Vec<&'static str>> {
    let fields = file.lines().map(|line| line.split(',').collect::<Vec<_>>());
    fields.filter(|it| it[0] == kind).map(|it| it[1..].to_vec()).collect()
}

impl Body {
    pub(super) fn read(file: &'static str) -> Self {
        let [mass, inertia, gravity] = numbers(&lines(file, "body")[0]);
        let mut body = Self {
            mass,
            inertia,
            gravity,
            drive: lines(file, "drive").iter().map(|it| numbers(it)).collect(),
            specs: vec![],
            pads: vec![],
            calls: Calls::default(),
        };
        for line in lines(file, "contact") {
            let [rx, ry, nx, ny, d, k, p, chi, stiction, kinetic] = numbers(&line[1..]);
            let spec = ContactSpec::new(line[0], 0.1);
            let friction = FrictionSpec::new(line[0], 1.0, 0.1);
            body.specs.push(if stiction > 0.0 { spec.with_friction(friction) } else { spec });
            body.pads.push(Pad { r: [rx, ry], n: [nx, ny], d, k, p, chi, stiction, kinetic });
        }
        body
    }

    fn kinematics(&self, contact: usize, x: &BodyState) -> Kinematics {
        let (pad, (sin, cos)) = (self.pads[contact], x[2].sin_cos());
        let arm = [cos * pad.r[0] - sin * pad.r[1], sin * pad.r[0] + cos * pad.r[1]];
        let v = [x[3] - x[5] * arm[1], x[4] + x[5] * arm[0]];
        let gap = dot(pad.n, [x[0] + arm[0], x[1] + arm[1]]) - pad.d;
        Kinematics { pad, arm, v, t: [pad.n[1], -pad.n[0]], gap }
    }

    fn accelerations(&self, arm: [f64; 2], force: [f64; 2]) -> BodyState {
        let torque = cross(arm, force);
        let [ax, ay] = force.map(|f| f / self.mass);
        [0.0, 0.0, 0.0, ax, ay, torque / self.inertia, 0.0, 0.0]
    }

    pub(super) fn energy(&self, x: &BodyState) -> f64 {
        let motion =
            0.5 * self.mass * (x[3] * x[3] + x[4] * x[4]) + 0.5 * self.inertia * x[5] * x[5];
        let pads = (0..self.pads.len()).map(|contact| {
            let it = self.kinematics(contact, x);
            let power = it.pad.p + 1.0;
            it.pad.k * (-it.gap).max(0.0).powf(power) / power
        });
        motion + self.mass * self.gravity * x[1] + pads.sum::<f64>()
    }
}

impl ContactSystem for Body {
    type Structure = ();
    type State = BodyState;
    type Input = Clock;
    const COORDS: usize = 3;

    fn contacts(&self) -> &[ContactSpec] {
        &self.specs
    }

    fn gap(&self, (): (), contact: usize, x: &BodyState, _: &Clock) -> GuardValue {
        count(&self.calls.gaps);
        let it = self.kinematics(contact, x);
        GuardValue::new(it.gap, it.rate())
    }

    fn derivative(&self, (): (), closed: ContactIndices, x: &BodyState, t: &Clock) -> BodyState {
        count(&self.calls.derivatives);
        let sine = |i: usize| self.drive[i][0] * (self.drive[i][1] * t.0 + self.drive[i][2]).sin();
        let (force, torque) = ([sine(0), sine(1)], sine(2));
        let put_in = dot(force, [x[3], x[4]]) + torque * x[5];
        let [ax, ay] = force.map(|f| f / self.mass);
        let mut flow =
            [x[3], x[4], x[5], ax, ay - self.gravity, torque / self.inertia, 0.0, put_in];
        for contact in closed {
            count(&self.calls.normals);
            let it = self.kinematics(contact, x);
            let [elastic, normal] = it.normal();
            flow = flow.plus(1.0, &self.accelerations(it.arm, it.pad.n.map(|n| normal * n)));
            flow[6] += (elastic - normal) * it.rate();
        }
        flow
    }
}

impl CoupledFrictions for Body {}

impl FrictionalContacts for Body {
    fn slip(&self, (): (), contact: usize, x: &BodyState, _: &Clock) -> Surface<BodyState> {
        let it = self.kinematics(contact, x);
        let turn = -x[5] * dot(it.t, it.arm);
        let gradient = [0.0, 0.0, turn, it.t[0], it.t[1], cross(it.arm, it.t), 0.0, 0.0];
        Surface { value: dot(it.t, it.v), gradient, drift: 0.0 }
    }

    fn response(&self, (): (), contact: usize, x: &BodyState, _: &Clock) -> BodyState {
        let it = self.kinematics(contact, x);
        let mut response = self.accelerations(it.arm, it.t);
        response[6] = -dot(it.t, it.v);
        response
    }

    fn friction(&self, (): (), contact: usize, x: &BodyState, _: &Clock) -> FrictionLimits {
        let it = self.kinematics(contact, x);
        let [_, normal] = it.normal();
        FrictionLimits { stiction: it.pad.stiction * normal, kinetic: it.pad.kinetic * normal }
    }
}

impl GuardedContacts for Body {}
