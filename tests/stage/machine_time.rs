//! Tests that need this machine's time, and whether they got it.
//!
//! Linux counts the waits of each runnable thread for a processor in
//! `/proc/<process>/task/<thread>/schedstat`. A [`WaitWatch`] measures the longest wait of the
//! threads and processes of one test, and of the kernel's workers, which move the bytes of
//! pseudo-terminals: a thread that needs these bytes sleeps meanwhile.
#![allow(dead_code, reason = "each test program uses its own part")]

use std::collections::BTreeMap;
use std::fs;
use std::io::Write as _;
use std::ops::{Deref, DerefMut};
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// Wait from which on a test had no time: half of the 20 ms after which boards drop their forces.
const TOO_LONG: Duration = Duration::from_millis(10);

const LOOK: Duration = Duration::from_millis(10);

const LOOKS_PER_SCAN: u32 = 50;

/// Looks over which stolen time is added up: a count of ticks of 10 ms says nothing of one look.
const LOOKS_PER_THEFT: u32 = 10;

/// Longest time until the kernel counts what a running thread has run.
const TICK: Duration = Duration::from_millis(10);

const ATTEMPTS: u32 = 3;

pub(crate) fn say(line: &str) {
    let _closed = writeln!(std::io::stderr(), "{line}");
}

/// Calls `attempt` until it returns a result, which it does if the machine had time. Prints
/// `SKIPPED` with `what` if no attempt does.
pub(crate) fn judged<T>(what: &str, mut attempt: impl FnMut() -> Option<T>) -> Option<T> {
    let judged = (0..ATTEMPTS).find_map(|_| attempt());
    if judged.is_none() {
        say(&format!("SKIPPED: {what}: this machine was too busy, three times"));
    }
    judged
}

/// Like [`judged`], but also attempts again if `attempt` panics while a thread that it watches
/// waited too long. A panic on a machine that had time is a failure.
pub(crate) fn judged_with_time<T>(
    what: &str,
    attempt: impl Fn(&WaitWatch) -> Option<T>,
) -> Option<T> {
    judged(what, || {
        let watch = WaitWatch::start();
        let outcome = catch_unwind(AssertUnwindSafe(|| attempt(&watch)));
        let waited = watch.stop();
        outcome.unwrap_or_else(|panic| {
            if waited < TOO_LONG {
                resume_unwind(panic);
            }
            say(&format!("{what}: not judged, a thread waited {waited:.0?} for a processor"));
            None
        })
    })
}

pub(crate) fn with_time(what: &str, test: impl Fn(&WaitWatch)) {
    judged_with_time(what, |watch| {
        test(watch);
        Some(())
    });
}

#[derive(Clone, Debug)]
pub(crate) enum Task {
    Thread(PathBuf),
    Process(PathBuf),
}

impl Task {
    pub(crate) fn this_thread() -> Self {
        let own = fs::read_link("/proc/thread-self").unwrap_or_default();
        Self::Thread(Path::new("/proc").join(own))
    }

    pub(crate) fn process(child: &Child) -> Self {
        Self::Process(format!("/proc/{}/task", child.id()).into())
    }

    fn threads(&self) -> Vec<PathBuf> {
        match self {
            Self::Thread(thread) => vec![thread.clone()],
            Self::Process(process) => {
                let threads = fs::read_dir(process).into_iter().flatten().flatten();
                threads.map(|thread| thread.path()).collect()
            }
        }
    }
}

#[derive(Debug)]
pub(crate) struct WaitWatch {
    tasks: Sender<Task>,
    thread: JoinHandle<Duration>,
}

impl WaitWatch {
    fn start() -> Self {
        let (tasks, added) = channel();
        Self { tasks, thread: std::thread::spawn(move || longest_wait(&added)) }
    }

    pub(crate) fn add(&self, task: Task) {
        let _ended = self.tasks.send(task);
    }

    /// Watches a process that an attempt starts, and that does not outlive the attempt.
    pub(crate) fn guard(&self, child: Child) -> Guarded {
        self.add(Task::process(&child));
        Guarded(Some(child))
    }

    pub(crate) fn output(&self, command: &mut Command) -> std::io::Result<Output> {
        self.guard(command.spawn()?).into_child().wait_with_output()
    }

    fn stop(self) -> Duration {
        drop(self.tasks);
        self.thread.join().unwrap_or(Duration::MAX)
    }
}

#[derive(Debug)]
pub(crate) struct Guarded(Option<Child>);

impl Guarded {
    pub(crate) fn into_child(mut self) -> Child {
        self.0.take().expect("a process")
    }
}

impl Deref for Guarded {
    type Target = Child;

    fn deref(&self) -> &Child {
        self.0.as_ref().expect("a process")
    }
}

