//! Identifiers that an end of the bus receives.

use firmware_protocol::{can::Class, frame::ALL_BOARDS};

use super::BusSide;

/// Bits of the identifier below the class.
const NODE_BITS: u16 = 7;
/// Linux' marks of extended and remote frames, which are no frames of the protocol.
const FOREIGN: u32 = 0xC000_0000;
const EXACT: u32 = 0x7FF;
const CLASS_ONLY: u32 = 0x780;

/// Identifiers and masks of their significant bits; a frame that fits any is received.
pub(super) fn filters(side: BusSide) -> Vec<(u32, u32)> {
    match side {
        BusSide::Host => {
            let classes = [Class::KeySamples, Class::Reply, Class::Hello];
            classes.map(|class| (id(class, 0), CLASS_ONLY | FOREIGN)).to_vec()
        }
        BusSide::Board(board) => {
            let for_all = [Class::Stop, Class::Sync, Class::MulticastForces]
                .map(|class| id(class, ALL_BOARDS));
            let for_it = [Class::KeyForces, Class::Request].map(|class| id(class, board.number()));
            for_all.into_iter().chain(for_it).map(|id| (id, EXACT | FOREIGN)).collect()
        }
    }
}

fn id(class: Class, node: u8) -> u32 {
    u32::from(u16::from(class as u8) << NODE_BITS | u16::from(node))
}

#[cfg(test)]
mod tests {
    use super::*;
    use firmware_protocol::{can::identifier, key::BoardId};

    fn hears(side: BusSide, head: [u8; 2]) -> bool {
        let id = u32::from(identifier(&head).unwrap());
        filters(side).iter().any(|(wanted, mask)| id & mask == wanted & mask)
    }

    #[test]
    fn the_host_hears_boards_and_a_board_hears_what_is_for_it() {
        let board = |number| BusSide::Board(BoardId::new(number).unwrap());
        // Kind and board in byte 0; receivers: host, board 3, board 4.
        let cases = [
            ([0x0F, 1], [false, true, true]),
            ([0x0F, 3], [false, true, true]),
            ([0x23, 0], [false, true, false]),
            ([0x42, 0], [false, true, true]),
            ([0x63, 0], [true, false, false]),
            ([0x84, 0], [false, false, true]),
            ([0xA4, 0], [true, false, false]),
            ([0xC3, 0], [true, false, false]),
        ];
        for (head, expected) in cases {
            let heard = [BusSide::Host, board(3), board(4)].map(|side| hears(side, head));
            assert_eq!(heard, expected, "{head:x?}");
        }
    }

    #[test]
    fn extended_and_remote_frames_are_heard_by_nobody() {
        for (wanted, mask) in filters(BusSide::Host) {
            assert_ne!((wanted | 0x8000_0000) & mask, wanted & mask);
            assert_ne!((wanted | 0x4000_0000) & mask, wanted & mask);
        }
    }
}
