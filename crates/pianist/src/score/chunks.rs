//! Header and tracks of a file, as bytes.

use super::ScoreError;

#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Chunks<'a> {
    /// 0 for one track, 1 for several, 2 for independent patterns.
    pub(super) format: u16,
    pub(super) division: u16,
    pub(super) tracks: Vec<TrackBytes<'a>>,
    /// Bytes after the last chunk.
    pub(super) trailing: usize,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct TrackBytes<'a> {
    /// Offset in the file.
    pub(super) at: usize,
    pub(super) bytes: &'a [u8],
    /// Announced bytes that the file does not have.
    pub(super) missing: usize,
}

impl<'a> Chunks<'a> {
    /// Finds the chunks of a file, which may be wrapped in RIFF; passes over unknown ones.
    pub(super) fn of(file: &'a [u8]) -> Result<Self, ScoreError> {
        let is_wrapped = file.starts_with(b"RIFF") && file.get(8..12) == Some(b"RMID");
        let begin = if is_wrapped { file.windows(4).position(|it| it == b"MThd") } else { Some(0) };
        let mut rest = begin.and_then(|begin| file.get(begin..)).unwrap_or(&[]);
        let (b"MThd", length, body) = chunk(rest).ok_or(ScoreError::NotMidi)? else {
            return Err(ScoreError::NotMidi);
        };
        let header = body.first_chunk::<6>().filter(|_| 6 <= length).ok_or(ScoreError::NotMidi)?;
        let [format, declared, division] =
            [0, 2, 4].map(|at| u16::from_be_bytes([header[at], header[at + 1]]));
        rest = body.get(length..).unwrap_or(&[]);
        let mut found = Self { format, division, tracks: Vec::new(), trailing: 0 };
        while let Some((kind, length, body)) = chunk(rest) {
            let (bytes, after) = body.split_at_checked(length).unwrap_or((body, &[]));
            let missing = length - bytes.len();
            if 0 < missing && usize::from(declared) <= found.tracks.len() {
                break;
            }
            if kind == b"MTrk" {
                found.tracks.push(TrackBytes { at: file.len() - body.len(), bytes, missing });
            }
            rest = after;
        }
        found.trailing = if is_wrapped { 0 } else { rest.len() };
        let present = u16::try_from(found.tracks.len()).unwrap_or(u16::MAX);
        if present < declared {
            return Err(ScoreError::TracksMissing { declared, present });
        }
        Ok(found)
    }
}

/// Returns kind and announced length of the next chunk, and all bytes after these.
fn chunk(bytes: &[u8]) -> Option<(&[u8; 4], usize, &[u8])> {
    let (kind, rest) = bytes.split_first_chunk::<4>()?;
    let (length, body) = rest.split_first_chunk::<4>()?;
    Some((kind, u32::from_be_bytes(*length) as usize, body))
}
