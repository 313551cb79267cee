//! Server and client: subscriptions, rights, and slow clients.

use std::net::{Ipv4Addr, SocketAddr};
use std::sync::Arc;

use telemetry::stream::protocol::{
    FromClient, FromServer, Level, ParameterValue, ServerFrame, Subscription, Text as _, channel_id,
};
use telemetry::stream::server::{ServerLimits, Tls, Token};
use telemetry::stream::{
    Backend, Dial, Fingerprint, ParameterSetting, Role, ServerSettings, StreamServer, Who,
};
use telemetry::{Arrival, ConnectionState, Reply, Request, Source as _, Topic, Update};
use tokio_tungstenite::tungstenite::{Error, Message};

use crate::test_server::synthetic::{self, KEY};
use crate::test_server::{RawClient, TestServer, Watcher, eventually, set};

fn done(text: &str) -> Reply {
    Reply::Done { text: text.to_owned() }
}

fn dial(test_server: &TestServer) -> Dial {
    Dial { address: test_server.url.clone(), ..Dial::default() }
}

fn with_token(test_server: &TestServer, token: &str) -> Dial {
    Dial { token: Some(token.to_owned()), ..dial(test_server) }
}

/// Secrets of the least allowed length.
const SEE: &str = "see-0123456789abcdef";
const TUNE: &str = "tune-0123456789abcdef";

fn guarded() -> ServerSettings {
    let token = |secret: &str, role| Token { secret: secret.to_owned(), role };
    ServerSettings {
        tokens: vec![token(SEE, Role::Viewer), token(TUNE, Role::Tuner)],
        origins: vec!["https://app.example".to_owned()],
        ..ServerSettings::default()
    }
}

#[test]
fn whoever_comes_late_gets_the_catalogue_and_the_last_voice_of_every_key() {
    let test_server = TestServer::new();
    test_server.publisher.publish(1, &synthetic::catalogue());
    for (key, revision) in [(39, 1), (39, 2), (40, 3)] {
        test_server.publisher.publish(2, &synthetic::voice(key, revision));
    }
    let mut watcher = test_server.watcher();
    watcher.follow(&[Topic::Catalogue, Topic::Voices]);
    watcher.update(|update| (update == synthetic::catalogue()).then_some(()));
    watcher.update(|update| (update == synthetic::voice(39, 2)).then_some(()));
    watcher.update(|update| (update == synthetic::voice(40, 3)).then_some(()));
    test_server.publisher.publish(3, &synthetic::voice(39, 4));
    let update = watcher.update(Some);
    assert_eq!(update, synthetic::voice(39, 4));
}

#[test]
fn a_voice_comes_before_the_rows_that_name_it() {
    let test_server = TestServer::new();
    let mut watcher = test_server.watcher();
    watcher.follow(&[Topic::Voices, Topic::Block(KEY)]);
    eventually("both are followed", || {
        test_server.publisher.is_followed(Topic::Voices)
            && test_server.publisher.is_followed(Topic::Block(KEY))
    });
    for revision in 1..=100 {
        test_server.publisher.publish(1, &synthetic::voice(39, revision));
        test_server.publisher.publish(1, &synthetic::block(revision.into(), 1));
    }
    for revision in 1..=100 {
        assert_eq!(watcher.update(Some), synthetic::voice(39, revision));
        assert_eq!(watcher.update(Some), synthetic::block(revision.into(), 1));
    }
}

#[test]
fn only_what_is_followed_is_asked_for() {
    let test_server = TestServer::new();
    assert!(!test_server.publisher.is_followed(Topic::Block(KEY)));
    let mut watcher = test_server.watcher();
    watcher.follow(&[Topic::Block(KEY), Topic::State(40), Topic::Events]);
    eventually("two keys are followed", || {
        test_server.publisher.followed_blocks() == 1 << 39 | 1 << 40
    });
    test_server.publisher.publish(5, &synthetic::overview(1, 1));
    test_server.publisher.publish(6, &synthetic::block(100, 33));
    let arrival = watcher.next();
    assert_eq!(arrival, Arrival::Update { at: 6, update: Box::new(synthetic::block(100, 33)) });
    watcher.follow(&[Topic::Block(KEY)]);
    eventually("one key is followed", || test_server.publisher.followed_blocks() == 1 << 39);
    drop(watcher);
    eventually("nobody follows", || test_server.publisher.followed_blocks() == 0);
}

