use std::time::Duration;

use boards::keybed::{Armed, BoardReport, Keybed, LineReport};
use boards::plan::BusPlan;
use boards::rt::link_monitor::LinkSample;
use boards::sim::keybed::SimulatedKeybed;
use boards::topology::{BoardPlace, standard};
use firmware_protocol::key::BoardId;
use rtrb::Consumer;
use scheduler::motion::{KEYS, KeySample, KeySlope};
use scheduler::port::KeyBus;
use scheduler::time::Nanos;
use telemetry::{Board, Line};

use super::PreparedRun;
use super::trial::SimulatedKeys;
use crate::connected_boards::stop_all;
use crate::control::{BoardsTold, IdentifyTarget, Lights};
use crate::observe::{LinksWatch, TelemetryMessage};
use crate::report::{BoardLine, LinkLine, LinkReport};

pub(super) type Plans = Vec<Option<BusPlan>>;

pub(super) enum KeyTransport {
    Simulated(SimulatedKeys),
    /// Keys on armed boards, the plan of each line, and the time at which tick 0 is due (us).
    Boards(Box<Keybed<Armed>>, Plans, u64),
}

impl KeyTransport {
    /// Returns simulated keys whose boards are rearmed after a stall of the host.
    pub(super) fn simulated(mut keys: SimulatedKeys, prepared: &PreparedRun) -> Self {
        let keybed = &mut keys.keybed;
        prepared.handle.lend_fingers(keybed.press_requests());
        keybed.keep_armed();
        let places = standard();
        let line = |it: &BoardPlace| Line {
            name: format!("simulated {}", it.board.number()),
            planned: f64::NAN,
            seen: f64::NAN,
            ..Line::default()
        };
        let samples = keybed.monitor(prepared.plan.tick_hz);
        publish(samples, places.iter().map(line).collect(), &places, prepared);
        Self::Simulated(keys)
    }

    pub(super) fn on_boards(
        mut keybed: Box<Keybed<Armed>>,
        plans: Plans,
        start: Nanos,
        prepared: &PreparedRun,
    ) -> Self {
        let places: Vec<_> = keybed.terms().map(|it| it.place).collect();
        let names: Vec<_> = keybed.line_names().map(str::to_owned).collect();
        let planned = plans.iter().map(Option::as_ref).chain(std::iter::repeat(None));
        let lines = names.iter().zip(planned).map(|(name, plan)| Line {
            name: name.clone(),
            planned: plan.map_or(f64::NAN, BusPlan::load),
            seen: f64::NAN,
            ..Line::default()
        });
        let lines = lines.collect();
        let target = |it: &BoardPlace| IdentifyTarget {
            line: number(it.line),
            name: names.get(it.line).cloned().unwrap_or_default(),
            board: it.board.number().into(),
        };
        let boards = places.iter().map(target).collect();
        prepared.handle.lend_lights(Lights { boards, requests: keybed.identify_requests() });
        publish(keybed.monitor(prepared.plan.tick_hz), lines, &places, prepared);
        Self::Boards(keybed, plans, start.as_u64() / 1_000)
    }
}

fn publish(
    samples: Consumer<LinkSample>,
    lines: Vec<Line>,
    places: &[BoardPlace],
    prepared: &PreparedRun,
) {
    let board = |it: &BoardPlace| Board {
        line: number(it.line),
        id: it.board.number().into(),
        first_key: it.first_key.number().into(),
        keys: number(it.n_keys),
        round_trip: f64::NAN,
        ..Board::default()
    };
    let links = telemetry::Links { lines, boards: places.iter().map(board).collect() };
    let watch = LinksWatch::new(samples, links, 1.0 / f64::from(prepared.plan.tick_hz));
    prepared.handle.tell(TelemetryMessage::Links(Box::new(watch)));
}

fn number(count: usize) -> u32 {
    u32::try_from(count).unwrap_or(u32::MAX)
}

