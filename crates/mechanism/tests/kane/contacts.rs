use mechanism::kane::mechanism::{DryFriction, Force, MechanismContact, SlipKind};

use crate::kane::builder::MechanismBuilder;
use crate::kane::evaluation::{Derived, Numbers, close};

fn links() -> MechanismBuilder {
    let mut m = MechanismBuilder::new(&[("l", 0.3), ("K", 900.0)], &["a", "b"]);
    m.gravity(&["0", "-9.81"]);
    let first = m.frame(0, &["0.2*s", "0"], "a");
    m.body(first, "0.4", &["l/2"], "0.002");
    let second = m.frame(first, &["l", "0"], "b");
    m.body(second, "0.3", &["l/2"], "0.001");
    m.define("gap", "l*sin(a) + l*sin(a + b) + 0.4 + 0.1*s");
    m.define("slip", "0.2*s' - l*sin(a)*a' - l*sin(a + b)*(a' + b')");
    m
}

const FORCE: &str = "K*max(0, -gap)*(1 - 0.5*rate_of_gap)";

fn with_contact() -> Derived {
    let mut m = links();
    let gap = m.e("gap");
    let gap_rate = m.rate(gap);
    m.names.insert("rate_of_gap".into(), gap_rate);
    let (tension, energy) = (m.e(FORCE), m.e("K*max(0, -gap)^2/2"));
    let (stretch, stretch_rate) = (m.graph().negate(gap), m.graph().negate(gap_rate));
    let force = Force { name: "tip".into(), stretch, stretch_rate, tension, energy, law: None };
    let (slip, stiction, kinetic) = (m.e("slip"), m.e("2"), m.e("1"));
    let (name, kind) = ("floor".into(), SlipKind::Speed);
    let friction = DryFriction { name, slip, stiction, kinetic, scales: (1.0, 1.0), kind };
    m.it.contacts.push(MechanismContact {
        name: "tip".into(),
        gap: Some(gap),
        scale: 1.0,
        force: Some(force),
        friction: Some(friction),
        sounds: None,
    });
    m.mode("free", &[]);
    m.output("a''", "a''");
    Derived::from(m)
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum ForceKind {
    Normal,
    Friction,
}

/// Replaces the contact's law, or 1 N along the slip, by a plain force.
fn with_force(kind: ForceKind) -> Derived {
    let mut m = links();
    let gap = m.e("gap");
    let rate = m.rate(gap);
    m.names.insert("rate_of_gap".into(), rate);
    if kind == ForceKind::Friction {
        m.force("friction", "0", "-1", "0");
        m.it.forces[0].stretch_rate = m.names["slip"];
    } else {
        m.force("tip", "-gap", FORCE, "K*max(0, -gap)^2/2");
    }
    m.mode("free", &[]);
    Derived::from(m)
}

#[test]
fn a_contact_adds_what_its_force_does() {
    let (contact, pushed, rubbed) =
        (with_contact(), with_force(ForceKind::Normal), with_force(ForceKind::Friction));
    let mut numbers = Numbers::new(12);
    let mut closed = 0;
    for _ in 0..40 {
        let x = numbers.list::<4>().map(|it| 2.0 * it);
        let input = numbers.list::<4>();
        let mode = &contact.system.modes[0];
        let here = &mode.contacts[0];
        let ([force, energy, lost], [gap, _]) =
            (here.normal.expect("felt"), here.gap.expect("gap"));
        let friction = here.friction.as_ref().expect("friction");
        let value = |node| contact.one(node, &x, input);
        closed += usize::from(value(gap) < 0.0);
        let free = contact.derivative(0, &x, input);
        let normal = contact.all(&here.normal_response.derivative, &x, input);
        let along = contact.all(&friction.response.derivative, &x, input);
        let [with_normal, with_slip] = [&pushed, &rubbed].map(|it| it.derivative(0, &x, input));
        for i in 0..4 {
            close(free[i] + normal[i] * value(force), with_normal[i], 1e-11, "normal");
            close(free[i] + along[i], with_slip[i], 1e-11, "friction");
        }
        let readout = |d: &Derived| d.one(d.system.modes[0].readout.expect("readout"), &x, input);
        let by_normal = value(here.normal_response.readout.expect("readout")) * value(force);
        close(readout(&contact) + by_normal, readout(&pushed), 1e-11, "readout");
        close(
            readout(&contact) + value(friction.response.readout.expect("readout")),
            readout(&rubbed),
            1e-11,
            "readout",
        );
        let other = &pushed.system.modes[0];
        let [dissipated, stored] = [other.balance.dissipated, other.balance.energy]
            .map(|it| pushed.one(it.expect("balance"), &x, input));
        close(value(lost), dissipated, 1e-11, "dissipated");
        close(value(energy) + value(mode.balance.energy.expect("energy")), stored, 1e-11, "energy");
        // Accelerations in outputs are those with the contact pressing.
        close(value(mode.outputs[0]), with_normal[2], 1e-11, "a''");
        let gradient = contact.all(&friction.gradient, &x, input);
        let linear = gradient[2] * x[2] + gradient[3] * x[3] + 0.2 * input[1];
        close(value(friction.slip), linear, 1e-12, "slip is linear in the speeds");
        close(value(friction.drift), 0.2 * input[2], 1e-12, "drift");
    }
    assert!((5..35).contains(&closed), "{closed} of 40 touch");
}
