//! A recording that was cut or changed: no panic, and no loss before the damage.

use std::{fs, sync::LazyLock};

use proptest::prelude::*;
use proptest::sample::Index;
use telemetry::Update;
use telemetry::recording::{Recorder, Recording, recover};

use crate::common::{noise, performance, read, record, settings, unrecorded};

/// Messages with their times (ns since 1970).
type Told = Vec<(u64, Update)>;

static RECORDED: LazyLock<(Told, Vec<u8>)> = LazyLock::new(|| {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("whole.mcap");
    let told = performance(3000);
    record(&path, &told);
    (told, fs::read(path).expect("the file"))
});

fn whole_before(bytes: &[u8], at: usize) -> usize {
    let mut messages = 0;
    let mut offset = mcap::MAGIC.len();
    while let Some(head) = bytes.get(offset..offset + 9) {
        let length = u64::from_le_bytes(head[1..].try_into().expect("eight bytes"));
        let end = offset + 9 + usize::try_from(length).expect("short");
        if at < end {
            break;
        }
        if head[0] == mcap::records::op::CHUNK {
            let body = &bytes[offset + 9..end];
            let record = mcap::parse_record(head[0], body).expect("a chunk");
            let mcap::records::Record::Chunk { header, data } = record else { unreachable!() };
            let inside = mcap::read::ChunkReader::new(header, &data).expect("a chunk");
            let is_told = |it: &mcap::records::Record<'_>| {
                matches!(it, mcap::records::Record::Message { header, .. }
                    if header.log_time == header.publish_time)
            };
            messages += inside.filter(|it| it.as_ref().is_ok_and(is_told)).count();
        }
        offset = end;
    }
    messages
}

fn messages_of_chunks(bytes: &[u8]) -> Vec<usize> {
    let summary = mcap::Summary::read(bytes).expect("a summary").expect("there is one");
    let mut chunks = summary.chunk_indexes.clone();
    chunks.sort_by_key(|chunk| chunk.chunk_start_offset);
    let first_told = |chunk: &mcap::records::ChunkIndex| {
        let messages = summary.stream_chunk(bytes, chunk).expect("a chunk");
        messages.filter(|it| it.as_ref().is_ok_and(|it| it.log_time == it.publish_time)).count()
    };
    chunks.iter().map(first_told).collect()
}

fn but_for_what_is_said_again(told: &[(u64, Update)]) -> Vec<&(u64, Update)> {
    let is_said_again = |it: &Update| matches!(it, Update::Catalogue(_) | Update::Voice(_));
    told.iter().filter(|(_, update)| !is_said_again(update)).collect()
}

#[test]
fn one_damaged_byte_anywhere_loses_one_piece_at_most_and_neither_catalogue_nor_voices() {
    let folder = tempfile::tempdir().expect("a folder");
    let (told, whole) = &*RECORDED;
    let chunks = messages_of_chunks(whole);
    assert!(4 < chunks.len() && chunks.iter().sum::<usize>() == told.len(), "{chunks:?}");
    let starts = chunks.iter().scan(0, |at, n| Some(std::mem::replace(at, *at + n)));
    let expected: Vec<Vec<_>> = starts
        .zip(&chunks)
        .map(|(start, n)| [&told[..start], &told[start + n..]].concat())
        .chain([told.clone()])
        .collect();
    let expected: Vec<_> = expected.iter().map(|it| but_for_what_is_said_again(it)).collect();
    let path = folder.path().join("hit.mcap");
    let begin = 0..600;
    let rest = (600..whole.len()).step_by(whole.len() / 400);
    let (mut lost, mut advised) = (0, 0);
    for (n, hit) in begin.chain(rest).enumerate() {
        let mut bytes = whole.clone();
        bytes[hit] ^= 1 << (n % 8);
        fs::write(&path, &bytes).expect("a file");
        let recording = Recording::open(&path).unwrap_or_else(|error| panic!("{hit}: {error}"));
        let (found, wrong) = read(&recording);
        let found = but_for_what_is_said_again(&found);
        let which = expected.iter().rposition(|it| *it == found);
        let Some(which) = which else { panic!("{hit}: more than one piece is lost") };
        assert!(which == chunks.len() || wrong.len() == 1, "{hit}: {wrong:?}");
        assert!(wrong.iter().all(|it| it.contains("`letoff recover ")), "{wrong:?}");
        assert_eq!(recording.run(), "the run", "{hit}");
        let catalogue = recording.catalogue().unwrap_or_else(|error| panic!("{hit}: {error}"));
        assert!(catalogue.is_some(), "{hit}");
        let voices = recording.voices_at(u64::MAX).expect("voices");
        assert_eq!(voices.len(), crate::common::KEYS.len(), "{hit}");
        lost += usize::from(which < chunks.len());
        advised += usize::from(recording.tear().is_some());
    }
    assert!(
        50 < lost && 50 < advised,
        "{lost} lost a piece, {advised} beginnings or ends were hit"
    );
}

