//! Takes what arrives off a live source while the window sleeps, and wakes it only for what can
//! be seen: a keyboard that lies still costs no frames.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::mpsc::{Receiver, Sender, SyncSender, channel, sync_channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::Duration;

use telemetry::source::Ticket;
use telemetry::{Arrival, ConnectionState, Request, Source, Topic, Update};

use crate::RepaintWaker;
use crate::store::glance::Glances;

/// At most sixty pictures a second.
const FRAME: Duration = Duration::from_millis(16);

/// How soon what changes all the time, and means little, is worth a frame.
const SELDOM: Duration = Duration::from_secs(5);

/// Arrivals that wait for the window; beyond, the source itself has to wait or to drop.
const WAITING: usize = 1 << 16;

/// What the source's thread is told.
enum SourceCommand {
    Rung,
    Follow(BTreeSet<Topic>),
    Ask(Ticket, Request),
}

/// Rung by a source's own threads when something has arrived.
#[derive(Clone, Debug)]
pub struct Notifier(Sender<SourceCommand>);

impl Notifier {
    /// Something has arrived. False once nobody listens any more.
    pub fn ring(&self) -> bool {
        self.0.send(SourceCommand::Rung).is_ok()
    }
}

/// A live source that lives on a thread of its own.
#[derive(Debug)]
pub struct SourceThread {
    arrivals: Receiver<Arrival>,
    orders: Sender<SourceCommand>,
    standing: Arc<Mutex<ConnectionState>>,
    name: String,
    tickets: u64,
}

impl SourceThread {
    /// Makes a source, which rings the bell that it gets, and takes care of it.
    ///
    /// # Errors
    /// If the source cannot be made.
    pub fn start<E>(
        make: impl FnOnce(Notifier) -> Result<Box<dyn Source + Send>, E>,
        wake: RepaintWaker,
    ) -> Result<Self, E> {
        let (orders, ordered) = channel();
        let source = make(Notifier(orders.clone()))?;
        let (given, arrivals) = sync_channel(WAITING);
        let standing = Arc::new(Mutex::new(source.standing()));
        let name = source.name();
        let worker = Worker {
            source,
            given,
            wake,
            standing: Arc::clone(&standing),
            glances: Glances::default(),
            tickets: BTreeMap::new(),
        };
        thread::spawn(move || worker.run(&ordered));
        Ok(Self { arrivals, orders, standing, name, tickets: 0 })
    }

    fn order(&self, order: SourceCommand) {
        // A thread that has ended says so by its standing.
        let _gone = self.orders.send(order).is_err();
    }
}

impl Source for SourceThread {
    fn next(&mut self) -> Option<Arrival> {
        self.arrivals.try_recv().ok()
    }

    fn follow(&mut self, topics: &BTreeSet<Topic>) {
        self.order(SourceCommand::Follow(topics.clone()));
    }

    fn ask(&mut self, request: Request) -> Ticket {
        self.tickets += 1;
        let ticket = Ticket(self.tickets);
        self.order(SourceCommand::Ask(ticket, request));
        ticket
    }

    fn standing(&self) -> ConnectionState {
        self.standing.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    fn name(&self) -> String {
        self.name.clone()
    }
}

/// The other side of a [`SourceThread`].
struct Worker {
    source: Box<dyn Source + Send>,
    given: SyncSender<Arrival>,
    wake: RepaintWaker,
    standing: Arc<Mutex<ConnectionState>>,
    glances: Glances,
    /// The window's ticket by the source's.
    tickets: BTreeMap<Ticket, Ticket>,
}

impl Worker {
    fn run(mut self, orders: &Receiver<SourceCommand>) {
        while let Ok(order) = orders.recv() {
            match order {
                SourceCommand::Rung => {}
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

    /// Hands on what has arrived; nothing once the window is gone.
    fn pass_on(&mut self) -> Option<()> {
        let mut soon = None;
        while let Some(arrival) = self.source.next() {
            let arrival = self.with_ticket(arrival);
            let worth = if self.is_seen(&arrival) { FRAME } else { SELDOM };
            soon = Some(soon.map_or(worth, |it: Duration| it.min(worth)));
            self.given.send(arrival).ok()?;
        }
        let standing = self.source.standing();
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

    /// Whether more than the time changes.
    fn is_seen(&mut self, arrival: &Arrival) -> bool {
        let Arrival::Update { update, .. } = arrival else { return true };
        match &**update {
            Update::Overview(it) => {
                let is_new = !self.glances.shows(it);
                self.glances.take(it);
                is_new
            }
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

    use telemetry::Reply;

    use super::*;
    use crate::WallClock;
    use crate::demo::Demo;

    /// How soon each wake wanted a frame.
    type Wakes = Receiver<Duration>;

    fn pump(hand: &Arc<AtomicU64>) -> (SourceThread, Notifier, Wakes) {
        let clock: WallClock = {
            let hand = Arc::clone(hand);
            Arc::new(move || hand.load(Ordering::Relaxed))
        };
        let (woken, wakes) = channel();
        let wake: RepaintWaker = Arc::new(move |soon| {
            let _gone = woken.send(soon).is_err();
        });
        let mut bell = None;
        let make = |given: Notifier| -> Result<Box<dyn Source + Send>, String> {
            bell = Some(given);
            Ok(Box::new(Demo::live(clock)))
        };
        let pump = SourceThread::start(make, wake).expect("a demonstration");
        (pump, bell.expect("a bell"), wakes)
    }

    /// Goes to `seconds`, rings, and says how soon a frame was wanted.
    fn at(seconds: f64, hand: &AtomicU64, bell: &Notifier, wakes: &Wakes) -> Duration {
        hand.store(crate::number::floor(seconds * 1e9), Ordering::Relaxed);
        assert!(bell.ring());
        wakes.recv_timeout(Duration::from_secs(20)).expect("a wake")
    }

    #[test]
    fn a_keyboard_that_lies_still_costs_no_frames() {
        let hand = Arc::new(AtomicU64::new(0));
        let (mut pump, bell, wakes) = pump(&hand);
        assert_eq!(at(0.1, &hand, &bell, &wakes), FRAME, "the catalogue is new");
        assert_eq!(at(0.2, &hand, &bell, &wakes), SELDOM, "nothing moves yet");
        assert_eq!(at(0.4, &hand, &bell, &wakes), FRAME, "the first key goes down");
        assert!(matches!(pump.next(), Some(Arrival::Update { .. })));
    }

    #[test]
    fn an_answer_comes_back_under_the_window_s_own_ticket() {
        let hand = Arc::new(AtomicU64::new(0));
        let (mut pump, _bell, wakes) = pump(&hand);
        let tickets = [pump.ask(Request::Scene {}), pump.ask(Request::Stop {})];
        let mut replies = Vec::new();
        while replies.len() < 2 {
            let _soon = wakes.recv_timeout(Duration::from_secs(20)).expect("a wake");
            let arrivals = std::iter::from_fn(|| pump.next());
            replies.extend(arrivals.filter_map(|arrival| match arrival {
                Arrival::Reply { ticket, result } => Some((ticket, result.expect("done"))),
                Arrival::Update { .. } | Arrival::Anew => None,
            }));
        }
        assert_eq!([replies[0].0, replies[1].0], tickets);
        assert!(matches!(replies[0].1, Reply::Scene { .. }));
    }

    #[test]
    fn the_thread_ends_with_the_window() {
        let hand = Arc::new(AtomicU64::new(0));
        let (pump, bell, wakes) = pump(&hand);
        drop(pump);
        while bell.ring() {
            thread::yield_now();
        }
        drop(wakes);
    }
}
