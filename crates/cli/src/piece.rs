//! A MIDI file on the command line: which parts of it are played, and what is in it.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use clap::Args;
use documents::{escaped, shown};
use pianist::{ChosenParts, ScoreTrack};
use serde_json::{Value, json};

use super::Failure;
use scene::{Override, PerformanceSource, is_midi_file};

/// What the virtual pianist plays.
#[derive(Clone, Debug, Default, Args)]
pub struct PieceArgs {
    /// What the virtual pianist plays: an embedded piece's name or a MIDI file, or a list of them
    /// in brackets, as a scene has it.
    #[arg(long, value_name = "FILE.mid")]
    pub performance: Option<String>,
    /// Tracks of the piece to play, counted from 1, as 2 or 2,3; all of them without.
    #[arg(long, value_name = "N", value_delimiter = ',')]
    pub track: Vec<u16>,
    /// Channels of the piece to play, 1 to 16; without it all but channel 10, which is percussion.
    #[arg(long, value_name = "N", value_delimiter = ',')]
    pub channel: Vec<u8>,
    /// Where rehearsals of the virtual pianist are kept for the next run; the user's own folder for
    /// what programs can make again if none is given.
    #[arg(long, value_name = "FOLDER|none")]
    pub rehearsals: Option<PathBuf>,
}

impl PieceArgs {
    /// Returns the overrides of the scene that have these arguments.
    pub(super) fn overrides(&self) -> impl Iterator<Item = Override> {
        let list = |numbers: String| Some(numbers).filter(|it| it != "[]");
        let named = [
            ("performance", self.performance.clone()),
            ("track", list(format!("{:?}", self.track))),
            ("channel", list(format!("{:?}", self.channel))),
        ];
        named.into_iter().filter_map(|(name, value)| {
            let value = value?;
            let typed = format!("--{name} {value}");
            Some(Override { name: format!("pianist.{name}"), typed, value })
        })
    }

    /// Returns these arguments with the piece in place of a scene, if `scene` is a MIDI file.
    pub(super) fn instead_of(&self, scene: &str) -> Result<Option<Self>, Failure> {
        match &self.performance {
            _ if !is_midi_file(Path::new(scene)) => Ok(None),
            Some(other) => Err(Failure::Usage(format!(
                "{scene} and {other} are both pieces: give one of them, or a scene and one of them"
            ))),
            None => Ok(Some(Self { performance: Some(scene.to_owned()), ..self.clone() })),
        }
    }
}

/// Returns the contents of the MIDI file at `path` in words, and for programs.
pub(super) fn contents(path: &Path) -> Result<(String, Value), Failure> {
    let source = PerformanceSource::Path(path.to_owned());
    let score = source.score(&ChosenParts::default()).map_err(Failure::Usage)?;
    let (file, length_s) = (shown(path), score.end());
    let (notes, pedal_moves) = (score.notes.len(), score.pedals.len());
    let mut lines = vec![
        format!("{file}: a good piece"),
        format!("  {length_s:.1} s, {notes} notes, {pedal_moves} pedal moves"),
    ];
    let mut tracks = Vec::new();
    for (number, ScoreTrack { name, notes, channels }) in (1..).zip(&score.tracks) {
        let channels: Vec<u16> = (1..=16).filter(|it| channels >> (it - 1) & 1 == 1).collect();
        let name = escaped(name);
        lines.push(format!("  track {number} \"{name}\": {notes} notes, channels {channels:?}"));
        tracks.push(json!({ "name": name, "notes": notes, "channels": channels }));
    }
    lines.push(format!("  not played as in the file: {}", score.passed_over));
    let unplayed: BTreeMap<_, _> = score.passed_over.named().collect();
    let report = json!({
        "file": file, "length_s": length_s, "notes": notes, "pedal_moves": pedal_moves,
        "tracks": tracks, "unplayed": unplayed,
    });
    Ok((lines.join("\n"), report))
}