#[test]
fn what_is_said_again_is_read_once_and_in_the_place_of_what_was_lost() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("hit.mcap");
    let (told, whole) = &*RECORDED;
    let summary = mcap::Summary::read(whole).expect("a summary").expect("there is one");
    let first = summary.chunk_indexes.iter().min_by_key(|it| it.chunk_start_offset);
    let first = first.expect("a chunk");
    let mut bytes = whole.clone();
    let middle = first.chunk_start_offset + first.chunk_length / 2;
    bytes[usize::try_from(middle).expect("a small file")] ^= 1;
    fs::write(&path, &bytes).expect("a file");
    let recording = Recording::open(&path).expect("a recording");
    let (found, wrong) = read(&recording);
    // The catalogue and three voices of the beginning.
    assert_eq!((&found[..4], wrong.len()), (&told[..4], 1));
    let said = |it: &Told| it.len() - but_for_what_is_said_again(it).len();
    assert_eq!((said(&found), said(told)), (4, 4));
    assert!(wrong[0].contains("what it had from 0.000 s to 0."), "{wrong:?}");
    let new = folder.path().join("new.mcap");
    let recovered = recover(&path, &new).expect("recovered");
    assert_eq!((recovered.messages, recovered.damaged), (found.len() as u64, 1));
    let again = folder.path().join("again.mcap");
    let copied = recover(&new, &again).expect("a copy");
    assert_eq!((copied.messages, copied.damaged, copied.wrong.len()), (recovered.messages, 0, 1));
    for file in [&new, &again] {
        let made = Recording::open(file).expect("a recording");
        assert_eq!((read(&made).0, made.tear()), (found.clone(), None));
        let (at, _rest) = wrong[0].split_once(", and `letoff recover ").expect("advice");
        let origin = format!("{} was recovered from hit.mcap, which", file.display());
        assert_eq!(read(&made).1, [at.replace(&path.display().to_string(), &origin)]);
    }
}

#[test]
fn a_recording_that_breaks_off_and_is_damaged_is_read_behind_the_damage() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("hit.mcap");
    let (told, whole) = &*RECORDED;
    let summary = mcap::Summary::read(whole).expect("a summary").expect("there is one");
    let mut chunks = summary.chunk_indexes.clone();
    chunks.sort_by_key(|chunk| chunk.chunk_start_offset);
    let byte = |at: u64| usize::try_from(at).expect("a small file");
    let (third, last) = (byte(chunks[2].chunk_start_offset), &chunks[chunks.len() - 2]);
    let cut = byte(last.chunk_start_offset + last.chunk_length);
    let lost = messages_of_chunks(whole)[2];
    for hit in [third, third + 1, third + 3, third + 8, third + 100] {
        let mut bytes = whole[..cut].to_vec();
        bytes[hit] ^= 0x10;
        fs::write(&path, &bytes).expect("a file");
        let recording = Recording::open(&path).expect("a recording");
        let (found, wrong) = read(&recording);
        assert_eq!((found.len() + lost, wrong.len()), (told.len(), 1), "{hit}: {wrong:?}");
        let tear = recording.tear().expect("it breaks off").to_string();
        assert!(tear.contains(", but for one damaged piece, and `letoff recover "), "{tear}");
    }
}

