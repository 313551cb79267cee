//! A good client is served, whatever arrives by the network.

use std::time::{Duration, Instant};
use std::{io::Write as _, net::TcpStream};

use telemetry::stream::protocol::{
    ClientFrame, FromClient, FromServer, Level, ParameterValue, Subscription, Text as _, channel_id,
};
use telemetry::stream::server::{ServerLimits, Tls, Token};
use telemetry::stream::{Dial, Role, ServerSettings};
use telemetry::{Reply, Request, Topic};
use tokio_tungstenite::tungstenite::{Error, Message};

use crate::test_server::synthetic::{self, KEY};
use crate::test_server::{RawClient, TestServer, Watcher, eventually, set};

struct Scene {
    test_server: TestServer,
    good: Watcher,
    count: u32,
}

impl Scene {
    fn on(test_server: TestServer) -> Self {
        let mut good = Watcher::new(Dial {
            address: test_server.url.clone(),
            pin: test_server.fingerprint,
            ..Dial::default()
        });
        good.connected();
        test_server.meet(&mut good);
        Self { test_server, good, count: 0 }
    }

    fn within(limits: ServerLimits) -> Self {
        Self::on(TestServer::within(limits))
    }

    #[track_caller]
    fn is_served(&mut self) {
        self.count += 1;
        let change = set("k2", f64::from(self.count));
        let done = self.good.ask(Request::Set { changes: vec![change] });
        assert_eq!(done, Ok(Reply::Done { text: "1 set".to_owned() }));
        let overview = synthetic::overview(self.count.into(), 1);
        self.test_server.publisher.publish(1, &overview);
        self.good.update(|update| (update == overview).then_some(()));
    }
}

struct Dice(u64);