impl KeyBus for KeyTransport {
    fn receive(&mut self, tick: u64, samples: &mut [KeySample; KEYS]) {
        match self {
            Self::Simulated(keys) => keys.receive(tick, samples),
            Self::Boards(keybed, _, start_us) => {
                let due_us = *start_us + tick * keybed.period_us();
                keybed.clock().advance_to(due_us);
                keybed.receive(tick, samples);
            }
        }
    }

    fn send(&mut self, tick: u64, forces: &[f64; KEYS], slopes: &[KeySlope; KEYS]) {
        match self {
            Self::Simulated(keys) => keys.send(tick, forces, slopes),
            Self::Boards(keybed, ..) => keybed.send(tick, forces, slopes),
        }
    }

    fn simulated_work(&self) -> Nanos {
        match self {
            Self::Simulated(keys) => keys.simulated_work(),
            Self::Boards(..) => Nanos::ZERO,
        }
    }
}

impl KeyTransport {
    /// Exchanges with boards until tick 0 is due, so that they stay armed and samples are new.
    pub(super) fn attend_until_start(&mut self) {
        let Self::Boards(keybed, _, start_us) = self else { return };
        while keybed.now_us() + keybed.period_us() < *start_us {
            keybed.exchange();
        }
        let rest_us = start_us.saturating_sub(keybed.now_us());
        keybed.clock().pause(Duration::from_micros(rest_us));
    }

    /// Returns `true` if the keys feel forces after the last tick, until they are disarmed.
    pub(super) const fn outlives_the_run(&self) -> bool {
        match self {
            Self::Simulated(_) => false,
            Self::Boards(..) => true,
        }
    }

    /// Stops the forces of boards until they are restarted; a simulated keybed ends with the run.
    pub(super) fn stop(&mut self) -> BoardsTold {
        match self {
            Self::Simulated(_) => {
                let boards = standard().len();
                BoardsTold { told: boards, boards }
            }
            Self::Boards(keybed, ..) => stop_all(keybed),
        }
    }

    pub(super) fn disarm(&mut self) {
        match self {
            Self::Simulated(_) => {}
            Self::Boards(keybed, ..) => keybed.disarm(),
        }
    }

    pub(super) fn links(&self) -> LinkReport {
        match self {
            Self::Simulated(keys) => simulated_links(&keys.keybed),
            Self::Boards(keybed, ..) => board_links(keybed),
        }
    }

    pub(super) fn lines(&self, seconds: f64) -> Vec<LinkLine> {
        match self {
            Self::Simulated(_) => Vec::new(),
            Self::Boards(keybed, plans, _) => {
                let boards = keybed.board_reports();
                let lines = keybed.line_reports();
                let plans = plans.iter().map(Option::as_ref).chain(std::iter::repeat(None));
                let lines = lines.iter().zip(plans);
                lines.map(|(line, plan)| LinkLine::new(line, plan, &boards, seconds)).collect()
            }
        }
    }

    pub(super) fn boards(&self, seconds: f64) -> Vec<BoardLine> {
        match self {
            Self::Simulated(_) => Vec::new(),
            Self::Boards(keybed, ..) => {
                keybed.board_reports().iter().map(|it| BoardLine::new(it, seconds)).collect()
            }
        }
    }
}

fn simulated_links(keybed: &SimulatedKeybed) -> LinkReport {
    let mut sum = LinkReport { rearmed: keybed.rearmed(), ..LinkReport::default() };
    for board in BoardId::all() {
        let (it, wire) = (keybed.statistics(board), keybed.wire(board));
        sum.frames += it.samples.frames;
        sum.gaps += it.samples.gaps;
        sum.refused += wire.corrupt + wire.foreign + it.refused + wire.down;
    }
    sum
}

fn board_links(keybed: &Keybed<Armed>) -> LinkReport {
    let mut sum = LinkReport::default();
    for BoardReport { statistics, condition, .. } in keybed.board_reports() {
        sum.frames += statistics.samples.frames;
        sum.gaps += statistics.samples.gaps;
        sum.refused += statistics.refused;
        sum.rearmed += condition.armings.saturating_sub(1);
    }
    for LineReport { statistics, .. } in keybed.line_reports() {
        sum.refused += statistics.corrupt + statistics.foreign;
    }
    sum
}
