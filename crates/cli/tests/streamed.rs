//! A host and a client of its stream: overview, tuning, presses.

use std::collections::BTreeSet;
use std::sync::Arc;
use std::time::{Duration, Instant};

use host::control::{RequestHandler, StreamSink};
use telemetry::request::Change;
use telemetry::stream::protocol::{FromClient, FromServer, ParameterValue};
use telemetry::stream::{Client, Dial, ServerSettings, StreamServer, serve};
use telemetry::{Arrival, Request, Source as _, Topic, Update, event};

use crate::common::{idle_host, run_while};
use crate::stranger::Stranger;

/// Maximum wait, for any machine: it only ends failed tests.
const PATIENCE: Duration = Duration::from_mins(1);

/// Runs an idle host, with `clients` who get the stream's address and the request handler.
fn beside_a_host(clients: impl FnOnce(&str, &RequestHandler)) {
    let (session, requests, runtime) = idle_host();
    let address = std::net::SocketAddr::from(([127, 0, 0, 1], 0));
    let server = {
        let _inside = runtime.enter();
        StreamServer::listen(ServerSettings { address, ..ServerSettings::default() })
            .expect("a port")
    };
    let address = server.url();
    session.observe(Box::new(StreamSink::new(server.publisher())));
    runtime.spawn(serve(server, Arc::<RequestHandler>::clone(&requests)));
    run_while(session, || clients(&address, &requests));
}

/// Waits until `wanted` finds its result.
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
    beside_a_host(|address, _requests| {
        let client =
            &mut Client::connect(Dial { address: address.into(), ..Dial::default() }, None);
        let topics = [Topic::Catalogue, Topic::Voices, Topic::Events, Topic::Overview];
        let topics: BTreeSet<_> = topics.into_iter().chain([Topic::Block(39)]).collect();
        client.follow(&topics);
        let catalogue = wait(client, |arrival| {
            if let Update::Catalogue(it) = update(arrival)? { Some(it) } else { None }
        });
        let model = catalogue.models.iter().find(|it| it.name == "key-hammer-springs");
        let model = model.expect("the model that plays");
        let k2 = model.parameters.iter().position(|it| it.name == "k2").expect("a spring");

        client.ask(Request::Press { key: 39, newtons: 12.0 });
        let strike = wait(client, |arrival| {
            let Update::Event(it) = update(arrival)? else { return None };
            (it.kind() == event::Kind::Strike).then_some(it)
        });
        assert_eq!(strike.key, 39);
        client.ask(Request::Press { key: 39, newtons: 0.0 });

        // A set value is used for the key, and its rows report it.
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

        // An invalid value is rejected, and changes nothing.
        let ticket = client.ask(Request::Set { changes: vec![change(-1.0), change(9e99)] });
        let refused = wait(client, |arrival| {
            let Arrival::Reply { ticket: of, result } = arrival else { return None };
            (of == ticket).then_some(result)
        });
        assert!(refused.expect_err("wrong values").contains("k2"));
    });
}

/// Connects a client that follows all parameters.
fn follower(address: &str) -> Stranger {
    let mut follower = Stranger::knock(address, &[]).unwrap_or_else(|it| unreachable!("{it}"));
    let parameter_names = Vec::new();
    follower.say(&FromClient::SubscribeParameterUpdates { parameter_names });
    get(&mut follower, "/key/39/k2");
    follower
}

fn get(client: &mut Stranger, name: &str) -> f64 {
    let parameter_names = vec![name.to_owned()];
    client.say(&FromClient::GetParameters { parameter_names, id: Some("now".into()) });
    let values = client.hear(|message| values(message, Some("now")));
    values.first().expect("the parameter").1
}