impl DerefMut for Guarded {
    fn deref_mut(&mut self) -> &mut Child {
        self.0.as_mut().expect("a process")
    }
}

impl Drop for Guarded {
    fn drop(&mut self) {
        if let Some(child) = &mut self.0 {
            let _ended = child.kill();
            let _status = child.wait();
        }
    }
}

fn longest_wait(added: &Receiver<Task>) -> Duration {
    let (mut tasks, mut workers, mut threads) = (Vec::new(), Vec::new(), BTreeMap::new());
    let mut longest = Duration::ZERO;
    let mut stolen = stolen_time();
    for n in 0.. {
        let due = Instant::now() + LOOK;
        let is_over = receive_until(due, added, &mut tasks);
        // A hypervisor delays this thread too, and no thread's count contains that.
        longest = longest.max(Instant::now().saturating_duration_since(due));
        if n % LOOKS_PER_SCAN == 0 {
            workers = kernel_workers();
        }
        if n % LOOKS_PER_THEFT == 0 {
            let now = stolen_time();
            let thefts = now.iter().zip(&stolen).map(|(now, last)| now.saturating_sub(*last));
            longest = longest.max(thefts.max().unwrap_or_default().saturating_sub(TICK));
            stolen = now;
        }
        for thread in tasks.iter().flat_map(Task::threads).chain(workers.iter().cloned()) {
            let Some(look) = ThreadLook::new(&thread) else { continue };
            let last = threads.entry(thread).or_insert(look);
            longest = longest.max(look.waited_since(last));
            if !look.waits_since(last) {
                *last = look;
            }
        }
        if is_over {
            break;
        }
    }
    longest
}

fn receive_until(due: Instant, added: &Receiver<Task>, tasks: &mut Vec<Task>) -> bool {
    loop {
        match added.recv_timeout(due.saturating_duration_since(Instant::now())) {
            Ok(task) => tasks.push(task),
            Err(RecvTimeoutError::Timeout) => return false,
            Err(RecvTimeoutError::Disconnected) => return true,
        }
    }
}

/// Time that a hypervisor gave to others, of each processor: no thread's count contains it.
fn stolen_time() -> Vec<Duration> {
    let stat = fs::read_to_string("/proc/stat").unwrap_or_default();
    let processors =
        stat.lines().filter(|line| line.starts_with("cpu") && !line.starts_with("cpu "));
    let stolen = |line: &str| line.split_whitespace().nth(8)?.parse().ok();
    processors.map(|line| TICK * stolen(line).unwrap_or(0)).collect()
}

fn kernel_workers() -> Vec<PathBuf> {
    let is_worker = |process: &PathBuf| {
        fs::read(process.join("comm")).is_ok_and(|name| name.starts_with(b"kworker/u"))
    };
    let processes = fs::read_dir("/proc").into_iter().flatten().flatten();
    processes.map(|process| process.path()).filter(is_worker).collect()
}

#[derive(Clone, Copy, Debug)]
struct ThreadLook {
    at: Instant,
    can_run: bool,
    run: Duration,
    waited: Duration,
}

impl ThreadLook {
    fn new(thread: &Path) -> Option<Self> {
        let at = Instant::now();
        let counts = fs::read_to_string(thread.join("schedstat")).ok()?;
        let mut counts = counts.split(' ').map(|it| it.parse().ok().map(Duration::from_nanos));
        let (run, waited) = (counts.next()??, counts.next()??);
        let stat = fs::read_to_string(thread.join("stat")).ok()?;
        // The name of the thread is in parentheses and may contain some.
        let can_run = stat.rsplit_once(") ")?.1.starts_with('R');
        Some(Self { at, can_run, run, waited })
    }

    fn waits_since(&self, last: &Self) -> bool {
        self.can_run && (self.run, self.waited) == (last.run, last.waited)
    }

    fn waited_since(&self, last: &Self) -> Duration {
        if self.waits_since(last) {
            return self.at.duration_since(last.at).saturating_sub(TICK);
        }
        self.waited.saturating_sub(last.waited)
    }
}

#[test]
fn a_wait_is_measured_when_it_is_over_and_before() {
    let at = Instant::now();
    let ms = Duration::from_millis;
    let before = ThreadLook { at, can_run: true, run: ms(5), waited: ms(1) };
    let waits = ThreadLook { at: at + ms(60), ..before };
    assert_eq!((waits.waited_since(&before), waits.waits_since(&before)), (ms(50), true));
    let runs = ThreadLook { at: at + ms(70), run: ms(6), waited: ms(66), ..before };
    assert_eq!((runs.waited_since(&before), runs.waits_since(&before)), (ms(65), false));
    let sleeps = ThreadLook { at: at + ms(60), can_run: false, ..before };
    assert_eq!((sleeps.waited_since(&before), sleeps.waits_since(&before)), (ms(0), false));
}