#[test]
fn a_set_is_acknowledged_and_seen_by_others() {
    let test_server = TestServer::new();
    let mut other = test_server.raw_client();
    other.say(&FromClient::SubscribeParameterUpdates { parameter_names: vec![] });
    other.say(&FromClient::GetParameters { parameter_names: vec![], id: Some("now".to_owned()) });
    let before = other.hear_text(|message| match message {
        FromServer::ParameterValues { parameters, id, .. } if id.as_deref() == Some("now") => {
            Some(parameters)
        }
        _ => None,
    });
    assert_eq!(
        before,
        [ParameterValue::new("/key/39/k2", 500.0), ParameterValue::new("/key/39/m", 0.1)]
    );
    let mut watcher = test_server.watcher();
    let changes = vec![set("k2", 700.5), set("m", 0.3)];
    assert_eq!(watcher.ask(Request::Set { changes }), Ok(done("2 set")));
    assert_eq!(
        (test_server.host.value("k2"), test_server.host.value("m")),
        (Some(700.5), Some(0.3))
    );
    let after = other.hear_text(|message| match message {
        FromServer::ParameterValues { parameters, id: None, .. } => Some(parameters),
        _ => None,
    });
    assert_eq!(
        after,
        [ParameterValue::new("/key/39/k2", 700.5), ParameterValue::new("/key/39/m", 0.3)]
    );
}

#[test]
fn a_set_with_one_mistake_is_refused_as_a_whole() {
    let test_server = TestServer::new();
    let mut watcher = test_server.watcher();
    let mut refused = |change, sentence: &str| {
        let changes = vec![set("k2", 9.0), change];
        assert_eq!(watcher.ask(Request::Set { changes }), Err(sentence.to_owned()));
        assert_eq!(test_server.host.value("k2"), Some(500.0));
    };
    refused(set("m", 2.0), "m is between 0.01 and 1 kg, and not 2");
    refused(set("mass", 2.0), "key 39 has no parameter mass");
    let no_number = "the value for \"/key/39/m\" is no finite number: \
                     send a number in the parameter's unit";
    refused(set("m", f64::NAN), no_number);
    refused(set("m", f64::INFINITY), no_number);
    assert_eq!(
        watcher.ask(Request::Set { changes: vec![] }),
        Err("nothing was set: name at least one parameter".to_owned())
    );
    assert_eq!(watcher.ask(Request::Set { changes: vec![set("k2", 9.0)] }), Ok(done("1 set")));
}

#[test]
fn whoever_is_refused_learns_what_is_the_case() {
    let test_server = TestServer::new();
    let mut other = test_server.raw_client();
    let text =
        r#"{"op":"setParameters","id":"x","parameters":[{"name":"/key/39/k2","value":"a"}]}"#;
    other.text(text.to_owned());
    let status = other.hear_text(|message| match message {
        FromServer::Status { level, id, .. } => Some((level, id)),
        _ => None,
    });
    assert_eq!(status, (Level::Error, Some("x".to_owned())));
    let values = other.hear_text(|message| match message {
        FromServer::ParameterValues { parameters, .. } => Some(parameters),
        _ => None,
    });
    assert_eq!(values, [ParameterValue::new("/key/39/k2", 500.0)]);
}

#[test]
fn services_are_answered_or_refused() {
    let test_server = TestServer::new();
    let mut watcher = test_server.watcher();
    let press = Request::Press { key: 39, newtons: 2.5 };
    assert_eq!(watcher.ask(press), Ok(done("key 39 feels 2.5 N")));
    let scene = Ok(Reply::Scene { toml: "tick_hz = 1000\n".to_owned() });
    assert_eq!(watcher.ask(Request::Scene {}), scene);
    let refused = watcher.ask(Request::Identify { line: 0, board: 0 });
    assert_eq!(refused, Err("a synthetic host has neither boards nor files".to_owned()));
    let (_, who) = test_server.host.asked().pop().expect("it was asked");
    assert_eq!(who.role, Role::Owner);
}

#[test]
fn a_stop_overtakes_what_takes_long() {
    let test_server = TestServer::new();
    let mut watcher = test_server.watcher();
    let workshop = test_server.host.workshop.lock().expect("nobody is in it");
    let slow = Request::UseInstrument { instrument: "grand".to_owned(), keys: None };
    let slow = watcher.client.ask(slow);
    assert_eq!(watcher.ask(Request::Stop {}), Ok(done("no force on any key")));
    drop(workshop);
    assert_eq!(watcher.reply(slow), Ok(done("every key is played by grand")));
}

