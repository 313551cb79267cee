use haptics::{EstimatorName, RigParameters, SampledWall};

use super::*;
use figures::parallel::in_parallel;

fn study(values: LoopValues) -> StabilityStudy<'static> {
    let axis = |quantity: LoopQuantity| MapAxis::of_quantity(quantity, quantity.entry().axis);
    StabilityStudy {
        name: "wall".to_owned(),
        subject: StabilitySubject::Wall,
        rig: RigParameters::default(),
        base: LoopPoint { values, parameters: Vec::new() },
        chosen: Vec::new(),
        axes: [axis(LoopQuantity::Stiffness), axis(LoopQuantity::Damping)],
        cells: 8,
    }
}

fn ideal(period: f64) -> LoopValues {
    LoopValues::ideal(&RigParameters::default(), period, 1e5)
}

fn with(mut values: LoopValues, changes: &[(LoopQuantity, f64)]) -> LoopValues {
    for (quantity, value) in changes {
        values.set(*quantity, *value);
    }
    values
}

fn verdict(values: LoopValues) -> LoopVerdict {
    let study = study(values);
    study.verdict(EstimatorName::BackwardDifference, &study.base)
}

/// Bisects for the stiffness (N/m) at which the loop stops coming to rest, to 1 %.
#[track_caller]
fn stiffest(values: LoopValues, (stable, unstable): (f64, f64)) -> f64 {
    let rests = |stiffness| {
        verdict(with(values, &[(LoopQuantity::Stiffness, stiffness)])) == LoopVerdict::Rests
    };
    assert!(rests(stable) && !rests(unstable), "between {stable} and {unstable}: {values:?}");
    let (mut low, mut high) = (stable, unstable);
    while low * 1.01 < high {
        let middle = (low * high).sqrt();
        *(if rests(middle) { &mut low } else { &mut high }) = middle;
    }
    (low * high).sqrt()
}

#[test]
fn under_the_worst_load_a_wall_is_stable_up_to_colgate_and_schenkels_boundary() {
    let mut cases = Vec::new();
    for period in [0.2e-3, 0.5e-3, 1e-3, 2.5e-3, 10e-3] {
        for device in [0.2, 1.0, 5.0] {
            cases.extend([0.0, 0.4].map(|share| (period, device, share)));
        }
    }
    let ratios = in_parallel(&cases, &|(period, device, share)| {
        let (period, device, damping) = (*period, *device, share * device);
        let wall = SampledWall { stiffness: 0.0, damping, period, delay: 0.0 };
        let theory = wall.passive_stiffness(device);
        // Worst case: the mass vanishes within 1/50 of a period, in steps of 1/500.
        let changes = [
            (LoopQuantity::Mass, 0.02 * device * period),
            (LoopQuantity::DeviceDamping, device),
            (LoopQuantity::Damping, damping),
        ];
        stiffest(with(ideal(period), &changes), (0.5 * theory, 2.0 * theory)) / theory
    });
    for (case, ratio) in cases.iter().zip(ratios) {
        assert!((ratio - 1.0).abs() < 0.1, "{case:?}: {ratio}");
    }
}

#[test]
fn on_a_key_of_40_g_a_wall_is_stable_up_to_where_its_poles_leave_the_unit_circle() {
    for (delay, damping) in [(0.0, 0.0), (0.0, 8.0), (0.5e-3, 3.0), (2e-3, 3.0), (5.25e-3, 1.0)] {
        let values =
            with(ideal(1e-3), &[(LoopQuantity::Delay, delay), (LoopQuantity::Damping, damping)]);
        let radius = |stiffness| {
            let wall = SampledWall { stiffness, damping, period: 1e-3, delay };
            spectral_radius(&wall, 0.04, 1.0).unwrap()
        };
        let (mut low, mut high) = (10.0, 1e5);
        while low * 1.0001 < high {
            let middle = f64::sqrt(low * high);
            *(if radius(middle) < 1.0 { &mut low } else { &mut high }) = middle;
        }
        let measured = stiffest(values, (0.5 * low, 2.0 * low));
        // The plant's step is a two-hundredth of a period, and of first order.
        assert!((measured / low - 1.0).abs() < 0.02, "{delay} s: {measured}, poles {low}");
        let wall = SampledWall { stiffness: 0.0, damping, period: 1e-3, delay };
        // A decay by less than 2 % of the energy in 0.1 s counts as ringing: 0.008 N s/m of b.
        assert!(0.99 * wall.passive_stiffness(1.0) < measured, "a passive wall is stable");
    }
}

