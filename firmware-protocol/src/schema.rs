//! The layouts of the cyclic frames as one text, and its hash.
//!
//! A board reports the hash of its build in its hello; a host never arms a board with another
//! one. So a changed layout is rejected even if the version was forgotten. Every change of a
//! cyclic frame must change the text; a test compares some of it with the code.

/// Layout of the cyclic frames; changing a character makes every earlier board incompatible.
pub const CYCLIC: &str = "\
header: kind:3 flag:1 board:4 | sequence:u8 | stamp_us:u16
key_samples kind 3: position16:i16 | position24:i24 | position16:i16 velocity:i16 | position24:i24 velocity:i16
key_forces kind 1: force:i16 | force:i16 stiffness:slope8 damping:slope8
multicast_forces kind 2: group:4 sequence:u8 stamp_us:u16 | 30 x force:i16
units: position 1 count, velocity 0.2 mm/s, force 1 mN, stiffness 0.25 N/m, damping 0.001 N s/m
slope8: sign:1 exponent:4 mantissa:3
";

/// FNV-1a of [`CYCLIC`], 64 bits.
///
/// G. Fowler, L. C. Noll, K.-P. Vo; D. Eastlake, "The FNV Non-Cryptographic Hash Algorithm",
/// RFC 9923.
pub const HASH: u64 = fnv1a(CYCLIC.as_bytes());

const fn fnv1a(bytes: &[u8]) -> u64 {
    let mut hash = 0xCBF2_9CE4_8422_2325_u64;
    let mut i = 0;
    while i < bytes.len() {
        hash = (hash ^ bytes[i] as u64).wrapping_mul(0x0000_0100_0000_01B3);
        i += 1;
    }
    hash
}
