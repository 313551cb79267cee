//! Requirements on every model.

use instruments::{
    Described, ModeCode, ModeName, ModelEntry, NamedModes as _, Parameter, Playable,
};
use pode::stepper::{Given, Rk4, Stepper as _};
use pode::{
    Dense as _, Energetic as _, EquationKind, GuardId, Guarded as _, MAX_GUARDS, Matrix as _,
    Model as _, Motion, Nature, Resets as _, Sloped as _, State,
};

use crate::every_model::{named, small};
use crate::random::Random;
use crate::stroke::{run, still, values};

fn is_word(name: &str, others: &[char]) -> bool {
    name.starts_with(|c: char| c.is_ascii_alphabetic())
        && name.chars().all(|c| c.is_ascii_alphanumeric() || others.contains(&c))
}

#[track_caller]
fn check_names(what: &str, others: &[char], names: &[&str]) {
    for (index, name) in names.iter().enumerate() {
        assert!(is_word(name, others), "{what}: {name:?} is no name");
        assert!(!names[..index].contains(name), "{what}: {name:?} twice");
    }
}

#[test]
fn models_have_names_of_their_own() {
    let names: Vec<_> = mechanism::model_names().collect();
    check_names("program", &['-'], &names);
    assert!(names.iter().all(|name| *name == name.to_lowercase()));
    assert!(names.iter().all(|name| named(name).name == *name));
}

#[test]
fn everything_in_a_model_has_a_name() {
    for model in small() {
        let ModelEntry { name, parameters, presets, states, outputs, .. } = model.entry();
        check_names(name, &['_'], &parameters.iter().map(|it| it.name).collect::<Vec<_>>());
        check_names(name, &['-'], &presets.iter().map(|it| it.name).collect::<Vec<_>>());
        check_names(name, &[], &model.entry().modes.iter().map(|it| it.name).collect::<Vec<_>>());
        check_names(name, &['_'], states);
        // A pose is called after its frame: `key.x`.
        check_names(name, &['_', '.'], outputs);
        assert!(states.len() <= model.at_rest(&still(0.0)).1.entries().len(), "{name}: states");
        assert_eq!(model.entry().coordinates, model.coordinates(), "{name}: coordinates");
        assert!(model.coordinates() <= states.len(), "{name}: coordinates");
        let sentences = parameters.iter().map(|it| &it.doc).chain(presets.iter().map(|it| &it.doc));
        let summary = &model.entry().summary;
        assert!(sentences.chain([summary]).all(|doc| doc.len() > 6), "{name}: documented");
        let are_given = |it: &Parameter| !it.unit.is_empty() && !it.title.is_empty();
        assert!(parameters.iter().all(are_given), "{name}: units and titles");
    }
}

#[test]
fn a_guard_is_called_alike_in_every_mode() {
    for model in small() {
        let mut known: Vec<(GuardId, &str)> = Vec::new();
        let name = model.entry().name;
        for (mode, _) in model.modes() {
            let guards = model.guards(mode);
            assert!(guards.len() <= MAX_GUARDS);
            let mut priorities: Vec<_> = guards.iter().map(|guard| guard.priority).collect();
            priorities.sort_unstable();
            priorities.dedup();
            assert_eq!(priorities.len(), guards.len(), "{name} {mode:?}: ties");
            for guard in guards {
                assert!(guard.scale > 0.0 && guard.scale.is_finite());
                let same = |it: &&(GuardId, &str)| it.0 == guard.id || it.1 == guard.name;
                match known.iter().find(same) {
                    Some(it) => assert_eq!(*it, (guard.id, guard.name), "{name}"),
                    None => known.push((guard.id, guard.name)),
                }
            }
        }
        check_names(name, &['_', '-'], &known.iter().map(|it| it.1).collect::<Vec<_>>());
    }
}

