//! Arbitrary bytes, read as numbers and choices; followed by zeros.

const SPECIAL: [f64; 14] = [
    0.0,
    -0.0,
    -1.0,
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    5e-324,
    1e-300,
    -1e-300,
    f64::EPSILON,
    1.0,
    1e300,
    f64::MAX,
    f64::MIN,
];

#[derive(Debug)]
pub struct Bytes<'a>(&'a [u8]);

impl<'a> Bytes<'a> {
    pub const fn new(bytes: &'a [u8]) -> Self {
        Self(bytes)
    }

    pub fn byte(&mut self) -> u8 {
        let Some((first, rest)) = self.0.split_first() else { return 0 };
        self.0 = rest;
        *first
    }

    pub fn word(&mut self) -> u64 {
        u64::from_le_bytes(std::array::from_fn(|_| self.byte()))
    }

    pub fn is_true(&mut self) -> bool {
        self.byte() % 2 == 1
    }

    pub fn is_one_in(&mut self, n: u8) -> bool {
        self.byte() % n == n - 1
    }

    pub fn pick<T: Copy>(&mut self, list: &[T]) -> T {
        list[usize::from(self.byte()) % list.len()]
    }

    pub fn part(&mut self) -> f64 {
        f64::from(u16::from_le_bytes([self.byte(), self.byte()])) / f64::from(u16::MAX)
    }

    /// Returns a positive number in `least` ..= `most`, of any magnitude.
    pub fn sized(&mut self, least: f64, most: f64) -> f64 {
        least * (most / least).powf(self.part())
    }

    pub fn signed(&mut self, least: f64, most: f64) -> f64 {
        let sign = if self.is_true() { -1.0 } else { 1.0 };
        sign * self.sized(least, most)
    }

    /// Returns a `usual` number, or now and then a special one.
    pub fn odd(&mut self, usual: impl FnOnce(&mut Self) -> f64) -> f64 {
        match self.byte() {
            0..224 => usual(self),
            224..248 => self.pick(&SPECIAL),
            248.. => f64::from_bits(self.word()),
        }
    }
}
