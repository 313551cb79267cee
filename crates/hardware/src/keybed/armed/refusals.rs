//! Why boards do not render forces, as refusals.

use firmware_protocol::acyclic::Operation;
use firmware_protocol::key::KeyIndex;

use super::{Armed, BoardReport};
use crate::keybed::{Keybed, address};
use crate::refusal::Refusal;
use crate::rt::board_supervisor::{ArmLockout, ArmState};

impl Keybed<Armed> {
    /// Returns why boards do not render forces after `seconds` of trying.
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
                ArmState::Barred(ArmLockout::Late(ms)) => Some(Refusal::LateSamples { board, ms }),
                ArmState::Armed if self.stage.supervisor.is_board_ready(index) => None,
                ArmState::Greeting
                | ArmState::Checking
                | ArmState::Streaming
                | ArmState::Disarming
                | ArmState::Arming { .. }
                | ArmState::Confirming
                | ArmState::Armed => {
                    let asked = self.stage.supervisor.asked(index).unwrap_or(Operation::Hello);
                    Some(Refusal::NoAnswer { board, asked, seconds })
                }
            }
        };
        boards.filter_map(refusal).collect()
    }
}

/// Returns the names of the keys from `first` on whose bits are set.
fn slot_names(first: KeyIndex, slots: u16) -> String {
    let keys = (first.number()..).map_while(KeyIndex::new).enumerate().take(16);
    let keys = keys.filter(|(slot, _)| slots >> slot & 1 == 1).map(|(_, key)| key.to_string());
    keys.collect::<Vec<_>>().join(", ")
}