fn rough(friction: f64) -> LoopValues {
    with(
        ideal(1e-3),
        &[
            (LoopQuantity::EncoderStep, 1e-4),
            (LoopQuantity::Friction, friction),
            (LoopQuantity::DeviceDamping, 5.0),
        ],
    )
}

#[test]
fn in_friction_of_half_a_count_a_wall_comes_to_rest() {
    for friction in [0.05, 0.1, 0.3] {
        let device = haptics::RoundedDevice { damping: 5.0, coulomb: friction, quantum: 1e-4 };
        let limit = device.passive_stiffness(1e-3);
        for share in [0.2, 0.6, 0.95] {
            let stiffness = [(LoopQuantity::Stiffness, share * limit)];
            let verdict = verdict(with(rough(friction), &stiffness));
            assert_eq!(verdict, LoopVerdict::Rests, "{share} of {limit} N/m");
        }
    }
}

#[test]
fn bad_values_of_any_corner_are_found_before_a_loop_is_run() {
    let mut late = study(with(ideal(1e-3), &[(LoopQuantity::Delay, 10e-3)]));
    assert_eq!(late.mistakes(), [""; 0]);
    late.axes[1] = MapAxis::of_quantity(LoopQuantity::Period, (0.1e-3, 1e-3));
    let wrong = late.mistakes();
    assert!(wrong.len() == 1 && wrong[0].contains("longer than 16 periods"), "{wrong:?}");
    late.axes[0] = MapAxis::of_quantity(LoopQuantity::Mass, (1.0, -1.0));
    assert!(late.mistakes()[0].contains("no range"), "{:?}", late.mistakes());
}

#[test]
fn a_map_is_in_its_files_with_its_axes_units_and_lines() {
    let folder = std::env::temp_dir().join(format!("letoff-lab-stability-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let mut study = study(ideal(1e-3));
    study.cells = 6;
    let map = study.measure(EstimatorName::BackwardDifference, &|| {});
    let counts = map.counts();
    assert_eq!(counts.rests + counts.rings + counts.makes_energy + counts.fails, 36);
    assert!(counts.rests > 5 && counts.makes_energy > 5, "{counts:?}");
    let summary = StabilitySummary::new(&study, std::slice::from_ref(&map));
    let poles = summary.maps[0].ratios["poles"];
    assert!(0.97 < poles.least && poles.most < 1.03, "{poles:?}");
    write_maps(&folder, &study, &[map]).unwrap();
    let read = |name: &str| std::fs::read_to_string(folder.join(name)).unwrap();
    let svg = read("backward-difference.svg");
    for words in ["stiffness K [kN/m]", "damping B [N·s/m]", "[CS97]"] {
        assert!(svg.contains(words), "{words}");
    }
    assert!(!svg.contains("NaN") && !svg.contains("inf"), "a place that is none");
    assert_eq!(read("map.csv").lines().count(), 37);
    assert!(read("boundary.csv").contains("backward-difference,"), "a boundary");
    assert!(read("index.html").contains("Where wall is stable"), "a page");
    std::fs::remove_dir_all(&folder).unwrap();
}

struct SpringVoice(f64);

impl TrialVoice for SpringVoice {
    fn answer(&mut self, _tick: u64, position: f64) -> TrialAnswer {
        TrialAnswer::Force(self.0 * position)
    }
}

fn verdict_of(make: VoiceMaker<'_>) -> LoopVerdict {
    let rig = RigParameters::default();
    let mut study = study(LoopValues::of_rig(&rig, 1e-3, 1e5));
    study.subject = StabilitySubject::Voice(make);
    study.verdict(EstimatorName::Kalman, &study.base)
}

#[test]
fn a_voice_is_judged_by_the_same_loop() {
    // 2 (b / T) plus friction: a soft spring rests, a fifty times stiffer one does not.
    assert_eq!(verdict_of(&|_| Ok(Box::new(SpringVoice(200.0)))), LoopVerdict::Rests);
    let stiff = verdict_of(&|_| Ok(Box::new(SpringVoice(100e3))));
    assert!(matches!(stiff, LoopVerdict::Rings | LoopVerdict::MakesEnergy), "{stiff:?}");
    assert_eq!(verdict_of(&|_| Err("none".to_owned())), LoopVerdict::Fails);
}

struct Mute;

impl TrialVoice for Mute {
    fn answer(&mut self, tick: u64, _position: f64) -> TrialAnswer {
        if tick < 2 { TrialAnswer::Force(0.0) } else { TrialAnswer::Muted }
    }
}

#[test]
fn a_voice_that_is_muted_makes_energy() {
    assert_eq!(verdict_of(&|_| Ok(Box::new(Mute))), LoopVerdict::MakesEnergy);
}
