//! The stage of known and measured boards, which can be armed.

use crate::links::{Link as _, RecvError};
use firmware_protocol::acyclic::{Operation, ping::Pong};
use firmware_protocol::{MAX_FRAME, Nothing, frame::hello::feature};
use keyboard::KeyRange;

use super::{Armed, Keybed, LOOK, NamedLink, faults};
use crate::refusal::{BoardName, Refusals};
use crate::rt::terms::{BoardAgreement, Terms};
use crate::rt::{board::BoardTerms, board_supervisor::BoardSupervisor, bus::KeybedBus};
use crate::topology::BoardPlace;

/// Boards that are known and measured.
#[derive(Clone, PartialEq, Debug)]
pub struct Calibrated {
    pub(super) boards: Vec<BoardTerms>,
    pub(super) uids: Vec<[u8; 6]>,
    pub(super) features: Vec<u16>,
}

impl Keybed<Calibrated> {
    pub fn places(&self) -> impl Iterator<Item = &BoardPlace> {
        self.stage.boards.iter().map(|board| &board.place)
    }

    /// Returns the boards that were never calibrated, with their links' addresses in commands.
    pub fn uncalibrated(&self) -> impl Iterator<Item = (BoardName, &str)> {
        let boards = self.stage.boards.iter().filter(|it| !it.is_calibrated());
        boards.map(|it| {
            let NamedLink { name, address, .. } = &self.lines[it.place.line];
            (BoardName { line: name.clone(), number: it.place.board.number() }, address.as_str())
        })
    }

    pub fn has_fingers(&self) -> bool {
        self.stage.features.iter().all(|it| it & feature::FINGERS != 0)
    }

    /// Returns the longest round trip (us) of the boards that answer, each the shortest of several.
    pub fn round_trip_us(&mut self) -> Option<u64> {
        const TRIPS: usize = 8;
        let places: Vec<_> = self.places().copied().collect();
        let shortest = |place: BoardPlace| {
            let mut asker = self.asker(place.line, place.board);
            let trips = (0..TRIPS).filter_map(|_| {
                let start = self.now_us();
                let answered = self.ask::<_, Pong>(&mut asker, Operation::Ping, &Nothing);
                answered.ok().map(|_pong| self.now_us().saturating_sub(start))
            });
            trips.min()
        };
        places.into_iter().filter_map(shortest).max()
    }

    pub fn boards_on(&self, line: usize) -> Vec<KeyRange> {
        let boards = self.stage.boards.iter().filter(|it| it.place.line == line);
        boards.filter_map(|it| it.place.key_range()).collect()
    }

    /// Starts samples and arms every board; waits until all are armed, for `patience_us` at most.
    ///
    /// # Errors
    /// The boards that were not armed, with the reasons.
    pub fn arm(self, terms: Terms, patience_us: u64) -> Result<Keybed<Armed>, Refusals> {
        let Self { mut lines, stage, clock } = self;
        lines.iter_mut().for_each(forget_the_past);
        let agreed = phases(&stage, terms);
        let names = stage.boards.iter().map(|board| BoardName {
            line: lines[board.place.line].name.clone(),
            number: board.place.board.number(),
        });
        let names: Vec<_> = names.collect();
        let start = clock.now_us();
        let supervisor = BoardSupervisor::new(agreed, start);
        let mut bus = KeybedBus::new(&stage.boards);
        for (index, line) in lines.iter().enumerate() {
            if let Some(medium) = line.medium {
                bus.meter(index, medium);
            }
        }
        let armed = Armed::new(bus, supervisor, names, u64::from(terms.period_us));
        let mut keybed = Keybed { lines, stage: armed, clock };
        while !keybed.is_ready() {
            let now = keybed.now_us();
            // Boards that may not be armed will not become ready.
            if start + patience_us <= now || keybed.is_settled() {
                let seconds = now.saturating_sub(start) as f64 * 1e-6;
                let mut refusals: Vec<_> = faults(&keybed.lines).collect();
                refusals.extend(keybed.refusals(seconds));
                keybed.disarm();
                return Err(Refusals(refusals));
            }
            keybed.attend();
            keybed.clock.pause(LOOK);
        }
        Ok(keybed)
    }
}

/// Discards earlier input: samples for another host, whose losses would look like lost frames.
fn forget_the_past(line: &mut NamedLink) {
    const MOST: usize = 100_000;
    for _ in 0..MOST {
        if let Ok(None) | Err(RecvError::Down) = line.link.try_recv(&mut [0; MAX_FRAME]) {
            return;
        }
    }
}

/// Returns the agreement with each board.
///
/// Boards on a line start in turns but drift apart by their own clocks; plans assume all at once.
fn phases(stage: &Calibrated, terms: Terms) -> Vec<BoardAgreement> {
    let on_line = |line| stage.boards.iter().filter(move |it| it.place.line == line);
    let known = stage.uids.iter().zip(&stage.features);
    let agreed = stage.boards.iter().zip(known).map(|(board, (uid, features))| {
        let line = board.place.line;
        let n = u16::try_from(on_line(line).count().max(1)).unwrap_or(1);
        let before = on_line(line).take_while(|it| it.place.board != board.place.board).count();
        let turn = u16::try_from(before).unwrap_or(0);
        // Boards compute every 100 us, and can send only then.
        let phase_us = terms.period_us / n * turn / 100 * 100;
        BoardAgreement { place: board.place, uid: *uid, features: *features, phase_us, terms }
    });
    agreed.collect()
}
