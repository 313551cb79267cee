//! Watches the playing descriptions, and loads saved ones.

use std::{collections::BTreeMap, io, sync::Arc, time::Duration};

use instruments::FileContents;
use mechanism::contents_now;

use super::{RequestHandler, repeated_look::RepeatedLook};

/// Interval of the polls; two equal finds are read, so that no half-written file is read.
const LOOK: Duration = Duration::from_millis(100);

/// Author of a request for a saved description.
const WATCH: &str = "--watch";

/// Watches the descriptions of `handler`'s voices and their bases until the result is dropped.
///
/// Compares contents, since editors write into files or replace them. Missing files change nothing.
pub fn watch_descriptions(handler: Arc<RequestHandler>) -> io::Result<RepeatedLook> {
    handler.begin_to_watch();
    let mut found = FoundContents::default();
    RepeatedLook::start("letoff-watch", LOOK, move || found.look(&handler))
}

#[derive(Debug, Default)]
struct FoundContents(BTreeMap<String, FileContents>);

impl FoundContents {
    fn look(&mut self, handler: &RequestHandler) {
        for (file, read) in handler.described_files() {
            let now = contents_now(&read);
            if now == read || now.lacks_one_of(&read) {
                self.0.remove(&file);
            } else if self.0.get(&file) == Some(&now) {
                // Mistakes were reported; the next poll retries a change that is rejected now.
                let _told = handler.load(&file, None, (WATCH, None));
            } else {
                self.0.insert(file, now);
            }
        }
    }
}
