//! A model by hand and the same one described, compared.

use equations::table::Functions;
use equations::{EquationModel, ModeNumber};
use models::{ModeCode, Playable};
use pode::{
    Energetic as _, GuardSpec, Guarded as _, Model as _, Motion, Resets as _, Sloped as _,
    State as _,
};

use super::span::Span;
use crate::random::Random;

/// How closely both agree, relative to the value and to what it is a sum of.
pub(super) const AGREEMENT: f64 = 1e-12;
/// Random places in each mode, for each set of values.
const PLACES: usize = 200;

/// A described model whose state is at the front of four entries.
pub(super) type DescribedModel<F> = EquationModel<F, 4, 256>;

/// A model by hand, the same one described, and how far states and input go.
pub(super) struct Pair<W, F> {
    pub(super) label: String,
    pub(super) written: W,
    pub(super) described: DescribedModel<F>,
    pub(super) span: fn(u8) -> Span,
    /// What the described energy has in addition (J).
    pub(super) offset: f64,
}

/// The entries of a state by hand from those of the described one.
fn short<W: Playable>(x: &[f64; 4]) -> W::State {
    let mut short = W::State::ZERO;
    for (entry, value) in short.as_mut().iter_mut().zip(x) {
        *entry = *value;
    }
    short
}

#[track_caller]
fn close(found: f64, expected: f64, size: f64, what: std::fmt::Arguments<'_>) {
    let bound = AGREEMENT * size.max(expected.abs()).max(1.0);
    assert!((found - expected).abs() <= bound, "{what}: {found} is not {expected}");
}

impl<W: Playable, F: Functions + Copy> Pair<W, F> {
    /// Compares everything in all modes.
    pub(super) fn compare_all(&self, random: &mut Random) {
        let (a, b) = (self.described.input_per_metre(), self.written.input_per_metre());
        close(a, b, 1.0, format_args!("{}: input per metre", self.label));
        for mode in (0..).take(self.described.table().modes.len()) {
            for _ in 0..PLACES {
                let (x, s) = self.place(mode, random);
                self.compare(mode, &x, &s);
                self.compare_outputs(mode, &x, &s);
                self.compare_guards(mode, &x, &s);
            }
            self.compare_resets(mode, random);
        }
    }

    fn mode(&self, number: u8) -> W::Mode {
        self.written.mode(ModeCode::structural(number)).expect("as many modes")
    }

    /// The guards of both in a mode, by their names.
    fn guards(&self, mode: u8) -> Vec<(GuardSpec, GuardSpec)> {
        let ours = self.described.guards(ModeNumber(mode));
        let theirs = self.written.guards(self.mode(mode));
        assert_eq!(ours.len(), theirs.len(), "{} {mode}", self.label);
        let named = |it: &GuardSpec| {
            let other = theirs.iter().find(|other| other.name == it.name);
            *other.unwrap_or_else(|| panic!("{} has no guard {}", self.label, it.name))
        };
        let spec = |it: &GuardSpec| (it.fires, it.scale.to_bits());
        let pairs: Vec<_> = ours.iter().map(|it| (*it, named(it))).collect();
        for (ours, theirs) in &pairs {
            assert_eq!(spec(ours), spec(theirs), "{} {mode} {}", self.label, ours.name);
        }
        // Which of two that fire at once is taken.
        let order = |all: &[GuardSpec]| {
            let mut all: Vec<_> = all.iter().map(|it| (it.priority, it.name)).collect();
            all.sort_unstable();
            all.into_iter().map(|(_, name)| name).collect::<Vec<_>>()
        };
        assert_eq!(order(ours), order(theirs), "{} {mode}", self.label);
        pairs
    }

    /// A random state that the mode can have, and an input.
    fn place(&self, mode: u8, random: &mut Random) -> ([f64; 4], Motion) {
        let (x, s) = (self.span)(mode).random(random);
        let ours = self.described.constrain(ModeNumber(mode), &x, &s);
        let theirs = self.written.constrain(self.mode(mode), &short::<W>(&x), &s);
        for (i, expected) in theirs.entries().iter().enumerate() {
            close(ours[i], *expected, x[i], format_args!("{} {mode}: slaved {i}", self.label));
        }
        (ours, s)
    }

    fn compare(&self, mode: u8, x: &[f64; 4], s: &Motion) {
        let (m, n, y) = (self.mode(mode), ModeNumber(mode), short::<W>(x));
        let (ours, theirs) = (&self.described, &self.written);
        let what = |of: &'static str| (of, &self.label, mode, x, s);
        let check = |found: f64, expected: f64, of| {
            close(found, expected, 1.0, format_args!("{:?}", what(of)));
        };
        let found = ours.derivative(n, x, s);
        let expected = theirs.derivative(m, &y, s);
        for (i, expected) in expected.entries().iter().enumerate() {
            let moves = |parts: &[pode::Part]| parts.iter().any(|part| part.has(i));
            assert_eq!(moves(ours.parts(n)), moves(theirs.parts(m)), "{:?} {i}", what("part"));
            if moves(ours.parts(n)) {
                check(found[i], *expected, "derivative");
            }
        }
        check(ours.readout(n, x, s), theirs.readout(m, &y, s), "readout");
        check(ours.energy(n, x, s), theirs.energy(m, &y, s) + self.offset, "energy");
        check(ours.supplied(n, x, s), theirs.supplied(m, &y, s), "supplied");
        check(ours.dissipated(n, x, s), theirs.dissipated(m, &y, s), "dissipated");
        let (found, expected) = (ours.slopes(n, x, s), theirs.slopes(m, &y, s));
        // Those of A by hand are differences.
        let size = if ours.table().name == "key-hammer-rigid" { 1e-6 / AGREEMENT } else { 1.0 };
        let pairs =
            [(found.per_position, expected.per_position), (found.per_rate, expected.per_rate)];
        for (found, expected) in pairs {
            close(
                found,
                expected,
                size * expected.abs().max(1.0),
                format_args!("{:?}", what("slope")),
            );
        }
    }

