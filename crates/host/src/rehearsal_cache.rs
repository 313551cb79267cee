//! Rehearsals that are kept in files, so that the second run of a piece starts at once.
//!
//! ```text
//! length of the content (8 bytes, little-endian)
//! content   all that the rehearsal depends on, as text: two rehearsals with it have equal bits
//! result    the performance
//! CRC-64    of everything before
//! ```

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use crc::{CRC_64_XZ, Crc};
use engine::voice::VoiceBuilder;
use pianist::{Performance, Pianist, Score};
use scene::Scene;

/// Maximum size of all files (bytes): the oldest ones are removed.
const MAX_SIZE: u64 = 64 << 20;

const ENDING: &str = "rehearsal";

/// Folder with the rehearsals of one program.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct RehearsalCache {
    pub folder: PathBuf,
    /// Version of the program: another one may rehearse otherwise.
    pub program: String,
}

impl RehearsalCache {
    /// Returns everything that the rehearsal of `score` depends on.
    pub(crate) fn content(
        &self,
        (scene, builder): (&Scene, &VoiceBuilder<'_>),
        pianist: &Pianist,
        score: &Score,
    ) -> String {
        let Pianist { curve, technique, .. } = pianist;
        let program = &self.program;
        let (hz, render, links) = (scene.tick_hz, &scene.render, &scene.links);
        let rig = builder.rig();
        let mut content = format!(
            "{program}\n{hz} Hz {render:?}\n{:?}\n{rig:?}\n{links:?}\n{curve:?} {technique:?}\n{score:?}\n",
            scene.rig
        );
        let mut described = Vec::new();
        for (key, voice) in builder.keys() {
            let (model, values) = (&voice.model, &voice.values);
            let line = format!("{key} {} {values:?}\n", model.name);
            content.push_str(&line);
            if let Some(source) = &model.source
                && !described.contains(&model.name)
            {
                described.push(model.name);
                let text = format!("{:?}\n", source.contents);
                content.push_str(&text);
            }
        }
        content
    }

    /// Returns the kept rehearsal with `content`, if there is an undamaged one.
    pub(crate) fn find(&self, content: &str) -> Option<Performance> {
        let bytes = fs::read(self.path(content)).ok()?;
        let (bytes, sum) = bytes.split_last_chunk::<8>()?;
        let (length, kept) = bytes.split_first_chunk::<8>()?;
        let length = usize::try_from(u64::from_le_bytes(*length)).ok()?;
        let (kept, performance) = kept.split_at_checked(length)?;
        let is_whole = checksum(bytes).to_le_bytes() == *sum && kept == content.as_bytes();
        is_whole.then(|| Performance::from_bytes(performance)).flatten()
    }

    /// Keeps a rehearsal, and removes the oldest ones. An error costs the next run its time only.
    pub(crate) fn keep(&self, content: &str, performance: &Performance) -> io::Result<()> {
        let mut bytes = (content.len() as u64).to_le_bytes().to_vec();
        bytes.extend(content.as_bytes());
        bytes.extend(performance.to_bytes());
        bytes.extend(checksum(&bytes).to_le_bytes());
        fs::create_dir_all(&self.folder)?;
        let path = self.path(content);
        // Another process may keep the same rehearsal.
        let part = path.with_added_extension(format!("{}.part", std::process::id()));
        fs::write(&part, bytes).and_then(|()| fs::rename(&part, &path))?;
        remove_oldest(&self.folder, MAX_SIZE)
    }

    fn path(&self, content: &str) -> PathBuf {
        let name = format!("{:016x}.{ENDING}", checksum(content.as_bytes()));
        self.folder.join(name)
    }
}

fn checksum(bytes: &[u8]) -> u64 {
    Crc::<u64>::new(&CRC_64_XZ).checksum(bytes)
}

/// Removes the oldest rehearsals in `folder` until the others have at most `size` (bytes).
fn remove_oldest(folder: &Path, size: u64) -> io::Result<()> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let path = entry.path();
        if path.extension().is_some_and(|it| it == ENDING || it == "part") {
            let about = entry.metadata()?;
            files.push((about.modified()?, path, about.len()));
        }
    }
    files.sort();
    let mut total = 0;
    for (_, path, len) in files.iter().rev() {
        total += len;
        if size < total {
            fs::remove_file(path)?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_newest_rehearsals_are_kept() {
        let folder = std::env::temp_dir().join(format!("letoff-kept-{}", std::process::id()));
        let cache = RehearsalCache { folder: folder.clone(), program: String::new() };
        let gestures = vec![Vec::new(); keyboard::KEYS];
        let performance = Performance { gestures, repeat: Some(1.0), ..Performance::default() };
        for content in ["one", "two"] {
            cache.keep(content, &performance).unwrap();
            assert_eq!(cache.find(content).as_ref(), Some(&performance));
        }
        let one = fs::File::options().append(true).open(cache.path("one")).unwrap();
        one.set_modified(std::time::SystemTime::UNIX_EPOCH).unwrap();
        remove_oldest(&folder, 1000).unwrap();
        let found = ["one", "two"].map(|content| cache.find(content).is_some());
        fs::remove_dir_all(&folder).unwrap();
        assert_eq!(found, [false, true]);
    }
}
