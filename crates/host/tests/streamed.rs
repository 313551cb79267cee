//! A host and a client of its stream: seen, tuned, pressed.

#![expect(clippy::expect_used, reason = "helpers of tests")]

use std::collections::BTreeSet;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use host::config::Scene;
use host::control::{StreamSink, Studio, Switchboard};
use host::session::{Options, Session};
use telemetry::request::Change;
use telemetry::stream::{Client, Dial, Server, Settings, serve};
use telemetry::{Arrival, Request, Source as _, Topic, Update, event};

/// Long enough for any machine: it only ends what has failed.
const PATIENCE: Duration = Duration::from_mins(1);

/// Runs a host on simulated keys that nobody plays, and a client of its stream.
fn beside_a_host(client: impl FnOnce(&mut Client)) {
    let silent = [("pianist.performance".to_owned(), "none".to_owned())];
    let scene = Scene::load("default", &silent).expect("the default scene");
    let session = Session::prepare(&scene, Options::default(), &|_| {}).expect("a session");
    let switchboard = Arc::new(Switchboard::new(scene, session.patchbay()));
    let runtime = tokio::runtime::Builder::new_multi_thread()
        .worker_threads(1)
        .enable_all()
        .build()
        .expect("a runtime");
    let address = std::net::SocketAddr::from(([127, 0, 0, 1], 0));
    let server = {
        let _inside = runtime.enter();
        Server::listen(Settings { address, ..Settings::default() }).expect("a port")
    };
    let dial = Dial { address: server.url(), ..Dial::default() };
    session.observe(Box::new(StreamSink(server.publisher())));
    runtime.spawn(serve(server, Arc::new(Studio(switchboard))));
    let stop = AtomicBool::new(false);
    std::thread::scope(|scope| {
        let host = scope.spawn(|| session.run(&stop));
        client(&mut Client::connect(dial, None));
        stop.store(true, Ordering::Release);
        host.join().expect("no panic").expect("a report");
    });
}

/// Waits for what `wanted` finds.
fn wait<T>(client: &mut Client, mut wanted: impl FnMut(Arrival) -> Option<T>) -> T {
    let end = Instant::now() + PATIENCE;
    while Instant::now() < end {
        match client.next() {
            Some(arrival) => {
                if let Some(found) = wanted(arrival) {
                    return found;
                }
            }
            None => std::thread::yield_now(),
        }
    }
    unreachable!("nothing came")
}

fn update(arrival: Arrival) -> Option<Update> {
    if let Arrival::Update { update, .. } = arrival { Some(*update) } else { None }
}

#[test]
fn a_client_sees_presses_and_tunes_a_key() {
    beside_a_host(|client| {
        let topics = [Topic::Catalogue, Topic::Voices, Topic::Events, Topic::Overview];
        let topics: BTreeSet<_> = topics.into_iter().chain([Topic::Block(39)]).collect();
        client.follow(&topics);
        let catalogue = wait(client, |arrival| {
            if let Update::Catalogue(it) = update(arrival)? { Some(it) } else { None }
        });
        let model = catalogue.models.iter().find(|it| it.name == "key-hammer-springs");
        let model = model.expect("the model that plays");
        let k2 = model.parameters.iter().position(|it| it.name == "k2").expect("a spring");

        // Pressed hard, the hammer strikes.
        client.ask(Request::Press { key: 39, newtons: 12.0 });
        let strike = wait(client, |arrival| {
            let Update::Event(it) = update(arrival)? else { return None };
            (it.kind() == event::Kind::Strike).then_some(it)
        });
        assert_eq!(strike.key, 39);
        client.ask(Request::Press { key: 39, newtons: 0.0 });

        // A value that is set is what the key is played by, and its rows say so.
        let change = |value| Change { key: 39, parameter: "k2".into(), value };
        let ticket = client.ask(Request::Set { changes: vec![change(20_000.5)] });
        let (mut revision, mut is_answered) = (None, false);
        let deepest = wait(client, |arrival| {
            if let Arrival::Reply { ticket: of, result } = &arrival {
                assert_eq!(result.clone().err(), None);
                is_answered |= *of == ticket;
            }
            let update = update(arrival)?;
            if let Update::Voice(voice) = &update
                && voice.key == 39
                && voice.kept
            {
                assert!((voice.values[k2] - 20_000.5).abs() < f64::EPSILON);
                revision = Some(voice.revision);
            }
            let Update::Block(block) = update else { return None };
            let is_it = is_answered && block.revision.last().copied() == revision;
            block.position.last().copied().filter(|_| is_it)
        });
        assert!(deepest.is_finite());

        // What is no value is refused, and changes nothing.
        let ticket = client.ask(Request::Set { changes: vec![change(-1.0), change(9e99)] });
        let refused = wait(client, |arrival| {
            let Arrival::Reply { ticket: of, result } = arrival else { return None };
            (of == ticket).then_some(result)
        });
        assert!(refused.expect_err("wrong values").contains("k2"));
    });
}