struct Fragile;

impl Backend for Fragile {
    fn parameters(&self, _names: Option<&[String]>) -> Vec<ParameterSetting> {
        Vec::new()
    }

    fn ask(&self, request: Request, _who: &Who) -> Result<Reply, String> {
        match request {
            Request::Scene {} => Ok(done("still here")),
            other => panic!("{other:?} was not thought of"),
        }
    }
}

#[test]
fn a_host_that_fails_over_a_request_goes_on() {
    let settings = ServerSettings::default();
    let test_server = TestServer::of(settings, Arc::default(), Arc::new(Fragile));
    let mut watcher = test_server.watcher();
    let unknown = "the host failed over this request: whether it was done is not known";
    let press = Request::Press { key: 39, newtons: 1.0 };
    assert_eq!(watcher.ask(press), Err(unknown.to_owned()));
    assert_eq!(
        watcher.ask(Request::Set { changes: vec![set("k2", 1.0)] }),
        Err(unknown.to_owned())
    );
    assert_eq!(watcher.ask(Request::Scene {}), Ok(done("still here")));
}

#[test]
fn a_token_is_asked_for_and_makes_the_role() {
    let test_server = TestServer::with(guarded());
    let wrong = with_token(&test_server, "see");
    for (dial, words) in [
        (dial(&test_server), "this host asks for a token: give it as ?token=..."),
        (wrong, "this host does not know the given token"),
    ] {
        let mut watcher = Watcher::new(dial);
        let standing = watcher.stands(|standing| *standing != ConnectionState::Connecting);
        let ConnectionState::Refused(text) = standing else { panic!("{standing:?}") };
        assert!(text.starts_with(words), "{text}");
    }
    let mut tuner = Watcher::new(with_token(&test_server, TUNE));
    tuner.connected();
    assert_eq!(tuner.ask(Request::Set { changes: vec![set("k2", 9.0)] }), Ok(done("1 set")));
    assert_eq!(
        tuner.ask(Request::Scene {}),
        Err("this host does not let us ask for /letoff/scene".to_owned())
    );
    assert_eq!(tuner.ask(Request::Stop {}), Ok(done("no force on any key")));
}

#[test]
fn what_was_asked_is_answered_before_a_stream_closes_and_everybody_is_told_why() {
    let test_server = TestServer::new();
    let (mut one, mut other) = (test_server.watcher(), test_server.watcher());
    let workshop = test_server.host.workshop.lock().expect("nobody is in it");
    let slow = Request::UseInstrument { instrument: "grand".to_owned(), keys: None };
    let slow = one.client.ask(slow);
    eventually("it is asked", || !test_server.host.asked().is_empty());
    test_server.closer.close("the host was stopped".to_owned());
    let why =
        ConnectionState::Lost("the host ended the connection: the host was stopped".to_owned());
    other.stands(|standing| *standing == why);
    drop(workshop);
    assert_eq!(one.reply(slow), Ok(done("every key is played by grand")));
    one.stands(|standing| *standing == why);
}

#[test]
fn the_host_hears_of_every_client_that_goes_however_it_goes() {
    let test_server = TestServer::new();
    let gone = |number: u64| {
        eventually("the host hears of it", || test_server.host.gone().contains(&number));
    };
    // A window that is closed, and a program that is killed.
    drop(test_server.watcher());
    gone(1);
    drop(test_server.raw_client());
    gone(2);
}

#[test]
fn a_viewer_watches_and_stops_and_may_not_set() {
    let test_server = TestServer::with(guarded());
    let mut viewer = Watcher::new(with_token(&test_server, SEE));
    viewer.connected();
    assert_eq!(
        viewer.ask(Request::Set { changes: vec![set("k2", 9.0)] }),
        Err("a viewer may not do this: connect with a token of the role tuner".to_owned())
    );
    assert!(viewer.ask(Request::Press { key: 39, newtons: 1.0 }).is_err());
    assert_eq!(test_server.host.value("k2"), Some(500.0));
    assert!(test_server.host.asked().is_empty(), "only a stop is a viewer's");
    assert_eq!(viewer.ask(Request::Stop {}), Ok(done("no force on any key")));
    test_server.meet(&mut viewer);
}

