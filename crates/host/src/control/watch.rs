//! Watches the descriptions that play, and loads one that was saved.

use std::collections::BTreeMap;
use std::io;
use std::sync::Arc;
use std::time::Duration;

use instruments::FileContents;
use mechanism::contents_now;

use super::RequestHandler;
use super::repeated_look::RepeatedLook;

/// Time between two looks; what is found twice is read, so that a file is not read while it is
/// written.
const LOOK: Duration = Duration::from_millis(100);

/// Who asks for a description that was saved.
const WATCH: &str = "--watch";

/// Watches the descriptions that the voices of the host of `handler` play, and what they are based
/// on, until what is returned is dropped.
///
/// It compares what stands in the files: editors write into them, or put others into their
/// places. A file that is not there for a moment changes nothing.
///
/// # Errors
/// If the system gives no thread.
pub fn watch_descriptions(handler: Arc<RequestHandler>) -> io::Result<RepeatedLook> {
    handler.begin_to_watch();
    let mut found = FoundContents::default();
    RepeatedLook::start("letoff-watch", LOOK, move || found.look(&handler))
}

/// What was found in files at the last look, where it is not what was read.
#[derive(Debug, Default)]
struct FoundContents(BTreeMap<String, FileContents>);

impl FoundContents {
    /// Looks at all files once, and has those read that were saved.
    fn look(&mut self, handler: &RequestHandler) {
        for (file, read) in handler.described_files() {
            let now = contents_now(&read);
            if now == read || now.lacks_one_of(&read) {
                self.0.remove(&file);
            } else if self.0.get(&file) == Some(&now) {
                // What is wrong was told; what was refused now is tried again at the next look.
                let _told = handler.load(&file, None, (WATCH, None));
            } else {
                self.0.insert(file, now);
            }
        }
    }
}