#[test]
fn a_hole_costs_the_chunks_that_it_hits_and_their_neighbours_at_most_and_garbage_behind_nothing() {
    let folder = tempfile::tempdir().expect("a folder");
    let (hit, new) = (folder.path().join("hit.mcap"), folder.path().join("new.mcap"));
    let (told, whole) = &*RECORDED;
    let garbage: Vec<u8> = (0..5_000).map(|n| noise(n).to_bits().to_le_bytes()[0]).collect();
    fs::write(&hit, [&whole[..], &garbage].concat()).expect("a file");
    assert_eq!(read(&Recording::open(&hit).expect("a recording")).0, *told);
    let summary = mcap::Summary::read(whole).expect("a summary").expect("there is one");
    let mut chunks = summary.chunk_indexes;
    chunks.sort_by_key(|chunk| chunk.chunk_start_offset);
    let starts = chunks.iter().map(|chunk| chunk.chunk_start_offset);
    let starts: Vec<_> = starts.map(|at| usize::try_from(at).expect("a small file")).collect();
    let n_of_chunks = messages_of_chunks(whole);
    for (length, hole) in (0..40).map(|n| (64 << (n % 11), n * whole.len() / 40)) {
        let end = whole.len().min(hole + length);
        let mut bytes = whole.clone();
        bytes[hole..end].fill(0);
        fs::write(&hit, bytes).expect("a file");
        let recording = Recording::open(&hit).unwrap_or_else(|error| panic!("{hole}: {error}"));
        let (found, _wrong) = read(&recording);
        let first_hit = starts.partition_point(|start| *start <= hole).saturating_sub(1);
        let behind = starts.partition_point(|start| *start < end);
        let before: usize = n_of_chunks.iter().take(first_hit.saturating_sub(1)).sum();
        let after: usize = n_of_chunks.iter().skip(behind + 1).sum();
        let [whole_before, whole_behind, saved] =
            [&told[..before], &told[told.len() - after..], &found].map(but_for_what_is_said_again);
        assert!(saved.starts_with(&whole_before), "{length} B from byte {hole}");
        assert!(saved.ends_with(&whole_behind), "{length} B from byte {hole}");
        let _before = fs::remove_file(&new);
        let recovered = recover(&hit, &new).expect("it is saved").messages;
        assert_eq!(recovered, found.len() as u64, "{length} B from byte {hole}");
    }
}

fn place() -> impl Strategy<Value = Place> {
    prop_oneof![
        3 => any::<Index>().prop_map(Place::Anywhere),
        1 => (0..400_usize).prop_map(Place::FromStart),
        1 => (1..400_usize).prop_map(Place::FromEnd),
    ]
}

#[derive(Clone, Copy, Debug)]
enum Place {
    Anywhere(Index),
    FromStart(usize),
    FromEnd(usize),
}