/// Returns the values in `message`, if it has this name; updates have none.
fn values(message: FromServer, called: Option<&str>) -> Option<Vec<(String, f64)>> {
    let FromServer::ParameterValues { parameters, id, .. } = message else { return None };
    let value = |it: ParameterValue| (it.name, it.value.as_f64().unwrap_or(f64::NAN));
    (id.as_deref() == called).then(|| parameters.into_iter().map(value).collect())
}

/// Collects the values sent to `client`, up to the `last`.
fn told_until(client: &mut Stranger, last: (&str, f64)) -> Vec<(String, f64)> {
    let mut told = Vec::new();
    while !told.iter().any(|(name, value): &(String, f64)| (name.as_str(), *value) == last) {
        told.extend(client.hear(|message| values(message, None)));
    }
    told
}

/// Asks like the control socket, and repeats until the host runs.
fn ask(requests: &RequestHandler, request: &Request) {
    let end = Instant::now() + PATIENCE;
    while let Err(why) = requests.answer(request, "letoff") {
        assert!(why.contains("not running yet") && Instant::now() < end, "{why}");
        std::thread::yield_now();
    }
}

fn tune(key: u8, parameter: &str, value: f64) -> Request {
    Request::Set { changes: vec![Change { key, parameter: parameter.into(), value }] }
}

#[test]
fn each_change_is_told_once_whoever_made_it() {
    beside_a_host(|address, requests| {
        let (mut one, mut other) = (follower(address), follower(address));
        // The initial values are sent before this.
        ask(requests, &tune(38, "g", 9.5));
        told_until(&mut one, ("/key/38/g", 9.5));
        told_until(&mut other, ("/key/38/g", 9.5));

        // By a client of the stream, who gets an answer beside the broadcast.
        let parameters = vec![ParameterValue::new("/key/39/k2", 20_000.5)];
        one.say(&FromClient::SetParameters { parameters, id: Some("x".into()) });
        for client in [&mut one, &mut other] {
            let told = told_until(client, ("/key/39/k2", 20_000.5));
            assert_eq!(told, [("/key/39/k2".to_owned(), 20_000.5)]);
        }
        // By the control socket: only changed values, and nothing more of key 39.
        ask(requests, &tune(40, "g", 8.5));
        for client in [&mut one, &mut other] {
            let told = told_until(client, ("/key/40/g", 8.5));
            assert_eq!(told, [("/key/40/g".to_owned(), 8.5)]);
        }
        let (instrument, keys) = ("grand-reduced".to_owned(), Some("41".to_owned()));
        ask(requests, &Request::UseInstrument { instrument, keys });
        ask(requests, &tune(42, "g", 8.5));
        let told = told_until(&mut other, ("/key/42/g", 8.5));
        let of_key = |key: &str| told.iter().filter(|(name, _)| name.starts_with(key)).count();
        assert!(0 < of_key("/key/") && of_key("/key/42/") == 1, "{told:?}");
        assert_eq!(of_key("/key/42/") + of_key("/key/20/"), told.len(), "{told:?}");
        assert!((get(&mut one, "/key/39/k2") - 20_000.5).abs() < f64::EPSILON);
    });
}

#[test]
fn a_key_comes_up_when_the_client_that_pressed_it_goes() {
    beside_a_host(|address, _requests| {
        let dial = || Dial { address: address.into(), ..Dial::default() };
        let (mut presses, mut watches) =
            (Client::connect(dial(), None), Client::connect(dial(), None));
        watches.follow(&BTreeSet::from([Topic::Block(39)]));
        wait(&mut watches, update);
        presses.ask(Request::Press { key: 39, newtons: 3.0 });
        let is_at = |arrival, there: &dyn Fn(f64) -> bool| {
            let Update::Block(block) = update(arrival)? else { return None };
            block.position.last().copied().filter(|position| there(*position)).map(drop)
        };
        wait(&mut watches, |arrival| is_at(arrival, &|position| 8e-3 < position));
        drop(presses);
        wait(&mut watches, |arrival| is_at(arrival, &|position| position < 1e-3));
    });
}
