use std::fs;
use std::process::Command;
use std::sync::Arc;

use mechanism::{Library, description};

fn resident() -> u64 {
    let statm = fs::read_to_string("/proc/self/statm").unwrap();
    let pages: u64 = statm.split_whitespace().nth(1).unwrap().parse().unwrap();
    pages * 4096
}

/// Set in the process that measures: other tests change what is resident.
const ALONE: &str = "LETOFF_RELOADS_ALONE";

#[test]
fn fifty_reloads_of_a_description_leave_no_memory_behind() {
    /// Reloads until the allocator has its reserve.
    const FIRST: u32 = 10;
    /// Table, machine code and entry of one version take 360 kB, fifty of them 18 MB.
    const MOST: u64 = 4 << 20;
    if std::env::var_os(ALONE).is_none() {
        let name = "memory::fifty_reloads_of_a_description_leave_no_memory_behind";
        let mut alone = Command::new(std::env::current_exe().unwrap());
        let status = alone.args(["--exact", name, "--nocapture"]).env(ALONE, "1").status().unwrap();
        assert!(status.success(), "{status}");
        return;
    }
    let (library, folder) = (Library::default(), tempfile::tempdir().unwrap());
    let path = folder.path().join("my-action.toml");
    let text = description("reduced-grand").unwrap();
    let mut before = Vec::new();
    let mut playing = None;
    let mut settled = 0;
    for reload in 0..FIRST + 50 {
        let changed = text.replace("summary = \"", &format!("summary = \"{reload}: "));
        assert_ne!(changed, text);
        fs::write(&path, changed).unwrap();
        let model = library.load(&path).unwrap();
        assert_eq!(model.version(), reload + 1);
        before.push(Arc::downgrade(&model));
        playing = Some(model);
        if reload + 1 == FIRST {
            settled = resident();
        }
    }
    let alive = before.iter().filter(|version| version.strong_count() > 0).count();
    assert_eq!(alive, 1, "the one that plays");
    assert!(playing.is_some());
    let grown = resident().saturating_sub(settled);
    assert!(grown < MOST, "{grown} bytes more after fifty reloads");
}