    fn compare_outputs(&self, mode: u8, x: &[f64; 4], s: &Motion) {
        let (m, n, y) = (self.mode(mode), ModeNumber(mode), short::<W>(x));
        let (ours, theirs) = (&self.described, &self.written);
        let names = theirs.entry().outputs;
        let (mut found, mut expected) = ([0.0; 32], [0.0; 32]);
        ours.outputs(n, x, s, &mut found);
        theirs.outputs(m, &y, s, &mut expected);
        for (i, name) in names.iter().enumerate() {
            assert_eq!(ours.table().outputs[i].name, *name, "{}", self.label);
            let what = format_args!("{} {mode} {name} at {x:?}, {s:?}", self.label);
            close(found[i], expected[i], 1.0, what);
        }
    }

    fn compare_guards(&self, mode: u8, x: &[f64; 4], s: &Motion) {
        let (m, n, y) = (self.mode(mode), ModeNumber(mode), short::<W>(x));
        let (ours, theirs) = (&self.described, &self.written);
        let what = |of: &'static str| (of, &self.label, mode, x, s);
        for (own, other) in self.guards(mode) {
            let found = ours.guard(n, own.id, x, s);
            let expected = theirs.guard(m, other.id, &y, s);
            let sum = expected.value.abs().max(own.scale);
            close(found.value, expected.value, sum, format_args!("{:?}", what(own.name)));
            let sum = sum.max(expected.rate.abs());
            close(found.rate, expected.rate, sum, format_args!("{:?}'s rate", what(own.name)));
        }
    }

    /// Compares where each guard leads, at states where it is 0.
    fn compare_resets(&self, mode: u8, random: &mut Random) {
        let span = (self.span)(mode);
        for (own, other) in self.guards(mode) {
            let pairs = (0..PLACES).map(|_| [span.random(random), span.random(random)]);
            let zeros: Vec<_> = pairs.filter_map(|pair| self.zero(mode, &own, pair)).collect();
            for (x, s) in &zeros {
                self.compare_reset(mode, (&own, &other), x, s);
            }
            assert!(!zeros.is_empty(), "{} {mode}: {} never fires", self.label, own.name);
        }
    }

    /// Where between two states a guard comes to zero and falls.
    fn zero(
        &self,
        mode: u8,
        guard: &GuardSpec,
        [a, b]: [([f64; 4], Motion); 2],
    ) -> Option<([f64; 4], Motion)> {
        let mode = ModeNumber(mode);
        let between = |t: f64| {
            let mix = |a: f64, b: f64| a + t * (b - a);
            let x = std::array::from_fn(|i| mix(a.0[i], b.0[i]));
            let s = Motion {
                position: mix(a.1.position, b.1.position),
                rate: mix(a.1.rate, b.1.rate),
                acceleration: mix(a.1.acceleration, b.1.acceleration),
                jerk: mix(a.1.jerk, b.1.jerk),
            };
            (self.described.constrain(mode, &x, &s), s)
        };
        let value = |t: f64| {
            let (x, s) = between(t);
            self.described.guard(mode, guard.id, &x, &s).value
        };
        let (mut above, mut below) = if value(0.0) > 0.0 { (0.0, 1.0) } else { (1.0, 0.0) };
        if value(above) <= 0.0 || value(below) > 0.0 {
            return None;
        }
        for _ in 0..100 {
            let middle = 0.5 * (above + below);
            *(if value(middle) > 0.0 { &mut above } else { &mut below }) = middle;
        }
        let (x, s) = between(below);
        (self.described.guard(mode, guard.id, &x, &s).rate < 0.0).then_some((x, s))
    }

    fn compare_reset(
        &self,
        mode: u8,
        (own, other): (&GuardSpec, &GuardSpec),
        x: &[f64; 4],
        s: &Motion,
    ) {
        let what = (&self.label, mode, own.name, x, s);
        let y = short::<W>(x);
        let found = self.described.reset(ModeNumber(mode), own.id, x, s);
        let expected = self.written.reset(self.mode(mode), other.id, &y, s);
        let number = |mode: W::Mode| self.written.mode_code(mode).structure();
        assert_eq!(found.mode.0, number(expected.mode), "{what:?}");
        // Slaved entries are put in place by the mode that follows.
        let found_state = self.described.constrain(found.mode, &found.state, s);
        let state = self.written.constrain(expected.mode, &expected.state, s);
        for (found, expected) in found_state.iter().zip(state.entries()) {
            close(*found, *expected, 1.0, format_args!("{what:?} resets"));
        }
        close(found.impulse, expected.impulse, 1.0, format_args!("{what:?} gives"));
        let sounds = self.described.sounding(own.id, x);
        let speed = self.written.sounding(other.id, &y).map(|it| it.speed);
        assert_eq!(sounds.is_some(), speed.is_some(), "{what:?}");
        close(sounds.unwrap_or(0.0), speed.unwrap_or(0.0), 1.0, format_args!("{what:?} sounds"));
    }
}