#[test]
fn a_foreign_page_is_answered_with_403() {
    let test_server = TestServer::with(guarded());
    let connect = |origin| {
        let path = format!("/?token={TUNE}");
        let error = RawClient::connect(test_server.address, &path, &[("Origin", origin)]).err()?;
        match *error {
            Error::Http(response) => Some(response.status().as_u16()),
            other => panic!("{other}"),
        }
    };
    assert_eq!(connect("https://app.example"), None);
    assert_eq!(connect("https://evil.example"), Some(403));
    assert_eq!(connect("null"), Some(403));
}

#[test]
fn beyond_this_machine_only_with_token_and_tls() {
    let address = SocketAddr::from((Ipv4Addr::UNSPECIFIED, 0));
    let refused =
        StreamServer::listen(ServerSettings { address, ..guarded() }).expect_err("no TLS");
    assert_eq!(
        refused.to_string(),
        "the stream would listen at 0.0.0.0:0 without TLS: \
         give it both --tokens and --tls, or listen at 127.0.0.1"
    );
}

/// Messages to the slow client, of rows of 28 bytes: more than any buffer of the system.
const MESSAGES: u64 = 4000;
const ROWS: u32 = 500;

/// Reads messages of the only subscription until tick `last`; counts read and dropped ones.
fn read_until(raw_client: &mut RawClient, last: u64) -> (u64, u64) {
    let (mut came, mut dropped) = (0, 0);
    let mut is_last = false;
    while !is_last || came + dropped < MESSAGES {
        match raw_client.hear().expect("a message") {
            Message::Binary(bytes) => {
                let Ok(ServerFrame::Message { at, .. }) = ServerFrame::decode(&bytes) else {
                    panic!("nothing else was subscribed to");
                };
                came += 1;
                is_last |= at == last;
            }
            Message::Text(text) => dropped += dropped_in(&text),
            Message::Ping(_) | Message::Pong(_) | Message::Close(_) | Message::Frame(_) => {}
        }
    }
    (came, dropped)
}

fn dropped_in(text: &str) -> u64 {
    match FromServer::decode(text).expect("a text") {
        FromServer::Status { level: Level::Warning, message, .. } => {
            let count = message
                .strip_suffix(" messages were dropped: they come faster than they are taken");
            count.expect("a count").parse().expect("a number")
        }
        _ => 0,
    }
}

#[test]
fn a_slow_client_loses_data_and_a_fast_one_nothing() {
    // However slow this machine is, no client is cut.
    let (stall, idle) = (crate::test_server::PATIENCE, crate::test_server::PATIENCE);
    let test_server = TestServer::within(ServerLimits {
        data_bytes: 1 << 18,
        stall,
        idle,
        ..ServerLimits::default()
    });
    let mut slow = test_server.raw_client();
    let subscription = Subscription { id: 5, channel_id: channel_id(Topic::Block(KEY)) };
    slow.say(&FromClient::Subscribe { subscriptions: vec![subscription] });
    eventually("it follows", || test_server.publisher.is_followed(Topic::Block(KEY)));
    let mut fast = test_server.watcher();
    fast.follow(&[Topic::Block(KEY), Topic::Overview]);
    eventually("both follow", || test_server.publisher.is_followed(Topic::Overview));
    for tick in 1..=MESSAGES {
        test_server.publisher.publish(tick, &synthetic::block(tick, ROWS));
        // A client that reads each message before the next is made loses none.
        let got = fast.update(|update| match update {
            Update::Block(block) => Some(block.tick),
            other => panic!("nothing else was published: {other:?}"),
        });
        assert_eq!(got, tick);
    }
    assert_eq!(test_server.publisher.lost(), 0);
    let (came, dropped) = read_until(&mut slow, MESSAGES);
    assert!(dropped > 0, "the system's buffers held everything");
    assert_eq!(came + dropped, MESSAGES);
}

#[test]
fn publishing_waits_for_nobody() {
    let test_server = TestServer::new();
    let mut watcher = test_server.watcher();
    test_server.meet(&mut watcher);
    let (go_on, held) = std::sync::mpsc::channel::<()>();
    let (stand, stands) = std::sync::mpsc::channel();
    test_server.runtime.spawn(async move {
        stand.send(()).expect("somebody waits");
        let _gone = held.recv();
    });
    stands.recv().expect("it stands still");
    for tick in 0..20_000 {
        test_server.publisher.publish(tick, &synthetic::overview(tick, 1));
        test_server.publisher.publish(tick, &synthetic::voice(39, 1));
    }
    assert!(test_server.publisher.lost() > 0);
    drop(go_on);
    assert!(watcher.ask(Request::Scene {}).is_ok());
}

