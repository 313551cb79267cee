use std::{cell::RefCell, collections::VecDeque};

use super::super::bus::ControllerReport;
use super::*;
use crate::links::WireState;

/// A bus in memory whose frames the sending port reads back, after the reports.
#[derive(Default)]
struct Memory {
    arrivals: RefCell<VecDeque<BusRead>>,
    room: usize,
}

impl CanBus for Memory {
    fn write(&mut self, id: u16, data: &[u8]) -> Result<(), SendError> {
        self.room = self.room.checked_sub(1).ok_or(SendError::Full)?;
        self.arrivals.borrow_mut().push_back(BusRead::Data(Data::new(id, data)));
        Ok(())
    }

    fn read(&mut self) -> Result<Option<BusRead>, RecvError> {
        Ok(self.arrivals.borrow_mut().pop_front())
    }
}

fn port(mode: CanMode) -> CanPort<Memory> {
    CanPort::new(Memory { room: 1_000, ..Memory::default() }, mode)
}

fn samples(board: u8, len: usize) -> Vec<u8> {
    let mut frame = vec![board + 1; len];
    frame[0] = 3 << 5 | board;
    frame
}

fn recv(port: &mut CanPort<Memory>) -> Result<Option<Vec<u8>>, RecvError> {
    let mut buffer = [0; MAX_FRAME];
    Ok(port.try_recv(&mut buffer)?.map(|len| buffer[..len].to_vec()))
}

fn written(port: &CanPort<Memory>) -> Vec<(u16, Vec<u8>)> {
    let arrivals = port.bus.arrivals.borrow();
    let data = |arrival: &BusRead| match arrival {
        BusRead::Data(data) => Some((data.id, data.bytes().to_vec())),
        BusRead::Report(_) | BusRead::Foreign => None,
    };
    arrivals.iter().filter_map(data).collect()
}

#[test]
fn on_can_fd_a_frame_is_padded_under_the_identifier_of_its_class_and_board() {
    let mut port = port(CanMode::Fd);
    port.try_send(&samples(5, 26)).unwrap();
    let mut expected = samples(5, 26);
    expected.resize(32, 0);
    assert_eq!(written(&port), [(0x205, expected.clone())]);
    assert_eq!(recv(&mut port), Ok(Some(expected)));
    assert_eq!(recv(&mut port), Ok(None));
}

#[test]
fn on_classic_can_a_frame_is_cut_and_comes_back_as_long_as_it_was() {
    for len in [1, 7, 8, 26, 59, 64] {
        let mut port = port(CanMode::Classic);
        port.try_send(&samples(5, len)).unwrap();
        assert_eq!(written(&port).len(), len.div_ceil(7));
        assert_eq!(recv(&mut port), Ok(Some(samples(5, len))));
    }
}

#[test]
fn the_pieces_of_sixteen_senders_may_come_in_turn() {
    let mut piles: Vec<_> = (0..=15)
        .map(|board| {
            let mut one = port(CanMode::Classic);
            one.try_send(&samples(board, 37)).unwrap();
            one.bus.arrivals.into_inner()
        })
        .collect();
    let mut port = port(CanMode::Classic);
    while !piles[0].is_empty() {
        let turn = piles.iter_mut().filter_map(VecDeque::pop_front);
        port.bus.arrivals.borrow_mut().extend(turn);
    }
    for board in 0..=15 {
        assert_eq!(recv(&mut port), Ok(Some(samples(board, 37))));
    }
    assert_eq!(recv(&mut port), Ok(None));
}

#[test]
fn a_lost_piece_costs_its_frame_and_not_those_of_other_boards() {
    let mut port = port(CanMode::Classic);
    for board in [1, 2, 1] {
        port.try_send(&samples(board, 26)).unwrap();
    }
    port.bus.arrivals.borrow_mut().remove(1);
    assert_eq!(recv(&mut port), Err(RecvError::Corrupt));
    // Each piece after the lost one is reported, up to the end of the frame.
    assert_eq!(recv(&mut port), Err(RecvError::Corrupt));
    assert_eq!(recv(&mut port), Ok(Some(samples(2, 26))));
    assert_eq!(recv(&mut port), Ok(Some(samples(1, 26))));
}

#[test]
fn a_frame_that_does_not_agree_with_its_identifier_is_corrupt() {
    for mode in [CanMode::Fd, CanMode::Classic] {
        let mut port = port(mode);
        for frame in [samples(5, 7), samples(6, 7)] {
            port.try_send(&frame).unwrap();
        }
        if let Some(BusRead::Data(data)) = port.bus.arrivals.borrow_mut().front_mut() {
            data.id = 0x206;
        }
        assert_eq!(recv(&mut port), Err(RecvError::Corrupt), "{mode:?}");
        assert_eq!(recv(&mut port).map(|frame| frame.map(|frame| frame[0])), Ok(Some(0x66)));
    }
}

#[test]
fn an_identifier_that_nobody_has_is_corrupt() {
    for (mode, id) in [(CanMode::Fd, 0x7FF), (CanMode::Classic, 0x7FF), (CanMode::Classic, 0x210)] {
        let mut port = port(mode);
        port.bus.write(id, &samples(0, 8)).unwrap();
        port.bus.arrivals.borrow_mut().push_back(BusRead::Foreign);
        assert_eq!(recv(&mut port), Err(RecvError::Corrupt));
        assert_eq!(recv(&mut port), Err(RecvError::Corrupt));
        assert_eq!(recv(&mut port), Ok(None));
    }
}

#[test]
fn a_report_is_health_and_no_frame() {
    let mut port = port(CanMode::Fd);
    let report = ControllerReport { class: 0x040, data: [0; 8] };
    port.bus.arrivals.borrow_mut().push_back(BusRead::Report(report));
    port.try_send(&samples(1, 8)).unwrap();
    assert_eq!(recv(&mut port), Ok(Some(samples(1, 8))));
    assert_eq!((port.health().state, port.health().reports), (WireState::Off, 1));
}

#[test]
fn a_full_bus_takes_a_frame_whole_or_not_at_all() {
    for mode in [CanMode::Fd, CanMode::Classic] {
        let mut port = port(mode);
        port.bus.room = 0;
        assert_eq!(port.try_send(&samples(1, 26)), Err(SendError::Full), "{mode:?}");
        assert_eq!((port.dropped(), written(&port).len()), (1, 0));
    }
    // Two of four pieces are sent; the rest precedes the next frame, newer than the dropped one.
    let mut port = port(CanMode::Classic);
    port.bus.room = 2;
    assert_eq!(port.try_send(&samples(1, 26)), Ok(()));
    assert_eq!(port.try_send(&samples(2, 26)), Err(SendError::Full));
    port.bus.room = 100;
    assert_eq!(port.try_send(&samples(3, 26)), Ok(()));
    assert_eq!(recv(&mut port), Ok(Some(samples(1, 26))));
    assert_eq!(recv(&mut port), Ok(Some(samples(3, 26))));
    assert_eq!((recv(&mut port), port.dropped()), (Ok(None), 1));
}

#[test]
fn what_is_too_long_or_of_no_kind_is_refused() {
    for mode in [CanMode::Fd, CanMode::Classic] {
        let mut port = port(mode);
        for frame in [samples(1, 65), vec![0xFF; 8], Vec::new()] {
            let len = frame.len();
            assert_eq!(port.try_send(&frame), Err(SendError::TooLong { len }));
        }
    }
}
