//! Receives from a live source while the window sleeps, and wakes it only for visible changes.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::mpsc::{Receiver, Sender, SyncSender, channel, sync_channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::{thread, time::Duration};

use telemetry::source::Ticket;
use telemetry::stream::Role;
use telemetry::{Arrival, ConnectionState, Request, Source, Status, Topic, Update};

use crate::{RepaintWaker, store::key_summary::KeySummaries};

/// Shortest time between two frames.
const FRAME: Duration = Duration::from_millis(16);

/// Longest delay of a frame for values that change all the time and matter little.
const SELDOM: Duration = Duration::from_secs(5);

/// Most arrivals that wait for the window; beyond, the source waits or drops.
const WAITING: usize = 1 << 16;

enum SourceCommand {
    Arrived,
    Follow(BTreeSet<Topic>),
    Ask(Ticket, Request),
}

/// Notifies the source's thread of an arrival.
#[derive(Clone, Debug)]
pub struct Notifier(Sender<SourceCommand>);

impl Notifier {
    /// Reports an arrival; returns `false` once the window is closed.
    pub fn notify(&self) -> bool {
        self.0.send(SourceCommand::Arrived).is_ok()
    }
}

/// A live source on its own thread.
#[derive(Debug)]
pub struct SourceThread {
    arrivals: Receiver<Arrival>,
    commands: Sender<SourceCommand>,
    standing: Arc<Mutex<(ConnectionState, Option<Role>)>>,
    name: String,
    tickets: u64,
}

impl SourceThread {
    /// Runs the source that `make` returns; the source calls the notifier for each arrival.
    pub fn start<E>(
        make: impl FnOnce(Notifier) -> Result<Box<dyn Source + Send>, E>,
        wake: RepaintWaker,
    ) -> Result<Self, E> {
        let (commands, received) = channel();
        let source = make(Notifier(commands.clone()))?;
        let (given, arrivals) = sync_channel(WAITING);
        let standing = Arc::new(Mutex::new((source.standing(), source.role())));
        let name = source.name();
        let worker = Worker {
            source,
            given,
            wake,
            standing: Arc::clone(&standing),
            summaries: KeySummaries::default(),
            status: None,
            tickets: BTreeMap::new(),
        };
        thread::spawn(move || worker.run(&received));
        Ok(Self { arrivals, commands, standing, name, tickets: 0 })
    }

    fn command(&self, command: SourceCommand) {
        // The standing reports a thread that has ended.
        let _gone = self.commands.send(command).is_err();
    }
}

impl Source for SourceThread {
    fn next(&mut self) -> Option<Arrival> {
        self.arrivals.try_recv().ok()
    }

    fn follow(&mut self, topics: &BTreeSet<Topic>) {
        self.command(SourceCommand::Follow(topics.clone()));
    }

    fn ask(&mut self, request: Request) -> Ticket {
        self.tickets += 1;
        let ticket = Ticket(self.tickets);
        self.command(SourceCommand::Ask(ticket, request));
        ticket
    }

    fn standing(&self) -> ConnectionState {
        self.standing.lock().unwrap_or_else(PoisonError::into_inner).0.clone()
    }

    fn role(&self) -> Option<Role> {
        self.standing.lock().unwrap_or_else(PoisonError::into_inner).1
    }

    fn name(&self) -> String {
        self.name.clone()
    }
}

struct Worker {
    source: Box<dyn Source + Send>,
    given: SyncSender<Arrival>,
    wake: RepaintWaker,
    standing: Arc<Mutex<(ConnectionState, Option<Role>)>>,
    summaries: KeySummaries,
    /// The last status, which a host repeats.
    status: Option<Status>,
    tickets: BTreeMap<Ticket, Ticket>,
}

impl Worker {
    fn run(mut self, commands: &Receiver<SourceCommand>) {
        while let Ok(command) = commands.recv() {
            match command {
                SourceCommand::Arrived => {}
                SourceCommand::Follow(topics) => self.source.follow(&topics),
                SourceCommand::Ask(ticket, request) => {
                    let own = self.source.ask(request);
                    self.tickets.insert(own, ticket);
                }
            }
            if self.pass_on().is_none() {
                break;
            }
        }
    }

    /// Forwards the arrivals; returns `None` once the window is closed.
    fn pass_on(&mut self) -> Option<()> {
        let mut soon = None;
        while let Some(arrival) = self.source.next() {
            let arrival = self.with_ticket(arrival);
            let worth = if self.is_seen(&arrival) { FRAME } else { SELDOM };
            soon = Some(soon.map_or(worth, |it: Duration| it.min(worth)));
            self.given.send(arrival).ok()?;
        }
        let standing = (self.source.standing(), self.source.role());
        let mut told = self.standing.lock().unwrap_or_else(PoisonError::into_inner);
        if *told != standing {
            *told = standing;
            soon = Some(FRAME);
        }
        drop(told);
        if let Some(soon) = soon {
            (self.wake)(soon);
        }
        Some(())
    }

