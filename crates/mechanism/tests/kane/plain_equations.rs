use crate::kane::builder::MechanismBuilder;
use crate::kane::evaluation::{Derived, Numbers, close};

/// A hammer on a key, z = y² here: its force balances its acceleration, which the guard reads.
#[test]
fn a_slaved_coordinate_follows_a_plain_equation() {
    let mut m = MechanismBuilder::new(&[("k", 3.0), ("m", 0.2)], &["y", "z"]);
    m.mode("on", &[]);
    m.mode("off", &[]);
    m.solved(0, 1, "y^2");
    let pushed = m.e("k*(s - y)");
    let falling = m.e("0 - 9.81");
    m.it.modes[0].equations = vec![(0, pushed)];
    m.it.modes[1].equations = vec![(0, pushed), (1, falling)];
    m.guard(0, "leave", "m*(z'' + 9.81)", 1);
    m.guard(1, "land", "z - y^2", 0);
    let d = Derived::from(m);
    assert_eq!(d.system.modes[0].is_free, [true, false, true, false]);
    let mut numbers = Numbers::new(13);
    for _ in 0..10 {
        let ([y, z, u, w], input) = (numbers.list::<4>(), numbers.list::<4>());
        let x = d.consistent(0, &[y, z, u, w], input);
        close(x[1], y * y, 1e-14, "z");
        close(x[3], 2.0 * y * u, 1e-14, "z'");
        let a = 3.0 * (input[0] - y);
        let bent = 2.0 * u.powi(2) + 2.0 * y * a;
        let f = d.derivative(0, &x, input);
        close(f[2], a, 1e-14, "y''");
        close(f[3], bent, 1e-13, "z''");
        let guard = &d.system.modes[0].guards[0];
        let [value, rate] = d.all(&[guard.value, guard.rate], &x, input)[..] else {
            unreachable!()
        };
        close(value, 0.2 * (bent + 9.81), 1e-13, "leave");
        let jerk = 3.0 * (input[1] - u);
        close(rate, 0.4 * (3.0 * u * a + y * jerk), 1e-13, "leave's rate");
        // Landing sets z and z' from the key, and keeps y and y'.
        let way = &d.system.modes[1].guards[0].ways[0];
        let after = d.all(&way.state, &[y, z, u, w], input);
        for (found, expected) in after.iter().zip([y, y * y, u, 2.0 * y * u]) {
            close(*found, expected, 1e-14, "landed");
        }
        close(d.derivative(1, &[y, z, u, w], input)[3], -9.81, 1e-14, "falls");
    }
}
