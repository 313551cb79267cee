//! A host that a test starts, kills and starts again.

use std::fs;
use std::net::TcpListener;
use std::path::{Path, PathBuf};
use std::process::Child;
use std::time::{Duration, Instant};

use dashboard::open::WindowTarget;
use host::control::{Reply, Request, send};

use crate::letoff::{folder, start_logged};

/// Maximum wait for any machine: it only ends failed tests.
pub(crate) const PATIENCE: Duration = Duration::from_mins(2);

const INTERVAL: Duration = Duration::from_millis(20);

#[derive(Debug)]
pub(crate) struct Program(Child);

impl Program {
    /// Starts `letoff` in `folder`, where it writes its log to the end of the file `log`.
    pub(crate) fn start(folder: &Path, log: &str, arguments: &[&str]) -> Self {
        Self(start_logged(folder, &folder.join(log), arguments))
    }
}

impl Drop for Program {
    fn drop(&mut self) {
        let _gone = self.0.kill();
        let _status = self.0.wait();
    }
}

#[derive(Debug)]
pub(crate) struct HostProgram {
    folder: PathBuf,
    arguments: Vec<String>,
    program: Option<Program>,
    address: String,
    token: Option<String>,
}

impl HostProgram {
    pub(crate) fn start(test: &str, arguments: &[&str]) -> Self {
        Self::start_scene(test, "springs", arguments)
    }

    pub(crate) fn start_scene(test: &str, scene: &str, arguments: &[&str]) -> Self {
        let listen = format!("127.0.0.1:{}", free_port());
        let usual = ["run", scene, "--midi", "none", "--black-box", "none", "--listen", &listen];
        // It ends by itself if this process is killed.
        let bound =
            if arguments.contains(&"--duration") { &[][..] } else { &["--duration", "600"] };
        let all = usual.iter().chain(bound).chain(arguments);
        let all = all.map(|it| (*it).to_owned()).collect();
        let folder = folder(test);
        let _none = fs::remove_file(folder.join("log"));
        let (program, address, token) = (None, String::new(), None);
        let mut host = Self { folder, arguments: all, program, address, token };
        host.start_again();
        host
    }

    pub(crate) fn kill(&mut self) {
        self.program = None;
    }

    /// Starts a killed host again at its address, with another secret, and waits for its stream.
    pub(crate) fn start_again(&mut self) {
        let arguments: Vec<&str> = self.arguments.iter().map(String::as_str).collect();
        self.program = Some(Program::start(&self.folder, "log", &arguments));
        let begun = Instant::now();
        loop {
            if let Ok(Ok(Reply::Where { address, token })) = self.ask(&Request::Where {}) {
                (self.address, self.token) = (address, token);
                return;
            }
            assert!(begun.elapsed() < PATIENCE, "no stream: {}", self.log());
            std::thread::park_timeout(INTERVAL);
        }
    }

    pub(crate) fn ask(&self, request: &Request) -> Result<Result<Reply, String>, String> {
        send(&self.socket(), request).map_err(|error| error.to_string())
    }

    pub(crate) fn folder(&self) -> &Path {
        &self.folder
    }

    pub(crate) fn socket(&self) -> PathBuf {
        self.folder.join("socket")
    }

    pub(crate) fn target(&self) -> WindowTarget {
        WindowTarget::of(&self.address, self.token.clone(), None)
    }

    pub(crate) fn log(&self) -> String {
        fs::read_to_string(self.folder.join("log")).unwrap_or_default()
    }
}

/// Returns a port that is free now, so that a host listens there again after a restart.
fn free_port() -> u16 {
    let bound = TcpListener::bind("127.0.0.1:0").and_then(|it| it.local_addr());
    bound.expect("a port").port()
}
