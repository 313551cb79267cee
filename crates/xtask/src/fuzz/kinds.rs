//! Kinds of files that `letoff` reads, with good files and the commands that read them.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};

use crate::command::{self, root};
use crate::{error::Error, files};

pub(super) struct FuzzKind {
    pub(super) name: &'static str,
    pub(super) ending: &'static str,
    /// Commands that read a file called FILE; each damaged file is given to one of them.
    pub(super) commands: &'static [&'static str],
    good: GoodFiles,
}

enum GoodFiles {
    /// All files of a folder with the kind's ending, below the workspace's root.
    Folder(&'static str),
    Text(&'static str),
    Stroke,
    Recording,
    Calibration,
}

const PLAY_LIST: &str = "[[keys]]\nrange = \"A0..C8\"\ninstrument = \"grand-springs\"\n\n[pianist]\n\
    performance = [\"bach-bwv-846\", \"beethoven-ode-to-joy\", \"bach-bwv-846\"]\nrepeat = true\n";

const TOKENS: &str = "# who may do what\nviewer 0123456789abcdef0123\ntuner 0123456789abcdef4567\n\n\
    owner 0123456789abcdef89ab\n";

const CALIBRATION: &str = r#"
board = "53494d000000"
made = "2026-11-27 12:37 UTC"
by = "letoff calibrate 0.1.0"
checksum = "6c4bcad0"

[[key]]
slot = 0
rest = 0
bottom = 10166
metres_per_count = 1.0000000000000002e-6
friction = 0.11879009999980925
gain = 1.0

[[key]]
slot = 1
rest = 0
bottom = 10165
metres_per_count = 1.0000000000000002e-6
friction = 0.11217885000014588
gain = 1.0

[[key]]
slot = 2
rest = 0
bottom = 10166
metres_per_count = 1.0000000000000002e-6
friction = 0.12119235000000109
gain = 1.0
"#;

pub(super) const KINDS: [FuzzKind; 10] = [
    FuzzKind {
        name: "scenes",
        ending: "toml",
        commands: &["check FILE", "run FILE --virtual-time --duration 0.2 --json"],
        good: GoodFiles::Folder("configs/scenes"),
    },
    FuzzKind {
        name: "descriptions",
        ending: "toml",
        commands: &["check FILE", "simulate FILE --until 0.02 --step 0.001"],
        good: GoodFiles::Folder("configs/models"),
    },
    FuzzKind {
        name: "instruments",
        ending: "toml",
        commands: &[
            "check FILE",
            "run springs --set keys.instrument=FILE --virtual-time --duration 0.1 --json",
        ],
        good: GoodFiles::Folder("configs/instruments"),
    },
    FuzzKind {
        name: "midi",
        ending: "mid",
        commands: &["run springs --performance FILE --virtual-time --duration 0.5 --json"],
        good: GoodFiles::Folder("configs/performances"),
    },
    FuzzKind {
        name: "csv",
        ending: "csv",
        commands: &["simulate key-hammer-springs --input FILE --until 0.05 --step 0.001"],
        good: GoodFiles::Stroke,
    },
    FuzzKind {
        name: "measurements",
        ending: "csv",
        commands: &["lab fit synth FILE --fit soft --out fitted --json"],
        good: GoodFiles::Folder("tests/fit"),
    },
    FuzzKind {
        name: "recordings",
        ending: "mcap",
        commands: &["replay FILE", "recover FILE --into recovered.mcap --overwrite"],
        good: GoodFiles::Recording,
    },
    FuzzKind {
        name: "tokens",
        ending: "txt",
        commands: &[
            "run springs --tokens FILE --listen 127.0.0.1:0 --performance none --duration 0.01 --json",
        ],
        good: GoodFiles::Text(TOKENS),
    },
    FuzzKind {
        name: "play-lists",
        ending: "toml",
        commands: &["run FILE --virtual-time --duration 0.2 --json"],
        good: GoodFiles::Text(PLAY_LIST),
    },
    FuzzKind {
        name: "calibrations",
        ending: "toml",
        commands: &["run springs --link serial:links/board0 --listen none --duration 0.01 --json"],
        good: GoodFiles::Calibration,
    },
];

pub(super) struct PreparedKind {
    pub(super) good: Vec<Vec<u8>>,
    pub(super) place: Option<PathBuf>,
    board: Option<Child>,
}

impl Drop for PreparedKind {
    fn drop(&mut self) {
        if let Some(board) = &mut self.board {
            let _gone = board.kill().and_then(|()| board.wait());
        }
    }
}

impl FuzzKind {
    pub(super) fn prepare(&self, program: &Path, folder: &Path) -> Result<PreparedKind, Error> {
        let mut it = PreparedKind { good: Vec::new(), place: None, board: None };
        let has_ending = |path: &PathBuf| path.extension().is_some_and(|it| it == self.ending);
        let paths: Vec<_> = match self.good {
            GoodFiles::Text(text) => {
                it.good.push(text.into());
                Vec::new()
            }
            GoodFiles::Stroke => {
                it.good.push(stroke().into());
                Vec::new()
            }
            GoodFiles::Folder(name) => files::list(&root().join(name))?,
            GoodFiles::Recording => {
                let file = folder.join("good.mcap");
                let mut record = in_folder(program, folder);
                record
                    .args(["run", "springs", "--duration", "0.5", "--listen", "none", "--record"])
                    .arg(&file);
                command::answer(&mut record)?;
                vec![file]
            }
            GoodFiles::Calibration => {
                let mut board = in_folder(program, folder);
                board.args(["board", "--keys", "A0..B0", "--links", "links"]);
                let board = board.stdout(Stdio::null()).stderr(Stdio::null()).spawn();
                it.board = Some(board.map_err(|cause| Error::file(program, cause))?);
                files::make(&folder.join("letoff/calibration"))?;
                it.place = Some("letoff/calibration/53494d000000.toml".into());
                it.good.push(CALIBRATION.into());
                Vec::new()
            }
        };
        for path in paths.iter().filter(|path| has_ending(path)) {
            it.good.push(fs::read(path).map_err(|cause| Error::file(path, cause))?);
        }
        Ok(it)
    }
}

fn in_folder(program: &Path, folder: &Path) -> Command {
    let mut command = Command::new(program);
    command.current_dir(folder).stdin(Stdio::null());
    command.env("XDG_CONFIG_HOME", folder).env("LETOFF_SOCKET", folder.join("socket"));
    command
}

fn stroke() -> String {
    let row = |n: u32| {
        let t = f64::from(n) * 1e-3;
        format!("{t},{:.6}\n", (t / 0.05).min(1.0).powi(2) * 0.01)
    };
    "t,s\n".to_owned() + &(0..100).map(row).collect::<String>()
}