#[test]
fn a_client_connects_again_when_its_host_is_back() {
    let first = TestServer::new();
    let mut watcher = first.watcher();
    first.meet(&mut watcher);
    let address = first.address;
    drop(first);
    watcher.stands(|standing| matches!(standing, ConnectionState::Lost(_)));
    assert_eq!(
        watcher.ask(Request::Stop {}),
        Err("no host is connected: wait until one is, and ask again".to_owned())
    );
    let second = TestServer::with(ServerSettings { address, ..ServerSettings::default() });
    watcher.connected();
    eventually("it follows what it did", || second.publisher.is_followed(Topic::Overview));
    second.publisher.publish(9, &synthetic::overview(9, 1));
    watcher.update(|update| (update == synthetic::overview(9, 1)).then_some(()));
    assert_eq!(watcher.client.standing(), ConnectionState::Live);
}

#[test]
fn what_was_asked_of_a_host_that_goes_is_answered() {
    let test_server = TestServer::new();
    let mut watcher = test_server.watcher();
    let host = Arc::clone(&test_server.host);
    let workshop = host.workshop.lock().expect("nobody is in it");
    let slow = Request::UseInstrument { instrument: "grand".to_owned(), keys: None };
    let slow = watcher.client.ask(slow);
    eventually("it is asked", || !test_server.host.asked().is_empty());
    // The runtime waits for what it has begun; the connections end before.
    let gone = std::thread::spawn(move || drop(test_server));
    let refused = watcher.reply(slow).expect_err("the host is gone");
    assert!(refused.starts_with("the connection was lost before the host answered"), "{refused}");
    drop(workshop);
    gone.join().expect("it went");
}

fn self_made() -> ServerSettings {
    let names = vec!["localhost".to_owned(), "127.0.0.1".to_owned()];
    ServerSettings { tls: Some(Tls::SelfMade { names, folder: None }), ..guarded() }
}

#[test]
fn a_self_made_certificate_is_recognised_by_its_fingerprint() {
    let test_server = TestServer::with(self_made());
    let pin = test_server.fingerprint;
    assert!(pin.is_some() && test_server.url.starts_with("wss://"));
    let mut watcher = Watcher::new(Dial { pin, ..with_token(&test_server, TUNE) });
    watcher.connected();
    assert_eq!(watcher.ask(Request::Set { changes: vec![set("k2", 9.0)] }), Ok(done("1 set")));
    test_server.meet(&mut watcher);
}

#[test]
fn a_host_with_another_certificate_is_refused() {
    let test_server = TestServer::with(self_made());
    let shown = test_server.fingerprint.expect("a certificate").to_string();
    let refusal = |dial: Dial| match Watcher::new(dial)
        .stands(|standing| *standing != ConnectionState::Connecting)
    {
        ConnectionState::Refused(text) | ConnectionState::Lost(text) => text,
        standing => panic!("{standing:?}"),
    };
    let wrong = Dial { pin: Some(Fingerprint([7; 32])), ..with_token(&test_server, TUNE) };
    let text = refusal(wrong);
    assert!(text.contains("another certificate") && text.contains(&shown), "{text}");
    let text = refusal(with_token(&test_server, TUNE));
    assert!(text.starts_with("wss:// needs the fingerprint"), "{text}");
    let plain = test_server.url.replace("wss://", "ws://");
    let text = refusal(Dial { address: plain, ..with_token(&test_server, TUNE) });
    assert!(text.contains("speaks no WebSocket"), "{text}");
}

#[test]
fn a_certificate_that_is_kept_is_the_same_tomorrow() {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR"))
        .join(format!("certificate-{}", std::process::id()));
    let settings = || {
        let tls =
            Tls::SelfMade { names: vec!["localhost".to_owned()], folder: Some(folder.clone()) };
        let address = SocketAddr::from((Ipv4Addr::LOCALHOST, 0));
        ServerSettings { address, tls: Some(tls), ..ServerSettings::default() }
    };
    let first = StreamServer::listen(settings()).expect("a server").fingerprint();
    let second = StreamServer::listen(settings()).expect("a server").fingerprint();
    assert!(first.is_some());
    assert_eq!(first, second);
    std::fs::remove_dir_all(&folder).expect("it was kept there");
}
