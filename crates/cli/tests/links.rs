//! The messages about lines and boards while a host runs, and the light of a board.

use std::sync::mpsc::{Receiver, Sender, channel};
use std::time::{Duration, Instant};

use boards::links::address::Address;
use host::control::RunHandle;
use host::observe::MessageSink;
use scene::{Override, Scene, link_overrides};
use telemetry::event::Kind;
use telemetry::{Links, Topic, Update};

use crate::common::{Board, make, run_while, session};
use crate::machine_time::{WaitWatch, with_time};

/// Maximum wait, for any machine: it only ends failed tests.
const PATIENCE: Duration = Duration::from_mins(1);

struct Ear(Sender<Update>);

impl MessageSink for Ear {
    fn take(&mut self, _at: u64, update: &Update) {
        let _gone = self.0.send(update.clone());
    }

    fn wants(&self, topic: Topic) -> bool {
        matches!(topic, Topic::Links | Topic::Events)
    }
}

/// Runs an idle host on these links, or on simulated keys if there are none.
fn beside_a_host(links: &[String], look: impl FnOnce(&RunHandle, &Receiver<Update>)) {
    let parsed: Vec<_> = links.iter().map(|it| Address::parse(it).expect("a link")).collect();
    let silent = Override::from(("pianist.performance".to_owned(), "none".to_owned()));
    let overrides: Vec<_> = link_overrides(&parsed).into_iter().chain([silent]).collect();
    let scene =
        Scene::load_as_typed(&scene::Library::default(), "springs", &overrides).expect("a scene");
    let session = session(&scene);
    let handle = session.handle();
    let (tell, told) = channel();
    session.observe(Box::new(Ear(tell)));
    run_while(session, || look(&handle, &told));
}

/// Returns the first result that `find` has for a message.
fn first<T>(told: &Receiver<Update>, mut find: impl FnMut(Update) -> Option<T>) -> T {
    let end = Instant::now() + PATIENCE;
    loop {
        // Other messages keep coming, so that the wait for one of them is no limit.
        let left = end.saturating_duration_since(Instant::now());
        let update = told.recv_timeout(left).expect("the message in time");
        if let Some(found) = find(update) {
            return found;
        }
    }
}

/// Returns the next message about links for which `is_it` holds.
fn links(told: &Receiver<Update>, is_it: impl Fn(&Links) -> bool) -> Links {
    first(told, |update| {
        if let Update::Links(it) = update { Some(it) } else { None }.filter(&is_it)
    })
}

/// Waits for these messages about boards and lines, in any order.
fn told_all(told: &Receiver<Update>, mut sentences: Vec<String>) {
    first(told, |update| {
        if let Update::Event(it) = update
            && it.kind() == Kind::Board
        {
            sentences.retain(|sentence| *sentence != it.text);
        }
        sentences.is_empty().then_some(())
    });
}

#[test]
fn boards_are_seen_show_their_light_and_are_missed_when_they_die() {
    with_time("what is seen of two boards", check_boards);
}

fn check_boards(watch: &WaitWatch) {
    let boards = [3, 4].map(|number| Board::start(make(number, 11), watch));
    let addresses = boards.each_ref().map(Board::link);
    let [three, four] = boards;
    beside_a_host(&addresses, |handle, told| {
        let is_well = |it: &telemetry::Board| it.state == "armed" && 0.0 < it.round_trip;
        let seen = links(told, |it| it.boards.iter().all(is_well));
        let both = seen.lines.iter().zip(&seen.boards).zip(&addresses);
        for (n, ((line, board), address)) in (0..).zip(both) {
            assert!(address.ends_with(&line.name), "{line:?}");
            assert_eq!(line.state, "active");
            assert!(line.planned.is_nan(), "a pseudo-terminal has no load: {line:?}");
            let place = (board.line, board.id, board.first_key, board.keys);
            assert_eq!(place, (n, 3 + n, 33 + 11 * n, 11));
            assert!(0 < board.samples && 0 < board.armings, "{board:?}");
        }
        let refused = handle.identify(0, 4).expect_err("it is on the other link");
        assert!(refused.contains("but board 3"), "{refused}");
        handle.identify(1, 4).expect("it is there");
        let before = seen.boards[1].samples;
        links(told, |it| before + 1_500 < it.boards[1].samples && is_well(&it.boards[1]));

        // What becomes of a board is told; a busy machine may tell of the other one too.
        assert_eq!((three.stop().lights, handle.emergency.is_asked()), (0, false));
        let port = &seen.lines[0].name;
        told_all(told, vec![format!("{port} is down now"), format!("board 3 on {port}: silent")]);
        links(told, |it| it.boards[0].state == "silent" && is_well(&it.boards[1]));
    });
    assert_eq!(four.stop().lights, 1);
}

#[test]
fn simulated_boards_are_seen_and_have_no_lights() {
    beside_a_host(&[], |handle, told| {
        let seen = links(told, |it| it.boards.iter().all(|board| 500 < board.samples));
        assert_eq!((seen.lines.len(), seen.boards.len()), (8, 8));
        assert_eq!(seen.boards.iter().map(|it| it.keys).sum::<u32>(), 88);
        let refused = handle.identify(0, 0).expect_err("nothing to be lit");
        assert!(refused.contains("simulated"), "{refused}");
    });
}