    fn with_ticket(&mut self, arrival: Arrival) -> Arrival {
        match arrival {
            Arrival::Reply { ticket, result } => {
                let ticket = self.tickets.remove(&ticket).unwrap_or(ticket);
                Arrival::Reply { ticket, result }
            }
            Arrival::Update { .. } | Arrival::Anew => arrival,
        }
    }

    fn is_seen(&mut self, arrival: &Arrival) -> bool {
        let Arrival::Update { update, .. } = arrival else { return true };
        match &**update {
            Update::Overview(it) => {
                let is_new = !self.summaries.shows(it);
                self.summaries.take(it);
                is_new
            }
            Update::Status(it) => self.status.replace(it.clone()).as_ref() != Some(it),
            Update::Ticks(_) | Update::Deadlines(_) | Update::Links(_) => false,
            Update::Catalogue(_)
            | Update::Voice(_)
            | Update::Block(_)
            | Update::State(..)
            | Update::Event(_)
            | Update::Midi(_)
            | Update::Log(_) => true,
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicU64, Ordering};

    use super::*;
    use crate::demonstration;

    type Wakes = Receiver<Duration>;

    fn start(time: &Arc<AtomicU64>) -> (SourceThread, Notifier, Wakes) {
        let clock = {
            let time = Arc::clone(time);
            Box::new(move || time.load(Ordering::Relaxed) as f64 * 1e-9)
        };
        let (woken, wakes) = channel();
        let wake: RepaintWaker = Arc::new(move |soon| {
            let _gone = woken.send(soon).is_err();
        });
        let mut notifier = None;
        let make = |given: Notifier| -> Result<Box<dyn Source + Send>, String> {
            notifier = Some(given);
            Ok(Box::new(demonstration(clock).map_err(|error| error.to_string())?))
        };
        let thread = SourceThread::start(make, wake).expect("a recorded take");
        (thread, notifier.expect("a notifier"), wakes)
    }

    fn at(seconds: f64, time: &AtomicU64, notifier: &Notifier, wakes: &Wakes) -> Duration {
        time.store(crate::number::floor(seconds * 1e9), Ordering::Relaxed);
        assert!(notifier.notify());
        wakes.recv_timeout(Duration::from_secs(20)).expect("a wake")
    }

    #[test]
    fn a_keyboard_that_lies_still_costs_no_frames() {
        let time = Arc::new(AtomicU64::new(0));
        let (mut thread, notifier, wakes) = start(&time);
        assert_eq!(at(0.1, &time, &notifier, &wakes), FRAME, "the catalogue is new");
        thread.follow(&BTreeSet::from(Topic::COMMON));
        let _soon = wakes.recv_timeout(Duration::from_secs(20)).expect("a wake");
        assert_eq!(at(0.5, &time, &notifier, &wakes), FRAME, "keys come to rest");
        assert_eq!(at(0.9, &time, &notifier, &wakes), SELDOM, "nothing moves yet");
        assert_eq!(at(1.3, &time, &notifier, &wakes), FRAME, "the first key goes down");
        assert_eq!(thread.next(), Some(Arrival::Anew));
        assert!(matches!(thread.next(), Some(Arrival::Update { .. })));
    }

    #[test]
    fn an_answer_comes_back_under_the_window_s_own_ticket() {
        let time = Arc::new(AtomicU64::new(0));
        let (mut thread, _notifier, wakes) = start(&time);
        let tickets = [thread.ask(Request::Scene {}), thread.ask(Request::Stop {})];
        let mut replies = Vec::new();
        while replies.len() < 2 {
            let _soon = wakes.recv_timeout(Duration::from_secs(20)).expect("a wake");
            let arrivals = std::iter::from_fn(|| thread.next());
            replies.extend(arrivals.filter_map(|arrival| match arrival {
                Arrival::Reply { ticket, result } => Some((ticket, result)),
                Arrival::Update { .. } | Arrival::Anew => None,
            }));
        }
        assert_eq!([replies[0].0, replies[1].0], tickets);
        assert!(replies.iter().all(|(_, result)| result.is_err()), "a take cannot be changed");
    }

    #[test]
    fn the_thread_ends_with_the_window() {
        let time = Arc::new(AtomicU64::new(0));
        let (thread, notifier, wakes) = start(&time);
        drop(thread);
        while notifier.notify() {
            thread::yield_now();
        }
        drop(wakes);
    }
}
