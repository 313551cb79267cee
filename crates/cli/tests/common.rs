//! Common parts of tests of hosts: an end to each, and simulated boards behind pseudo-terminals.

use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::sync_channel;
use std::thread::JoinHandle;

use boards::identity::Uid;
use boards::sim::board::BoardMake;
use firmware_protocol::key::BoardId;
use haptics::RigParameters;
use host::control::{Folders, RequestHandler};
use host::report::RunReport;
use host::session::{RunOptions, RunSession};
use host::simulated::{BoardProcess, WireEndpoint, place, run as run_boards};
use scene::{Library, Scene};
use scheduler::time::Nanos;
use tokio::runtime::{Builder, Runtime};

use crate::machine_time::{Task, WaitWatch};

const LOOK: Nanos = Nanos::from_millis(10);

pub(crate) struct Board {
    pub(crate) port: PathBuf,
    pub(crate) uid: Uid,
    stop: Arc<AtomicBool>,
    is_armed: Arc<AtomicBool>,
    thread: Option<JoinHandle<BoardProcess>>,
}

impl Board {
    /// Starts a board of this make, on a watched thread.
    pub(crate) fn start(make: BoardMake, watch: &WaitWatch) -> Self {
        let placed = place(make.id, &WireEndpoint::Pty).expect("a pseudo-terminal");
        let port = placed.address.place.clone().into();
        let mut living =
            BoardProcess::new(make, placed, 0.0, Vec::new()).expect("a possible board");
        let stop = Arc::new(AtomicBool::new(false));
        let is_armed = Arc::new(AtomicBool::new(false));
        let (its_stop, its_armed) = (Arc::clone(&stop), Arc::clone(&is_armed));
        let look = move |living: &mut BoardProcess| {
            run_boards(std::slice::from_mut(living), Some(LOOK), &its_stop, &mut |_lit| {});
            its_armed.store(!living.board.is_safe(), Ordering::Release);
            !its_stop.load(Ordering::Acquire)
        };
        let (tells, task) = sync_channel(1);
        let thread = std::thread::spawn(move || {
            let _waits = tells.send(Task::this_thread());
            while look(&mut living) {}
            living
        });
        watch.add(task.recv().expect("a thread"));
        Self { port, uid: Uid(make.uid()), stop, is_armed, thread: Some(thread) }
    }

    /// Returns `true` while the board renders forces.
    pub(crate) fn is_armed(&self) -> bool {
        self.is_armed.load(Ordering::Acquire)
    }

    pub(crate) fn link(&self) -> String {
        format!("serial:{}", self.port.display())
    }

    pub(crate) fn stop(mut self) -> BoardProcess {
        self.stop.store(true, Ordering::Release);
        self.thread.take().expect("it lives").join().expect("it lives well")
    }
}

impl Drop for Board {
    fn drop(&mut self) {
        self.stop.store(true, Ordering::Release);
    }
}

pub(crate) fn make(number: u8, n_keys: usize) -> BoardMake {
    let id = BoardId::new(number).expect("a board");
    BoardMake { n_keys, ..BoardMake::standard(id, 100e-6, RigParameters::default()) }
}

/// Returns a scene of the program with these values.
pub(crate) fn scene(name: &str, values: &[(&str, &str)]) -> Scene {
    let values: Vec<_> = values.iter().map(|it| (it.0.to_owned(), it.1.to_owned())).collect();
    Scene::load(&Library::default(), name, &values).unwrap_or_else(|it| unreachable!("{it}"))
}

pub(crate) const SILENT: (&str, &str) = ("pianist.performance", "none");

pub(crate) fn session(scene: &Scene) -> RunSession {
    RunSession::prepare(scene, RunOptions::default(), &|_| {}).expect("a session")
}

/// Returns an idle host of "springs", the handler of its requests, and a runtime for both.
pub(crate) fn idle_host() -> (RunSession, Arc<RequestHandler>, Runtime) {
    let scene = scene("springs", &[SILENT]);
    let session = session(&scene);
    let requests = Arc::new(RequestHandler::new(scene, session.handle(), Folders::default()));
    let runtime = Builder::new_multi_thread().worker_threads(1).enable_all().build();
    (session, requests, runtime.expect("a runtime"))
}

pub(crate) fn run_while(session: RunSession, look: impl FnOnce()) -> RunReport {
    let stop = AtomicBool::new(false);
    std::thread::scope(|scope| {
        let host = scope.spawn(|| session.run(&stop));
        let stops = Stop(&stop);
        look();
        drop(stops);
        host.join().expect("no panic").expect("a report")
    })
}

struct Stop<'a>(&'a AtomicBool);

impl Drop for Stop<'_> {
    fn drop(&mut self) {
        self.0.store(true, Ordering::Release);
    }
}
