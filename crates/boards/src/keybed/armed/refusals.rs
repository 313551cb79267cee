use firmware_protocol::{acyclic::Operation, key::KeyIndex};

use super::{Armed, BoardReport};
use crate::keybed::{Keybed, address};
use crate::refusal::{BoardName, Refusal};
use crate::rt::board_supervisor::{ArmLockout, ArmState};
use crate::untaken::UntakenForces;

/// Time without an answer after which a board counts as missing (us).
const SILENCE_US: u64 = 1_000_000;

impl Keybed<Armed> {
    pub(in crate::keybed) fn refusals(&self, seconds: f64) -> Vec<Refusal> {
        let boards = self.board_reports().into_iter().enumerate();
        let refusal = |(index, report): (usize, BoardReport)| {
            let board = report.name;
            if self.stage.supervisor.answers_late(index) {
                return Some(Refusal::LateAnswers { board });
            }
            match report.condition.state {
                ArmState::Barred(ArmLockout::Latched(reason)) => {
                    Some(Refusal::Latched { board, reason })
                }
                ArmState::Barred(ArmLockout::Declined(asked, status)) => {
                    let link = address(&self.lines, &board.line);
                    Some(Refusal::Declined { board, link, asked, status })
                }
                ArmState::Barred(ArmLockout::Exchanged) => Some(Refusal::Exchanged { board }),
                ArmState::Barred(ArmLockout::Clock(ppm)) => Some(Refusal::Clock { board, ppm }),
                ArmState::Barred(ArmLockout::NoSamples) => Some(Refusal::NoSamples { board }),
                ArmState::Barred(ArmLockout::Unreadable) => {
                    let n_keys = report.place.n_keys;
                    Some(Refusal::Unreadable { board, n_keys })
                }
                ArmState::Barred(ArmLockout::StaysSafe) => Some(Refusal::StaysSafe { board }),
                ArmState::Barred(ArmLockout::NotHomed(slots)) => {
                    let keys = slot_names(report.place.first_key, slots);
                    Some(Refusal::NotHomed { board, keys })
                }
                ArmState::Barred(ArmLockout::Slow(slow)) => Some(Refusal::Slow { board, slow }),
                ArmState::Barred(ArmLockout::Bursts(us)) => Some(Refusal::Bursts { board, us }),
                ArmState::Barred(ArmLockout::Restarting { times, reason }) => {
                    Some(Refusal::Restarting { board, times, reason })
                }
                ArmState::Barred(ArmLockout::Late(ms)) => Some(Refusal::LateSamples { board, ms }),
                ArmState::Armed if self.stage.supervisor.is_board_ready(index) => None,
                ArmState::Greeting
                | ArmState::Checking
                | ArmState::Streaming
                | ArmState::Measuring
                | ArmState::Disarming
                | ArmState::Arming { .. }
                | ArmState::Confirming
                | ArmState::Armed => Some(self.unready(index, board, seconds)),
            }
        };
        boards.filter_map(refusal).collect()
    }

    fn unready(&self, index: usize, board: BoardName, seconds: f64) -> Refusal {
        let supervisor = &self.stage.supervisor;
        let asked = supervisor.asked(index).unwrap_or(Operation::Hello);
        match supervisor.since_answer(index) {
            Some(us) if us < SILENCE_US => Refusal::NotReady { board, asked, seconds },
            Some(us) => Refusal::NoAnswer { board, asked, seconds: us as f64 * 1e-6 },
            None => Refusal::NoAnswer { board, asked, seconds },
        }
    }
}

impl Keybed<Armed> {
    pub(crate) fn untaken_forces(&self, key: KeyIndex) -> Option<UntakenForces> {
        let mut reports = self.board_reports().into_iter();
        reports.find(|it| it.place.keys().contains(&key.index()))?.untaken_forces()
    }
}

impl BoardReport {
    pub(super) fn untaken_forces(&self) -> Option<UntakenForces> {
        let (counters, sent) = (self.condition.counters?, self.statistics.sent);
        let forces = UntakenForces { sent, refused: counters.refused, stale: counters.stale };
        (sent < 2 * u64::from(forces.refused.max(forces.stale))).then_some(forces)
    }
}

pub(super) fn slot_names(first: KeyIndex, slots: u16) -> String {
    let keys = (first.number()..).map_while(KeyIndex::new).enumerate().take(16);
    let keys = keys.filter(|(slot, _)| slots >> slot & 1 == 1).map(|(_, key)| key.to_string());
    keys.collect::<Vec<_>>().join(", ")
}