impl Place {
    fn in_file(self, bytes: &[u8]) -> usize {
        match self {
            Self::Anywhere(index) => index.index(bytes.len()),
            Self::FromStart(byte) => byte,
            Self::FromEnd(byte) => bytes.len() - byte,
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 500, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_recording_that_was_cut_is_read_up_to_there(place in place()) {
        let folder = tempfile::tempdir().expect("a folder");
        let (told, bytes) = &*RECORDED;
        let cut = place.in_file(bytes);
        let path = folder.path().join("cut.mcap");
        fs::write(&path, &bytes[..cut]).expect("a file");
        match Recording::open(&path) {
            Ok(recording) => {
                let expected = whole_before(bytes, cut);
                let (found, wrong) = read(&recording);
                prop_assert_eq!(&found[..], &told[..expected]);
                prop_assert!(wrong.is_empty());
                let tear = recording.tear().expect("it was cut").to_string();
                prop_assert!(tear.contains(" breaks off at byte ") || tear.contains(" damaged index"), "{tear}");
                prop_assert!(!tear.contains('\n'));
            }
            Err(error) => {
                prop_assert!(whole_before(bytes, cut) == 0, "{error}");
                prop_assert!(!error.to_string().contains('\n'));
            }
        }
    }

    #[test]
    fn a_recording_with_changed_bytes_is_read_but_for_what_they_hit(
        place in place(), flip in 1..=u8::MAX, and_more in 0..3_usize,
    ) {
        let folder = tempfile::tempdir().expect("a folder");
        let (told, whole) = &*RECORDED;
        let mut bytes = whole.clone();
        let hit = place.in_file(whole);
        for byte in bytes[hit..].iter_mut().take(1 + and_more) {
            *byte ^= flip;
        }
        let path = folder.path().join("hit.mcap");
        fs::write(&path, &bytes).expect("a file");
        let Ok(recording) = Recording::open(&path) else {
            prop_assert!(whole_before(whole, hit) == 0);
            return Ok(());
        };
        let (found, wrong) = read(&recording);
        let expected = whole_before(whole, hit);
        prop_assert_eq!(&found[..expected], &told[..expected]);
        let lost = found.len() < told.len();
        prop_assert!(!lost || recording.tear().is_some() || !wrong.is_empty(), "lost in silence");
        prop_assert!(wrong.iter().all(|it| it.contains(" is damaged at byte ")), "{wrong:?}");
        let _voices = recording.voices_at(u64::MAX);
        let _catalogue = recording.catalogue();
        let _marks = telemetry::recording::marks(&recording).count();
        let new = folder.path().join("new.mcap");
        match recover(&path, &new) {
            Ok(recovered) => prop_assert_eq!(recovered.messages, found.len() as u64),
            Err(error) => prop_assert!(found.is_empty() && !new.exists(), "{error}"),
        }
    }

    #[test]
    fn any_bytes_behind_a_beginning_do_no_harm(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("any.mcap");
        for beginning in [&b""[..], mcap::MAGIC] {
            fs::write(&path, [beginning, &bytes].concat()).expect("a file");
            if let Ok(recording) = Recording::open(&path) {
                read(&recording);
            }
        }
    }
}

#[test]
fn what_a_dying_host_leaves_behind_is_read_and_made_whole() {
    let (folder, path) = unrecorded();
    let told = performance(3000);
    let mut recorder = Recorder::create(settings(&path)).expect("a new file");
    for (at, update) in &told {
        recorder.write(*at, update).expect("written");
    }
    // The bytes on the disk while the file is still being written.
    let torn = folder.path().join("torn.mcap");
    fs::copy(&path, &torn).expect("a copy");
    let recording = Recording::open(&torn).expect("a recording");
    let size = torn.metadata().expect("the file").len();
    let tear = recording.tear().expect("no summary").to_string();
    let expected = format!(
        "{} breaks off at byte {size} of {size}, because its host died or the file was cut: \
         everything before is there, and `letoff recover {}` makes a complete file of it",
        torn.display(),
        torn.display()
    );
    assert_eq!(tear, expected);
    let (found, _) = read(&recording);
    assert!(told.len() - found.len() < told.len() / 5, "a second of three at most");
    assert_eq!(found[..], told[..found.len()]);
    let whole = folder.path().join("whole.mcap");
    let recovered = recover(&torn, &whole).expect("recovered");
    let (what, _advice) = tear.split_once(": ").expect("what is wrong, and advice");
    assert_eq!((recovered.messages, recovered.wrong), (found.len() as u64, vec![what.to_owned()]));
    assert_eq!((recovered.cut, recovered.damaged), (0, 0));
    assert_eq!(recovered.span, Some((found[0].0, found[found.len() - 1].0)));
    let recording = Recording::open(&whole).expect("a recording");
    assert_eq!((recording.tear(), recording.run()), (None, "the run"));
    assert_eq!(read(&recording).0, found);
    assert!(recover(&torn, &whole).is_err(), "nothing is overwritten");
    assert_eq!(recover(&whole, &folder.path().join("again.mcap")).expect("a copy").wrong, [""; 0]);
}
