//! The C codec is held to the same vectors, and to this crate frame by frame.

use core::fmt::Write as _;
use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::sync::OnceLock;

use firmware_protocol::MAX_FRAME;
use firmware_protocol::acyclic::{AcyclicReply, AcyclicRequest};
use firmware_protocol::can::pieces::{self, Reassembler};
use firmware_protocol::can::{self};
use firmware_protocol::frame::DecodeError;
use firmware_protocol::frame::broadcast::{self, Broadcast};
use firmware_protocol::frame::hello::Introduction;
use firmware_protocol::frame::key_forces::{ForceLayout, ForcePacking, KeyForces};
use firmware_protocol::frame::key_samples::{KeySamples, SampleLayout, SamplePacking};
use firmware_protocol::frame::multicast_forces::MulticastForces;
use firmware_protocol::quantity::SlopeCode;
use firmware_protocol::serial::{self, Deframer, FramingError};

use crate::random::Random;
use crate::tools::{STRICT, are_there, crate_root, run, say, scratch};

const FRAMES: usize = 8_000;

#[test]
fn the_generated_header_is_current() {
    let committed = crate_root().join("c/letoff_protocol.h");
    let committed = std::fs::read_to_string(committed).expect("the header");
    let hint = "run: cargo run -p firmware-protocol --example c_header";
    assert!(committed == crate::c_header::header(), "c/letoff_protocol.h is not current; {hint}");
}

#[test]
fn the_c_codec_meets_every_vector() {
    let Some(program) = build("vectors", &[]) else { return };
    let names = crate::vector::all().into_iter().map(|vector| format!("{}.hex", vector.name));
    let paths: Vec<_> = names.map(|name| crate::vector::folder().join(name)).collect();
    let output = run(Command::new(program).args(&paths));
    let said = String::from_utf8_lossy(&output.stdout);
    assert_eq!(said.trim(), format!("{} vectors, 0 failures", paths.len()));
}

#[test]
fn the_c_codec_takes_refuses_and_writes_frames_as_the_rust_does() {
    let mut random = Random::new(1);
    let seeds: Vec<_> = crate::vector::all().iter().map(crate::vector::Vector::frame).collect();
    let frames = (0..FRAMES).map(|i| random.near(&seeds[i % seeds.len()], 80));
    compare(&frames.map(|frame| (format!("f {}", hex(&frame)), frame_line(&frame))).collect());
}

#[test]
fn the_c_deframer_finds_what_the_rust_does_in_any_stream() {
    let mut random = Random::new(2);
    let seeds: Vec<_> =
        crate::vector::all().iter().map(|vector| vector.bytes("wire").concat()).collect();
    let streams = (0..FRAMES / 4).map(|i| {
        let wires = (0..4).map(|j| random.near(&seeds[(i + 7 * j) % seeds.len()], 90));
        wires.collect::<Vec<_>>().concat()
    });
    compare(&streams.map(|bytes| (format!("s {}", hex(&bytes)), stream_line(&bytes))).collect());
}

#[test]
fn the_c_assembler_finds_what_the_rust_does_in_any_pieces() {
    let mut random = Random::new(3);
    let seeds: Vec<_> = crate::vector::all().iter().map(crate::vector::Vector::frame).collect();
    let trains = (0..FRAMES / 4).map(|i| {
        let frames = [&seeds[i % seeds.len()], &seeds[(i + 5) % seeds.len()]];
        let cut = frames.into_iter().zip(0..).flat_map(|(frame, roll)| pieces::cut(frame, roll));
        let cut = cut.map(|(piece, len)| piece[..len].to_vec()).collect::<Vec<_>>();
        let kept = cut.into_iter().filter(|_| random.below(20) != 0).collect::<Vec<_>>();
        let near = |piece: &Vec<u8>| {
            if random.below(9) == 0 { random.near(piece, 12) } else { piece.clone() }
        };
        kept.iter().map(near).collect::<Vec<_>>()
    });
    let line = |pieces: Vec<Vec<u8>>| {
        // A space after each piece makes an empty one visible.
        let words: Vec<_> = pieces.iter().map(|piece| hex(piece) + " ").collect();
        (format!("p {}", words.concat()), pieces_line(&pieces))
    };
    compare(&trains.map(line).collect());
}

#[test]
fn slopes_are_rounded_alike() {
    let near_powers = (0..20).flat_map(|e| (-2..=2).map(move |d| (1 << e) + d));
    let units = near_powers.chain([i32::MAX, i32::MIN, i32::MIN + 1]).chain(-300..300);
    let line = |units: i32| {
        let slope = SlopeCode::toward_zero(units);
        (format!("n {units}"), format!("{} {}", slope.code(), slope.get()))
    };
    compare(&units.flat_map(|units| [units, units.wrapping_neg()]).map(line).collect());
}

#[test]
fn the_parts_of_the_firmware_without_hardware_do_what_they_say() {
    let parts = ["arm", "forces", "gesture", "history", "law", "lever", "log", "plant"];
    let parts = parts.map(|part| format!("firmware/{part}.c"));
    let parts = parts.each_ref().map(String::as_str);
    let Some(program) = build("pure", &parts) else { return };
    let output = Command::new(program).output().expect("the program starts");
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{said}");
}

fn build(name: &str, parts: &[&str]) -> Option<PathBuf> {
    if !are_there(&["gcc"]) {
        return None;
    }
    let program = scratch(&format!("c_{name}_{}", std::process::id()));
    let c = crate_root().join("c");
    let mut gcc = Command::new("gcc");
    gcc.args(STRICT).args(["-O1", "-g", "-fsanitize=address,undefined"]);
    gcc.arg("-fno-sanitize-recover=all").arg(c.join(format!("test/{name}.c")));
    gcc.args(parts.iter().map(|part| c.join(part))).arg(c.join("letoff_codec.c"));
    run(gcc.arg("-o").arg(&program));
    Some(program)
}