#[test]
fn an_entry_lists_the_modes_and_guards_of_its_model() {
    for model in small() {
        let entry = model.entry();
        let label = entry.name;
        assert!(named(label).is(entry), "{label} is found by its name");
        let modes: Vec<_> = model.modes().collect();
        assert_eq!(modes.len(), entry.modes.len(), "{label}: modes");
        for (index, ((mode, name), listed)) in (0..).zip(modes.into_iter().zip(&entry.modes)) {
            let number = model.mode_code(mode);
            assert_eq!((number, model.mode(number)), (ModeCode::structural(index), Some(mode)));
            assert_eq!(
                ModeName { model: model.shared(), mode: number }.to_string(),
                name,
                "{label}"
            );
            let guards: Vec<_> = model.guards(mode).iter().map(|guard| guard.name).collect();
            let named: Vec<_> = listed.guards.iter().map(|guard| guard.name).collect();
            assert_eq!(guards, named, "{label} {name}");
            assert_eq!(listed.p, listed.n - listed.m, "{label} {name}");
            let moves = |index: &usize| model.parts(mode).iter().any(|part| part.has(*index));
            let free = (0..entry.states.len()).filter(moves).count();
            assert_eq!(free, 2 * usize::from(listed.p), "{label} {name}: coordinates and speeds");
        }
        assert_eq!(model.mode(ModeCode::structural(u8::MAX)), None, "{label}");
        assert_eq!(
            ModeName { model: model.shared(), mode: ModeCode::NONE }.to_string(),
            "?",
            "{label}"
        );
    }
}

#[test]
fn presets_are_complete_and_within_ranges_for_all_keys() {
    for model in small() {
        let ModelEntry { name: model, presets, parameters, .. } = model.entry();
        assert!(!presets.is_empty());
        for preset in presets {
            for (index, Parameter { name, range, .. }) in parameters.iter().enumerate() {
                let values = (0..88).map(|key| preset.value(index, key));
                let outside = values.enumerate().find(|(_, it)| !(range.0..=range.1).contains(it));
                assert_eq!(outside, None, "{model} {}: {name} of a key", preset.name);
            }
        }
    }
}

fn presets<M: Described>(model: &M) -> impl Iterator<Item = (String, M)> + use<'_, M> {
    let ModelEntry { name, presets, parameters, .. } = model.entry();
    let keys = |preset| [0_u8, 29, 58, 87].map(|key| (preset, key));
    presets.iter().flat_map(keys).map(move |(preset, key)| {
        let at_rest = |(index, it): (usize, &Parameter)| {
            if it.name == "y0" { 0.0 } else { preset.value(index, key) }
        };
        let values: Vec<_> = parameters.iter().enumerate().map(at_rest).collect();
        (format!("{name} {} key {key}", preset.name), model.with_values(&values))
    })
}

struct Place<M: Described> {
    label: String,
    model: M,
    mode: M::Mode,
    x: M::State,
    input: Motion,
}

fn places<M: Playable>(
    model: &M,
    n: usize,
    seed: u64,
) -> impl Iterator<Item = Place<M>> + use<'_, M> {
    let mut random = Random::new(seed);
    let modes = |(label, model): (String, M)| {
        let modes: Vec<_> = model.modes().collect();
        modes.into_iter().map(move |(mode, name)| (format!("{label} {name}"), model.clone(), mode))
    };
    let again = move |it| std::iter::repeat_n(it, n);
    presets(model).flat_map(modes).flat_map(again).map(move |(label, model, mode)| {
        let (x, input) = somewhere(&model, mode, &mut random);
        Place { label, model, mode, x, input }
    })
}

#[test]
fn missing_values_are_the_default_presets() {
    for model in small() {
        let ModelEntry { name: label, presets, parameters, .. } = model.entry();
        let all = values(&presets[0], parameters.len(), 0);
        assert!(model == model.with_values(&all), "{label}");
        assert!(model.with_values(&[]) == model.with_values(&all), "{label}");
        assert!(model.with_values(&all[..1]) == model.with_values(&all), "{label}");
        for index in 0..all.len() {
            let mut changed = all.clone();
            changed[index] = 0.5 * all[index] + 0.123;
            let name = parameters[index].name;
            assert!(model.with_values(&changed) != model.with_values(&all), "{label}: {name}");
            assert!(model.with_values(&changed).with_values(&all) == model, "{label}: {name}");
        }
    }
}

/// Largest accelerations at an equilibrium (1/s²): an angle's last bit, 1e-17, times the stiffest
/// spring over the smallest inertia of any preset, 1e6 1/s².
const ROUNDING: f64 = 1e-10;

