use boards::keybed::{Calibrated, Keybed, Offline, Terms, WantedBoards};
use boards::plan::{BusPlan, BusVerdict};
use haptics::plant::{MAX_DELAY_STEPS, MAX_SUBSTEP};
use pianist::Performance;
use scheduler::time::Nanos;

use super::key_transport::{KeyTransport, Plans};
use super::trial::SimulatedKeys;
use super::{PreparedRun, SessionError, all_keys};
use crate::connected_boards::{self, PATIENCE_US, calibration, open_all, planning};
use engine::realtime::clock;
use scene::{Boards, period_us};

pub(super) enum KeySource {
    Simulated(SimulatedKeys),
    /// On boards that were found and may be armed.
    Boards(Box<Keybed<Calibrated>>, Terms, Plans),
}

/// Longest delay of a rig (s); nothing is stable behind a longer one.
const LONGEST_DELAY: f64 = MAX_DELAY_STEPS as f64 * MAX_SUBSTEP;

/// Finds the boards of a scene at `tick_hz` without arming them.
///
/// Rejects overloaded links before they are opened if the scene lists the boards, else afterwards.
pub(super) fn find(boards: &Boards, tick_hz: u32) -> Result<KeySource, SessionError> {
    let terms = terms(boards, tick_hz)?;
    refuse_overload(&planning::listed(boards, tick_hz))?;
    let clock = connected_boards::clock(&boards.buses);
    let lines = open_all(&boards.buses, &clock).map_err(SessionError::Links)?;
    let keybed = Keybed::<Offline>::new(lines, clock).identify(PATIENCE_US)?;
    let buses = boards.buses.iter().enumerate();
    let wanted = WantedBoards {
        samples: boards.samples,
        forces: boards.forces,
        boards: buses
            .flat_map(|(line, bus)| bus.boards.iter().map(move |(n, keys)| (line, *n, *keys)))
            .collect(),
        hz: tick_hz,
    };
    let calibrated = keybed.calibrate(&wanted, |found, name| calibration(found, name, boards))?;
    let plans = planning::found(boards, &calibrated, tick_hz);
    refuse_overload(plans.iter().flatten())?;
    Ok(KeySource::Boards(Box::new(calibrated), terms, plans))
}

fn refuse_overload<'a, P: IntoIterator<Item = &'a BusPlan>>(plans: P) -> Result<(), SessionError> {
    let refused = planning::sentences(plans, BusVerdict::Refused);
    if refused.is_empty() {
        Ok(())
    } else {
        Err(SessionError::Overload(refused.join("\nletoff: ")))
    }
}

fn terms(boards: &Boards, tick_hz: u32) -> Result<Terms, SessionError> {
    Ok(Terms {
        period_us: period_us(tick_hz).ok_or(SessionError::BoardRate { tick_hz })?,
        samples: boards.samples,
        forces: boards.forces,
        valid_ms: boards.valid_ms,
    })
}

impl KeySource {
    pub(super) fn carries(&self, key: usize) -> bool {
        match self {
            Self::Simulated(_) => true,
            Self::Boards(keybed, ..) => keybed.places().any(|it| it.keys().contains(&key)),
        }
    }

    /// Returns the time from a sample to the action of its force (s), in ticks of `period` (s):
    /// measured on boards' links, where samples wait half a tick on average.
    pub(super) fn loop_delay(&mut self, period: f64) -> Option<f64> {
        let Self::Boards(keybed, ..) = self else { return None };
        let way = 1e-6 * keybed.round_trip_us()? as f64;
        Some((way + 0.5 * period).min(LONGEST_DELAY))
    }

    pub(super) fn notices(&self) -> Vec<String> {
        let Self::Boards(keybed, ..) = self else { return Vec::new() };
        let (boards, links): (Vec<_>, Vec<_>) = keybed
            .uncalibrated()
            .map(|(name, link)| (name.to_string(), format!(" --link {link}")))
            .unzip();
        if boards.is_empty() {
            return Vec::new();
        }
        let mut links = links;
        links.dedup();
        vec![format!(
            "no calibration file: {}; with simulated fingers, they are taken as they describe \
             themselves: `letoff calibrate{}` measures them",
            boards.join(", "),
            links.concat()
        )]
    }

    pub(super) fn has_fingers(&self) -> bool {
        match self {
            Self::Simulated(_) => true,
            Self::Boards(keybed, ..) => keybed.has_fingers(),
        }
    }

    pub(super) fn load_gestures(&mut self, performance: &Performance) {
        if let Self::Simulated(SimulatedKeys { keybed, .. }) = self {
            for (key, gestures) in all_keys().zip(&performance.gestures) {
                keybed.play(key, gestures.clone());
            }
            performance.repeat.into_iter().for_each(|length| keybed.repeat_after(length));
        }
    }

    /// Arms boards and sends them the performance's gestures; returns the boards' time at which
    /// the gestures begin, at least `lead` from now.
    pub(super) fn arm(
        self,
        prepared: &PreparedRun,
        lead: Nanos,
    ) -> Result<(KeyTransport, Nanos), SessionError> {
        match self {
            Self::Simulated(keys) => {
                let start = clock::monotonic().after(lead);
                Ok((KeyTransport::simulated(keys, prepared), start))
            }
            Self::Boards(keybed, terms, plans) => {
                let mut keybed = Box::new(keybed.arm(terms, PATIENCE_US)?);
                keybed.guard();
                if let Err(refusals) = keybed.prove_motors() {
                    keybed.disarm();
                    return Err(refusals.into());
                }
                let list = prepared.play_list.as_ref().map(|list| &list.performance);
                for (key, gestures) in list.iter().flat_map(|it| all_keys().zip(&it.gestures)) {
                    keybed.play(key, gestures);
                }
                if let Some(length) = list.and_then(|it| it.repeat) {
                    keybed.repeat_after(length);
                }
                let start = Nanos::from_micros(keybed.now_us()).after(lead);
                keybed.begin_at(start.as_u64() / 1_000);
                Ok((KeyTransport::on_boards(keybed, plans, start, prepared), start))
            }
        }
    }
}
