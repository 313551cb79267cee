//! The last samples of a board, which forces may answer.

use firmware_protocol::frame::{Header, key_samples::KeySamples};
use firmware_protocol::{acyclic::arm::HISTORY, sequence::SequenceNumber};

#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Sent {
    pub(super) samples: KeySamples,
    pub(super) taken_us: u64,
    /// Index, counted from the first frame.
    pub(super) number: u64,
}

/// The last 64 frames of samples.
#[derive(Clone, Debug)]
pub(super) struct SampleHistory {
    sent: Box<[Option<Sent>; HISTORY]>,
    n: u64,
}

impl SampleHistory {
    pub(super) fn new() -> Self {
        Self { sent: Box::new([None; HISTORY]), n: 0 }
    }

    pub(super) const fn next_sequence(&self) -> SequenceNumber {
        let [low, ..] = self.n.to_le_bytes();
        SequenceNumber(low)
    }

    pub(super) fn push(&mut self, samples: KeySamples, taken_us: u64) {
        self.sent[place(samples.header.sequence)] =
            Some(Sent { samples, taken_us, number: self.n });
        self.n += 1;
    }

    /// Returns the frame that `answer` answers: equal number and time, or none.
    pub(super) fn find(&self, answer: Header) -> Option<&Sent> {
        self.sent[place(answer.sequence)].as_ref().filter(|sent| {
            let header = sent.samples.header;
            header.sequence == answer.sequence && header.stamp_us == answer.stamp_us
        })
    }
}

const fn place(sequence: SequenceNumber) -> usize {
    sequence.0 as usize % HISTORY
}

const _: () = assert!(HISTORY.is_power_of_two(), "the number masks the place");

#[cfg(test)]
mod tests {
    use super::*;
    use firmware_protocol::key::{BoardId, PerKey};

    fn samples(history: &SampleHistory, stamp_us: u16) -> KeySamples {
        let board = BoardId::new(1).unwrap();
        let sequence = history.next_sequence();
        let header = Header { board, sequence, stamp_us, flag: false };
        KeySamples { header, positions: PerKey::default(), velocities: PerKey::default() }
    }

    #[test]
    fn only_the_last_64_can_be_answered_and_only_by_number_and_time() {
        let mut history = SampleHistory::new();
        let mut frames = Vec::new();
        for n in 0..300_u16 {
            let frame = samples(&history, n.wrapping_mul(1_000));
            history.push(frame, u64::from(n) * 1_000);
            frames.push(frame.header);
        }
        for (n, header) in frames.iter().enumerate() {
            let found = history.find(*header).map(|sent| sent.taken_us);
            assert_eq!(found, (300 - 64 <= n).then_some(n as u64 * 1_000), "{n}");
            let later = Header { stamp_us: header.stamp_us.wrapping_add(1), ..*header };
            assert_eq!(history.find(later), None);
        }
    }
}