fn is_nothing<S: State>(x: &S) -> bool {
    x.entries().iter().all(|entry| entry.abs() < ROUNDING)
}

#[test]
fn at_rest_is_at_rest() {
    for (label, model) in small().flat_map(|it| presets(&it).collect::<Vec<_>>()) {
        for metres in [0.0, 0.004] {
            let input = still(metres * model.input_per_metre());
            let (mode, x) = model.at_rest(&input);
            // In a mode without equations the constraint determines the state.
            if !model.parts(mode).is_empty() {
                let dx = model.derivative(mode, &x, &input);
                assert!(is_nothing(&dx), "{label} at {metres}: {dx:?}");
            }
            assert_eq!(model.constrain(mode, &x, &input), x, "{label}");
            let guards = model.guards(mode).iter();
            let lowest = guards
                .map(|guard| model.guard(mode, guard.id, &x, &input).value)
                .fold(f64::INFINITY, f64::min);
            assert!(lowest >= 0.0, "{label} at {metres}: a guard is {lowest}");
        }
    }
}

#[test]
fn what_is_at_rest_stays_there() {
    for (label, model) in small().flat_map(|it| presets(&it).collect::<Vec<_>>()) {
        let input = still(0.002 * model.input_per_metre());
        let (mode, x) = model.at_rest(&input);
        let force = model.readout(mode, &x, &input);
        let (audited, end) = run(&model, (mode, x), (1e-3, 1.0), |_| input);
        assert!(audited.events.is_empty(), "{label}: {:?}", audited.names());
        let drift = end.state().plus(-1.0, &x);
        assert!(is_nothing(&drift), "{label} moved by {drift:?}");
        let last = audited.ticks.last().expect("a tick").mean_readout;
        assert!((last - force).abs() < 1e-8 * force.abs().max(1.0), "{label}: {last} N");
    }
}

#[test]
fn every_output_is_written() {
    for model in small() {
        let n = model.entry().outputs.len();
        for Place { label, model, mode, x, input } in places(&model, 1, 1) {
            let mut out = [f64::NAN; 64];
            model.outputs(mode, &x, &input, &mut out);
            let (written, rest) = out.split_at(n);
            assert!(written.iter().all(|it| it.is_finite()), "{label}: {out:?}");
            assert!(rest.iter().all(|it| it.is_nan()), "{label}: {out:?}");
            // A shorter buffer is filled.
            model.outputs(mode, &x, &input, &mut out[..1]);
        }
    }
}

#[test]
fn everything_is_finite() {
    for model in small() {
        for Place { label, model, mode, x, input } in places(&model, 5, 2) {
            let scale = model.input_per_metre();
            assert!(scale.is_finite() && scale.abs() > 0.0, "{label}: {scale}");
            let longest_step = model.nature(mode).longest_step;
            assert!(longest_step > 1e-5, "{label}: {longest_step}");
            let scalars = [
                model.readout(mode, &x, &input),
                model.energy(mode, &x, &input),
                model.supplied(mode, &x, &input),
                model.dissipated(mode, &x, &input),
            ];
            assert!(scalars.iter().all(|it| it.is_finite()), "{label}: {scalars:?}");
        }
    }
}

#[test]
fn resets_lead_to_listed_modes() {
    for model in small() {
        let is_listed = |mode| model.modes().any(|(known, _)| known == mode);
        for Place { label, model, mode, x, input } in places(&model, 20, 5) {
            for guard in model.guards(mode) {
                let reset = model.reset(mode, guard.id, &x, &input);
                let finite = reset.state.entries().iter().all(|it| it.is_finite());
                assert!(finite && reset.impulse.is_finite(), "{label}: {:?}", reset.state);
                assert!(is_listed(reset.mode), "{label}: {:?}", reset.mode);
                assert!(leads(&model, (mode, guard.id), reset.mode), "{label}: {:?}", reset.mode);
                let Some(settling) = reset.settles else { continue };
                assert!(is_listed(settling.mode), "{label}: {:?}", settling.mode);
                assert!(
                    leads(&model, (mode, guard.id), settling.mode),
                    "{label}: {:?}",
                    settling.mode
                );
                assert!(settling.after > 0.0 && settling.ratio > 0.0 && settling.ratio < 1.0);
            }
        }
    }
}

