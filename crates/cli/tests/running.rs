//! A host in its own process, until it is dropped.

use std::fs::File;
use std::path::Path;
use std::process::Child;

use host::control::{Reply, Request, STARTING, send};
use rustix::process::{Pid, Signal, kill_process};

use crate::typed::{Folder, eventually};

pub(crate) struct Host<'a> {
    folder: &'a Folder,
    pub(crate) child: Child,
    /// Address of its stream, if any.
    address: Option<String>,
    /// Secret for its own user.
    pub(crate) token: Option<String>,
}

impl<'a> Host<'a> {
    /// Starts an idle host on simulated keys, and waits until it answers.
    pub(crate) fn start(
        folder: &'a Folder,
        arguments: &[&str],
        environment: &[(&str, &str)],
    ) -> Self {
        let listen: &[&str] =
            if arguments.contains(&"--listen") { &[] } else { &["--listen", "127.0.0.1:0"] };
        Self::start_scene(folder, "springs", &[arguments, listen].concat(), environment)
    }

    /// Like [`Self::start`], with another `scene`.
    pub(crate) fn start_scene(
        folder: &'a Folder,
        scene: &str,
        arguments: &[&str],
        environment: &[(&str, &str)],
    ) -> Self {
        let silent = ["--performance", "none", "--midi", "none", "--black-box", "none"];
        let run = [&["run", scene], &silent[..], arguments].concat();
        let mut host = Self::spawn(folder, &run, environment);
        (host.address, host.token) = eventually("a host", || {
            let ended = host.child.try_wait().expect("a process");
            assert!(ended.is_none(), "it ended: {}", folder.read("complaints"));
            match send(&folder.socket(), &Request::Where {}).ok()? {
                Ok(Reply::Where { address, token }) => Some((Some(address), token)),
                Err(why) if why == STARTING => None,
                Err(_no_stream) => Some((None, None)),
                other => unreachable!("{other:?}"),
            }
        });
        host
    }

    /// Starts `letoff` with `arguments`, without waiting.
    pub(crate) fn spawn(
        folder: &'a Folder,
        arguments: &[&str],
        environment: &[(&str, &str)],
    ) -> Self {
        let letoff = Path::new(env!("CARGO_BIN_EXE_letoff"));
        let mut command = folder.command(letoff, arguments);
        command.envs(environment.iter().copied());
        command.stdout(File::create(folder.join("report")).expect("a file"));
        command.stderr(File::create(folder.join("complaints")).expect("a file"));
        Self { folder, child: command.spawn().expect("a process"), address: None, token: None }
    }

    pub(crate) fn address(&self) -> String {
        self.address.clone().expect("a stream")
    }

    /// Returns the scene as it sounds now.
    pub(crate) fn scene(&self) -> String {
        match send(&self.folder.socket(), &Request::Scene {}) {
            Ok(Ok(Reply::Scene { toml })) => toml,
            other => unreachable!("{other:?}"),
        }
    }
}

impl Drop for Host<'_> {
    fn drop(&mut self) {
        if let Ok(None) = self.child.try_wait() {
            signal(&self.child, Signal::CONT);
            signal(&self.child, Signal::TERM);
        }
        let _ended = self.child.wait();
    }
}

pub(crate) fn signal(child: &Child, signal: Signal) {
    let id = i32::try_from(child.id()).ok().and_then(Pid::from_raw).expect("a process");
    kill_process(id, signal).expect("it is there");
}
