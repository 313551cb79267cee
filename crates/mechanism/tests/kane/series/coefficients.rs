use pode::{GuardId, Guarded as _, Model as _};

use super::{ORDER, each, motion_at};

/// Returns the validity of the series: later terms are rounding, and no condition is near zero.
fn reach(case: &super::Case<12>) -> f64 {
    let series = &case.series;
    let rows = (0..case.states()).map(|entry| series.terms.map(|term| term[entry]));
    let by_rows = rows.flat_map(|row| {
        [ORDER, ORDER - 1].map(|k| {
            let size = row[k].abs() / (1e-16 * (row[0].abs() + row[1].abs()).max(1e-3));
            size.max(1e-6).powf(-1.0 / k as f64)
        })
    });
    let conditions = series.conditions.iter().take(series.known_conditions);
    let by_conditions = conditions.map(|row| {
        let moves: f64 = row[1..=ORDER].iter().map(|it| it.abs()).sum();
        if moves > 0.0 { row[0].abs() / moves } else { 1.0 }
    });
    by_rows.chain(by_conditions).fold(0.5, f64::min)
}

#[test]
fn the_polynomial_meets_equations_and_guards() {
    let (mut seen, mut worst) = (0, 0.0_f64);
    each(|_, case| {
        let reach = reach(case);
        seen += usize::from(reach > 0.01);
        for tau in [0.0, 0.2, 0.5].map(|part| part * reach) {
            let input = motion_at(&case.input, case.series.scale, tau);
            let [x, rates] = case.at(tau);
            let expected = case.model.derivative(case.mode, &x, &input);
            let placed = case.model.constrain(case.mode, &x, &input);
            let size = expected.iter().fold(1.0_f64, |most, it| most.max(it.abs()));
            for entry in 0..case.states() {
                let off = (rates[entry] - expected[entry]).abs() / size;
                let moved = (placed[entry] - x[entry]).abs() / (1.0 + x[entry].abs());
                let off = off.max(moved);
                assert!(off < 1e-10, "{} at {tau}: entry {entry}: {off:e}", case.name());
                worst = worst.max(off);
            }
            for (at, spec) in case.model.guards(case.mode).iter().enumerate() {
                let row = &case.series.guards[at][..=ORDER];
                let found = row.iter().rev().fold(0.0, |sum, term| term + tau * sum);
                let GuardId(id) = spec.id;
                let value = case.model.guard(case.mode, GuardId(id), &x, &input).value;
                let off = (found - value).abs() / (1.0 + value.abs());
                assert!(off < 1e-11, "{} at {tau}: guard {}: {off:e}", case.name(), spec.name);
            }
        }
    });
    println!("{seen} cases, {worst:e}");
    assert!(seen > 70, "only {seen} cases go on for a while");
}
