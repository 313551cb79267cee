//! Each fault of a disturbed link, and reproducibility by the seed.

use boards::links::faulty::{
    Chance, Direction, FaultCounts, FaultPlan, Faults, LinkFault, Scripted,
};
use boards::links::{Link as _, MAX_LEN, RecvError, SendError, loopback::Loopback};

#[test]
fn a_frame_never_arrives_arrives_twice_or_is_overtaken() {
    check(LinkFault::Drop, &[&[], &[1], &[2], &[3]]);
    check(LinkFault::Duplicate, &[&[0, 0], &[1], &[2], &[3]]);
    check(LinkFault::Delay(2), &[&[], &[1], &[0, 2], &[3]]);
}

#[test]
fn a_flipped_bit_changes_one_bit() {
    for direction in [Direction::Send, Direction::Receive] {
        let [first, ..] = run(scripted(LinkFault::FlipBit, direction), direction).0;
        let [got] = first.try_into().unwrap();
        assert_eq!(got.count_ones(), 1, "frame 0 arrived as {got:#b}");
    }
}

#[test]
fn a_link_that_is_down_says_so_and_comes_back() {
    let mut wire = Loopback::new(4);
    let mut faults = Faults::new(FaultPlan {
        script: vec![
            Scripted { exchanges: 0..1, direction: Direction::Send, fault: LinkFault::Down },
            Scripted { exchanges: 0..1, direction: Direction::Receive, fault: LinkFault::Down },
        ],
        ..FaultPlan::default()
    });
    assert_eq!(faults.around(wire.host_end()).try_send(&[1]), Err(SendError::Down));
    let mut buffer = [0; MAX_LEN];
    assert_eq!(faults.around(wire.host_end()).try_recv(&mut buffer), Err(RecvError::Down));
    faults.next_exchange();
    assert_eq!(faults.around(wire.host_end()).try_send(&[1]), Ok(()));
    assert_eq!(faults.around(wire.host_end()).try_recv(&mut buffer), Ok(None));
    assert_eq!(faults.counts(), FaultCounts { down: 2, ..FaultCounts::default() });
}

#[test]
fn chance_strikes_about_as_often_as_planned_and_the_same_way_for_a_seed() {
    let n = 10_000;
    let losses = |seed| {
        let chances = vec![Chance { probability: 0.1, fault: LinkFault::Drop }];
        let mut faults = Faults::new(FaultPlan { seed, chances, script: Vec::new() });
        let mut wire = Loopback::new(1);
        let lost: Vec<_> = (0..n)
            .filter(|_| {
                faults.around(wire.host_end()).try_send(&[1]).unwrap();
                wire.board_end().try_recv(&mut [0; MAX_LEN]) == Ok(None)
            })
            .collect();
        lost
    };
    // Five standard deviations of a binomial with n p q = 900.
    let count = losses(7).len();
    assert!(count.abs_diff(1_000) < 150, "{count}");
    assert_eq!(losses(7), losses(7));
    assert_ne!(losses(7), losses(8));
}

fn scripted(fault: LinkFault, direction: Direction) -> FaultPlan {
    let script = vec![Scripted { exchanges: 0..1, direction, fault }];
    FaultPlan { script, ..FaultPlan::default() }
}

#[track_caller]
fn check(fault: LinkFault, expected: &[&[u8]; 4]) {
    for direction in [Direction::Send, Direction::Receive] {
        let (mut arrived, counts) = run(scripted(fault, direction), direction);
        // A delayed frame is put on the wire before the frame of its exchange.
        for bytes in &mut arrived {
            bytes.sort_unstable();
        }
        assert_eq!(arrived, expected.map(<[u8]>::to_vec), "{direction:?}");
        let counts = [counts.dropped, counts.duplicated, counts.delayed, counts.flipped];
        assert_eq!(counts.iter().sum::<u64>(), 1, "{direction:?}");
    }
}

fn run(plan: FaultPlan, direction: Direction) -> ([Vec<u8>; 4], FaultCounts) {
    let mut wire = Loopback::new(4);
    let mut faults = Faults::new(plan);
    let arrived = [0, 1, 2, 3].map(|frame: u8| {
        let arrived = match direction {
            Direction::Send => {
                let sent = faults.around(wire.host_end()).try_send(&[frame]);
                assert_eq!(sent, Ok(()));
                drain(|buffer| wire.board_end().try_recv(buffer))
            }
            Direction::Receive => {
                assert_eq!(wire.board_end().try_send(&[frame]), Ok(()));
                drain(|buffer| faults.around(wire.host_end()).try_recv(buffer))
            }
        };
        faults.next_exchange();
        arrived
    });
    (arrived, faults.counts())
}

fn drain(mut recv: impl FnMut(&mut [u8]) -> Result<Option<usize>, RecvError>) -> Vec<u8> {
    let mut buffer = [0; MAX_LEN];
    let mut frames = Vec::new();
    while recv(&mut buffer) == Ok(Some(1)) {
        frames.push(buffer[0]);
    }
    frames
}
