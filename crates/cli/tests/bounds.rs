//! Work and memory stay within bounds, whatever a file or a client asks for.

use std::io::Write as _;
use std::os::unix::net::UnixStream;
use std::path::Path;
use std::process::Output;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex};
use std::time::Duration;

use host::control::{Answers, Clients, ControlServer, Reply, Request, serve};

use crate::typed::Folder;

const PATIENCE: Duration = Duration::from_mins(1);

fn letoff(limit: &str, arguments: &str, folder: &Folder) -> Output {
    let script = format!("ulimit {limit} && exec {} {arguments}", env!("CARGO_BIN_EXE_letoff"));
    folder.command(Path::new("/bin/sh"), &["-c", &script]).output().expect("a shell")
}

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

#[test]
fn a_host_runs_whatever_stack_the_shell_allows() {
    let folder = Folder::new("stack");
    let run = "run springs --virtual-time --duration 1 --performance none";
    let output = letoff("-s 64", run, &folder);
    assert!(output.status.success(), "{:?}: {}", output.status, said(&output));
}

#[test]
fn a_length_that_a_recording_only_declares_takes_no_memory() {
    let folder = Folder::new("length");
    let record = |opcode: u8, body: &[u8]| {
        [&[opcode], (body.len() as u64).to_le_bytes().as_slice(), body].concat()
    };
    let header = [&6_u32.to_le_bytes(), b"letoff".as_slice(), &0_u32.to_le_bytes()].concat();
    // Metadata whose name would have 4 GiB.
    let metadata = [&0xffff_0002_u32.to_le_bytes(), b"letoff".as_slice()].concat();
    let magic = b"\x89MCAP0\r\n".as_slice();
    let bytes = [magic, &record(1, &header), &record(12, &metadata)].concat();
    folder.write("x.mcap", bytes);
    for command in ["replay x.mcap", "recover x.mcap"] {
        let output = letoff("-v 3000000", command, &folder);
        let said = said(&output);
        assert!(matches!(output.status.code(), Some(1 | 2)), "{:?}: {said}", output.status);
        assert!(said.contains("no recording of letoff's"), "{said}");
    }
}

#[test]
fn a_piece_of_many_years_is_refused_before_it_is_rehearsed() {
    let folder = Folder::new("years");
    // One tick per quarter, the slowest tempo, and a note after the longest pause.
    let track = [
        &[0, 0xff, 0x51, 3, 0xff, 0xff, 0xff][..],
        &[0xff, 0xff, 0xff, 0x7f, 0x90, 60, 64],
        &[1, 0x80, 60, 0, 0, 0xff, 0x2f, 0],
    ];
    let track = track.concat();
    let head = b"MThd\0\0\0\x06\0\0\0\x01\0\x01MTrk";
    let length = u32::try_from(track.len()).expect("short").to_be_bytes();
    let bytes = [head.as_slice(), &length, &track].concat();
    folder.write("x.mid", bytes);
    let run = "run springs --virtual-time --performance x.mid";
    let arguments: Vec<_> = run.split(' ').collect();
    folder.refuses(&arguments, 2, &["take too long to rehearse"]);
}

/// Answers when the client is known to have left.
struct WaitingAnswers {
    left: Sender<()>,
    leaves: Mutex<Receiver<()>>,
    begun: Sender<()>,
    answered: Sender<bool>,
}

impl Answers for WaitingAnswers {
    fn reply_to(&self, _request: &Request, _connection: u64) -> Result<Reply, String> {
        self.begun.send(()).expect("a test that waits");
        let has_left = self.leaves.lock().expect("no panic").recv_timeout(PATIENCE).is_ok();
        let _over = self.answered.send(has_left);
        Err("nobody hears this".to_owned())
    }

    fn left(&self, _connection: u64) {
        let _over = self.left.send(());
    }
}

#[test]
fn a_client_that_hangs_up_is_known_to_have_left_before_its_answer() {
    let folder = Folder::new("hang-up");
    let path = folder.socket();
    let runtime = tokio::runtime::Builder::new_multi_thread().enable_all().build().unwrap();
    let _guard = runtime.enter();
    let server = ControlServer::listen(&path).expect("a socket");
    let (left, leaves) = channel();
    let (begun, begins) = channel();
    let (answered, answers) = channel();
    let waiting = WaitingAnswers { left, leaves: leaves.into(), begun, answered };
    runtime.spawn(serve(server, Arc::new(waiting), Clients::default()));
    let mut client = UnixStream::connect(&path).expect("it listens");
    let request = serde_json::to_string(&Request::Status {}).expect("JSON");
    writeln!(client, "{request}").expect("it reads");
    begins.recv_timeout(PATIENCE).expect("it answers");
    drop(client);
    assert_eq!(answers.recv_timeout(2 * PATIENCE), Ok(true));
}
