//! Damages good files, reproducibly by seed.

/// Numbers on which readers fail: 0, the ends of integers and of floating point, and no numbers.
const EXTREMES: &str = "0 -1 255 65536 2147483648 9223372036854775807 1e-308 1e308 -1e308 1e999 \
                        nan inf";

/// Lengths and counts on which readers of binary formats fail.
const EXTREME_WORDS: [u32; 4] = [0, 1, 0x7FFF_FFFF, 0xFFFF_FFFF];

const DEEPEST: usize = 5000;

/// Distance from an end of a file that counts as near (bytes).
const NEAR: usize = 1000;

pub(super) struct FuzzRandom(pub(super) u64);

impl FuzzRandom {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    pub(super) fn below(&mut self, end: usize) -> usize {
        usize::try_from(self.next() % (end.max(1) as u64)).unwrap_or(0)
    }

    pub(super) fn pick<'a, T>(&mut self, all: &'a [T]) -> Option<&'a T> {
        all.get(self.below(all.len()))
    }

    /// Returns a position in a file of `len` bytes, two of three near an end: heads and tables.
    fn place(&mut self, len: usize) -> usize {
        match self.below(3) {
            0 => self.below(len.min(NEAR)),
            1 => len.saturating_sub(1 + self.below(len.min(NEAR))),
            _ => self.below(len),
        }
    }

    fn piece(&mut self, bytes: &[u8], longest: usize) -> (usize, usize) {
        let start = self.below(bytes.len() + 1);
        (start, (start + self.below(longest + 1)).min(bytes.len()))
    }
}

/// Returns one of the `good` files with one to three damages, mostly one.
pub(super) fn mutated(random: &mut FuzzRandom, good: &[Vec<u8>]) -> Vec<u8> {
    let mut bytes = random.pick(good).cloned().unwrap_or_default();
    for _ in 0..=random.pick(&[0, 0, 0, 1, 2]).copied().unwrap_or(0) {
        damage(random, &mut bytes, good);
    }
    bytes
}

fn damage(random: &mut FuzzRandom, bytes: &mut Vec<u8>, good: &[Vec<u8>]) {
    let at = random.place(bytes.len());
    match random.below(12) {
        0 => bytes.truncate(at),
        1 => drop(bytes.drain(at..(at + random.below(64)).min(bytes.len()))),
        2 => flip(random, bytes),
        3..=7 => replace_number(random, bytes),
        8 => repeat_line(random, bytes),
        9 => {
            let other = random.pick(good).cloned().unwrap_or_default();
            let (start, end) = random.piece(&other, 200);
            let replaced = at..(at + random.below(200)).min(bytes.len());
            drop(bytes.splice(replaced, other[start..end].iter().copied()));
        }
        10 => {
            let nested: &[u8] = random
                .pick(&["[", "(", "{", "-", "[[", "a.", "\""])
                .map_or(b"", |it| it.as_bytes());
            let nested = nested.repeat(random.below(DEEPEST));
            drop(bytes.splice(at..at, nested));
        }
        _ => {
            let word = random.pick(&EXTREME_WORDS).copied().unwrap_or(0).to_le_bytes();
            bytes.iter_mut().skip(at).zip(word).for_each(|(byte, new)| *byte = new);
        }
    }
}

fn flip(random: &mut FuzzRandom, bytes: &mut [u8]) {
    for _ in 0..=random.below(8) {
        let at = random.place(bytes.len());
        if let Some(byte) = bytes.get_mut(at) {
            *byte ^= 1 << random.below(8);
        }
    }
}

fn replace_number(random: &mut FuzzRandom, bytes: &mut Vec<u8>) {
    let from = random.below(bytes.len());
    let Some(start) = (from..bytes.len()).find(|at| bytes[*at].is_ascii_digit()) else { return };
    let is_part = |byte: u8| byte.is_ascii_digit() || b".e-".contains(&byte);
    let end = (start..bytes.len()).find(|at| !is_part(bytes[*at])).unwrap_or(bytes.len());
    let digits = "9".repeat(300);
    let extremes: Vec<_> = EXTREMES.split(' ').collect();
    let extreme = random.pick(&extremes).copied().unwrap_or_default();
    let extreme = if random.below(16) == 0 { &digits } else { extreme };
    drop(bytes.splice(start..end, extreme.bytes()));
}

fn repeat_line(random: &mut FuzzRandom, bytes: &mut Vec<u8>) {
    let at = random.below(bytes.len());
    let start = bytes[..at].iter().rposition(|byte| *byte == b'\n').map_or(0, |at| at + 1);
    let end =
        bytes[at..].iter().position(|byte| *byte == b'\n').map_or(bytes.len(), |to| at + to + 1);
    let most = if random.below(8) == 0 { DEEPEST } else { 4 };
    let line = bytes[start..end.min(start + 200)].repeat(1 + random.below(most));
    drop(bytes.splice(start..start, line));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_seed_makes_the_same_damage_again() {
        let good = [b"tick_hz = 1000\n[[keys]]\n".to_vec(), b"x = 1\n".to_vec(), Vec::new()];
        let all = |seed: u64| -> Vec<_> {
            let one = |n: u64| mutated(&mut FuzzRandom(seed + n), &good);
            (0..200).map(one).collect()
        };
        assert_eq!(all(1), all(1));
        let different = all(1).into_iter().filter(|it| !good.contains(it)).count();
        assert!(100 < different, "{different} of 200 are damaged");
    }
}
