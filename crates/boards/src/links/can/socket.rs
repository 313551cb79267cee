//! The bus on Linux: a raw socket on an interface.

use std::io;

use rustix::io::Errno;
use socketcan::id::FdFlags;
use socketcan::{
    CanAnyFrame, CanDataFrame, CanErrorFrame, CanFdFrame, CanFdSocket, CanFrame, CanSocket,
    EmbeddedFrame as _, Id, Socket as _, SocketOptions, StandardId,
};

use super::bus::{BusRead, CanBus, ControllerReport, Data};
use super::{BusSide, CanMode, filter::filters};
use crate::links::{RecvError, SendError};

#[derive(Debug)]
pub(super) enum Socket {
    Fd(CanFdSocket),
    Classic(CanSocket),
}

impl Socket {
    /// Opens an interface, with filters and all reports.
    ///
    /// Unlike the kernel's default, other sockets of this machine do not receive frames sent here.
    pub(super) fn open(interface: &str, mode: CanMode, side: BusSide) -> io::Result<Self> {
        Ok(match mode {
            CanMode::Fd => Self::Fd(prepare(CanFdSocket::open(interface)?, side)?),
            CanMode::Classic => Self::Classic(prepare(CanSocket::open(interface)?, side)?),
        })
    }
}

fn prepare<S: socketcan::Socket + SocketOptions>(socket: S, side: BusSide) -> io::Result<S> {
    socket.set_nonblocking(true)?;
    socket.set_filters(&filters(side))?;
    socket.set_error_filter_accept_all()?;
    Ok(socket)
}

impl CanBus for Socket {
    fn write(&mut self, id: u16, data: &[u8]) -> Result<(), SendError> {
        let too_long = SendError::TooLong { len: data.len() };
        let id = StandardId::new(id).ok_or(too_long)?;
        match self {
            Self::Fd(socket) => {
                let frame = CanFdFrame::with_flags(id, data, FdFlags::BRS).ok_or(too_long)?;
                socket.write_frame(&frame)
            }
            Self::Classic(socket) => {
                socket.write_frame(&CanDataFrame::new(id, data).ok_or(too_long)?)
            }
        }
        .map_err(|error| refusal(&error))
    }

    fn read(&mut self) -> Result<Option<BusRead>, RecvError> {
        let arrival = match self {
            Self::Fd(socket) => socket.read_frame().map(any_arrival),
            Self::Classic(socket) => socket.read_frame().map(classic_arrival),
        };
        arrival.map_or_else(|error| silence(&error), |arrival| Ok(Some(arrival)))
    }
}

/// Converts a frame of a socket for CAN FD, where a classic frame is foreign.
fn any_arrival(frame: CanAnyFrame) -> BusRead {
    match frame {
        CanAnyFrame::Fd(frame) => data(frame.id(), frame.data()),
        CanAnyFrame::Error(frame) => report(&frame),
        CanAnyFrame::Normal(_) | CanAnyFrame::Remote(_) => BusRead::Foreign,
    }
}

fn classic_arrival(frame: CanFrame) -> BusRead {
    match frame {
        CanFrame::Data(frame) => data(frame.id(), frame.data()),
        CanFrame::Error(frame) => report(&frame),
        CanFrame::Remote(_) => BusRead::Foreign,
    }
}

fn data(id: Id, bytes: &[u8]) -> BusRead {
    match id {
        Id::Standard(id) => BusRead::Data(Data::new(id.as_raw(), bytes)),
        Id::Extended(_) => BusRead::Foreign,
    }
}

fn report(frame: &CanErrorFrame) -> BusRead {
    let data = frame.data().first_chunk().copied().unwrap_or_default();
    BusRead::Report(ControllerReport { class: frame.error_bits(), data })
}

/// Distinguishes a full queue from an interface that is down, was removed, or lost its CAN FD.
fn refusal(error: &io::Error) -> SendError {
    match Errno::from_io_error(error) {
        Some(Errno::NOBUFS | Errno::AGAIN | Errno::INTR | Errno::NOMEM) => SendError::Full,
        _ => SendError::Down,
    }
}

fn silence(error: &io::Error) -> Result<Option<BusRead>, RecvError> {
    match Errno::from_io_error(error) {
        Some(Errno::AGAIN | Errno::INTR) => Ok(None),
        Some(_) => Err(RecvError::Down),
        // An error of the crate about a length that no frame has.
        None => Err(RecvError::Corrupt),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use firmware_protocol::MAX_FRAME;
    use socketcan::frame::AsPtr as _;

    #[test]
    fn the_kernel_s_reasons_are_room_or_the_end() {
        let send = |errno: Errno| refusal(&io::Error::from(errno));
        for errno in [Errno::NOBUFS, Errno::AGAIN] {
            assert_eq!(send(errno), SendError::Full, "{errno}");
        }
        for errno in [Errno::NETDOWN, Errno::NXIO, Errno::NODEV, Errno::INVAL] {
            assert_eq!(send(errno), SendError::Down, "{errno}");
        }
        let recv = |errno: Errno| silence(&io::Error::from(errno)).map(|none| none.is_none());
        assert_eq!(recv(Errno::AGAIN), Ok(true));
        for errno in [Errno::NETDOWN, Errno::NODEV] {
            assert_eq!(recv(errno), Err(RecvError::Down), "{errno}");
        }
    }

    #[test]
    fn frames_of_the_kernel_become_arrivals() {
        let id = StandardId::new(0x205).unwrap();
        let bytes = [0x65; MAX_FRAME];
        let fd = CanFdFrame::with_flags(id, &bytes, FdFlags::BRS).unwrap();
        assert!(fd.is_brs() && fd.size() == 72);
        let BusRead::Data(data) = any_arrival(fd.into()) else { panic!("{fd:?}") };
        assert_eq!((data.id, data.bytes()), (0x205, &bytes[..]));
        let classic = CanDataFrame::new(id, &bytes[..8]).unwrap();
        assert!(matches!(any_arrival(classic.into()), BusRead::Foreign));
        let BusRead::Data(data) = classic_arrival(classic.into()) else { panic!("{classic:?}") };
        assert_eq!((data.id, data.bytes()), (0x205, &bytes[..8]));
        let error = CanErrorFrame::new_error(0x004, &[0, 0x10, 0, 0, 0, 0, 136, 0]).unwrap();
        let BusRead::Report(report) = any_arrival(error.into()) else { panic!("{error:?}") };
        assert_eq!(report, ControllerReport { class: 4, data: [0, 0x10, 0, 0, 0, 0, 136, 0] });
    }
}
