//! Samples and forces that are usually late by a tick or two, and overtake each other.

use std::sync::Arc;

use boards::links::faulty::{Chance, FaultPlan, LinkFault};
use boards::sim::keybed::SimulatedKeybed;
use firmware_protocol::key::BoardId;
use haptics::Touch;
use scene::Scene;
use scheduler::motion::{KEYS, KeyEvent};
use scheduler::port::{FinishedTick, TickObserver};
use scheduler::voice::VoiceFault;

use crate::stage::{Stage, audited, key, keybed, scene, stroke};
use engine::voice::AuditCell;

const STROKES: u32 = 8;
const END: f64 = 4.5;
/// Unexplained energy of a voice permitted in a tick: 25 N over 20 mm (J).
const MOST_UNEXPLAINED: f64 = 0.5;

#[derive(Default)]
struct Heard {
    strikes: u32,
    fastest: f64,
    /// Ticks with unexplained energy of the voice, by key.
    diverged: Vec<u32>,
    other_faults: u32,
    /// Unexplained energy of each voice (J).
    unexplained: Vec<f64>,
}

impl TickObserver for Heard {
    fn observe(&mut self, seen: &FinishedTick<'_>) {
        let turns = seen.turns;
        for (turn, diverged) in turns.iter().zip(&mut self.diverged) {
            let is_diverged =
                matches!(turn.fault, Some(VoiceFault::Diverged | VoiceFault::MakesEnergy));
            *diverged += u32::from(is_diverged);
            self.other_faults += u32::from(turn.fault.is_some() && !is_diverged);
        }
        for (_at, event) in turns.iter().flat_map(|it| it.events.as_slice()) {
            if let KeyEvent::Strike { speed, .. } = event {
                self.strikes += 1;
                self.fastest = self.fastest.max(*speed);
            }
        }
    }
}

fn hands(scene: &Scene) -> SimulatedKeybed {
    let mut keybed = keybed(scene);
    for number in 0..KEYS {
        let first = 0.05 + 0.003 * (number % 11) as f64;
        let strokes = (0..STROKES).map(f64::from).map(|n| {
            let touch = if n % 2.0 < 1.0 { Touch::Pressed } else { Touch::Struck };
            let start = first + 0.5 * n;
            stroke(start, start + 0.25, touch, 0.3 + 0.15 * n)
        });
        keybed.play(key(number), strokes.collect());
    }
    keybed
}

fn heard(hz: u32, probability: f64) -> Heard {
    let mut scene = scene("springs", &[]);
    scene.tick_hz = hz;
    let mut bus = hands(&scene);
    for board in BoardId::all() {
        let chances = [1, 2].map(|ticks| Chance { probability, fault: LinkFault::Delay(ticks) });
        bus.disturb(board, FaultPlan { seed: 3, chances: chances.into(), script: Vec::new() });
    }
    let audits: [Arc<AuditCell>; KEYS] = std::array::from_fn(|_key| Arc::default());
    let silence = Heard { diverged: vec![0; KEYS], ..Heard::default() };
    let mut stage = Stage::of(audited(&scene, &audits), scene.tick_hz, bus, 1).watched_by(silence);
    while stage.scheduler.next_due().as_secs_f64() < END {
        stage.tick();
    }
    let unexplained = audits.iter().map(|it| it.read().residual()).collect();
    Heard { unexplained, ..stage.observer }
}

#[test]
fn at_a_thousand_ticks_a_second_late_frames_cost_some_strikes_and_no_voice() {
    let played = STROKES * u32::try_from(KEYS).expect("few");
    assert_eq!(heard(1000, 0.0).strikes, played, "in time");
    let late = heard(1000, 0.3);
    assert_eq!((late.diverged.iter().sum::<u32>(), late.other_faults), (0, 0));
    // Forces and samples are up to 2 ms late: some hammers are caught late.
    let most = played + played / 5;
    assert!((played..most).contains(&late.strikes), "{} of {played}", late.strikes);
    for (key, unexplained) in late.unexplained.iter().enumerate() {
        assert!(unexplained.abs() < 1e-3, "key {key}: {unexplained} J");
    }
}

/// With up to 16 ms between a finger and its force every key oscillates; its voice must end in a
/// fault before its energies and notes lose their meaning.
#[test]
fn voices_that_oscillate_for_late_frames_end_in_a_fault_and_explain_the_rest() {
    for hz in [500, 250] {
        let late = heard(hz, 0.3);
        assert!(0 < late.diverged.iter().sum::<u32>(), "{hz} Hz: nothing diverged");
        // Ten times a hard blow; without the fault, 1e60 and more.
        assert!(late.fastest < 50.0, "{hz} Hz: a hammer of {} m/s", late.fastest);
        for (key, unexplained) in late.unexplained.iter().enumerate() {
            let most = 20.0 * MOST_UNEXPLAINED;
            assert!(unexplained.abs() < most, "{hz} Hz, key {key}: {unexplained} J");
        }
    }
}