/// Returns `true` if the entry of `model` lists `to` among the targets of the mode's guard.
fn leads<M: Playable>(model: &M, (mode, guard): (M::Mode, GuardId), to: M::Mode) -> bool {
    let of = |mode| usize::from(model.mode_code(mode).structure());
    let modes = &model.entry().modes;
    let spec = model.guards(mode).iter().find(|it| it.id == guard).expect("a listed guard");
    let listed = modes[of(mode)].guards.iter().find(|it| it.name == spec.name).expect("a guard");
    listed.to.contains(&modes[of(to)].name)
}

#[test]
fn dampers_only_take() {
    for model in small() {
        for Place { label, model, mode, x, input } in places(&model, 50, 3) {
            let mut guards = model.guards(mode).iter();
            if guards.all(|guard| model.guard(mode, guard.id, &x, &input).value > 0.0) {
                let power = model.dissipated(mode, &x, &input);
                assert!(power >= 0.0, "{label}: {power} W");
            }
        }
    }
}

#[test]
fn guard_rates_are_the_guards_rates() {
    // Compares each guard's rate with central differences along the flow.
    //
    // The difference over 2ε errs by ε²/6 of the third derivative, a third of its difference from
    // the one over 4ε, and by rounding, a few ulps of the guard's terms over ε. Far from rest stiff
    // springs reverse friction within 1 µs: there ε must be smaller.
    for model in small() {
        const EPSILONS: [f64; 3] = [1e-5, 1e-6, 1e-7];
        for place in places(&model, 20, 4) {
            let Place { label, model, mode, x, input } = &place;
            for guard in model.guards(*mode) {
                let at = |t: f64| {
                    let (x, input) = flow(&place, t);
                    model.guard(*mode, guard.id, &x, &input).value
                };
                let here = model.guard(*mode, guard.id, x, input);
                let difference = |epsilon: f64| {
                    let slope = |e: f64| (at(e) - at(-e)) / (2.0 * e);
                    let (fine, coarse) = (slope(epsilon), slope(2.0 * epsilon));
                    let rounding = 1e-14 * (here.value.abs() + guard.scale) / epsilon;
                    (fine, (fine - coarse).abs() + rounding)
                };
                let tried = EPSILONS.map(difference);
                let (name, rate) = (guard.name, here.rate);
                let agrees = tried.iter().any(|(slope, allowed)| (rate - slope).abs() <= *allowed);
                assert!(agrees, "{label} {name}: rate {rate} is none of {tried:?}");
            }
        }
    }
}

#[test]
fn slopes_are_those_of_the_readout() {
    for model in small() {
        let mut random = Random::new(30);
        for (mode, name) in model.modes() {
            for _ in 0..50 {
                let (x, input) = somewhere(&model, mode, &mut random);
                let readout =
                    |input: Motion| model.readout(mode, &model.constrain(mode, &x, &input), &input);
                let slopes = model.slopes(mode, &x, &input);
                // A chord over 1e-5 of the key's travel: boards do not resolve a bend inside it.
                let by = 1e-7 * model.input_per_metre();
                let position = |by: f64| Motion { position: input.position + by, ..input };
                let rate = |by: f64| Motion { rate: input.rate + by, ..input };
                let chord = |moved: &dyn Fn(f64) -> Motion| {
                    (readout(moved(by)) - readout(moved(-by))) / (2.0 * by)
                };
                let size = 1.0 + readout(input).abs() * 1e-3 / by.abs();
                for (chord, slope) in
                    [(chord(&position), slopes.per_position), (chord(&rate), slopes.per_rate)]
                {
                    let error = (chord - slope).abs();
                    let tolerance = 1e-4 * chord.abs() + 1e-10 * size;
                    assert!(
                        error < tolerance,
                        "{} {name}: {slope}, chord {chord}",
                        model.entry().name
                    );
                }
            }
        }
    }
}

#[test]
fn every_mode_is_of_the_nature_that_it_states() {
    for model in small() {
        let mut random = Random::new(20);
        let modes = model.modes().filter(|(mode, _)| !model.parts(*mode).is_empty());
        for (mode, name) in modes {
            for _ in 0..50 {
                let here = somewhere(&model, mode, &mut random);
                let there = somewhere(&model, mode, &mut random);
                if model.nature(mode).is_linear() {
                    check_linear(&model, (mode, name), &here, &there);
                }
                check_rate(&model, (mode, name), &here);
            }
        }
    }
}

