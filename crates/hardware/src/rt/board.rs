//! The host's end of one board: its newest samples, and the forces that answer them.

use firmware_protocol::frame::Header;
use firmware_protocol::frame::key_forces::{self, ForceLayout, ForcePacking, KeyForces};
use firmware_protocol::frame::key_samples::{KeySamples, SampleLayout};
use firmware_protocol::key::PerKey;
use scheduler::motion::{KEYS, KeySample, KeySlope};

use super::loss::{Loss, LossCounts};
use crate::calibration::{self, KeyCalibration};
use crate::topology::BoardPlace;

/// What the host must know of a board to exchange with it.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct BoardTerms {
    /// Where it is, and which keys it carries.
    pub place: BoardPlace,
    /// How its samples are packed.
    pub samples: SampleLayout,
    /// How its forces are packed.
    pub forces: ForceLayout,
    /// How each of its keys reads and pushes.
    pub calibration: PerKey<KeyCalibration>,
}

/// What one board has sent and was sent.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct BoardStatistics {
    /// Counts over the sequence numbers of its samples.
    pub samples: LossCounts,
    /// Frames from it that were refused: length, padding or content.
    pub refused: u64,
    /// Force frames that the link took.
    pub sent: u64,
    /// Force frames that it did not take, or that had no samples to answer.
    pub unsent: u64,
    /// Its newest frame said that it renders no force.
    pub is_safe: bool,
}

/// The host's end of one board.
#[derive(Clone, Debug)]
pub struct BoardEnd {
    terms: BoardTerms,
    loss: Loss,
    statistics: BoardStatistics,
    /// The newest samples, which the next forces answer.
    newest: Option<KeySamples>,
}

impl BoardEnd {
    /// An end that has heard nothing.
    pub fn new(terms: BoardTerms) -> Self {
        let (loss, statistics) = (Loss::default(), BoardStatistics::default());
        Self { terms, loss, statistics, newest: None }
    }

    /// What was agreed with the board.
    pub const fn terms(&self) -> &BoardTerms {
        &self.terms
    }

    /// Whether its forces come in frames for all boards.
    pub(super) fn takes_multicast(&self) -> bool {
        self.terms.forces.packing == ForcePacking::Multicast16
    }

    /// What it has sent and was sent.
    pub const fn statistics(&self) -> BoardStatistics {
        BoardStatistics { samples: self.loss.counts(), ..self.statistics }
    }

    /// The newest samples as they came.
    pub const fn newest(&self) -> Option<&KeySamples> {
        self.newest.as_ref()
    }

    /// Forgets what came, for a board that starts anew; the counts stay.
    pub const fn forget(&mut self) {
        self.loss.forget();
        self.newest = None;
    }

    /// Takes a frame of samples; says whether it was newer than all before.
    pub fn hear(&mut self, frame: &[u8], tick: u64) -> bool {
        let Ok(samples) = KeySamples::decode(frame, self.terms.samples) else {
            self.statistics.refused += 1;
            return false;
        };
        let news = self.loss.accept(samples.header.sequence, tick);
        if news {
            self.statistics.is_safe = samples.header.flag;
            self.newest = Some(samples);
        }
        news
    }

    /// Writes the newest samples into their keys' places, as if they had just been taken.
    pub fn publish(&self, samples: &mut [KeySample; KEYS]) {
        let Some(newest) = &self.newest else { return };
        let places = samples[self.terms.place.keys()].iter_mut();
        let readings = newest.positions.as_slice().iter().zip(self.terms.calibration.as_slice());
        for (sample, (counts, calibration)) in places.zip(readings) {
            *sample = KeySample::fresh(calibration.position(*counts));
        }
    }

    /// The next force frame and its length; nothing if there are no samples to answer.
    pub fn answer(
        &mut self,
        forces: &[f64; KEYS],
        slopes: &[KeySlope; KEYS],
    ) -> Option<([u8; key_forces::MAX_LEN], usize)> {
        let newest = self.newest.as_ref()?;
        let keys = self.terms.place.keys();
        let mut frame = KeyForces {
            header: Header { flag: false, ..newest.header },
            forces: PerKey::default(),
            slopes: PerKey::default(),
        };
        if self.terms.forces.packing == ForcePacking::Force16Slope {
            let answered = (keys.clone()).zip(self.terms.calibration.as_slice()).enumerate().map(
                |(slot, (key, calibration))| {
                    let here = Self::measured(slot, newest, calibration);
                    calibration.sloped(forces[key], &slopes[key], here)
                },
            );
            let answered: PerKey<_> = PerKey::collect(answered);
            frame.forces = PerKey::collect(answered.as_slice().iter().map(|(force, _)| *force));
            frame.slopes = PerKey::collect(answered.as_slice().iter().map(|(_, slopes)| *slopes));
        } else {
            let pairs = forces[keys].iter().zip(self.terms.calibration.as_slice());
            frame.forces = PerKey::collect(pairs.map(|(force, it)| it.millinewtons(*force)));
        }
        let mut bytes = [0; key_forces::MAX_LEN];
        let len = frame.encode(&mut bytes);
        Some((bytes, len))
    }

    /// Counts a force frame that the link took, or did not take.
    #[expect(clippy::fn_params_excessive_bools, reason = "the one fact that there is")]
    pub const fn count_sent(&mut self, taken: bool) {
        if taken {
            self.statistics.sent += 1;
        } else {
            self.statistics.unsent += 1;
        }
    }

    /// Where a key was when the newest samples were taken, as the board knows it too.
    fn measured(
        slot: usize,
        newest: &KeySamples,
        calibration: &KeyCalibration,
    ) -> calibration::Measured {
        let counts = newest.positions.as_slice().get(slot).copied().unwrap_or_default();
        let speed = newest.velocities.as_slice().get(slot).copied().unwrap_or_default();
        calibration::Measured {
            position: calibration.position(counts),
            velocity: calibration::metres_per_second(speed),
        }
    }
}
