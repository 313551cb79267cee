//! A model built from arbitrary bytes, as difficult as the traits permit, and the promises of a
//! tick. Shared by the fuzz target and its twin in the tests.
#![allow(dead_code, unreachable_pub, reason = "each of its users has its own part")]

pub mod bytes;
mod effect;
mod motion;
pub mod plan;
pub mod promises;
mod specs;
pub mod steppers;
mod trouble;
mod wave;

use std::cell::Cell;

use bytes::Bytes;
use effect::Effect;
use motion::ModePart;
use pode::{
    Enclosure, GuardBound, GuardId, GuardSpec, GuardValue, Guarded, MAX_GUARDS, Model, Motion,
    Nature, Reset, Resets, State,
};
use trouble::Trouble;

/// Entries of the state: time, count, height and its rate.
pub const STATE: usize = 4;

pub const MODES: u8 = 4;

#[derive(Debug, Default)]
pub struct Calls {
    pub derivatives: Cell<u32>,
    pub jacobians: Cell<u32>,
    pub guards: Cell<u32>,
    pub readouts: Cell<u32>,
    pub lists: Cell<u32>,
    /// Bracket of the malicious guard's root.
    pub malice: Cell<[f64; 2]>,
}

fn count(calls: &Cell<u32>) -> u32 {
    let before = calls.get();
    calls.set(before.wrapping_add(1));
    before
}

#[derive(Clone, Copy, Debug)]
struct GuardPart {
    trouble: Trouble,
    effect: Effect,
    /// Declared bound of its curvature, true or not (1/s²).
    bound: f64,
}

impl GuardPart {
    fn from_bytes(bytes: &mut Bytes<'_>) -> Self {
        Self {
            trouble: Trouble::from_bytes(bytes),
            effect: Effect::from_bytes(bytes),
            bound: match bytes.byte() % 4 {
                0..=1 => f64::INFINITY,
                2 => 9.81,
                _ => bytes.odd(|it| it.signed(1e-3, 1e12)),
            },
        }
    }
}

#[derive(Clone, Copy, Debug)]
pub struct Adversary<'a> {
    calls: &'a Calls,
    modes: [ModePart; MODES as usize],
    lists: [&'static [GuardSpec]; MODES as usize],
    guards: [GuardPart; MAX_GUARDS],
    is_forgetful: bool,
}

impl<'a> Adversary<'a> {
    pub fn from_bytes(bytes: &mut Bytes<'_>, calls: &'a Calls) -> Self {
        let is_ball = bytes.is_one_in(4);
        let mut it = Self {
            calls,
            modes: std::array::from_fn(|_| ModePart::from_bytes(bytes)),
            lists: std::array::from_fn(|_| match bytes.byte() {
                0..232 => bytes.pick(&specs::LISTS[..7]),
                232.. => bytes.pick(&specs::LISTS),
            }),
            guards: std::array::from_fn(|_| GuardPart::from_bytes(bytes)),
            is_forgetful: bytes.is_one_in(16),
        };
        if is_ball {
            it.modes[0] = ModePart::fall();
            it.guards[0].trouble = Trouble::Floor;
            it.guards[0].effect = Effect::bounce(bytes);
        }
        it
    }

    pub fn turned(mut self) -> Self {
        self.modes.rotate_left(1);
        self
    }

    fn mode(&self, mode: u8) -> &ModePart {
        &self.modes[usize::from(mode % MODES)]
    }

    fn part(&self, guard: GuardId) -> &GuardPart {
        &self.guards[usize::from(guard.0) % MAX_GUARDS]
    }
}

impl Model for Adversary<'_> {
    type Mode = u8;
    type State = [f64; STATE];
    type Input = Motion;
    const COORDS: usize = 3;

    fn derivative(&self, mode: u8, x: &[f64; STATE], input: &Motion) -> [f64; STATE] {
        count(&self.calls.derivatives);
        self.mode(mode).derivative(x, input)
    }

    fn readout(&self, mode: u8, x: &[f64; STATE], input: &Motion) -> f64 {
        count(&self.calls.readouts);
        self.mode(mode).readout(x, input)
    }

    fn jacobian(
        &self,
        mode: u8,
        x: &[f64; STATE],
        input: &Motion,
    ) -> <[f64; STATE] as State>::Matrix {
        count(&self.calls.jacobians);
        self.mode(mode).jacobian(x, input)
    }

    fn nature(&self, mode: u8) -> Nature {
        self.mode(mode).nature.with_longest_step(self.mode(mode).longest_step)
    }
}

impl Guarded for Adversary<'_> {
    fn constrain(&self, mode: u8, x: &[f64; STATE], input: &Motion) -> [f64; STATE] {
        self.mode(mode).constrain(x, input)
    }

    fn guards(&self, mode: u8) -> &'static [GuardSpec] {
        let is_forgotten = self.is_forgetful && count(&self.calls.lists) % 3 == 2;
        if is_forgotten { &[] } else { self.lists[usize::from(mode % MODES)] }
    }

    fn guard_bound(
        &self,
        _: u8,
        guard: GuardId,
        over: &Enclosure<[f64; STATE], Motion>,
    ) -> GuardBound {
        over.entry(usize::from(guard.0) % STATE).plus(over.position()).times(self.part(guard).bound)
    }

    fn guard(&self, mode: u8, id: GuardId, x: &[f64; STATE], input: &Motion) -> GuardValue {
        count(&self.calls.guards);
        let it = self.part(id).trouble.value(x, input, self.calls);
        if self.mode(mode).is_negated { GuardValue::new(-it.value, -it.rate) } else { it }
    }
}

impl Resets for Adversary<'_> {
    fn reset(&self, mode: u8, id: GuardId, x: &[f64; STATE], _: &Motion) -> Reset<Self> {
        self.part(id).effect.reset(mode, x)
    }
}