#[track_caller]
fn check_linear<M: Playable>(
    model: &M,
    (mode, name): (M::Mode, &str),
    (x, input): &(M::State, Motion),
    (y, other): &(M::State, Motion),
) {
    let f = |x: &M::State, u: &Motion| model.derivative(mode, x, u);
    let sum = f(x, input).plus(1.0, &f(y, input));
    let parts = f(&x.plus(1.0, y), input).plus(1.0, &f(&M::State::ZERO, input));
    check_equal(&sum, &parts, format_args!("{} {name} is not linear", model.entry().name));
    if model.nature(mode).kind == EquationKind::Affine {
        check_equal(
            &f(x, input),
            &f(x, other),
            format_args!("{} {name} reads its input", model.entry().name),
        );
    }
}

/// Checks the stated rate near rest and where the mode is valid: a felt that hardens has any rate
/// if it is pressed deep enough.
#[track_caller]
fn check_rate<M: Playable>(
    model: &M,
    (mode, name): (M::Mode, &str),
    (x, input): &(M::State, Motion),
) {
    let rest = model.at_rest(input).1;
    let x = model.constrain(mode, &rest.plus(0.01, &x.plus(-1.0, &rest)), input);
    let mut guards = model.guards(mode).iter();
    let is_valid = guards.all(|guard| model.guard(mode, guard.id, &x, input).value >= 0.0);
    let stated = model.nature(mode).rate;
    if stated > 0.0 && is_valid {
        // ‖J³²‖^(1/32) is at most slightly above the largest magnitude of an eigenvalue.
        let squared = |j: <M::State as State>::Matrix| j.product(&j);
        let j = model.jacobian(mode, &x, input);
        let rate = squared(squared(squared(squared(squared(j))))).norm().powf(1.0 / 32.0);
        assert!(rate < 2.0 * stated, "{} {name}: {rate}, stated {stated}", model.entry().name);
    }
}

#[track_caller]
fn check_equal<S: State>(a: &S, b: &S, what: std::fmt::Arguments<'_>) {
    for (a, b) in a.entries().iter().zip(b.entries()) {
        assert!((a - b).abs() <= 1e-12 * (1.0 + a.abs()), "{what}: {a} and {b}");
    }
}

/// Returns a state of `mode` near rest, and an input near its own.
fn somewhere<M: Playable>(model: &M, mode: M::Mode, random: &mut Random) -> (M::State, Motion) {
    let span = 0.01 * model.input_per_metre();
    let input = Motion {
        position: span * random.between(0.0, 1.0),
        rate: 10.0 * span * random.between(-1.0, 1.0),
        acceleration: 100.0 * span * random.between(-1.0, 1.0),
        jerk: 1000.0 * span * random.between(-1.0, 1.0),
    };
    let mut x = model.at_rest(&input).1;
    for (index, entry) in x.as_mut().iter_mut().enumerate() {
        *entry += random.between(-1.0, 1.0) * if index < model.coordinates() { 0.1 } else { 1.0 };
    }
    (model.constrain(mode, &x, &input), input)
}

/// Returns state and input `t` (s) later, in the same mode, with constant jerk of the input.
fn flow<M: Playable>(place: &Place<M>, t: f64) -> (M::State, Motion) {
    let Place { model, mode, x, input, .. } = place;
    let later = |t: f64| {
        let Motion { position, rate, acceleration, jerk } = *input;
        Motion {
            position: position + t * (rate + t * (acceleration / 2.0 + t * jerk / 6.0)),
            rate: rate + t * (acceleration + t * jerk / 2.0),
            acceleration: acceleration + t * jerk,
            jerk,
        }
    };
    let f = |tau: f64, x: &M::State| model.derivative(*mode, x, &later(tau * t));
    let mut field = Given { coords: model.coordinates(), nature: Nature::default(), f };
    let step = Rk4.step(&mut field, x, &mut (), t);
    (model.constrain(*mode, step.dense.end(), &later(t)), later(t))
}