impl Dice {
    fn roll(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    fn below(&mut self, most: u64) -> usize {
        usize::try_from(self.roll() % most).expect("a small number")
    }

    fn bytes(&mut self, most: u64) -> Vec<u8> {
        (0..self.below(most)).map(|_| self.roll().to_le_bytes()[0]).collect()
    }
}

fn send_bytes(test_server: &TestServer, dice: &mut Dice) {
    let mut stream = TcpStream::connect(test_server.address).expect("a connection");
    // The server may have closed it before the end.
    let _either = stream.write_all(&dice.bytes(4096));
}

#[test]
fn random_bytes() {
    let mut scene = Scene::within(ServerLimits::default());
    let mut dice = Dice(1);
    for _ in 0..100 {
        for _ in 0..3 {
            send_bytes(&scene.test_server, &mut dice);
        }
        scene.is_served();
    }
}

#[test]
fn random_bytes_where_tls_is_spoken() {
    let names = vec!["localhost".to_owned()];
    let tls = Some(Tls::SelfMade { names, folder: None });
    let mut scene =
        Scene::on(TestServer::with(ServerSettings { tls, ..ServerSettings::default() }));
    let mut dice = Dice(2);
    for _ in 0..50 {
        send_bytes(&scene.test_server, &mut dice);
        scene.is_served();
    }
}

fn texts() -> Vec<String> {
    let parameters =
        vec![ParameterValue::new("/key/39/k2", 1.0), ParameterValue::new("/key/39/m", 0.5)];
    let parameter_names = vec!["/key/39/k2".to_owned()];
    let subscriptions = vec![Subscription { id: 1, channel_id: 2 }];
    [
        FromClient::SetParameters { parameters, id: Some("x".to_owned()) },
        FromClient::GetParameters { parameter_names: parameter_names.clone(), id: None },
        FromClient::SubscribeParameterUpdates { parameter_names: parameter_names.clone() },
        FromClient::UnsubscribeParameterUpdates { parameter_names },
        FromClient::Subscribe { subscriptions },
        FromClient::Unsubscribe { subscription_ids: vec![1, 2, 3] },
    ]
    .iter()
    .filter_map(FromClient::encode)
    .collect()
}

fn spoiled_text(dice: &mut Dice, texts: &[String]) -> Message {
    let mut letters: Vec<char> = texts[dice.below(6)].chars().collect();
    for _ in 0..dice.below(4) {
        let place = dice.below(letters.len() as u64);
        letters[place] = ['"', '{', '}', '9', '-', 'e', ',', '\u{1f3b9}'][dice.below(8)];
    }
    Message::text(letters.into_iter().collect::<String>())
}

fn spoiled_bytes(dice: &mut Dice) -> Message {
    let request = ClientFrame::Request {
        service: u32::try_from(dice.below(8)).expect("small"),
        call: 1,
        encoding: "json",
        payload: br#"{"key":39,"newtons":1.0}"#,
    };
    let mut bytes = request.encode();
    for _ in 0..dice.below(3) {
        let place = dice.below(bytes.len() as u64);
        bytes[place] = dice.roll().to_le_bytes()[0];
    }
    bytes.truncate(dice.below(80));
    Message::binary(bytes)
}

#[test]
fn random_messages() {
    let mut scene = Scene::within(ServerLimits::default());
    let (mut dice, texts) = (Dice(3), texts());
    for _ in 0..20 {
        let mut raw_client = scene.test_server.raw_client();
        for _ in 0..50 {
            let message = match dice.below(4) {
                0 => Message::text(String::from_utf8_lossy(&dice.bytes(200)).into_owned()),
                1 => Message::binary(dice.bytes(200)),
                2 => spoiled_text(&mut dice, &texts),
                _ => spoiled_bytes(&mut dice),
            };
            raw_client.socket.send(message).expect("no client is cut for talking nonsense");
        }
        scene.is_served();
        raw_client.say(&FromClient::GetParameters {
            parameter_names: vec![],
            id: Some("sense".to_owned()),
        });
        raw_client.hear_text(|message| match message {
            FromServer::ParameterValues { id: Some(id), .. } if id == "sense" => Some(()),
            _ => None,
        });
    }
}

fn a_set(number: u32) -> FromClient {
    let parameters = vec![ParameterValue::new("/key/39/m", 0.5)];
    FromClient::SetParameters { parameters, id: Some(number.to_string()) }
}

#[test]
fn a_flood_of_sets_each_of_which_is_answered() {
    // So few that even a slow machine exceeds them.
    let mut scene =
        Scene::within(ServerLimits { requests_per_second: 10, ..ServerLimits::default() });
    let mut raw_client = scene.test_server.raw_client();
    let (mut done, mut refused) = (0, 0);
    for round in 0..10 {
        for number in 0..500 {
            raw_client.say(&a_set(round * 500 + number));
        }
        scene.is_served();
        for _ in 0..500 {
            let is_done = raw_client.hear_text(|message| match message {
                FromServer::ParameterValues { id: Some(_), .. } => Some(true),
                FromServer::Status { level: Level::Error, id: Some(_), message } => {
                    assert!(message.starts_with("too many requests "), "{message}");
                    Some(false)
                }
                _ => None,
            });
            done += u32::from(is_done);
            refused += u32::from(!is_done);
        }
    }
    assert_eq!(done + refused, 5000);
    assert!(done > 0 && refused > 0, "{done} done, {refused} refused");
}

#[test]
fn a_flood_of_which_nothing_is_read() {
    let mut scene = Scene::within(ServerLimits::default());
    for _ in 0..3 {
        let mut raw_client = scene.test_server.raw_client();
        for number in 0..2000 {
            // The server cuts it when its answers find no room any more.
            if raw_client.socket.send(Message::text(a_set(number).encode().expect("text"))).is_err()
            {
                break;
            }
        }
        scene.is_served();
    }
    eventually("the host hears of all three", || scene.test_server.host.gone().len() == 3);
}

#[test]
fn a_thousand_clients() {
    let limits = ServerLimits { clients: 20, ..ServerLimits::default() };
    let mut scene = Scene::within(limits);
    let (mut inside, mut turned_away) = (Vec::new(), 0);
    for number in 0..1000 {
        match RawClient::connect(scene.test_server.address, "/", &[]) {
            Ok(raw_client) => inside.push(raw_client),
            Err(error) => {
                assert!(matches!(&*error, Error::Http(it) if it.status().as_u16() == 503));
                turned_away += 1;
            }
        }
        if number % 100 == 0 {
            scene.is_served();
        }
    }
    // One place is the good client's.
    assert_eq!((inside.len(), turned_away), (19, 981));
    drop(inside);
    eventually("there is room", || RawClient::connect(scene.test_server.address, "/", &[]).is_ok());
    scene.is_served();
}

fn secret(role: Role) -> String {
    format!("{}-0123456789abcdef", role.name())
}

fn guarded(limits: ServerLimits) -> TestServer {
    let token = |role| Token { secret: secret(role), role };
    let tokens = vec![token(Role::Viewer), token(Role::Owner)];
    TestServer::with(ServerSettings { tokens, limits, ..ServerSettings::default() })
}

fn knock(test_server: &TestServer, secret: &str) -> Result<RawClient, u16> {
    let bearer = format!("Bearer {secret}");
    let knocked = RawClient::connect(test_server.address, "/", &[("Authorization", &bearer)]);
    knocked.map_err(|error| match *error {
        Error::Http(response) => response.status().as_u16(),
        other => unreachable!("{other}"),
    })
}

#[test]
fn idle_viewers_in_every_place_lock_no_owner_out() {
    let test_server = guarded(ServerLimits { clients: 20, owners: 2, ..ServerLimits::default() });
    let viewers: Vec<_> = (0..30).map(|_| knock(&test_server, &secret(Role::Viewer))).collect();
    let inside = viewers.iter().filter(|it| it.is_ok()).count();
    let turned_away = viewers.iter().filter(|it| matches!(it, Err(503))).count();
    assert_eq!((inside, turned_away), (18, 12));
    assert!(knock(&test_server, &secret(Role::Owner)).is_ok());
}

#[test]
fn who_guesses_a_token_waits_for_the_refusal_and_nobody_else_does() {
    let wrong_token = Duration::from_secs(1);
    let test_server = guarded(ServerLimits { wrong_token, ..ServerLimits::default() });
    let begun = Instant::now();
    assert!(knock(&test_server, &secret(Role::Owner)).is_ok());
    assert!(begun.elapsed() < wrong_token);
    assert_eq!(knock(&test_server, &secret(Role::Tuner)).err(), Some(401));
    assert!(wrong_token <= begun.elapsed());
}

#[test]
fn connections_that_never_say_who_they_are() {
    let handshake = Duration::from_mins(10);
    let mut scene =
        Scene::within(ServerLimits { handshakes: 16, handshake, ..ServerLimits::default() });
    let mut silent: Vec<_> = (0..60)
        .map(|_| TcpStream::connect(scene.test_server.address).expect("a connection"))
        .collect();
    for stream in silent.iter_mut().step_by(2) {
        let _either = stream.write_all(b"GET / HTTP/1.1\r\nHost: x\r\nUpgr");
    }
    scene.is_served();
    // A new client replaces the oldest, though they hold on.
    let mut new = scene.test_server.watcher();
    assert!(new.ask(Request::Scene {}).is_ok());
    scene.is_served();
    drop(silent);
}

#[test]
fn a_client_that_is_gone_without_a_word_is_forgotten() {
    let idle = Duration::from_secs(5);
    let test_server = TestServer::within(ServerLimits { idle, ..ServerLimits::default() });
    let mut raw_client = test_server.raw_client();
    let subscription = Subscription { id: 1, channel_id: channel_id(Topic::Block(KEY)) };
    raw_client.say(&FromClient::Subscribe { subscriptions: vec![subscription] });
    eventually("it follows", || test_server.publisher.is_followed(Topic::Block(KEY)));
    // Its connection stays open, but it answers no ping.
    eventually("it is forgotten", || !test_server.publisher.is_followed(Topic::Block(KEY)));
    eventually("the host hears of it", || !test_server.host.gone().is_empty());
    while raw_client.hear().is_ok() {}
}

#[test]
fn messages_that_are_too_large() {
    let mut scene = Scene::within(ServerLimits::default());
    let mut raw_client = scene.test_server.raw_client();
    let large = "x".repeat(2 << 20);
    // The server may have cut it in the middle.
    let _either = raw_client.socket.send(Message::text(large));
    while raw_client.hear().is_ok() {}
    scene.is_served();
    let mut raw_client = scene.test_server.raw_client();
    // The frame announces a length of eight exabytes.
    let header = [0x82, 0xff, 0x7f, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0, 0, 0, 0];
    raw_client.socket.get_mut().write_all(&header).expect("it is sent");
    while raw_client.hear().is_ok() {}
    scene.is_served();
}
