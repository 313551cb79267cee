use super::*;
use crate::links::trouble::PortTrouble;

#[test]
fn a_file_is_no_port() {
    let error = Serial::open(Path::new("/proc/self/status"), 115_200).unwrap_err();
    assert!(
        matches!(
            error,
            Error::Port { why: PortTrouble::Unfit(_) | PortTrouble::Refused { .. }, .. }
        ),
        "{error}"
    );
}

#[test]
fn a_port_is_opened_by_one_at_a_time_and_again_when_it_is_free() {
    let pty = Pty::open().unwrap();
    let first = Serial::open(&pty.path, 115_200).unwrap();
    let error = Serial::open(&pty.path, 115_200).unwrap_err();
    assert!(matches!(error, Error::Port { why: PortTrouble::Busy { .. }, .. }), "{error}");
    drop(first);
    Serial::open(&pty.path, 115_200).unwrap();
}

#[test]
fn what_had_come_before_the_port_was_opened_is_thrown_away() {
    let Pty { mut board, path } = Pty::open().unwrap();
    board.try_send(b"old").unwrap();
    let mut host = Serial::open(&path, 115_200).unwrap();
    board.try_send(b"new").unwrap();
    let mut buffer = [0; 64];
    let got = (0..1_000_000).find_map(|_| host.try_recv(&mut buffer).unwrap());
    assert_eq!(got.map(|len| &buffer[..len]), Some(&b"new"[..]));
}