#[track_caller]
fn compare(lines: &Vec<(String, String)>) {
    static PROGRAM: OnceLock<Option<PathBuf>> = OnceLock::new();
    let Some(program) = PROGRAM.get_or_init(|| build("differential", &[])) else { return };
    let questions: Vec<_> = lines.iter().map(|(question, _)| question.as_str()).collect();
    let questions = questions.join("\n") + "\n";
    let mut child = Command::new(program);
    let child = child.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn();
    let mut child = child.expect("the program starts");
    let mut stdin = child.stdin.take().expect("piped");
    let writer =
        std::thread::spawn(move || std::io::Write::write_all(&mut stdin, questions.as_bytes()));
    let output = child.wait_with_output().expect("it ends");
    writer.join().expect("no panic").expect("all questions are read");
    assert!(output.status.success(), "the sanitizers found something, see above");
    let said = String::from_utf8(output.stdout).expect("text");
    assert_eq!(said.lines().count(), lines.len());
    for (answer, (question, expected)) in said.lines().zip(lines) {
        assert_eq!(answer.trim(), expected.trim(), "{question}");
    }
    say(&format!("{} lines are alike in C and in Rust", lines.len()));
}

fn hex(bytes: &[u8]) -> String {
    let mut digits = String::new();
    for byte in bytes {
        write!(digits, "{byte:02x}").expect("a string grows");
    }
    digits
}

fn answer(line: &mut String, outcome: Result<Vec<u8>, DecodeError>) {
    let said = match outcome {
        Ok(again) => format!(" ={}", hex(&again)),
        Err(DecodeError::Length { .. }) => " 1".to_owned(),
        Err(DecodeError::Kind(_)) => " 2".to_owned(),
        Err(DecodeError::NoSuchBoard(_)) => " 3".to_owned(),
        Err(DecodeError::Version(_)) => " 4".to_owned(),
        Err(DecodeError::Magic) => " 5".to_owned(),
        Err(DecodeError::Padding) => " 6".to_owned(),
        Err(DecodeError::Value { .. }) => " 7".to_owned(),
    };
    line.push_str(&said);
}

fn frame_line(frame: &[u8]) -> String {
    let mut line = can::identifier(frame).map_or_else(|| "-1".to_owned(), |id| id.to_string());
    for n_keys in [1, 11, 12] {
        cyclic(&mut line, frame, n_keys);
    }
    answer(&mut line, MulticastForces::decode(frame).map(|forces| forces.encode().to_vec()));
    answer(
        &mut line,
        Broadcast::decode(frame).map(|said| {
            let mut again = [0; broadcast::MAX_LEN];
            let len = said.encode(&mut again);
            again[..len].to_vec()
        }),
    );
    answer(
        &mut line,
        Introduction::decode(frame).map(|who| {
            let mut again = [0; MAX_FRAME];
            let len = who.encode(&mut again);
            again[..len].to_vec()
        }),
    );
    answer(
        &mut line,
        AcyclicRequest::decode(frame).map(|request| {
            let operation = request.operation.map_or_else(|number| number, |known| known as u8);
            [&[0x80 | request.board.number(), request.id, operation], request.record].concat()
        }),
    );
    answer(
        &mut line,
        AcyclicReply::decode(frame).map(|reply| {
            let operation = reply.operation.map_or_else(|number| number, |known| known as u8);
            let head = [0xA0 | reply.board.number(), reply.id, operation, reply.status as u8];
            [&head, reply.record].concat()
        }),
    );
    line
}

fn cyclic(line: &mut String, frame: &[u8], n_keys: usize) {
    let mut again = [0; MAX_FRAME];
    for packing in SamplePacking::ALL {
        let samples = KeySamples::decode(frame, SampleLayout { packing, n_keys });
        answer(
            line,
            samples.map(|samples| {
                let len = samples.encode(packing, &mut again);
                again[..len].to_vec()
            }),
        );
    }
    for packing in ForcePacking::ALL {
        let forces = KeyForces::decode(frame, ForceLayout { packing, n_keys });
        answer(
            line,
            forces.map(|forces| {
                let len = forces.encode(&mut again);
                again[..len].to_vec()
            }),
        );
    }
}

fn stream_line(bytes: &[u8]) -> String {
    let mut deframer = Deframer::default();
    let mut line = String::new();
    for byte in bytes {
        let said = match deframer.push(*byte) {
            None => continue,
            Some(Ok(frame)) => {
                let mut wire = [0; serial::MAX_WIRE];
                let len = serial::encode(frame, &mut wire).expect("a frame that came in goes out");
                format!(" ={} ~{}", hex(frame), hex(&wire[..len]))
            }
            Some(Err(FramingError::TooLong)) => " 2".to_owned(),
            Some(Err(FramingError::Stuffing)) => " 3".to_owned(),
            Some(Err(FramingError::Checksum)) => " 4".to_owned(),
        };
        line.push_str(&said);
    }
    line
}

fn pieces_line(pieces: &[Vec<u8>]) -> String {
    let mut assembler = Reassembler::default();
    let mut line = String::new();
    for piece in pieces {
        let said = match assembler.push(piece) {
            Ok(None) => " 0".to_owned(),
            Ok(Some(frame)) => format!(" ={}", hex(frame)),
            Err(_lost) => " 2".to_owned(),
        };
        line.push_str(&said);
    }
    line
}
